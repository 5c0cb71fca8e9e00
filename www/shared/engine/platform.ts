/**
 * The platform of a page served over HTTP. The single-file build replaces this module by `platform.single.ts`; the two export the
 * same names (see `spawn.ts`, the only place that imports them).
 */
import wasmUrl from '../../../pkg/wasm/tiepoint_bg.wasm?url';

/** Starts the worker script. */
export function createWorker(name: string): Worker {
  return new Worker(new URL('../../worker.ts', import.meta.url), { type: 'module', name });
}

/** Compiles the wasm module while it downloads; from its bytes where the host serves it under another media type. */
export async function compileWasm(): Promise<WebAssembly.Module> {
  const response = await fetch(wasmUrl);
  if (!response.ok) {
    throw new Error(`The program file ${wasmUrl} could not be loaded (HTTP ${String(response.status)}). Reload the page.`);
  }
  if (response.headers.get('content-type')?.startsWith('application/wasm') === true) {
    return WebAssembly.compileStreaming(response);
  }
  return WebAssembly.compile(await response.arrayBuffer());
}
