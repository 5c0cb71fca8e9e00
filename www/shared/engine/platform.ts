/**
 * Where the worker's script and the wasm module come from: files beside the page, or, in the page in one file, inert elements of the
 * document. Such a page runs from file:// too, where nothing beside it can be fetched and a module worker does not start from a Blob:
 * the worker is therefore one classic script everywhere.
 *
 * The module is compiled once and handed to each worker in its first message: a worker loads nothing by itself.
 */
import { scriptAddress } from './trusted';

/** As `tools/lib/page.mjs` names the files and `tools/lib/compose.mjs` the elements. */
const WORKER = { file: 'worker.js', element: 'tiepoint-worker' };
const WASM = { file: 'tiepoint_bg.wasm', element: 'tiepoint-wasm' };

/** The text of an element of the page in one file; null in a page with files beside it. */
function embedded(id: string): string | null {
  return document.getElementById(id)?.textContent ?? null;
}

let workerUrl: string | undefined;

/** A fresh worker, waiting for the module as its first message. */
export function spawnWorker(name: string): Worker {
  const code = embedded(WORKER.element);
  workerUrl ??= code === null ? new URL(WORKER.file, document.baseURI).href : URL.createObjectURL(new Blob([code], { type: 'text/javascript' }));
  // The development server gives modules.
  return new Worker(scriptAddress(workerUrl), { name, type: import.meta.env.DEV ? 'module' : 'classic' });
}

let compiled: Promise<WebAssembly.Module> | undefined;

/** The compiled wasm module; compiled on the first call, and again after a failure. */
export function wasmModule(): Promise<WebAssembly.Module> {
  compiled ??= compileWasm().catch((error: unknown) => {
    compiled = undefined;
    throw error;
  });
  return compiled;
}

async function compileWasm(): Promise<WebAssembly.Module> {
  const deflated = embedded(WASM.element);
  if (deflated !== null) return WebAssembly.compile(await inflated(deflated.trim()));
  // While it downloads; from its bytes where the host serves it under another media type.
  const response = await fetch(new URL(WASM.file, document.baseURI));
  if (!response.ok) throw new Error(`The program file ${WASM.file} could not be loaded (HTTP ${String(response.status)}). Reload the page.`);
  if (response.headers.get('content-type')?.startsWith('application/wasm') === true) return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}

/** Bytes of base64 text, deflated without a header. */
function inflated(base64: string): Promise<ArrayBuffer> {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'))).arrayBuffer();
}
