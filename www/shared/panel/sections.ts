/** A control for each parameter, under the headings that the crate gives them. */
import type { Parameter } from '../crate';
import { save } from '../files/save';
import { sentence } from '../text/format';
import { makeControl } from './control';
import type { Control, Value } from './control';
import { button, fill, h } from './dom';
import { isOpen, setDrawer, watchDrawers } from './drawers';
import { readOwn, writeOwn } from './own';
import type { Subject } from './own';
import { fileButton } from './picker';
import { readSetting } from './settings';
import { say } from '../text/words';
import { messageOf } from '../text/messages';

/** What the controls read and change. */
export interface Bound {
  change: (key: string, value: Value) => void;
  defaults: () => object;
  /** The settings as they act, where absent ones follow from others. */
  resolved?: () => object;
  /** Told of which parameter a field holds a value that is not allowed and not used. */
  refused?: (parameter: Parameter) => void;
}

export interface Sections {
  controls: readonly Control[];
  elements: readonly HTMLElement[];
  /** Shows values; only those of `acting` where that is given. */
  show: (settings: object, acting?: readonly string[]) => void;
}

/** Which settings stand first; the others unfold under their headings. */
export interface Folding {
  title: string;
  first: readonly string[];
  /** What the settings are of. */
  of: Subject;
  /** Takes all of them anew. */
  take: (settings: object) => void;
  /** Told how many differ from their defaults. */
  changed: (count: number) => void;
}

export function makeSections(parameters: readonly Parameter[], bound: Bound): Sections {
  const controls = parameters.map((parameter) => controlOf(parameter, bound));
  const groups = groupsOf(controls, (title, elements) => h('fieldset', { class: 'group' }, h('legend', {}, title), ...elements));
  const show = (settings: object, acting?: readonly string[]) => showAll(controls, groups, settings, acting);
  return { controls, elements: groups.map(({ element }) => element), show };
}

/** The same with few settings in sight, the number of those that were changed, and one button that sets all back. */
export function makeFolded(parameters: readonly Parameter[], bound: Bound, { title, first, of, take, changed }: Folding): Sections {
  const controls = parameters.map((parameter) => controlOf(parameter, bound));
  const ahead = controls.filter(({ parameter }) => first.includes(parameter.key));
  const folds: HTMLDetailsElement[] = [];
  const groups = groupsOf(
    controls.filter((control) => !ahead.includes(control)),
    (name, elements) => {
      const fold = h('details', { class: 'group' }, h('summary', {}, name, ' ', h('span', { class: 'changed' })), ...elements);
      folds.push(fold);
      return fold;
    },
  );
  const number = h('span', { testid: `${of}-changed-settings` });
  const back = h(
    'p',
    { class: 'buttons' },
    number,
    button(say('set-all-back'), `${of}-reset-settings`, () => take(bound.defaults())),
  );
  const unfold = button('', `${of}-all-settings`, () => setDrawer('all-settings', !isOpen('all-settings')));
  let unfolded: boolean | null = null;
  watchDrawers(() => {
    if (unfolded === isOpen('all-settings')) return;
    unfolded = isOpen('all-settings');
    for (const fold of folds) fold.open = unfolded;
    unfold.textContent = unfolded ? say('fold-all') : say('unfold-all');
  });
  let now = bound.defaults();
  const files = settingsFiles(of, parameters, bound, () => now, take);
  const show = (settings: object, acting?: readonly string[]) => {
    now = settings;
    showAll(controls, groups, settings, acting);
    const all = controls.filter(({ element }) => element.classList.contains('is-changed')).length;
    for (const { own, element } of groups) {
      const here = own.filter((control) => control.element.classList.contains('is-changed')).length;
      fill(element.querySelector('.changed') ?? element, here === 0 ? '' : say('changed', { here }));
    }
    back.hidden = all === 0;
    number.textContent = all === 1 ? say('n-1-setting-differs-from-its') : say('settings-differ-from-their-defaults', { all });
    changed(all);
  };
  const top = h('fieldset', { class: 'group' }, h('legend', {}, title), ...ahead.map(({ element }) => element));
  return { controls, elements: [back, top, h('p', { class: 'buttons folds' }, unfold), ...groups.map(({ element }) => element), files], show };
}

/** Saves the settings that were changed, and takes them from a file. */
function settingsFiles(of: Subject, parameters: readonly Parameter[], { defaults }: Bound, now: () => object, take: (settings: object) => void): HTMLElement {
  const problem = h('p', { class: 'field-problem', role: 'alert', testid: `${of}-settings-problem` });
  const write = () => save(new Blob([writeOwn(of, parameters, defaults(), now())], { type: 'application/json' }), `tiepoint-${of}-settings.json`);
  const read = async ([file]: File[]) => {
    problem.textContent = '';
    try {
      if (file !== undefined) take(readOwn(await file.text(), of, parameters, defaults()));
    } catch (error) {
      problem.textContent = sentence(messageOf(error));
    }
  };
  const [load, input] = fileButton(
    say('load'),
    { testid: `${of}-settings-load`, label: say('settings-of-a-as-a', { of }), accept: '.json,application/json' },
    (files) => void read(files),
    say('takes-settings-that-were-saved'),
  );
  const give = button(say('save'), `${of}-settings-save`, write, say('saves-what-differs-from-the'));
  return h('fieldset', { class: 'group' }, h('legend', {}, say('settings-as-a-file')), h('div', { class: 'buttons' }, give, load, input), problem);
}

/** What a button says that opens settings. */
export function settingsText(changed: number): string {
  return changed === 0 ? say('settings') : say('settings-2', { changed });
}

function controlOf(parameter: Parameter, { change, defaults, resolved, refused }: Bound): Control {
  return makeControl(parameter, {
    set: (value) => change(parameter.key, value),
    standard: () => readSetting(defaults(), parameter.key),
    whenEmpty: () => (resolved === undefined ? null : readSetting(resolved(), parameter.key)),
    refused: () => refused?.(parameter),
  });
}

interface Group {
  own: readonly Control[];
  element: HTMLElement;
}

function groupsOf(controls: readonly Control[], made: (title: string, elements: HTMLElement[]) => HTMLElement): Group[] {
  return [...new Set(controls.map(({ parameter }) => parameter.section))].map((section) => {
    const own = controls.filter(({ parameter }) => parameter.section === section);
    return {
      own,
      element: made(
        section,
        own.map(({ element }) => element),
      ),
    };
  });
}

function showAll(controls: readonly Control[], groups: readonly Group[], settings: object, acting: readonly string[] | undefined): void {
  const used = ({ parameter }: Control) => acting === undefined || acting.includes(parameter.key);
  for (const control of controls) {
    control.show(readSetting(settings, control.parameter.key));
    control.element.hidden = !used(control);
  }
  for (const { own, element } of groups) element.hidden = !own.some(used);
}
