/** The worker's end of the calls: answers them in their order, each by the handler of its name. */
import { breakdownOf } from '../../../pkg/block/faults.js';
import { initSync } from '../../../pkg/wasm/tiepoint.js';
import { compiled } from './compile';
import type { CompileMessage, Handlers, RequestMessage, StartMessage, Table, WireFailure } from './messages';
import { messageOf } from '../text/messages';

/** Buffers and bitmaps of an answer, moved rather than copied. Every array the crate hands out is a copy of its own. */
function transferables(value: unknown): Transferable[] {
  if (value instanceof ImageBitmap) return [value];
  if (ArrayBuffer.isView(value)) return value.buffer instanceof ArrayBuffer ? [value.buffer] : [];
  if (typeof value !== 'object' || value === null || Array.isArray(value)) return [];
  return Object.values(value).flatMap(transferables);
}

function failureOf(error: unknown): WireFailure {
  const message = messageOf(error);
  const code = error instanceof Error && 'code' in error && typeof error.code === 'string' ? error.code : null;
  const breakdown = breakdownOf(error);
  if (breakdown !== null) return { kind: breakdown, code, message };
  return {
    kind: code === null ? 'other' : 'refused',
    code,
    message,
    error: error instanceof Error && 'error' in error ? (error.error as { kind: string }) : null,
  };
}

/** Why the module could not start here; every call is then answered with it. */
let startFailure: { error: unknown } | null = null;

function start(message: StartMessage): void {
  try {
    initSync({ module: message.module });
  } catch (error) {
    startFailure = { error };
  }
}

/** Answers the page's calls from now on. */
export function serve<C extends Table<C>>(handlers: Handlers<C>): void {
  const answer = async ({ id, call, input }: RequestMessage): Promise<void> => {
    try {
      if (startFailure !== null) throw startFailure.error;
      // The client pairs each name with its input.
      const output: unknown = await handlers[call as keyof C](input as never);
      postMessage({ id, output }, { transfer: transferables(output) });
    } catch (error) {
      postMessage({ id, failure: failureOf(error) });
    }
  };
  // Calls are answered one after the other: what reads a file comes before what needs its content.
  let queue: Promise<void> = Promise.resolve();
  addEventListener('message', (event: MessageEvent<StartMessage | CompileMessage | RequestMessage>) => {
    const message = event.data;
    if ('compile' in message) void compiled(message.compile).then((made) => postMessage(made));
    else if ('module' in message) start(message);
    else queue = queue.then(() => answer(message));
  });
}
