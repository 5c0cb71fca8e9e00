import type { PairVerdict } from '../wasm/tiepoint.js';

/** What a verdict asks for: `given`, a camera where none is known or hardly one; `other`, another one than that which is used; null: no camera helps. */
export function cameraWanted(verdict: PairVerdict): 'given' | 'other' | null;
