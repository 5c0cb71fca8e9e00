/** What a user does to matches, whatever was pressed for it. */
import { editOfChoice, keysOfLefts, toggled } from './choice';
import { editedPair } from './edited';
import { leftIndexOf } from './selected';
import type { Selection } from './state';
import type { Store } from './store';

export class Editing {
  constructor(private readonly store: Store) {}

  /** Rejects or restores what is chosen; nothing where there is nothing of it. */
  edit(kind: 'reject' | 'restore'): void {
    const edit = editOfChoice(this.store.state, kind);
    if (edit !== null) this.store.dispatch({ type: 'edit', edit });
  }

  /** Takes edits back, or makes them again. */
  step(by: 1 | -1): void {
    this.store.dispatch({ type: 'goto', done: this.store.state.history.done + by });
  }

  /** Chooses the match of a point beside others, or no longer. */
  choose(selection: Selection | null): void {
    const { state } = this.store;
    const edited = editedPair(state);
    if (edited === null || selection === null) return;
    const left = leftIndexOf({ selection }, edited.match.best, edited.match.rules);
    this.chooseAll(keysOfLefts(edited, left < 0 ? [] : [left]));
  }

  /** Chooses matches of left points beside others, or no longer where all of them were. */
  chooseLefts(lefts: Iterable<number>): void {
    const edited = editedPair(this.store.state);
    if (edited !== null) this.chooseAll(keysOfLefts(edited, lefts));
  }

  chooseNone(): void {
    if (this.store.state.chosen.length > 0) this.store.dispatch({ type: 'choose', chosen: [] });
  }

  private chooseAll(keys: readonly string[]): void {
    if (keys.length > 0) this.store.dispatch({ type: 'choose', chosen: toggled(this.store.state.chosen, keys) });
  }
}
