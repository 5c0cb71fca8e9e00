/** Photos of a simulated block, taken one at a time. */
import { zlibSync } from 'fflate';
import { photoFile, photoTruth } from '../../../pkg/block/photo.js';
import type { BlockFlight, BlockModel } from '../../../pkg/wasm/tiepoint.js';

/** The truth of a flight, which names its photos. */
export function blockPlan(flight: BlockFlight): BlockModel {
  return photoTruth(flight);
}

export function blockPhoto({ flight, index }: { flight: BlockFlight; index: number }): Uint8Array<ArrayBuffer> {
  // Noise deflates hardly better the longer it takes.
  return photoFile(flight, index, (bytes) => zlibSync(bytes, { level: 1 }));
}
