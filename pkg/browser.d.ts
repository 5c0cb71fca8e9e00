/// <reference path="./libs.d.ts" />
import type { InitInput } from './wasm/tiepoint.js';

export * from './wasm/tiepoint.js';

/** Loads the module; later calls do nothing. It lies beside this file unless told. */
export default function load(source?: InitInput | Promise<InitInput>): Promise<void>;
