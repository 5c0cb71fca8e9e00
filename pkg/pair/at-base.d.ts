import type { FiveParameters } from '../wasm/tiepoint.js';

/** An orientation with by and bz at the scale of another base; NaN where its own base is 0, which has no scale. */
export function atBase(orientation: FiveParameters, baseMm: number, otherMm: number): FiveParameters;
