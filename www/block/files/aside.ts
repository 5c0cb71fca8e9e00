/** Leaves the block in the list of projects before it is gone from the page. */
import type { Here } from '../../shared/files/leaving';
import { say } from '../../shared/text/words';
import type { BlockStore } from '../engine/engine';
import { areDefault } from '../state/of-file';

export class BlockAside {
  constructor(
    private readonly store: BlockStore,
    /** Leaves the block that is shown in the list; false where it cannot be. */
    readonly putAside: () => Promise<boolean>,
  ) {}

  /**
   * Before the block is gone: one of photos that were not simulated, one with edits, and what was placed on an orthophoto stay in the list of projects, which
   * is true then; `isSetUp`: so does what was set up or found otherwise. Null where it cannot, and the user keeps it: what was simulated by settings as they
   * were is made again, and not asked for.
   */
  async leave(step: string, here: Here, isSetUp = false): Promise<boolean | null> {
    const { state } = this.store;
    const { shown, truth, history, marks, draft, placing } = state;
    // A point that is being measured is kept as it is.
    const length = history.edits.length + marks.edits.length + (draft !== null && draft.places.size > 0 ? 1 : 0);
    const isFound = shown !== null && !shown.view.partial && shown.view.oriented > 0 && truth === null;
    const isMade = length > 0 || placing.placed.size > 0 || isFound;
    if (!isMade && !isSetUp) return false;
    const stays = await this.putAside();
    here();
    if (stays) return true;
    if (!isMade && truth !== null && areDefault(state)) return false;
    const what = placing.placed.size > 0 ? say('what-was-placed-on-the') : isMade ? say('the-block-of-these-photos') : say('what-was-set-up');
    const edits = length === 0 ? what : length === 1 ? say('the-edit-by-hand-of') : say('the-edits-by-hand-of', { length });
    return window.confirm(say('cannot-be-kept-in-this', { edits, step, length: Math.max(1, length) })) ? false : null;
  }
}
