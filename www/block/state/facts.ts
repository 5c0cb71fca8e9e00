/** What the page asks of a block that is held. */
export type { ImagePoints } from '../../../pkg/wasm/tiepoint.js';

/** All observations of a block, image by image. */
export interface ViewObservations {
  images: Uint32Array;
  /** Indices of the points. */
  points: Uint32Array;
  places: Float64Array;
  residuals: Float64Array;
  /** As `ImagePoints` has them. */
  redundancy: Float64Array;
  w: Float64Array;
  detectable: Float64Array;
  parts: Uint8Array;
}
