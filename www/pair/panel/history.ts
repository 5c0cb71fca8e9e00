/** All that was done by hand in a pair, as lists: to its matches, its masks and its fiducial marks, each of which is undone by itself. */
import { fill, h } from '../../shared/panel/dom';
import { showHistory } from '../../shared/panel/history';
import type { History } from '../../shared/state/history';
import { say } from '../../shared/text/words';
import { nameOfEdit } from '../state/edits';
import { nameOfMarkStep } from '../state/mark-steps';
import { nameOfMaskStep } from '../state/mask-steps';
import type { State } from '../state/state';
import type { Store } from '../state/store';

/** Goes to where so many steps hold. */
export interface Going {
  matches: (done: number) => void;
  masks: (done: number) => void;
  marks: (done: number) => void;
}

const PARTS = ['history', 'maskSteps', 'markSteps'] as const;

export function mountHistory(host: HTMLElement, store: Store, go: Going): void {
  const unfold = h('summary', {}, '');
  const details = h('details', { testid: 'history-section' }, unfold);
  const section = h('div', { class: 'edits' }, details);
  const lists = [
    listOf(store, '', say('matches-2'), say('as-matched'), 'history', nameOfEdit, go.matches),
    listOf(store, 'masks-', say('history-of-masks'), say('masks-as-given'), 'maskSteps', nameOfMaskStep, go.masks),
    listOf(store, 'marks-', say('history-of-marks'), say('marks-as-given'), 'markSteps', nameOfMarkStep, go.marks),
  ];
  details.append(...lists.map(({ element }) => element));
  host.append(section);
  store.watch(PARTS, (histories) => {
    const counts = histories.map(({ edits }) => edits.length);
    const edits = counts.reduce((sum, count) => sum + count, 0);
    section.hidden = edits === 0;
    fill(unfold, say('history-2', { edits }));
    lists.forEach(({ element, title }, i) => {
      element.hidden = counts[i] === 0;
      // Matches by themselves need no name.
      title.hidden = edits === counts[0];
    });
  });
}

/** The list of one kind under its name; `first`: what there was before all of its steps. */
function listOf<K extends (typeof PARTS)[number]>(
  store: Store,
  prefix: string,
  name: string,
  first: string,
  part: K,
  nameOf: (step: State[K]['edits'][number], images: State['images']) => string,
  go: (done: number) => void,
): { element: HTMLElement; title: HTMLElement } {
  const list = h('ol', { class: 'history', testid: `${prefix}history`, aria: { label: name } });
  store.watch([part, 'images'], ([history, images]) =>
    showHistory(list, prefix, first, history as History<State[K]['edits'][number]>, (step) => nameOf(step, images), go),
  );
  const title = h('p', { class: 'group-label' }, name);
  return { element: h('div', {}, title, list), title };
}
