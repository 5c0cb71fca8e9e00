/// <reference path="./libs.d.ts" />
import type { InitInput } from './wasm/tiepoint.js';

export * from './wasm/tiepoint.js';

/** For code that browsers run too: here the module is ready at once, whatever is given. */
export default function load(source?: InitInput | Promise<InitInput>): Promise<void>;
