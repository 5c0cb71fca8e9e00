/** What a user does to matches, whatever was pressed for it. */
import { editOfChoice, keysOfLefts, toggled } from './choice';
import { begun, editOfDraft, moving, placed, placeOfDraft, withoutPlace } from './draft';
import { editedPair, leftsByTarget } from './edited';
import { keyOfTarget } from './edits';
import { leftIndexOf } from './selected';
import type { Position } from '../../shared/state/pane';
import { otherSide } from './state';
import type { Draft, Selection, Side, Tool } from './state';
import type { Store } from './store';
import { say } from '../../shared/text/words';

/** Finds the place in the right image near a given one by least squares; null where there is none. */
export type Fitter = (left: Position, right: Position) => Promise<Position | null>;

export class Editing {
  constructor(
    private readonly store: Store,
    private readonly fitter: Fitter,
  ) {}

  /** Rejects or restores what is chosen; nothing where there is nothing of it. */
  edit(kind: 'reject' | 'restore'): void {
    const edit = editOfChoice(this.store.state, kind);
    if (edit !== null) this.store.dispatch({ type: 'edit', edit });
  }

  /** Takes edits back, or makes them again; of a match that is measured the point that was placed last, which comes before any edit. */
  step(by: 1 | -1): void {
    const { draft } = this.store.state;
    if (draft !== null) {
      if (by < 0) this.withoutPlace(draft);
      return;
    }
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

  /** Takes up a tool, or puts it away where it is in use. Without matches there is nothing to be done with any. */
  toggle(tool: Tool): void {
    const { state } = this.store;
    const next = state.tool === tool || editedPair(state) === null ? 'look' : tool;
    if (next !== state.tool) this.store.dispatch({ type: 'tool', tool: next });
  }

  /** Measures the match of the selected point anew. */
  move(): void {
    const draft = moving(this.store.state);
    if (draft === null) return;
    this.store.dispatch({ type: 'tool', tool: 'measure' });
    this.store.dispatch({ type: 'draft', draft });
  }

  /** Places a point of the match that is measured; the first one begins it. */
  place(side: Side, at: Position): void {
    const { state } = this.store;
    const { draft } = state;
    this.store.dispatch({ type: 'draft', draft: draft === null ? begun(state, side, at) : placed(state, draft, side, at) });
  }

  /** Moves the point that is placed now. */
  nudge(dx: number, dy: number): void {
    const { draft } = this.store.state;
    const at = draft === null ? null : placeOfDraft(this.store.state, draft.side);
    if (draft !== null && at !== null) this.place(draft.side, [at[0] + dx, at[1] + dy]);
  }

  /** Goes on in the other image. */
  exchange(): void {
    const { state } = this.store;
    const { draft } = state;
    if (draft === null) return;
    this.store.dispatch({ type: 'draft', draft: { ...draft, side: otherSide(draft.side) } });
  }

  /** Finds the right place by least squares, near where it is. */
  async fit(): Promise<void> {
    const { state } = this.store;
    const { draft } = state;
    const [left, right] = [placeOfDraft(state, 'left'), placeOfDraft(state, 'right')];
    if (draft === null || left === null || right === null) return;
    const found = await this.fitter(left, right);
    // Meanwhile something else may be measured, or elsewhere; who has gone on to the other image waits for it there.
    const now = this.store.state.draft;
    if (now === null || now.of !== draft.of || now.places !== draft.places) return;
    if (found !== null) this.store.dispatch({ type: 'draft', draft: placed(state, placed(state, now, 'left', left), 'right', found) });
    const text = say('least-squares-matching-confirms-no');
    this.store.dispatch({ type: 'notice', notice: found === null ? { kind: 'info', text } : null });
  }

  /** The match is measured: it becomes an edit, and is selected. */
  accept(): void {
    const edit = editOfDraft(this.store.state);
    if (edit === null || (edit.kind !== 'add' && edit.kind !== 'move')) return;
    this.store.dispatch({ type: 'edit', edit });
    this.store.dispatch(edit.kind === 'add' ? { type: 'draft', draft: null } : { type: 'tool', tool: 'look' });
    const edited = editedPair(this.store.state);
    const left = edited === null ? undefined : leftsByTarget(edited).get(keyOfTarget(edit.kind === 'add' ? edit.id : edit.of));
    if (left !== undefined) this.store.dispatch({ type: 'select', selection: { side: 'left', index: left } });
  }

  /** Ends what was begun last: the match that is measured, the area that is outlined, the tool, the choice; false where nothing was. */
  leave(): boolean {
    const { tool, chosen, draft, outline } = this.store.state;
    if (draft !== null && draft.of === null) this.store.dispatch({ type: 'draft', draft: null });
    else if (outline !== null) this.store.dispatch({ type: 'outline', outline: null });
    else if (tool !== 'look') this.store.dispatch({ type: 'tool', tool: 'look' });
    else if (chosen.length > 0) this.chooseNone();
    else return false;
    return true;
  }

  private withoutPlace(draft: Draft): void {
    // One that was there is measured no more.
    if (draft.of === null) this.store.dispatch({ type: 'draft', draft: withoutPlace(draft) });
    else this.leave();
  }

  private chooseAll(keys: readonly string[]): void {
    if (keys.length > 0) this.store.dispatch({ type: 'choose', chosen: toggled(this.store.state.chosen, keys) });
  }
}
