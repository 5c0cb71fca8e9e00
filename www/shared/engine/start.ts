/** The module on the main thread: for what takes no time, as checks of fields and drawing. */
import init from '../../../pkg/wasm/tiepoint.js';
import { readCatalogue } from '../crate';
import type { Catalogue } from '../crate';
import { catalogueInLanguage } from '../text/options';
import { wasmModule } from './platform';

/** Loads the module and reads what the crate says of itself. */
export async function loadCatalogue(): Promise<Catalogue> {
  // Browsers refuse to make one of this size on the main thread but by a promise.
  await init({ module_or_path: await wasmModule() });
  return catalogueInLanguage(readCatalogue());
}
