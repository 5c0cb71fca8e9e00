/** Photos of a simulated block, taken one at a time. */
import { photoFile, photoTruth } from '../../../pkg/block/photo.js';
import type { BlockFlight, BlockModel } from '../../../pkg/wasm/tiepoint.js';

/** The truth of a flight, which names its photos. */
export function blockPlan(flight: BlockFlight): BlockModel {
  return photoTruth(flight);
}

export function blockPhoto(job: { flight: BlockFlight; index: number }): Uint8Array<ArrayBuffer> {
  return photoFile(job);
}
