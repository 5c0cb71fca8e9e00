/** Where images and recorded positions of an oriented block lie on the ground. */
import type { GeographicOrigin } from '../../../pkg/wasm/tiepoint.js';

export interface ViewGround {
  /** Corners of each image on a level plane at the height of its points, from the top left on clockwise: x, y; NaN where it sees none; stride 8. */
  footprints: Float64Array;
  /** Ground sample distance in the middle of each image, in units of the block; NaN where it is not oriented. */
  gsd: Float64Array;
  /** GNSS position of each image in the system of the block; NaN without one, or where the system is another; stride 3. */
  gnss: Float64Array;
  /** Where the system lies on the earth; null where it does not say. */
  origin: GeographicOrigin | null;
}

/** What the coordinates of a block are: east and north of a place on the earth, those of the surveyed points, or its own. */
export type System = 'geographic' | 'surveyed' | 'own';
