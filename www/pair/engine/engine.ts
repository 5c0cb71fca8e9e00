/** Starts what is wanted and not there, one call a stage at a time, and reports to the store. */
import { editedPair } from '../state/edited';
import { wantedKeys } from '../state/keys';
import type { MatchesOf } from '../state/data';
import type { StageDone } from '../state/actions';
import type { GivenImage, Side, StageName, State } from '../state/state';
import type { Store } from '../state/store';
import type { Output, PairCalls, PairClient } from './calls';
import { CallError, Cancelled, WorkerClient } from '../../shared/engine/client';
import { plainMessage } from './failure';
import { nearestPieces } from './nearest';
import type { Workers } from './inputs';
import { WorkerPool } from '../../shared/engine/pool';
import { RUNS } from './runs';
import { STAGES, STAGE_NAMES } from '../state/stages';
import type { WorkerName } from '../state/stages';
import { say } from '../../shared/text/words';

/** Quiet time after a change of settings before work starts, in ms. */
const DEBOUNCE_MS = 150;
/** Longest side of the copy that is shown until detail tiles come, in px. */
const OVERVIEW_SIDE = 2048;

export class Engine implements Workers {
  private clients: Record<WorkerName, PairClient> = {
    left: new WorkerClient<PairCalls>(say('left-image')),
    right: new WorkerClient<PairCalls>(say('right-image')),
    pair: new WorkerClient<PairCalls>('pair'),
    preview: new WorkerClient<PairCalls>('preview'),
    report: new WorkerClient<PairCalls>('report'),
  };
  /** For what can be done in pieces. */
  private readonly pool = new WorkerPool<PairCalls>();
  /** What each worker has opened last: the image, in which life of the worker, and the answer to come. */
  private readonly opened = new Map<PairClient, { tag: string; answer: Promise<Output<'open'>> }>();
  /** Which pair the pair's worker holds, and when it does. */
  private held: { tag: string; answer: Promise<unknown> } | null = null;
  private timer: number | undefined;

  constructor(private readonly store: Store) {
    store.watch(['settings', 'camera', 'photos', 'masks', 'offset', 'fiducialModel'], () => this.later());
    store.watch(['images', 'selection', 'history', 'draft', 'paused', 'failures'], () => this.update());
  }

  client(name: WorkerName): PairClient {
    return this.clients[name];
  }

  /** Opens an image in the worker of a side; the earlier answer where that worker holds it already. */
  open(side: Side, image: GivenImage): Promise<Output<'open'>> {
    if (image.source.kind === 'project') return Promise.reject(new Error(say('the-project-does-not-hold', { name: image.name })));
    const client = this.clients[side];
    const tag = lifeTag(client, String(image.id));
    const held = this.opened.get(client);
    if (held?.tag === tag) return held.answer;
    const answer = client.call('open', { source: image.source, overviewSide: OVERVIEW_SIDE });
    this.opened.set(client, { tag, answer });
    answer.catch(() => {
      if (this.opened.get(client)?.answer === answer) this.opened.delete(client);
    });
    return answer;
  }

  /** The worker of a side; opens the side's image in it where it holds another or none (after a cancel, a trap or a swap). */
  async withImage(side: Side, state: State): Promise<PairClient> {
    const client = this.clients[side];
    const image = state.images[side];
    if (image === null) throw new Error(`there is no ${side} image`);
    await this.open(side, image);
    return client;
  }

  async withPair(state: State): Promise<PairClient> {
    const client = this.clients.pair;
    const tag = lifeTag(client, `${String(state.images.left?.id)}:${String(state.images.right?.id)}`);
    if (this.held?.tag !== tag) this.held = { tag, answer: this.holdPair(client, state) };
    const { held } = this;
    held.answer.catch(() => {
      if (this.held === held) this.held = null;
    });
    await held.answer;
    return client;
  }

  nearest(left: Uint8Array, right: Uint8Array): Promise<Output<'nearest'>[]> | null {
    return nearestPieces(left, right, this.pool.size, (first, end) => this.pool.call('nearest', { left, first, end, right }));
  }

  private async holdPair(client: PairClient, state: State): Promise<unknown> {
    const greyOf = async (side: Side) => (await this.withImage(side, state)).call('grey', null);
    const [left, right] = await Promise.all([greyOf('left'), greyOf('right')]);
    return client.call('hold', { left, right }, [left.grey.buffer, right.grey.buffer]);
  }

  /** Ends all workers and what they do; nothing runs until the user asks or changes something. */
  cancel(): void {
    this.stopWorkers();
    this.store.dispatch({ type: 'cancelled' });
  }

  /** Exchanges the images; each worker keeps the image it holds. */
  swap(): void {
    this.clients = { ...this.clients, left: this.clients.right, right: this.clients.left };
    this.store.dispatch({ type: 'swap' });
  }

  /** Starts every stage whose inputs are current and whose own result is not. */
  update(): void {
    window.clearTimeout(this.timer);
    for (const stage of STAGE_NAMES) {
      const { state } = this.store;
      if ((state.paused && !isOfMarks(state, stage)) || state.running[stage] !== undefined) continue;
      const key = wantedKeys(state)[stage];
      if (key === null || state.results[stage]?.key === key || state.failures[stage]?.key === key) continue;
      if (isReady(state, stage)) void this.run(stage, key);
    }
  }

  private later(): void {
    window.clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.update(), DEBOUNCE_MS);
  }

  private stopWorkers(): void {
    for (const client of Object.values(this.clients)) client.cancel();
    this.pool.cancel();
  }

  private async run(stage: StageName, key: string): Promise<void> {
    this.store.dispatch({ type: 'stageStarted', stage, key });
    const started = performance.now();
    const { state } = this.store;
    try {
      const value = await RUNS[stage](state, this);
      // The table of runs gives each stage its own type of value.
      const of = stage === 'orientation' ? matchesOf(state) : null;
      const result = { key, value, milliseconds: performance.now() - started, ...(of === null ? {} : { of }) };
      this.store.dispatch({ type: 'stageDone', stage, result } as StageDone);
    } catch (error) {
      this.failed(stage, key, error);
    }
    this.update();
  }

  private failed(stage: StageName, key: string, error: unknown): void {
    if (error instanceof Cancelled) {
      this.store.dispatch({ type: 'stageStopped', stage });
      return;
    }
    const ended = error instanceof CallError && error.ended;
    const refused = error instanceof CallError ? (error.failure.error ?? null) : null;
    this.store.dispatch({
      type: 'stageFailed',
      stage,
      failure: { key, ended, error: refused, message: plainMessage(stage, error, this.store.state.catalogue) },
    });
  }
}

/** Whether a stage says how well marks fit: that goes on while they are measured, in a pair that waits too. */
function isOfMarks({ tool }: State, stage: StageName): boolean {
  return tool === 'fiducials' && (stage === 'interiorLeft' || stage === 'interiorRight');
}

/** The matches that are oriented in this state. */
function matchesOf(state: State): MatchesOf | null {
  const pair = editedPair(state);
  return pair === null ? null : { ...pair, key: state.results.match?.key ?? '' };
}

/** Names what a worker holds in one of its lives. */
function lifeTag(client: PairClient, what: string): string {
  return `${String(client.generation)}:${what}`;
}

function isReady(state: State, stage: StageName): boolean {
  const { needs, uses = [] } = STAGES[stage];
  const keys = wantedKeys(state);
  const current = (input: StageName) => state.results[input]?.key === keys[input];
  // A stage with a key has all that it needs: what has no key is not part of this run.
  return (
    needs.every((input) => keys[input] === null || current(input)) &&
    uses.every((input) => keys[input] === null || current(input) || state.failures[input]?.key === keys[input])
  );
}
