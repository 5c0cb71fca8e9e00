/** The block in a worker: runs it, its jobs done elsewhere and its records kept by the page, and holds what came of it for exports. */
import { runBlock } from '../../../pkg/block/index.js';
import type { BlockJob, Pool, Store as RecordStore } from '../../../pkg/block/index.js';
import { FinishedBlock } from '../../../pkg/wasm/tiepoint.js';
import type { ExportKind, FromRun, JobAnswer, MadeFile, Refusal, RunInput, ToRun } from './calls';
import type { BlockFile } from '../state/state';
import { Coming } from './coming';
import { made } from './made';
import { viewOf } from './outcome';
import type { BlockView } from '../state/view';

let held: FinishedBlock | null = null;

/** The block that was run or opened last. */
function heldBlock(): FinishedBlock {
  if (held === null) throw new Error('no block is held: run it again');
  return held;
}

export async function blockRun({ files, options, masks, truth, workers, kept, port }: RunInput): Promise<BlockView> {
  const link = new Link(port);
  const coming = new Coming((view) => link.send({ kind: 'part', view }));
  try {
    const finished = await runBlock(
      files.map(sourceOf),
      { ...options, masks: masks.map(sourceOf) },
      {
        pool: link.pool(workers),
        store: storeOf(kept, link),
        progress: (step) => link.send({ kind: 'step', step }),
        news: (news) => coming.take(news),
        signal: link.stopped.signal,
      },
    );
    return { ...hold(finished), score: truth === null ? null : finished.score(truth) };
  } catch (error) {
    coming.tell();
    throw error;
  } finally {
    coming.end();
    port.close();
  }
}

export function blockOpen({ bytes }: { bytes: Uint8Array }): BlockView {
  return hold(FinishedBlock.open(bytes));
}

function hold(block: FinishedBlock): BlockView {
  held?.free();
  held = block;
  return viewOf(block);
}

export async function blockExport({ kind, name, stop }: { kind: ExportKind; name: string; stop: MessagePort }): Promise<MadeFile> {
  const stopped = new AbortController();
  stop.onmessage = () => stopped.abort();
  try {
    return await made(heldBlock(), kind, name, stopped.signal);
  } finally {
    stop.close();
  }
}

function sourceOf({ name, file }: BlockFile) {
  return { name, bytes: async () => new Uint8Array(await file.arrayBuffer()) };
}

/** Records as blobs: they lie outside the memory of the worker, and outlive it with the page. */
function storeOf(kept: ReadonlyMap<string, Blob>, link: Link): RecordStore {
  const records = new Map(kept);
  return {
    get: async (key) => {
      const record = records.get(key);
      return record === undefined ? null : new Uint8Array(await record.arrayBuffer());
    },
    put: (key, bytes) => {
      const record = new Blob([bytes as Uint8Array<ArrayBuffer>]);
      records.set(key, record);
      link.send({ kind: 'keep', key, record });
      return Promise.resolve();
    },
  };
}

interface Waiting {
  resolve: (made: Uint8Array) => void;
  reject: (error: Error) => void;
}

/** The page as the run sees it: it has the workers. */
class Link {
  readonly stopped = new AbortController();
  private readonly waiting = new Map<number, Waiting>();
  private nextId = 1;

  constructor(private readonly port: MessagePort) {
    port.onmessage = (event: MessageEvent<ToRun>) => this.receive(event.data);
  }

  send(message: FromRun, transfer: Transferable[] = []): void {
    this.port.postMessage(message, transfer);
  }

  pool(size: number): Pool {
    return { size, run: (_, job, transfer) => this.ask(job, transfer as ArrayBuffer[]) };
  }

  private ask(job: BlockJob, transfer: ArrayBuffer[]): Promise<Uint8Array> {
    return new Promise((resolve, reject) => {
      this.stopped.signal.throwIfAborted();
      const id = this.nextId++;
      this.waiting.set(id, { resolve, reject });
      this.send({ kind: 'job', id, job }, transfer);
    });
  }

  private receive(message: ToRun): void {
    if (message.kind === 'stop') {
      this.stopped.abort();
      // The workers were ended, and answer nothing more.
      for (const { reject } of this.waiting.values()) reject(this.stopped.signal.reason as Error);
      this.waiting.clear();
      return;
    }
    const waiting = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (message.kind === 'broke') waiting?.reject(named('WorkerError', message.message));
    else settle(waiting, message.answer);
  }
}

function settle(waiting: Waiting | undefined, answer: JobAnswer): void {
  if ('made' in answer) waiting?.resolve(answer.made);
  else waiting?.reject(refused(answer.refusal));
}

function named(name: string, message: string): Error {
  const error = new Error(message);
  error.name = name;
  return error;
}

/** The crate's error as it was in the worker that threw it. */
function refused({ message, code, usage }: Refusal): Error {
  return Object.assign(named('TiepointError', message), { code, usage });
}
