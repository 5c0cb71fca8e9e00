/** The block on the screen follows the edits by hand: it is adjusted anew with those that hold. */
import { Cancelled, CallError } from '../../shared/engine/client';
import { sentence } from '../../shared/text/format';
import { editsInForce, isEditable, isSameList, nextEdits } from '../state/editing';
import type { BlockEngine, BlockStore } from './engine';
import { messageOf } from '../../shared/text/messages';

/** So often a worker that broke down is asked again. */
const MOST_FAILURES = 1;

export class EditFollower {
  private busy = false;
  /** After a refusal of several edits together: each is tried by itself. */
  private singly = false;
  private failures = 0;

  constructor(
    private readonly store: BlockStore,
    private readonly engine: BlockEngine,
  ) {
    store.watch(['history', 'shown', 'running'], () => void this.follow());
  }

  private async follow(): Promise<void> {
    if (this.busy) return;
    this.busy = true;
    while (await this.step());
    this.busy = false;
    if (this.store.state.adjusting) this.store.dispatch({ type: 'adjusting', adjusting: false });
  }

  /** Makes the next adjustment; false where there is none to be made. */
  private async step(): Promise<boolean> {
    const { history, shown } = this.store.state;
    const wanted = editsInForce(history);
    if (!isEditable(this.store.state) || shown === null || isSameList(wanted, shown.edits)) return false;
    const { edits, several } = nextEdits(history, shown.edits, this.singly);
    if (!this.store.state.adjusting) this.store.dispatch({ type: 'adjusting', adjusting: true });
    try {
      const view = await this.engine.edited(edits);
      this.failures = 0;
      if (edits.length === wanted.length) this.singly = false;
      // Another block may have come meanwhile.
      if (this.store.state.shown?.found === shown.found) this.store.dispatch({ type: 'edited', view, edits });
      return true;
    } catch (error) {
      if (this.store.state.shown?.found !== shown.found) return true;
      return this.failed(error, several && !this.singly);
    }
  }

  private failed(error: unknown, several: boolean): boolean {
    if (error instanceof Cancelled) return false;
    const broke = error instanceof CallError && error.ended;
    if (broke && this.failures < MOST_FAILURES) {
      this.failures += 1;
      return true;
    }
    this.failures = 0;
    this.singly = several;
    if (!several) this.store.dispatch({ type: 'editRefused', reason: sentence(messageOf(error)) });
    return true;
  }
}
