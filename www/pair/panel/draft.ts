/** While a match is measured by hand: what to do next, where its points lie, and buttons for each key. */
import { button, h } from '../../shared/panel/dom';
import { fixed } from '../../shared/text/format';
import { editOfDraft, placeOfDraft } from '../state/draft';
import { editedPair } from '../state/edited';
import type { Editing } from '../state/editing';
import type { Side, State } from '../state/state';
import type { Store } from '../state/store';

/** In the bar above the pictures. `follow` shows the points that are measured. */
export function mountDraft(host: HTMLElement, store: Store, editing: Editing, follow: () => void): void {
  const tool = button('Add match', 'tool-measure', () => editing.toggle('measure'), 'Measure a match by hand (A)');
  const text = h('span', { testid: 'draft-text', role: 'status' });
  const accept = button('Accept', 'draft-accept', () => editing.accept(), 'The match is measured (Enter)');
  const fit = button('Fit', 'draft-fit', () => void editing.fit(), 'Move the right point to where least squares matching finds it (F)');
  const exchange = button(
    'Other image',
    'draft-exchange',
    () => {
      editing.exchange();
      follow();
    },
    'Go on with the point in the other image (O)',
  );
  const cancel = button('Cancel', 'draft-cancel', () => editing.leave(), 'Give this match up (Escape)');
  const bar = h('div', { class: 'drafting', testid: 'draft', role: 'group', aria: { label: 'Match measured by hand' } }, text, accept, exchange, fit, cancel);
  host.append(tool, bar);
  store.watch(
    (s) => [s.tool, s.draft, s.results, s.history, s.images] as const,
    () => {
      const { state } = store;
      tool.setAttribute('aria-pressed', String(state.tool === 'measure'));
      tool.disabled = editedPair(state) === null;
      bar.hidden = state.tool !== 'measure';
      accept.disabled = editOfDraft(state) === null;
      exchange.disabled = state.draft === null;
      fit.disabled = accept.disabled;
      const now = textOf(state);
      if (text.textContent !== now) text.textContent = now;
    },
  );
}

function textOf(state: State): string {
  const { draft } = state;
  if (draft === null) return 'New match: press a point in either picture, or Enter for the middle of the active one.';
  const place = (side: Side) => {
    const at = placeOfDraft(state, side);
    return at === null ? `${side} –` : `${side} ${fixed(at[0], 2)}, ${fixed(at[1], 2)}`;
  };
  const what = draft.of === null ? 'New match' : 'Moved match';
  return `${what}: ${place('left')} · ${place('right')} px. Place the ${draft.side} point: press, or arrows by 0.1 px, with Shift by 1 px.`;
}
