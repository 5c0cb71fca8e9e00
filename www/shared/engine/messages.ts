/** What passes between the page and its workers. Each part of the page has a table of calls: name to input and output. */

/** What a table of calls must be like. */
export type Table<C> = { [K in keyof C]: { input: unknown; output: unknown } };

/** What answers the calls of a table. */
export type Handlers<C extends Table<C>> = { [K in keyof C]: (input: C[K]['input']) => C[K]['output'] | Promise<C[K]['output']> };

/** The first message to a worker. */
export interface StartMessage {
  module: WebAssembly.Module;
}

/** The only message to a worker that compiles the module; its address. */
export interface CompileMessage {
  compile: string;
}

/** `status`: what the host answered in place of the module; null where something else went wrong. */
export type CompiledMessage = { compiled: WebAssembly.Module } | { status: number | null; message: string };

export interface RequestMessage {
  id: number;
  call: string;
  input: unknown;
}

/** Why a call failed. After `fault`, a bug of the program, and `memory` the worker must be ended: its wasm memory is no longer to be trusted. */
export interface WireFailure {
  kind: 'refused' | 'fault' | 'memory' | 'other';
  /** The crate's stable code, where it refused. */
  code: string | null;
  message: string;
  /** The refusal with its figures. */
  error?: { kind: string } | null;
}

export type ResponseMessage = { id: number; output: unknown } | { id: number; failure: WireFailure };
