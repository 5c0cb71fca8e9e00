/** The module on the main thread: for what takes no time, as checks of fields and drawing. */
import { initSync } from '../../../pkg/wasm/tiepoint.js';
import { readCatalogue } from '../crate';
import type { Catalogue } from '../crate';
import { wasmModule } from './platform';

/** Loads the module and reads what the crate says of itself. */
export async function loadCatalogue(): Promise<Catalogue> {
  initSync({ module: await wasmModule() });
  return readCatalogue();
}
