/** Coordinates of a block in the coordinate reference system that was chosen for its results, as its exports have them. All else is drawn and computed in that of its adjustment. Pure. */
import { geographic_positions, system_coordinates } from '../../../pkg/wasm/tiepoint.js';
import type { CountedFrom } from '../../../pkg/wasm/tiepoint.js';
import { remember } from '../../shared/state/remember';
import { fixed } from '../../shared/text/format';
import { withUnit } from '../../shared/text/units';
import { say } from '../../shared/text/words';
import { median } from './ground';
import { unitOf } from './scale';
import { mapped } from '../../shared/state/plane-map';
import type { Affine } from '../../shared/state/plane-map';
import type { BlockView } from './view';

type Unit = 'm' | 'ft' | '°' | '';

/** The system that coordinates are said in. */
export interface ResultSystem {
  /** Empty where the block has none but its own. */
  name: string;
  /** In few letters: its code, where it was given by that. */
  code: string;
  /** Of X and Y, and of Z. */
  unit: readonly [Unit, Unit];
  /** Digits of X and Y that say as much as those of m do. */
  more: number;
  /** Of positions in the system of the adjustment (stride 3); NaN where there are none. */
  coordinates: (positions: Float64Array) => Float64Array;
  /** From its X and Y to those of the adjustment, about the middle of the block; null where they are the same. */
  toBlock: Affine | null;
}

/** So far apart are the places that say how the systems lie to each other, m: about a block. */
const APART_M = 500;
const FOOT_M = 0.3048;
/** Units differ by more than projections change lengths. */
const MOST_SCALE = 0.02;
/** Degrees have so many digits more than m that say the same. */
const DIGITS_OF_DEGREES = 5;

/** The system of a block: its own where none was chosen, or that cannot be read any more. */
export const resultSystem = remember((view: BlockView): ResultSystem => chosenSystem(view) ?? ownSystem(view));

function ownSystem(view: BlockView): ResultSystem {
  const unit = unitOf(view);
  return { name: '', code: '', unit: [unit, unit], more: 0, coordinates: (positions) => positions, toBlock: null };
}

/** Where the heights of a block count from. */
export function countedFrom({ geoidM, geoid = null }: Pick<BlockView, 'geoidM' | 'geoid'>): CountedFrom {
  return geoid === null ? { geoid_m: geoidM } : { geoid };
}

/** Positions in the system of the adjustment (stride 3) in another one, with heights from where those of the block count. The block says where it lies on the earth. */
export function inSystem(view: Pick<BlockView, 'origin' | 'geoidM' | 'geoid'>, crs: string, positions: Float64Array): Float64Array {
  const { origin } = view;
  const all = new Float64Array(positions.length + 3);
  if (origin !== null) all.set([origin.longitude_deg, origin.latitude_deg, origin.height_m]);
  all.set(positions, 3);
  return system_coordinates(crs, geographic_positions(all), countedFrom(view));
}

function chosenSystem(view: BlockView): ResultSystem | null {
  const { crs, system = null, origin, points } = view;
  if (system === null || crs === null || origin === null) return null;
  const coordinates = (positions: Float64Array) => inSystem(view, crs, positions);
  const ground = median(points.positions.filter((value, i) => i % 3 === 2 && !Number.isNaN(value)));
  const z = Number.isNaN(ground) ? 0 : ground;
  try {
    const [x = NaN, y = NaN, up = NaN, ...others] = coordinates(Float64Array.of(0, 0, z, APART_M, 0, z, 0, APART_M, z, 0, 0, z + APART_M));
    const [xe = NaN, ye = NaN, , xn = NaN, yn = NaN, , , , over = NaN] = others;
    const [a, b, c, d] = [(xe - x) / APART_M, (ye - y) / APART_M, (xn - x) / APART_M, (yn - y) / APART_M];
    const determinant = a * d - b * c;
    if (!(Math.abs(determinant) > 0)) return null;
    const across = unitOfLength(Math.sqrt(Math.abs(determinant)));
    const turned = { a: d / determinant, b: -b / determinant, c: -c / determinant, d: a / determinant, e: 0, f: 0 };
    const [e, f] = mapped(turned, x, y);
    return {
      name: system,
      code: /^epsg:\d+$/iu.test(crs) ? crs.toUpperCase() : system,
      unit: [across, unitOfLength((over - up) / APART_M)],
      more: across === '°' ? DIGITS_OF_DEGREES : 0,
      coordinates,
      toBlock: { ...turned, e: -e, f: -f },
    };
  } catch {
    // A block of elsewhere, or of an earlier release.
    return null;
  }
}

/** The unit of which so many are a m; none where it is another one. */
function unitOfLength(perM: number): Unit {
  const is = (wanted: number) => Math.abs(perM / wanted - 1) < MOST_SCALE;
  if (is(1)) return 'm';
  return is(1 / FOOT_M) ? 'ft' : perM < 1e-3 ? '°' : '';
}

/** The head of a coordinate: with the system that it is in, where that has a name. */
export function headOf({ code }: ResultSystem, axis: string): string {
  return code === '' ? axis : say('in-system', { axis, code });
}

/** X and Y of a system are in one unit, Z in another where it has one. */
export function unitOn({ unit }: ResultSystem, axis: number): Unit {
  return unit[axis < 2 ? 0 : 1];
}

/** Of the positions of points: there are many, and they are those of one result in its system, however often that is shown. */
const converted = new WeakMap<Float64Array, Float64Array>();

/** The coordinates of all points of a block, of the projection centres of its images, and of its surveyed points, in the system of the results; stride 3. */
export function pointCoordinates(view: BlockView): Float64Array {
  const { positions } = view.points;
  const coordinates = converted.get(positions) ?? resultSystem(view).coordinates(positions);
  converted.set(positions, coordinates);
  return coordinates;
}
export const imageCoordinates = remember((view: BlockView): Float64Array => {
  const positions = Float64Array.from(view.images.flatMap(({ position }) => position ?? [NaN, NaN, NaN]));
  return resultSystem(view).coordinates(positions);
});
export const surveyedCoordinates = remember(
  (view: BlockView): Float64Array => resultSystem(view).coordinates(Float64Array.from(view.surveyed.flatMap(({ position }) => [...position]))),
);

/** A position of the block's adjustment in the system of the results, in words: "X Y Z 500123.12 5800456.78 101.20 m". */
export function coordinatesText(view: BlockView, position: readonly [number, number, number], digits: number): string {
  const system = resultSystem(view);
  const at = system.name === '' ? position : system.coordinates(Float64Array.from(position));
  const { unit, more } = system;
  const [x, y, z] = [at[0] ?? NaN, at[1] ?? NaN, at[2] ?? NaN];
  const plan = `${fixed(x, digits + more)} ${fixed(y, digits + more)}`;
  if (unit[0] === unit[1]) return withUnit(`X Y Z ${plan} ${fixed(z, digits)}`, unit[0]);
  return `${withUnit(`X Y ${plan}`, unit[0])} ${withUnit(`Z ${fixed(z, digits)}`, unit[1])}`;
}
