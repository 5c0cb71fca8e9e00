/**
 * THE SEAM between the page and how it is delivered: this module alone imports `./platform`.
 *
 * A platform exports
 *   `createWorker(name: string): Worker`              a fresh worker that runs `worker.ts`;
 *   `compileWasm(): Promise<WebAssembly.Module>`      the compiled `pkg/wasm/tiepoint_bg.wasm`.
 * `platform.ts` serves a page on a host, `platform.single.ts` the page in one file; a build chooses by aliasing `./platform`.
 *
 * The module is compiled once and handed to each worker in its first message, so that a worker loads nothing by itself: it needs
 * neither a path to the wasm file nor a second compilation, and `worker.ts` can be bundled as one classic script.
 */
import { compileWasm, createWorker } from './platform';

let compiled: Promise<WebAssembly.Module> | undefined;

/** The compiled wasm module; compiled on the first call, and again after a failure. */
export function wasmModule(): Promise<WebAssembly.Module> {
  compiled ??= compileWasm().catch((error: unknown) => {
    compiled = undefined;
    throw error;
  });
  return compiled;
}

/** A fresh worker, waiting for the module as its first message. */
export function spawnWorker(name: string): Worker {
  return createWorker(name);
}
