/** Runs a block: hands its jobs to the pool, keeps its records, and reports to the store. */
import type { BlockJob } from '../../../pkg/block/index.js';
import type { BlockEdit, BlockFlight, BlockModel, BlockPlaces, BlockSettings, PlaceAgain, PointDetail } from '../../../pkg/wasm/tiepoint.js';
import { breakdownOf, Cancelled, WorkerClient } from '../../shared/engine/client';
import { WorkerPool } from '../../shared/engine/pool';
import { sentence } from '../../shared/text/format';
import { rememberCalibrations } from '../../shared/state/calibrations';
import type { Holder } from '../../shared/state/store';
import type { Position } from '../../shared/state/pane';
import type { Turn, Window } from './match';
import type { BlockCalls, ExportKind, FromRun, MadeFile, OpenedBlock, RunInput, ToRun } from './calls';
import type { ImagePoints, ViewObservations } from '../state/facts';
import type { ViewGround } from '../state/ground';
import type { BlockFile, BlockOptions, BlockState } from '../state/state';
import { calibrationsOf } from '../state/calibrated';
import { stepsOf } from '../state/editing';
import { firstProblem } from '../state/given';
import { givenToRun } from '../state/marks';
import type { BlockAction } from '../state/reducer';
import { purposeOf } from '../state/purpose';
import { isBusy, wantedKey } from '../state/state';
import type { BlockView } from '../state/view';
import { say } from '../../shared/text/words';
import { messageOf } from '../../shared/text/messages';

/** A block that was read from its project file and is not on the screen yet. */
export interface ReadBlock extends OpenedBlock {
  /** Puts it in the place of the one on the screen; not called where it is not wanted. */
  hold: () => void;
  /** Where its images show its places of an orthophoto. */
  places: () => Promise<BlockPlaces>;
  /** Which of these lie where those of a block before lay, as its images are numbered; null: of the block on the screen. */
  placesAgain: (before: BlockPlaces | null) => Promise<PlaceAgain[]>;
}

export type BlockStore = Holder<BlockState, BlockAction>;

/** How long a run that was stopped may take to end by itself, in ms; computing what cannot be interrupted it is ended with its worker. */
const PATIENCE_MS = 80;
/** The same of an export, which ends after the file that it writes, and after what the views asked before: its worker holds the block. */
const EXPORT_PATIENCE_MS = 3000;

export class BlockEngine {
  readonly pool = new WorkerPool<BlockCalls>();
  /** Holds the block on the screen, or of the run that goes on. */
  private block = new WorkerClient<BlockCalls>('block');
  /** Records of images and pairs that were done, by key: what is done once is not done again. */
  private readonly kept = new Map<string, Blob>();
  private recorded: () => void = () => undefined;
  private port: MessagePort | null = null;
  /** What a run tells, also one that was stopped and has not ended. */
  private told: MessagePort | null = null;
  /** Opens a project; what it read is not held yet, or was not wanted. */
  private reading: WorkerClient<BlockCalls> | null = null;
  /** Of the worker that holds the block. */
  private heldIn = -1;
  private spare: Blob | null = null;
  private regaining: Promise<void> | null = null;
  /** Of the export that is written. */
  private writing: MessagePort | null = null;

  constructor(private readonly store: BlockStore) {}

  async run(): Promise<void> {
    const { state } = this.store;
    const { settings } = state.options;
    if (settings === null || state.running.kind === 'yes') return;
    const problem = firstProblem(state);
    if (problem !== null) {
      this.store.dispatch({ type: 'notice', notice: { kind: 'problem', text: say('not-run', { problem: sentence(problem) }) } });
      return;
    }
    const key = wantedKey(state);
    const { files, truth } = state;
    const started = performance.now();
    this.store.dispatch({ type: 'started', key });
    const channel = new MessageChannel();
    this.listen(channel.port1, files);
    try {
      const input = {
        files,
        options: { ...runOptions({ ...state.options, ...givenToRun(state) }, settings), onOrthophoto: purposeOf(state) === 'block' },
        masks: state.options.masks,
        geoid: state.options.geoid,
        truth,
        workers: this.pool.size,
        kept: this.kept,
        port: channel.port2,
      };
      const view = await this.block.call('blockRun', input, [channel.port2]);
      this.heldIn = this.block.generation;
      this.spare = null;
      rememberCalibrations(calibrationsOf(view, truth !== null, Date.now()));
      this.store.dispatch({ type: 'done', key, view, files, seconds: (performance.now() - started) / 1000 });
    } catch (error) {
      this.pool.cancel();
      const stopped = this.port !== channel.port1;
      this.store.dispatch({ type: 'ended', failure: stopped || error instanceof Cancelled ? null : reasonOf(error) });
    } finally {
      channel.port1.close();
      if (this.port === channel.port1) this.port = null;
      if (this.told === channel.port1) this.told = null;
    }
  }

  /** Ends the run, the export, or whatever else the workers do. What was done is kept. */
  cancel(): void {
    const { port, writing } = this;
    this.port = null;
    this.writing = null;
    this.pool.cancel();
    port?.postMessage({ kind: 'stop' } satisfies ToRun);
    writing?.postMessage('stop');
    if (port === null && writing === null) return;
    window.setTimeout(
      () => {
        if (isBusy(this.store.state) && this.port === null && this.writing === null) this.block.cancel();
      },
      port === null ? EXPORT_PATIENCE_MS : PATIENCE_MS,
    );
  }

  /** Ends the run of a project that is left: nothing of it is shown or kept any more. */
  leave(): void {
    if (this.told === null) return;
    this.told.onmessage = null;
    this.port = null;
    this.pool.cancel();
    this.block.cancel();
  }

  /** Records of images and pairs that were done. */
  get records(): ReadonlyMap<string, Blob> {
    return this.kept;
  }

  /** Takes records of earlier runs, in place of those that are there. */
  takeRecords(records: ReadonlyMap<string, Blob>): void {
    this.kept.clear();
    for (const [key, record] of records) this.kept.set(key, record);
  }

  /** Calls back whenever there is another record. */
  watchRecords(recorded: () => void): void {
    this.recorded = recorded;
  }

  /** The project file of the block that is held. */
  async project(): Promise<Blob> {
    await this.regained();
    const { port1, port2 } = new MessageChannel();
    try {
      const { bytes } = await this.block.call('blockExport', { kind: 'project', name: 'block', stop: port2 }, [port2]);
      return new Blob([bytes]);
    } finally {
      port1.close();
    }
  }

  /** Opens a project file in a worker of its own: the block on the screen can be looked at and edited until `hold` is called. `truth`: of its photos. */
  async read(bytes: Uint8Array, truth: BlockModel | null = null): Promise<ReadBlock> {
    this.reading?.cancel();
    const worker = new WorkerClient<BlockCalls>('block');
    this.reading = worker;
    const opened = await worker.call('blockOpen', { bytes, truth }, [bytes.buffer as ArrayBuffer]);
    const hold = () => {
      this.block.cancel();
      this.block = worker;
      this.reading = null;
      this.heldIn = worker.generation;
      this.spare = null;
    };
    const ofShown = async () => {
      await this.regained();
      return this.block.call('blockPlaces', null);
    };
    const placesAgain = async (before: BlockPlaces | null) => worker.call('blockPlacesAgain', { before: before ?? (await ofShown()) });
    return { ...opened, hold, places: () => worker.call('blockPlaces', null), placesAgain };
  }

  /** The block that is held with these edits, in place of those that it has; it stays as it is where they are refused. */
  async edited(edits: readonly BlockEdit[]): Promise<BlockView> {
    await this.regained();
    // A run that was started meanwhile would get the edits of the former block when it is done.
    if (this.port !== null) throw new Cancelled('cancelled');
    return this.block.call('blockEdited', this.inSteps(edits));
  }

  /** The project file of the block that is shown, for a worker that lost it. */
  keepSpare(project: Blob | null): void {
    this.spare = project;
  }

  /** A worker that was ended, as with a run that was cancelled, held the block on the screen: the next one opens its project file. */
  private async regained(): Promise<void> {
    const { spare } = this;
    if (this.heldIn === this.block.generation || spare === null) return;
    this.regaining ??= this.regain(spare).finally(() => {
      this.regaining = null;
    });
    await this.regaining;
  }

  private async regain(spare: Blob): Promise<void> {
    const { block } = this;
    const bytes = new Uint8Array(await spare.arrayBuffer());
    await block.call('blockOpen', { bytes, truth: null }, [bytes.buffer]);
    // Another block was opened meanwhile, or is found.
    if (block !== this.block || this.port !== null) return;
    this.heldIn = block.generation;
    const { shown } = this.store.state;
    if (shown !== null) await this.block.call('blockEdited', this.inSteps(shown.edits));
  }

  private inSteps(edits: readonly BlockEdit[]): BlockCalls['blockEdited']['input'] {
    const { history, truth } = this.store.state;
    return { steps: stepsOf(history, edits), truth };
  }

  /** The observations of an image of the block that is held. */
  async imagePoints(image: number): Promise<ImagePoints> {
    await this.regained();
    return this.block.call('blockImagePoints', { image });
  }

  /** All observations of the block that is held, of so many images. */
  async observations(images: number): Promise<ViewObservations> {
    await this.regained();
    return this.block.call('blockObservations', { images });
  }

  /** Where images and recorded positions of the block that is held lie on the ground. */
  async ground(): Promise<ViewGround> {
    await this.regained();
    return this.block.call('blockGround', null);
  }

  /** A point of the block that is held. */
  async pointDetail(point: number): Promise<PointDetail> {
    await this.regained();
    return this.block.call('blockPoint', { point });
  }

  /** Where the ground at a place of one image may lie in another: x, y in px, stride 2. */
  async epipolarLine(from: number, x: number, y: number, to: number): Promise<Float64Array> {
    await this.regained();
    return this.block.call('blockLine', { from, x, y, to });
  }

  /** An image that the browser cannot decode. */
  grey(file: Blob): Promise<ImageBitmap> {
    return this.pool.call('blockGrey', { file });
  }

  /** The window of a place that others are matched to. */
  window(file: Blob, at: Position, turn: Turn | null): Promise<Window> {
    return this.pool.call('blockWindow', { file, at, turn });
  }

  /** Where least squares matching finds the place of a window near a place of another image; null where it confirms none. */
  async matched(left: Window, file: Blob, near: Position, turn: Turn): Promise<Position | null> {
    const by = await this.pool.call('blockFit', { left, right: await this.window(file, near, turn) });
    if (by === null) return null;
    const [ax, ay, bx, by_] = turn;
    return [near[0] + by[0] * ax + by[1] * bx, near[1] + by[0] * ay + by[1] * by_];
  }

  /** Rejects with `Cancelled` where the user ends it. */
  async export(kind: ExportKind, name: string): Promise<MadeFile> {
    const { port1, port2 } = new MessageChannel();
    this.writing = port1;
    try {
      await this.regained();
      return await this.block.call('blockExport', { kind, name, stop: port2 }, [port2]);
    } catch (error) {
      throw this.writing === port1 ? error : new Cancelled('cancelled');
    } finally {
      if (this.writing === port1) this.writing = null;
      port1.close();
    }
  }

  /** Takes the photos of the flight that is set, on all workers. */
  async photograph(flight: BlockFlight, done: (count: number, of: number) => void): Promise<{ files: Omit<BlockFile, 'id'>[]; truth: BlockModel }> {
    const truth = await this.pool.call('blockPlan', flight);
    let count = 0;
    const files = await Promise.all(
      truth.images.map(async ({ name }, index) => {
        const bytes = await this.pool.call('blockPhoto', { flight, index });
        count += 1;
        done(count, truth.images.length);
        return { name, file: new Blob([bytes], { type: 'image/png' }) };
      }),
    );
    return { files, truth };
  }

  private listen(port: MessagePort, files: readonly BlockFile[]): void {
    this.port = port;
    this.told = port;
    port.onmessage = (event: MessageEvent<FromRun>) => {
      const message = event.data;
      if (message.kind === 'keep') {
        this.kept.set(message.key, message.record);
        this.recorded();
      } else if (message.kind === 'job') void this.perform(port, message.id, message.job);
      else if (message.kind === 'part') this.store.dispatch({ type: 'part', view: message.view, files });
      else if (this.port === port) this.store.dispatch({ type: 'step', step: message.step });
    };
  }

  private async perform(port: MessagePort, id: number, job: BlockJob): Promise<void> {
    const tell = (message: ToRun, transfer: Transferable[] = []) => port.postMessage(message, transfer);
    try {
      if (this.port !== port) return;
      const answer = await this.pool.call('blockJob', job, buffersOf(job));
      tell({ kind: 'answer', id, answer }, 'made' in answer ? [answer.made.buffer as ArrayBuffer] : []);
    } catch (error) {
      // A run that was stopped waits for nothing.
      if (!(error instanceof Cancelled)) tell({ kind: 'broke', id, message: reasonOf(error) });
    }
  }
}

function runOptions({ gps, cameras, control, marks, positions }: BlockOptions, settings: BlockSettings): RunInput['options'] {
  return {
    settings,
    gps,
    ...(cameras === null ? {} : { cameras }),
    ...(control === null || marks === null ? {} : { control: { points: control.text, marks: marks.text } }),
    ...(positions === null ? {} : { positions: positions.text }),
  };
}

/** The memory of a job's bytes, which are copies that the run made for it. */
function buffersOf({ inputs }: BlockJob): Transferable[] {
  return [...new Set(inputs.map(({ buffer }) => buffer as ArrayBuffer))];
}

function reasonOf(error: unknown): string {
  return breakdownOf(error) ?? messageOf(error);
}
