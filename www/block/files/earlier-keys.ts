/** What names how images were placed on an orthophoto, as earlier releases kept it: written as it is now, what was up to date stays so. */
import { givenPositions } from '../state/given-positions';
import { keyWith } from '../state/placed';
import type { Placed, Placing } from '../state/placing';
import type { FilmTexts } from '../state/film';
import type { BlockFile, BlockOptions, TextFile } from '../state/state';

type Position = Parameters<typeof keyWith>[2];

export function withPresentKeys(placing: Placing, files: readonly BlockFile[], options: Pick<BlockOptions, 'settings'>): Placing {
  if (placing.placed.size === 0) return placing;
  const names = new Map(files.map(({ id, name }) => [id, name]));
  const positionIn = (positions: TextFile, image: string): Position =>
    givenPositions({ files, placing, options: { ...options, positions } }).get(image) ?? null;
  const placed = [...placing.placed].map(([id, own]): [number, Placed] => {
    const key = presentKey(own.key, (table) => positionIn(table, names.get(id) ?? ''));
    // The same object: what is kept already is not written again.
    return [id, key === own.key ? own : { ...own, key }];
  });
  return { ...placing, placed: new Map(placed) };
}

/** A key named the table of positions as a whole, in place of what it has of the image; of a scan there was nothing behind its film. */
function presentKey(key: string, positionIn: (table: TextFile) => Position): string {
  let parts: { all: unknown[]; own: unknown[] };
  try {
    const given = JSON.parse(key) as unknown[];
    const [all, ...own] = given;
    parts = typeof all === 'string' ? { all: JSON.parse(all) as unknown[], own } : { all: given, own: [] };
  } catch {
    return key;
  }
  const { all, own } = parts;
  if (own.length > 1) return key;
  const [orthophoto, heights, options, cameras, table = null] = all;
  const position = table === null ? null : positionIn(table as TextFile);
  return keyWith(JSON.stringify([orthophoto, heights, options, cameras]), (own[0] ?? null) as FilmTexts | null, position);
}
