/** What this program is, and whose work is in it. */
import { button, h } from './dom';
import { say } from '../text/words';

/** `name`: of the program, with its version. */
export function aboutDialog(name: string, { CRATES, LICENCES }: typeof import('./about')): HTMLDialogElement {
  const heading = h('h2', { id: 'about-heading' }, name);
  const dialog = h('dialog', { class: 'dialog', testid: 'about-dialog', aria: { labelledby: heading.id } });
  const holds = LICENCES.map(({ name: of, version, licence, text }) => licenceOf(`licence-${of}`, `${of} ${version} (${licence})`, text));
  const crates = CRATES.crates.map(({ name: of, version, licence, text }) =>
    licenceOf(`crate-${of}-${version}`, `${of} ${version} (${licence})`, CRATES.texts[text] ?? ''),
  );
  const close = button(say('close-2'), 'about-close', () => dialog.close());
  dialog.append(
    h('div', { class: 'dialog-head' }, heading, close),
    h('p', {}, say('matches-and-orients-overlapping-photographs')),
    h('h3', {}, say('the-page-holds')),
    ...holds,
    h('h3', {}, say('its-module-holds')),
    h('details', { class: 'group', testid: 'crates' }, h('summary', {}, say('so-many-crates', { crates: crates.length })), ...crates),
  );
  return dialog;
}

function licenceOf(testid: string, title: string, text: string): HTMLElement {
  // They are English in every language of the page.
  const [name, own] = [h('bdi', {}, title), h('pre', { class: 'licence' }, text)];
  for (const part of [name, own]) Object.assign(part, { lang: 'en', dir: 'ltr' });
  return h('details', { class: 'group', testid }, h('summary', {}, name), own);
}
