/** The unit of an orthophoto's system: images that are placed on it by themselves have their coordinates in it. */
import { local_positions, system_positions } from '../../../pkg/wasm/tiepoint.js';
import type { OrthophotoInfo } from '../../../pkg/wasm/tiepoint.js';
import { remember } from '../../shared/state/remember';
import type { GivenOrthophoto } from './placing';
import { affineOf } from './under';
import { mapped } from '../../shared/state/plane-map';

export type LengthUnit = 'm' | 'ft';

const FOOT_M = 0.3048;
/** Projections in feet change lengths by less than this share; both kinds of feet differ by far less. */
const MOST_SCALE = 0.002;
/** Apart in units of the system: far enough for coordinates that are rounded. */
const APART = 1000;

/** Metres, where nothing says that they are feet. */
const unitOfInfo = remember((info: OrthophotoInfo): LengthUnit => {
  const { epsg, described } = info;
  if (epsg === null) return /(?:^|[^a-z])(?:ft|ftUS|feet|foot)(?:[^a-z]|$)/iu.test(described ?? '') ? 'ft' : 'm';
  return Math.abs(unitM(`EPSG:${String(epsg)}`, info) / FOOT_M - 1) < MOST_SCALE ? 'ft' : 'm';
});

export function unitOfOrthophoto(orthophoto: GivenOrthophoto | null): LengthUnit {
  return orthophoto === null ? 'm' : unitOfInfo(orthophoto.info);
}

/** How many m a unit is in the middle of the orthophoto; NaN where the system does not say where that is. */
function unitM(crs: string, { width, height, georeference }: OrthophotoInfo): number {
  const [x, y] = mapped(affineOf(georeference), width / 2, height / 2);
  try {
    const places = local_positions(system_positions(crs, Float64Array.of(x, y, 0, x + APART, y, 0)));
    return Math.hypot(...places.subarray(3)) / APART;
  } catch {
    // A system that the crate does not know.
    return NaN;
  }
}
