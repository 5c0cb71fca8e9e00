/** The tables of images that were placed, as the command writes them. */
import { placed_tables } from '../../../pkg/wasm/tiepoint.js';
import type { PlacedImage } from '../../../pkg/wasm/tiepoint.js';

export function placedCsv(names: readonly string[], placed: readonly PlacedImage[]): { placed: string; links: string } {
  return placed_tables([...names], placed);
}
