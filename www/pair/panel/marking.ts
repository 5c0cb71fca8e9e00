/** While fiducial marks are measured: which one is in hand, where it lies, and buttons for each key. */
import { button, byId, h } from '../../shared/panel/dom';
import { passFocus } from '../../shared/panel/focus';
import { showSteps, undoKeys } from '../../shared/panel/history';
import { fixed } from '../../shared/text/format';
import { say } from '../../shared/text/words';
import type { Marking } from '../state/marking';
import { nameOfMarkStep } from '../state/mark-steps';
import { markInHand, placeOfMark } from '../state/marks';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import { declareLack } from '../../shared/panel/lack';

/** Whether undo and redo by their keys are of marks: while they are measured, and where the keyboard is in their tables. */
export function marksHaveKeys({ tool }: State): boolean {
  const held = document.activeElement?.closest('[data-testid="fiducials"]') ?? null;
  return tool === 'fiducials' || held !== null;
}

/** In the bar above the pictures. */
export function mountMarking(bar: HTMLElement, store: Store, marking: Marking): void {
  const text = h('span', { testid: 'mark-text', role: 'status' });
  const former = button(say('mark-before'), 'mark-before', () => void marking.go(-1), say('the-mark-before-p'));
  const next = button(say('next-mark'), 'mark-next', () => void marking.go(1), say('the-next-mark-enter'));
  const clear = button(say('clear-mark'), 'mark-clear', () => marking.clear(), say('the-mark-is-not-measured'));
  const undo = button(say('undo-sign'), 'mark-undo', () => marking.step(-1));
  const redo = button(say('redo-sign'), 'mark-redo', () => marking.step(1));
  const end = button(say('end-marking'), 'mark-end', () => store.dispatch({ type: 'tool', tool: 'look' }));
  const buttons = h(
    'div',
    { class: 'drafting', testid: 'marking', role: 'group', aria: { label: say('fiducial-marks-measured') } },
    text,
    former,
    next,
    clear,
    undo,
    redo,
    end,
  );
  declareLack([buttons], () => (store.state.tool === 'fiducials' ? '' : say('nothing-is-measured')));
  bar.append(buttons);
  undoKeys(
    // Where the pair is what is shown.
    () => byId('view').offsetParent !== null && marksHaveKeys(store.state),
    (by) => marking.step(by),
  );
  store.watch(
    (s) => [s.tool, s.mark, s.photos, s.markSteps, s.images] as const,
    () => {
      const { state } = store;
      const held = document.activeElement;
      buttons.hidden = state.tool !== 'fiducials' || state.mark === null;
      former.disabled = state.mark === null || state.mark.index === 0;
      next.disabled = markInHand(state) === undefined;
      clear.disabled = placeInHand(state) === null;
      showSteps(undo, redo, state.markSteps, (one) => nameOfMarkStep(one, state.images));
      // Keys of the pictures go on from a button that has done its work.
      if (buttons.contains(held)) passFocus(held, [byId('view')]);
      const now = textOf(state);
      if (text.textContent !== now) text.textContent = now;
    },
  );
}

const placeInHand = (state: State) => (state.mark === null ? null : placeOfMark(state.photos[state.mark.side], markInHand(state)));

function textOf(state: State): string {
  const { mark } = state;
  if (mark === null) return '';
  const one = markInHand(state);
  const at = placeInHand(state);
  const known = one !== undefined && Number.isFinite(one.x_mm) && Number.isFinite(one.y_mm);
  const photo = known ? say('mark-at-mm', { x: fixed(one.x_mm, 3), y: fixed(one.y_mm, 3) }) : '';
  const number = mark.index + 1;
  if (at !== null) return say('mark-is-at', { number, photo, column: fixed(at[0], 2), row: fixed(at[1], 2) });
  if (one === undefined) return say('new-mark-press-it', { number, side: mark.side });
  return mark.expected === null ? say('mark-press-it', { number, photo, side: mark.side }) : say('mark-is-expected', { number, photo, side: mark.side });
}
