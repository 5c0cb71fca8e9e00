/** What the user does with a block: it is run, its images are placed, it is taken off the orthophoto, all images are removed. It is done with the project that is shown then. */
import { doHere } from '../../shared/files/leaving';
import type { Here } from '../../shared/files/leaving';
import { say } from '../../shared/text/words';
import type { BlockStore } from '../engine/engine';
import type { PlacingEngine } from '../engine/placing';
import { carriedOver } from '../state/carrying';
import { namesOf, withoutPlaces } from '../state/naming';
import type { Purpose } from '../state/placing';
import { lacksPlaceAlone } from '../state/purpose';
import { removesOthers } from '../state/removing';
import { isOutdated, wantedKey } from '../state/state';
import type { BlockAside } from './aside';
import { takeFrames } from './frames';
import type { BlockRuns } from './runs';
import type { Telling } from './told';

const NOTHING_LOST = { lost: 0, aside: [] };

export class BlockActions {
  constructor(
    private readonly store: BlockStore,
    private readonly placing: PlacingEngine,
    private readonly runs: BlockRuns,
    private readonly telling: Telling,
    private readonly aside: BlockAside,
    /** Waits for the project that is being left: what is done is done with the one that is shown now. */
    private readonly stays: () => Promise<Here>,
  ) {
    let before = store.state;
    store.watch(['marks', 'shown'], ([marks, shown]) => {
      // What the browser kept, and another block, are shown as they are.
      const others = shown !== null && shown.found === before.shown?.found && removesOthers(before.marks, marks);
      before = store.state;
      if (others && isOutdated(before)) queueMicrotask(() => void this.run());
    });
  }

  /** What the user decides to do with the orthophoto. */
  decide(purpose: Purpose): Promise<void> {
    return doHere(this.stays, async (here) => {
      this.store.dispatch({ type: 'purpose', purpose });
      this.store.dispatch({ type: 'notice', notice: null });
      if (purpose === 'images') await this.runs.placeImages(here);
      else if (purpose === 'block') await this.runOf(here);
      else this.store.dispatch({ type: 'stage', view: 'map' });
    });
  }

  /** Runs the block. One with edits that do not hold for the next one stays in the list of projects. */
  run(): Promise<void> {
    return doHere(this.stays, (here) => this.runOf(here));
  }

  private async runOf(here: Here): Promise<void> {
    // What is placed of a point that is still measured is of this run; what is too little for a point stays, and is measured on.
    this.store.dispatch({ type: 'accept', leaves: false });
    const { shown, history } = this.store.state;
    const names = shown === null ? null : namesOf(shown.found);
    // The same files and settings give the same tie points.
    const isSame = shown !== null && shown.tiePoints !== '' && shown.key === wantedKey(this.store.state);
    const { lost, aside } = names === null ? NOTHING_LOST : carriedOver(history, names, withoutPlaces(names), isSame);
    if (lost + aside.length === 0 || lacksPlaceAlone(this.store.state)) return this.runs.run(here);
    this.telling.tell('busy', say('keeping-the-edited-block'));
    const stays = await this.aside.leave(say('run-it-again'), here);
    this.store.dispatch({ type: 'notice', notice: null });
    if (stays === null) return;
    await this.runs.run(here);
    here();
    const { notice, running } = this.store.state;
    if (!stays || running.kind !== 'no' || notice === null) return;
    this.store.dispatch({ type: 'notice', notice: { ...notice, text: say('the-former-block-stays-under-projects', { text: notice.text }) } });
  }

  /** Places the images that are given on the orthophoto. */
  place(): Promise<void> {
    return doHere(this.stays, (here) => this.runs.placeImages(here));
  }

  /** The block as it was before it was placed on the orthophoto. */
  takeOff(): Promise<void> {
    return doHere(this.stays, (here) => this.runs.takeOff(here));
  }

  /** Puts frames in the place of scans of film. */
  frames(): Promise<void> {
    return doHere(this.stays, (here) => takeFrames(this.store, this.placing, here));
  }

  /** Removes all images, and the block. */
  clear(): Promise<void> {
    return doHere(this.stays, async (here) => {
      const { shown, history, marks, draft } = this.store.state;
      const isEdited = history.edits.length + marks.edits.length + (draft?.places.size ?? 0) > 0;
      const stays = await this.aside.leave(say('remove-all-images'), here);
      if (stays === null) return;
      this.store.dispatch({ type: 'clear' });
      const what = shown === null ? say('project') : isEdited ? say('edited-block') : say('oriented-block');
      if (stays) this.telling.tell('info', say('the-stays-under-projects', { what }));
    });
  }
}
