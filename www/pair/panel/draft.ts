/** While a match is measured by hand: what to do next, where its points lie, and buttons for each key. */
import { declareLack } from '../../shared/panel/lack';
import { lackOfMatches } from '../state/choice';
import { button, h } from '../../shared/panel/dom';
import { fixed } from '../../shared/text/format';
import { editOfDraft, isPredicted, placeOfDraft } from '../state/draft';
import { editedPair } from '../state/edited';
import type { Editing } from '../state/editing';
import type { Side, State } from '../state/state';
import type { Store } from '../state/store';
import { say } from '../../shared/text/words';

/** What else its buttons do. */
export interface Drafting {
  /** Shows the points that are measured. */
  follow: () => void;
  /** A measurement was begun, or given up, by its button. */
  begun: () => void;
  /** One was ended by a button that is pressed no more: the keyboard goes on in the pictures. */
  ended: () => void;
}

/** In the bar above the pictures. */
export function mountDraft(host: HTMLElement, store: Store, editing: Editing, { follow, begun, ended }: Drafting): void {
  const tool = button(
    say('add-match'),
    'tool-measure',
    () => {
      editing.toggle('measure');
      begun();
    },
    say('measure-a-match-by-hand'),
  );
  const text = h('span', { testid: 'draft-text', role: 'status' });
  const accept = button(
    say('accept'),
    'draft-accept',
    () => {
      editing.accept();
      ended();
    },
    say('the-match-is-measured-enter'),
  );
  const fit = button(say('fit'), 'draft-fit', () => void editing.fit(), say('move-the-right-point-to'));
  const exchange = button(
    say('other-image'),
    'draft-exchange',
    () => {
      editing.exchange();
      follow();
    },
    say('go-on-with-the-point'),
  );
  const cancel = button(
    say('cancel'),
    'draft-cancel',
    () => {
      editing.leave();
      ended();
    },
    say('give-this-match-up-escape'),
  );
  const bar = h(
    'div',
    { class: 'drafting', testid: 'draft', role: 'group', aria: { label: say('match-measured-by-hand') } },
    text,
    accept,
    exchange,
    fit,
    cancel,
  );
  declareLack([tool], () => lackOfMatches(store.state));
  declareLack([bar], () => (store.state.draft === null ? say('nothing-is-measured') : ''));
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
      fit.disabled = accept.disabled && !isPredicted(state);
      const now = textOf(state);
      if (text.textContent !== now) text.textContent = now;
    },
  );
}

function textOf(state: State): string {
  const { draft } = state;
  if (draft === null) return say('new-match-press-a-point');
  const place = (side: Side) => {
    const at = placeOfDraft(state, side);
    return at === null ? `${side} –` : `${side} ${fixed(at[0], 2)}, ${fixed(at[1], 2)}`;
  };
  if (isPredicted(state)) return say('px-predicted', { place: place('left'), place_2: place('right'), side: draft.side });
  const what = draft.of === null ? say('new-match') : say('moved-match');
  return say('px-place-the-point-press', { what, place: place('left'), place_2: place('right'), side: draft.side });
}
