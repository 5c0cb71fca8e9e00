/** Places the block on the orthophoto, in a worker of its own: the block on the screen stays until the placed one takes its place. */
import { Cancelled, WorkerClient } from '../../shared/engine/client';
import { say } from '../../shared/text/words';
import { awaitedOf } from '../state/former';
import { groundKey } from '../state/purpose';
import type { ImageVerdict } from '../state/placing';
import { imagesOfBlock } from '../state/state';
import type { BlockCalls } from './calls';
import type { BlockEngine, BlockStore } from './engine';
import { named } from './placing';
import type { PlacingEngine } from './placing';

export class BlockPlacing {
  private readonly worker = new WorkerClient<BlockCalls>('georeferencing');
  private stopped = false;

  constructor(
    private readonly store: BlockStore,
    private readonly engine: BlockEngine,
    private readonly placing: PlacingEngine,
  ) {}

  /** False where the user ended it: the block then is as it was. */
  async place(): Promise<boolean> {
    const { shown, placing } = this.store.state;
    const { ground } = this.placing;
    if (shown === null || ground === null || placing.options === null) return false;
    const key = groundKey(this.store.state);
    this.stopped = false;
    this.tell(0, 1, say('looking-for-points-of-the'));
    try {
      this.placing.release();
      const before = shown.ground?.before ?? (await this.engine.project());
      const { project, verdicts } = await this.linked({ project: before, ground, options: placing.options });
      const read = await this.engine.read(project, this.store.state.truth);
      const awaited = awaitedOf(this.store.state);
      const [places, again] = [await read.places(), await read.placesAgain(awaited?.spots ?? null)];
      // Another block came meanwhile.
      if (this.stopped || this.store.state.shown?.found !== shown.found) return false;
      read.hold();
      this.store.dispatch({ type: 'onGround', view: read.view, edits: read.steps.flat(), ground: { key, before, places, verdicts }, again });
      return true;
    } catch (error) {
      if (this.stopped || error instanceof Cancelled) return false;
      throw named(error);
    } finally {
      // The memory of block and orthophoto is given back.
      this.worker.cancel();
      this.store.dispatch({ type: 'placing', running: null });
    }
  }

  /** Gives the block as it was before it was placed, where it was placed here. */
  async takeOff(): Promise<void> {
    const { shown } = this.store.state;
    if (shown?.ground == null) return;
    const read = await this.engine.read(new Uint8Array(await shown.ground.before.arrayBuffer()), this.store.state.truth);
    if (this.store.state.shown?.found !== shown.found) return;
    read.hold();
    this.store.dispatch({ type: 'onGround', view: read.view, edits: read.steps.flat(), ground: null });
  }

  cancel(): void {
    this.stopped = true;
    this.worker.cancel();
  }

  /** The project file of the placed block, and what came of each image. */
  private async linked(input: BlockCalls['linksOpen']['input']): Promise<{ project: Uint8Array; verdicts: ImageVerdict[] }> {
    const names = await this.worker.call('linksOpen', input);
    const files = new Map(imagesOfBlock(this.store.state).map(({ name, file }) => [name, file]));
    const images = names.flatMap((name, index) => {
      const file = name === null ? undefined : files.get(name);
      return name === null || file === undefined ? [] : [{ name, index, file }];
    });
    const verdicts: ImageVerdict[] = [];
    for (const [done, { name, index, file }] of images.entries()) {
      this.tell(done, images.length, say('placing-on-the-orthophoto', { name }));
      const verdict = await this.worker.call('linksPlace', { index, file });
      if (verdict !== null) verdicts.push({ name, verdict });
    }
    this.tell(1, 1, say('adjusting-by-the-orthophoto'));
    return { project: await this.worker.call('linksFinish', null), verdicts };
  }

  private tell(done: number, total: number, text: string): void {
    this.store.dispatch({ type: 'placing', running: { done, total, text } });
  }
}
