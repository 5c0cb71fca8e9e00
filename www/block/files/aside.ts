/** Leaves the block in the list of projects before it is gone from the page. */
import type { Here } from '../../shared/files/leaving';
import { say } from '../../shared/text/words';
import type { BlockStore } from '../engine/engine';

export class BlockAside {
  constructor(
    private readonly store: BlockStore,
    /** Leaves the block that is shown in the list; false where it cannot be. */
    readonly putAside: () => Promise<boolean>,
  ) {}

  /**
   * Before the block is gone: one of photos that were not simulated, one with edits, and what was placed on an orthophoto stay in the list of projects, which
   * is true then. Null where it cannot, and the user keeps it.
   */
  async leave(step: string, here: Here): Promise<boolean | null> {
    const { shown, truth, history, marks, draft, placing } = this.store.state;
    // A point that is being measured is kept as it is.
    const length = history.edits.length + marks.edits.length + (draft !== null && draft.places.size > 0 ? 1 : 0);
    const isFound = shown !== null && !shown.view.partial && shown.view.oriented > 0 && truth === null;
    if (length === 0 && placing.placed.size === 0 && !isFound) return false;
    const stays = await this.putAside();
    here();
    if (stays) return true;
    const what = placing.placed.size > 0 ? say('what-was-placed-on-the') : say('the-block-of-these-photos');
    const edits = length === 0 ? what : length === 1 ? say('the-edit-by-hand-of') : say('the-edits-by-hand-of', { length });
    return window.confirm(say('cannot-be-kept-in-this', { edits, step, length: Math.max(1, length) })) ? false : null;
  }
}
