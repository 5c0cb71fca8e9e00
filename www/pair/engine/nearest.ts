/** The search for nearest gradient descriptors, in pieces over a pool of workers: the same result for any number of them. */
import { DESCRIPTOR_BYTES } from '../state/descriptor';
import type { Output } from './calls';

/** Pairs of descriptors that a worker compares in some ten milliseconds: fewer are not worth a message to it. */
const LEAST_PAIRS = 2e6;

/** What searches one piece of the left descriptors: from `first` to before `end`. */
export type Searcher = (first: number, end: number) => Promise<Output<'nearest'>>;

/** The pieces in their order, of equal size, as many as there are workers or are worth it; null where it is not worth more than one. */
export function nearestPieces(left: Uint8Array, right: Uint8Array, workers: number, search: Searcher): Promise<Output<'nearest'>[]> | null {
  const count = left.length / DESCRIPTOR_BYTES;
  const pieces = Math.min(workers, Math.floor((count * (right.length / DESCRIPTOR_BYTES)) / LEAST_PAIRS));
  if (pieces < 2) return null;
  const cut = (piece: number) => Math.round((count * piece) / pieces);
  return Promise.all(Array.from({ length: pieces }, (_, piece) => search(cut(piece), cut(piece + 1))));
}
