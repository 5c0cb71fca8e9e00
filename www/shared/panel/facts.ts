/** Figures that explain themselves: a press on a name shows what the figure is. */
import { button, h } from './dom';

export interface Fact {
  name: string;
  testid: string;
  value: string;
  /** What the figure is and what to read from it. */
  help: string;
  kind?: 'problem';
}

/** Names whose explanation is open: kept, since the panels are built anew with each result. */
const open = new Set<string>();

export function facts(list: readonly Fact[]): HTMLElement {
  return h(
    'dl',
    { class: 'facts' },
    ...list.flatMap(({ name, testid, value, help, kind }) => {
      const text = h('dd', { class: 'help', id: `${testid}-help`, hidden: !open.has(testid) }, help);
      const press = button(
        name,
        `${testid}-name`,
        () => {
          text.hidden = !text.hidden;
          if (text.hidden) open.delete(testid);
          else open.add(testid);
          press.setAttribute('aria-expanded', String(!text.hidden));
        },
        help,
      );
      press.className = 'explained';
      press.setAttribute('aria-expanded', String(!text.hidden));
      press.setAttribute('aria-controls', text.id);
      return [h('dt', {}, press), h('dd', { testid, class: kind ?? '' }, value), text];
    }),
  );
}
