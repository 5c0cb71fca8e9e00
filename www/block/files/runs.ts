/** Runs the block, and does with an orthophoto what is wanted: the block is placed on it, or each image by itself. It ends without a word where the project is left. */
import { unlessLeft } from '../../shared/files/leaving';
import type { Here } from '../../shared/files/leaving';
import { sentence } from '../../shared/text/format';
import type { GroundFiles } from './ground';
import type { BlockPlacing } from '../engine/block-placing';
import type { BlockEngine, BlockStore } from '../engine/engine';
import type { PlacingEngine } from '../engine/placing';
import { lacksPlaceAlone, purposeOf } from '../state/purpose';
import { imagesOfBlock } from '../state/state';
import { say } from '../../shared/text/words';
import { messageOf } from '../../shared/text/messages';

export class BlockRuns {
  constructor(
    private readonly store: BlockStore,
    private readonly engine: BlockEngine,
    private readonly images: PlacingEngine,
    private readonly block: BlockPlacing,
    private readonly ground: GroundFiles,
  ) {}

  /** Runs the block and places it on the orthophoto, where that is wanted. Of a block that is there as it is wanted only the place is made anew. */
  run(here: Here): Promise<void> {
    return unlessLeft(this.runBlock(here));
  }

  /** Places the images on the orthophoto that are not placed yet. */
  placeImages(here: Here): Promise<void> {
    return unlessLeft(this.placeEach(here));
  }

  /** The block as it was before it was placed on an orthophoto. */
  takeOff(here: Here): Promise<void> {
    return unlessLeft(this.takeBlockOff(here));
  }

  private async runBlock(here: Here): Promise<void> {
    const { state } = this.store;
    const places = purposeOf(state) === 'block';
    // It stays so when there is a block.
    if (places) this.store.dispatch({ type: 'purpose', purpose: 'block' });
    if (state.onStage === 'orthophoto') this.store.dispatch({ type: 'stage', view: 'map' });
    const runs = !lacksPlaceAlone(state);
    if (runs) await this.engine.run();
    here();
    const { running, notice } = this.store.state;
    // What became of edits is said until the block lies on the orthophoto, which says it anew.
    const said = runs && notice?.beside === true ? notice.text : '';
    if (running.kind === 'no' && lacksPlaceAlone(this.store.state)) await this.placeBlock(here, said);
  }

  private async placeEach(here: Here): Promise<void> {
    this.store.dispatch({ type: 'purpose', purpose: 'images' });
    this.store.dispatch({ type: 'stage', view: 'orthophoto' });
    this.store.dispatch({ type: 'notice', notice: null });
    try {
      // A block that was found after the orthophoto was given says how high its ground lies. Without it placing begins at once, as files that are given are told.
      if (this.ground.hasOtherLevel() && (await this.ground.takeLevelOfBlock(here)) === null) return;
      const done = await this.images.place();
      here();
      if (done === null) this.tell('info', say('cancelled-what-was-placed-stays'));
    } catch (error) {
      here();
      this.tell('problem', say('nothing-was-placed', { sentence: sentence(messageOf(error)) }));
    }
  }

  private async takeBlockOff(here: Here): Promise<void> {
    this.tell('busy', say('taking-the-block-off-the'));
    try {
      await this.block.takeOff();
      here();
      if (this.store.state.notice?.kind === 'busy') this.store.dispatch({ type: 'notice', notice: null });
    } catch (error) {
      here();
      this.tell('problem', say('the-block-stays-as-it', { sentence: sentence(messageOf(error)) }));
    }
  }

  /** `said`: what the run said of edits. */
  private async placeBlock(here: Here, said: string): Promise<void> {
    const andSaid = (text: string) => [text, said].join(' ').trimEnd();
    if (imagesOfBlock(this.store.state).length === 0) {
      this.tell('info', andSaid(say('a-block-is-placed-by')), true);
      return;
    }
    this.store.dispatch({ type: 'notice', notice: null });
    try {
      const isPlaced = await this.block.place();
      here();
      if (!isPlaced) this.tell('info', andSaid(say('cancelled-the-block-is-as')), true);
    } catch (error) {
      here();
      this.tell('problem', andSaid(say('the-block-stays-as-it', { sentence: sentence(messageOf(error)) })));
    }
  }

  private tell(kind: 'info' | 'busy' | 'problem', text: string, beside = false): void {
    this.store.dispatch({ type: 'notice', notice: { kind, text, ...(beside ? { beside } : {}) } });
  }
}
