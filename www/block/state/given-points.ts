/** Control and check points that were given and are not in the block: tables list them, and they can be measured. Pure. */
import { remember } from '../../shared/state/remember';
import type { History } from '../../shared/state/history';
import type { TextFile } from './file';
import { inSystemOfBlock } from './in-common';
import { allMarks, pointsOfFile } from './marks';
import type { MarkStep } from './marks';
import type { BlockState } from './state';
import type { BlockView, ViewGiven } from './view';

export const NONE_GIVEN: readonly ViewGiven[] = [];

type Beside = Omit<ViewGiven, 'images'>;

/** They stay the same while only measurements change. */
const besideBlock = remember((view: BlockView, control: TextFile | null, crs: string | null, geoid_m: number): readonly Beside[] => {
  const known = new Set(view.surveyed.map(({ name }) => name));
  const places = inSystemOfBlock(view, pointsOfFile(control), { crs, geoid_m });
  return pointsOfFile(control).flatMap(({ name, position, role }, i) =>
    known.has(name) ? [] : [{ name, position, place: places[i] ?? null, role: role ?? null }],
  );
});

const measured = remember((points: readonly Beside[], file: TextFile | null, history: History<MarkStep>): readonly ViewGiven[] => {
  if (points.length === 0) return NONE_GIVEN;
  const images = new Map<string, number>();
  for (const { point } of allMarks(file, history)) images.set(point, (images.get(point) ?? 0) + 1);
  return points.map((point) => ({ ...point, images: images.get(point.name) ?? 0 }));
});

/** The points beside a block, in the order of their file. */
export function givenBeside(view: BlockView, { options, marks }: Pick<BlockState, 'options' | 'marks'>): readonly ViewGiven[] {
  if (view.partial || options.control === null) return NONE_GIVEN;
  const { crs = null, geoid_m = null } = options.settings?.placing ?? {};
  // Of an opened block the settings are not those that it was made with.
  return measured(besideBlock(view, options.control, crs ?? view.crs, geoid_m ?? view.geoidM ?? 0), options.marks, marks);
}
