/** What this program is, and whose work is in it. */
import { LICENCES } from 'virtual:licences';
import { button, h } from './dom';
import { say } from '../text/words';

/** `name`: of the program, with its version. */
export function aboutDialog(name: string): HTMLDialogElement {
  const heading = h('h2', { id: 'about-heading' }, name);
  const dialog = h('dialog', { class: 'dialog', testid: 'about-dialog', aria: { labelledby: heading.id } });
  const holds = LICENCES.map(({ name: of, version, licence, text }) =>
    h('details', { class: 'group', testid: `licence-${of}` }, h('summary', {}, `${of} ${version} (${licence})`), h('pre', { class: 'licence' }, text)),
  );
  const close = button(say('close-2'), 'about-close', () => dialog.close());
  dialog.append(
    h('div', { class: 'dialog-head' }, heading, close),
    h('p', {}, say('matches-and-orients-overlapping-photographs')),
    h('h3', {}, say('the-page-holds')),
    ...holds,
  );
  return dialog;
}
