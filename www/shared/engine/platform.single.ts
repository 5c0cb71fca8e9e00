/**
 * The platform of `tiepoint.html`, the page in one file that also runs from file://.
 *
 * Contract with the build: the document holds two inert scripts beside the page's own,
 *   `<script type="text/plain" id="tiepoint-worker">`: `worker.ts` bundled as ONE CLASSIC script (module workers do not start from
 *   a Blob URL of a file:// page), every `</` in it written `<\/`;
 *   `<script type="text/plain" id="tiepoint-wasm">`: `tiepoint_bg.wasm`, deflated (raw, without header), in base64.
 */

function embedded(id: string): string {
  const text = document.getElementById(id)?.textContent;
  if (text === null || text === undefined || text === '') {
    throw new Error(`This copy of the page is incomplete: its part "${id}" is missing. Save the file again.`);
  }
  return text;
}

let workerUrl: string | undefined;

/** Starts the worker script from the copy in the document. */
export function createWorker(name: string): Worker {
  workerUrl ??= URL.createObjectURL(new Blob([embedded('tiepoint-worker')], { type: 'text/javascript' }));
  return new Worker(workerUrl, { name });
}

/** Compiles the wasm module from the copy in the document. */
export async function compileWasm(): Promise<WebAssembly.Module> {
  const deflated = Uint8Array.from(atob(embedded('tiepoint-wasm').trim()), (c) => c.charCodeAt(0));
  const bytes = new Blob([deflated]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  return WebAssembly.compile(await new Response(bytes).arrayBuffer());
}
