/** The crate in a browser: `await load()` once, then call the functions. */

import init from './wasm/tiepoint.js';

export * from './wasm/tiepoint.js';

/**
 * Loads the module; later calls do nothing.
 * @param {import('./wasm/tiepoint.js').InitInput | Promise<import('./wasm/tiepoint.js').InitInput>} [source] beside this file unless told
 */
export default async function load(source = new URL('./wasm/tiepoint_bg.wasm', import.meta.url)) {
  await init({ module_or_path: source });
}
