// @ts-check
/** Messages of the crate as outputs have them. */

import { message } from './wasm/tiepoint.js';

/**
 * A message and its text.
 * @template {keyof import('./wasm/tiepoint.js').Messages} F @template {import('./wasm/tiepoint.js').Messages[F] & object} M
 * @param {F} family @param {M} given @returns {M & { text: string }}
 */
export const withText = (family, given) => ({ ...given, text: message(family, given) });
