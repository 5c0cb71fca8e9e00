/** Where images and recorded positions of an oriented block lie on the ground, and how much of that a pixel shows. */
import type { GeographicOrigin } from '../../../pkg/wasm/tiepoint.js';
import { remember } from '../../shared/state/remember';
import type { BlockView } from './view';

export interface ViewGround {
  /** Corners of each image on a level plane at the height of its points, from the top left on clockwise: x, y; NaN where it sees none; stride 8. */
  footprints: Float64Array;
  /** Ground sample distance of each image where its tie points are, in units of the block; NaN where it is not oriented. */
  gsd: Float64Array;
  /** GNSS position of each image in the system of the block; NaN without one, or where the system is another; stride 3. */
  gnss: Float64Array;
  /** Where the system lies on the earth; null where it does not say. */
  origin: GeographicOrigin | null;
}

/** What the coordinates of a block are: east and north of a place on the earth, those of the surveyed points, or its own. */
export type System = 'geographic' | 'surveyed' | 'own';

/** The system of what is shown: coordinates without a place on the earth and without surveyed points are the block's own. */
export function systemOf(view: BlockView, ground: ViewGround | null): System {
  if (view.layout.kind === 'recorded' || ground?.origin != null) return 'geographic';
  return view.surveyed.some(({ role }) => role === 'control') ? 'surveyed' : 'own';
}

/** The median ground sample distance of the images, in m; null where the system of the block is none of metres. */
export const medianGsd = remember((view: BlockView, ground: ViewGround | null): number | null => {
  if (ground === null || systemOf(view, ground) === 'own') return null;
  return numberOf(median([...ground.gsd].filter(Number.isFinite)));
});

/** The ground sample distance of an image, in m; null where it has none, and as `medianGsd`. */
export function gsdOf(view: BlockView, ground: ViewGround | null, image: number): number | null {
  return ground === null || systemOf(view, ground) === 'own' ? null : numberOf(ground.gsd[image] ?? NaN);
}

/** The median standard errors of the points that take part, in plan and in height, in the unit of the block; NaN where there are none. */
export const medianErrors = remember(({ points: { errors, taking } }: Pick<BlockView, 'points'>): [plan: number, height: number] => {
  const of = (error: (at: number) => number) => median(Array.from({ length: taking }, (_, point) => error(3 * point)).filter(Number.isFinite));
  return [of((at) => Math.hypot(errors[at] ?? NaN, errors[at + 1] ?? NaN)), of((at) => errors[at + 2] ?? NaN)];
});

/** NaN of none. */
export function median(values: Iterable<number>): number {
  const sorted = Float64Array.from(values).sort();
  return sorted[Math.floor(sorted.length / 2)] ?? NaN;
}

function numberOf(value: number): number | null {
  return Number.isFinite(value) ? value : null;
}
