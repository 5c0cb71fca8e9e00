/** Photos of a simulated block, taken one at a time. */
import { zlibSync } from 'fflate';
import { photoFile, photoNames } from '../../pkg/block/photo.js';
import type { BlockFlight } from '../../pkg/wasm/tiepoint.js';

/** The names of the photos that a flight takes, in their order. */
export function blockPlan(flight: BlockFlight): string[] {
  return photoNames(flight);
}

export function blockPhoto({ flight, index }: { flight: BlockFlight; index: number }): Uint8Array<ArrayBuffer> {
  // Noise deflates hardly better the longer it takes.
  return photoFile(flight, index, (bytes) => zlibSync(bytes, { level: 1 }));
}
