/** Runs a block: hands its jobs to the pool, keeps its records, and reports to the store. */
import type { BlockJob } from '../../../pkg/block/index.js';
import type { BlockFlight, BlockModel, BlockSettings } from '../../../pkg/wasm/tiepoint.js';
import { breakdownOf, Cancelled, WorkerClient } from '../../shared/engine/client';
import { WorkerPool } from '../../shared/engine/pool';
import { messageOf, sentence } from '../../shared/text/format';
import type { Holder } from '../../shared/state/store';
import type { BlockCalls, ExportKind, FromRun, MadeFile, RunInput, ToRun } from './calls';
import type { BlockFile, BlockOptions, BlockState } from '../state/state';
import { firstProblem } from '../state/given';
import type { BlockAction } from '../state/reducer';
import { isBusy, wantedKey } from '../state/state';
import type { BlockView } from '../state/view';

export type BlockStore = Holder<BlockState, BlockAction>;

/** How long a run that was stopped may take to end by itself, in ms; computing what cannot be interrupted it is ended with its worker. */
const PATIENCE_MS = 80;

export class BlockEngine {
  readonly pool = new WorkerPool<BlockCalls>();
  /** Holds the block of the last run. */
  private readonly block = new WorkerClient<BlockCalls>('block');
  /** Records of images and pairs that were done, by key: what is done once is not done again. */
  private readonly kept = new Map<string, Blob>();
  private recorded: () => void = () => undefined;
  private port: MessagePort | null = null;
  /** Of the export that is written. */
  private writing: MessagePort | null = null;

  constructor(private readonly store: BlockStore) {}

  async run(): Promise<void> {
    const { state } = this.store;
    const { settings } = state.options;
    if (settings === null || state.running.kind === 'yes') return;
    const problem = firstProblem(state);
    if (problem !== null) {
      this.store.dispatch({ type: 'notice', notice: { kind: 'problem', text: `Not run: ${sentence(problem)}` } });
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
        options: runOptions(state.options, settings),
        masks: state.options.masks,
        truth,
        workers: this.pool.size,
        kept: this.kept,
        port: channel.port2,
      };
      const view = await this.block.call('blockRun', input, [channel.port2]);
      this.store.dispatch({ type: 'done', key, view, files, seconds: (performance.now() - started) / 1000 });
    } catch (error) {
      this.pool.cancel();
      const stopped = this.port !== channel.port1;
      this.store.dispatch({ type: 'ended', failure: stopped || error instanceof Cancelled ? null : reasonOf(error) });
    } finally {
      channel.port1.close();
      if (this.port === channel.port1) this.port = null;
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
    window.setTimeout(() => {
      if (isBusy(this.store.state) && this.port === null && this.writing === null) this.block.cancel();
    }, PATIENCE_MS);
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
    const { port1, port2 } = new MessageChannel();
    try {
      const { bytes } = await this.block.call('blockExport', { kind: 'project', name: 'block', stop: port2 }, [port2]);
      return new Blob([bytes]);
    } finally {
      port1.close();
    }
  }

  /** Holds the block of a project file; what is shown stays. */
  read(bytes: Uint8Array): Promise<BlockView> {
    return this.block.call('blockOpen', { bytes }, [bytes.buffer as ArrayBuffer]);
  }

  async open(bytes: Uint8Array): Promise<void> {
    const view = await this.read(bytes);
    this.store.dispatch({ type: 'openedFile', view });
  }

  /** Rejects with `Cancelled` where the user ends it. */
  async export(kind: ExportKind, name: string): Promise<MadeFile> {
    const { port1, port2 } = new MessageChannel();
    this.writing = port1;
    try {
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
    const say = (message: ToRun, transfer: Transferable[] = []) => port.postMessage(message, transfer);
    try {
      if (this.port !== port) return;
      const answer = await this.pool.call('blockJob', job, buffersOf(job));
      say({ kind: 'answer', id, answer }, 'made' in answer ? [answer.made.buffer as ArrayBuffer] : []);
    } catch (error) {
      // A run that was stopped waits for nothing.
      if (!(error instanceof Cancelled)) say({ kind: 'broke', id, message: reasonOf(error) });
    }
  }
}

function runOptions({ gps, cameras, control, marks }: BlockOptions, settings: BlockSettings): RunInput['options'] {
  return {
    settings,
    gps,
    ...(cameras === null ? {} : { cameras }),
    ...(control === null || marks === null ? {} : { control: { points: control.text, marks: marks.text } }),
  };
}

/** The memory of a job's bytes, which are copies that the run made for it. */
function buffersOf({ inputs }: BlockJob): Transferable[] {
  return [...new Set(inputs.map(({ buffer }) => buffer as ArrayBuffer))];
}

function reasonOf(error: unknown): string {
  return breakdownOf(error) ?? messageOf(error);
}
