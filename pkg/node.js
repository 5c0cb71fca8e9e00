/** The crate in Node: the module is read from disk and ready at once. */

import { readFileSync } from 'node:fs';
import { initSync } from './wasm/tiepoint.js';

initSync({ module: readFileSync(new URL('./wasm/tiepoint_bg.wasm', import.meta.url)) });

export * from './wasm/tiepoint.js';

/** Nothing is left to load: code that browsers run too calls it all the same. */
export default async function load() {}
