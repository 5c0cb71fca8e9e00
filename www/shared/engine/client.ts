/** One worker as the page sees it: typed calls that are answered, refused, or ended with the worker. */
import type { RequestMessage, ResponseMessage, StartMessage, Table, WireFailure } from './messages';
import { spawnWorker, wasmModule } from './platform';
import { say } from '../text/words';
import { messageOf } from '../text/messages';

/** A call that was refused or failed. `ended`: the worker is gone, and with it what it held. */
export class CallError extends Error {
  override readonly name = 'CallError';
  constructor(
    readonly failure: WireFailure,
    readonly ended: boolean,
  ) {
    super(failure.message);
  }
}

/** What ended the worker, in words; null where it lives on.  */
export function breakdownOf(error: unknown): string | null {
  if (!(error instanceof CallError) || !error.ended) return null;
  return error.failure.kind === 'memory'
    ? say('the-worker-ran-out-of', { message: error.message })
    : say('the-worker-broke-off-at', { message: error.message });
}

/** A call that the user cancelled. */
export class Cancelled extends Error {
  override readonly name = say('cancelled');
}

interface Pending {
  resolve: (output: never) => void;
  reject: (error: Error) => void;
}

export class WorkerClient<C extends Table<C>> {
  private worker: Started | null = null;
  private readonly pending = new Map<number, Pending>();
  private nextId = 1;
  /** Changes when a worker ends: what it held is lost. */
  generation = 0;

  constructor(private readonly name: string) {}

  /** Asks the worker, starting one where there is none. Rejects with `CallError` or `Cancelled`; no promise stays open. */
  async call<K extends keyof C & string>(call: K, input: C[K]['input'], transfer: Transferable[] = []): Promise<C[K]['output']> {
    this.worker ??= this.start();
    const worker = this.worker;
    return new Promise<C[K]['output']>((resolve, reject) => {
      const id = this.nextId++;
      this.pending.set(id, { resolve, reject });
      const request: RequestMessage = { id, call, input };
      // At once: what the page does beside it, as drawing, is not waited for.
      if (worker.isReady) {
        worker.handle.postMessage(request, transfer);
        return;
      }
      worker.ready.then(
        () => {
          if (this.pending.has(id)) worker.handle.postMessage(request, transfer);
        },
        (error: unknown) => this.end(new CallError(otherFailure(error), true)),
      );
    });
  }

  /** Ends the worker and rejects what waits for it. The next call starts a fresh one. */
  cancel(): void {
    this.end(new Cancelled('cancelled'));
  }

  private start(): Started {
    const handle = spawnWorker(this.name);
    handle.onmessage = (event: MessageEvent<ResponseMessage>) => this.receive(event.data);
    handle.onerror = (event) => {
      event.preventDefault();
      this.end(new CallError({ kind: 'fault', code: null, message: event.message || say('the-worker-could-not-start') }, true));
    };
    const started: Started = {
      handle,
      isReady: false,
      ready: wasmModule().then((module) => {
        const start: StartMessage = { module };
        handle.postMessage(start);
        started.isReady = true;
      }),
    };
    return started;
  }

  private receive(response: ResponseMessage): void {
    const waiting = this.pending.get(response.id);
    if (waiting === undefined) return;
    this.pending.delete(response.id);
    if ('output' in response) {
      waiting.resolve(response.output as never);
      return;
    }
    const ended = response.failure.kind === 'fault' || response.failure.kind === 'memory';
    const error = new CallError(response.failure, ended);
    waiting.reject(error);
    if (ended) this.end(error);
  }

  private end(error: Error): void {
    this.worker?.handle.terminate();
    this.worker = null;
    this.generation += 1;
    const waiting = [...this.pending.values()];
    this.pending.clear();
    for (const { reject } of waiting) reject(error);
  }
}

interface Started {
  handle: Worker;
  /** Whether it has its module, so that it takes calls. */
  isReady: boolean;
  ready: Promise<void>;
}

function otherFailure(error: unknown): WireFailure {
  return { kind: 'other', code: null, message: messageOf(error) };
}
