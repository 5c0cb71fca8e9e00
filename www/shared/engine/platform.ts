/**
 * Where the worker's script and the wasm module come from: files beside the page, or, in the page in one file, inert elements of the
 * document. Such a page runs from file:// too, where nothing beside it can be fetched and a module worker does not start from a Blob:
 * the worker is therefore one classic script everywhere.
 *
 * The module is compiled once, and handed to each worker in its first message.
 */
import type { CompiledMessage, CompileMessage } from './messages';
import { namedInLanguage } from '../text/language';
import { scriptAddress } from './trusted';
import { say } from '../text/words';

/** As `tools/lib/page.mjs` names the files and `tools/lib/compose.mjs` the elements. */
const WORKER = { file: 'worker.js', element: 'tiepoint-worker' };
const WASM = { file: 'tiepoint_bg.wasm', element: 'tiepoint-wasm' };

/** The text of an element of the page in one file; null in a page with files beside it. */
function embedded(id: string): string | null {
  return document.getElementById(id)?.textContent ?? null;
}

/** Whether the page's files lie beside it, and not within it. */
export function besideFiles(): boolean {
  return embedded(WORKER.element) === null;
}

let workerUrl: string | undefined;

/** A fresh worker, waiting for the module as its first message. */
export function spawnWorker(name: string): Worker {
  const code = embedded(WORKER.element);
  workerUrl ??= code === null ? new URL(WORKER.file, document.baseURI).href : URL.createObjectURL(new Blob([code], { type: 'text/javascript' }));
  // The development server gives modules.
  return new Worker(scriptAddress(workerUrl), { name: namedInLanguage(name), type: import.meta.env.DEV ? 'module' : 'classic' });
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
  const made = await compiledElsewhere(new URL(WASM.file, document.baseURI).href);
  if ('compiled' in made) return made.compiled;
  throw new Error(made.status === null ? made.message : say('the-program-file-could-not', { file: WASM.file, status: made.status }));
}

/** In a worker of its own: a browser reads the bytes of a module on the thread that asks for it, and the page is to answer meanwhile. */
async function compiledElsewhere(compile: string): Promise<CompiledMessage> {
  const worker = spawnWorker('compile');
  try {
    return await new Promise((resolve, reject) => {
      worker.onmessage = ({ data }: MessageEvent<CompiledMessage>) => resolve(data);
      worker.onerror = (event) => {
        event.preventDefault();
        reject(new Error(event.message || say('the-worker-could-not-start')));
      };
      const first: CompileMessage = { compile };
      worker.postMessage(first);
    });
  } finally {
    worker.terminate();
  }
}

/** Bytes of base64 text, deflated without a header. */
function inflated(base64: string): Promise<ArrayBuffer> {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'))).arrayBuffer();
}
