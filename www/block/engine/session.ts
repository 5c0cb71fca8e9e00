/** The block in a worker: runs it, its jobs done elsewhere and its records kept by the page, and holds what came of it for exports. */
import { runBlock } from '../../../pkg/block/index.js';
import type { BlockJob, Pool, Store as RecordStore } from '../../../pkg/block/index.js';
import { errorOf } from '../../../pkg/block/wire.js';
import { FinishedBlock } from '../../../pkg/wasm/tiepoint.js';
import type { BlockModel, BlockPlaces, PlaceAgain, PointDetail } from '../../../pkg/wasm/tiepoint.js';
import type { EditStep } from '../state/edits';
import type { ImagePoints, ViewObservations } from '../state/facts';
import type { ViewGround } from '../state/ground';
import type { ExportKind, FromRun, JobAnswer, MadeFile, OpenedBlock, RunInput, ToRun } from './calls';
import type { BlockFile } from '../state/state';
import { Coming } from './coming';
import { groundOf } from './ground';
import { made } from './made';
import { Found, Rejected } from './rejected';
import { viewOf } from './outcome';
import { projectInputOf } from './project-input';
import type { BlockView } from '../state/view';

let held: FinishedBlock | null = null;
/** The block as it was found, once edits have left something out; what they left out. */
let found: Found | null = null;
let rejected: Rejected | null = null;

/** The block that was run or opened last. */
function heldBlock(): FinishedBlock {
  if (held === null) throw new Error('no block is held');
  return held;
}

export async function blockRun({ files, options, masks, geoid, truth, workers, kept, port }: RunInput): Promise<BlockView> {
  const link = new Link(port);
  const coming = new Coming((view) => link.send({ kind: 'part', view }));
  try {
    const finished = await runBlock(
      files.map(sourceOf),
      { ...options, masks: masks.map(sourceOf), strayMasks: 'list', ...(geoid && { geoid: sourceOf(geoid) }) },
      {
        pool: link.pool(workers),
        store: storeOf(kept, link),
        progress: (step) => link.send({ kind: 'step', step }),
        news: (news) => coming.take(news),
        signal: link.stopped.signal,
      },
    );
    return hold(finished, truth, 'another');
  } catch (error) {
    coming.tell();
    throw error;
  } finally {
    coming.end();
    port.close();
  }
}

export function blockOpen({ bytes, truth }: { bytes: Uint8Array; truth: BlockModel | null }): OpenedBlock {
  const block = FinishedBlock.open(bytes);
  return { view: hold(block, truth, 'another'), steps: stepsIn(block), made: projectInputOf(bytes, block) };
}

/** The edits that a block has, in their steps. */
function stepsIn(block: FinishedBlock): EditStep[] {
  const edits = block.edits();
  return block.edit_steps().map((length) => edits.splice(0, length));
}

/** The former block stays where the edits are refused. */
export function blockEdited({ steps, truth }: { steps: readonly EditStep[]; truth: BlockModel | null }): BlockView {
  const edited = heldBlock().edited(
    steps.flat(),
    steps.map(({ length }) => length),
  );
  return hold(edited, truth, 'edited');
}

/** Takes the place of the former block, which stays where anything of this one is refused. */
function hold(block: FinishedBlock, truth: BlockModel | null, kind: 'another' | 'edited'): BlockView {
  try {
    const view = { ...viewOf(block), score: truth === null ? null : block.score(truth) };
    const edits = block.edits();
    const before = kind === 'edited' ? found : null;
    const own = edits.length === 0 ? null : (before ?? foundOf(block));
    const gone = own === null ? null : new Rejected(own, edits, view.points.count, view.points.sources);
    const shown = gone === null ? view : gone.inView(view);
    held?.free();
    if (found !== own) found?.block.free();
    [held, found, rejected] = [block, own, gone];
    return shown;
  } catch (error) {
    block.free();
    throw error;
  }
}

function foundOf(block: FinishedBlock): Found {
  const before = block.edited([]);
  const { surveyed, givenControl } = viewOf(before);
  return new Found(before, surveyed, givenControl);
}

function imagePoints(image: number): ImagePoints {
  const of = heldBlock().image_points(image);
  return rejected === null ? of : rejected.inImage(of, image);
}

export function blockImagePoints({ image }: { image: number }): ImagePoints {
  return imagePoints(image);
}

export function blockObservations({ images }: { images: number }): ViewObservations {
  const each = Array.from({ length: images }, (_, image) => imagePoints(image));
  const total = each.reduce((sum, { points }) => sum + points.length, 0);
  const all: ViewObservations = {
    images: new Uint32Array(total),
    points: new Uint32Array(total),
    places: new Float64Array(2 * total),
    residuals: new Float64Array(2 * total),
    redundancy: new Float64Array(2 * total),
    w: new Float64Array(2 * total),
    detectable: new Float64Array(2 * total),
    parts: new Uint8Array(total),
  };
  let at = 0;
  each.forEach((own, image) => {
    const { points } = own;
    all.images.fill(image, at, at + points.length);
    all.points.set(points, at);
    all.parts.set(own.parts, at);
    for (const column of ['places', 'residuals', 'redundancy', 'w', 'detectable'] as const) all[column].set(own[column], 2 * at);
    at += points.length;
  });
  return all;
}

export function blockGround(): ViewGround {
  return groundOf(heldBlock());
}

export function blockPlaces(): BlockPlaces {
  return heldBlock().places();
}

export function blockPlacesAgain({ before }: { before: BlockPlaces }): PlaceAgain[] {
  return heldBlock().places_again(before);
}

export function blockPoint({ point }: { point: number }): PointDetail {
  return rejected?.detail(point) ?? heldBlock().point(point);
}

export function blockLine({ from, x, y, to }: { from: number; x: number; y: number; to: number }): Float64Array {
  return heldBlock().epipolar_line(from, x, y, to);
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
    return { size, run: (_, job, transfer) => this.ask(job, transfer) };
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
  else waiting?.reject(errorOf(answer.refusal));
}

function named(name: string, message: string): Error {
  const error = new Error(message);
  error.name = name;
  return error;
}
