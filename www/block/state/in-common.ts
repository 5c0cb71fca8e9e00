/** Where given coordinates lie in the system of a block: known where both say where they lie on the earth, or the block has some of the points already. Pure. */
import { local_positions, system_positions } from '../../../pkg/wasm/tiepoint.js';
import type { CountedFrom, GeographicOrigin, GroundControlRow } from '../../../pkg/wasm/tiepoint.js';
import { scaleOf, similarity } from './under';
import { mapped } from '../../shared/state/plane-map';
import type { BlockView } from './view';

type Coordinates = readonly [number, number, number];

/** The coordinate reference system of a file, and where its heights count from. */
interface SystemOfFile {
  crs: string | null;
  heights: CountedFrom;
}

/** The coordinates of each row in the system of the block; null where nothing leads there. */
export function inSystemOfBlock(view: BlockView, rows: readonly GroundControlRow[], { crs, heights }: SystemOfFile): readonly (Coordinates | null)[] {
  const { orthophoto, origin } = view;
  if (orthophoto !== null && orthophoto.kind !== 'not_linked' && !orthophoto.inCrs) return rows.map(({ position }) => position);
  const onEarth = crs === null || origin === null ? null : byEarth(rows, crs, heights, origin);
  return onEarth ?? byCommonPoints(view, rows);
}

/** As a run takes them. Null where the system cannot be read, or no point lies in it. */
function byEarth(
  rows: readonly GroundControlRow[],
  crs: string,
  heights: CountedFrom,
  { longitude_deg, latitude_deg, height_m }: GeographicOrigin,
): readonly (Coordinates | null)[] | null {
  try {
    const geographic = system_positions(
      crs,
      rows.flatMap(({ position }) => position),
      heights,
    );
    const local = local_positions([longitude_deg, latitude_deg, height_m, ...geographic]);
    const places = rows.map((_, i): Coordinates | null => {
      const [x = NaN, y = NaN, z = NaN] = local.subarray(3 * i + 3, 3 * i + 6);
      return Number.isNaN(x + y + z) ? null : [x, y, z];
    });
    return places.every((place) => place === null) ? null : places;
  } catch {
    // What is wrong with the system is said where it is set.
    return null;
  }
}

/** By the similarity in plan of the points that block and file share, and the scale and the mean difference of their heights. */
function byCommonPoints({ surveyed }: BlockView, rows: readonly GroundControlRow[]): readonly (Coordinates | null)[] {
  const inBlock = new Map(surveyed.map(({ name, position }) => [name, position]));
  const common = rows.flatMap(({ name, position }): [Coordinates, Coordinates][] => {
    const own = inBlock.get(name);
    return own === undefined ? [] : [[position, own]];
  });
  const plan = similarity(
    common.map(([[x, y]]) => [x, y]),
    common.map(([, [x, y]]) => [x, y]),
  );
  if (plan === null) return rows.map(() => null);
  const scale = scaleOf(plan);
  const rise = common.reduce((sum, [given, own]) => sum + own[2] - scale * given[2], 0) / common.length;
  return rows.map(({ position: [x, y, z] }) => [...mapped(plan, x, y), scale * z + rise]);
}
