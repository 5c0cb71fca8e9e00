/** A control for every parameter the crate names: label, unit, range and help come from there. */
import type { Parameter, Settings } from '../engine/wasm';
import type { Store } from '../state/store';
import { button, fill, h } from './dom';
import { unusedBecause } from './relevance';
import { readSetting, withSetting } from './settings';
import type { SettingValue } from './settings';

const GROUPS: Readonly<Record<string, string>> = {
  points: 'Points',
  window: 'Moments',
  matching: 'Matching',
  orientation: 'Relative orientation',
};

/** Beyond this many steps, or this range of a real number, a slider is too coarse to be of use. */
const SLIDER_STEPS = 200;
const WIDEST_SLIDER = 20;

interface Control {
  parameter: Parameter;
  element: HTMLElement;
  show: (settings: Settings) => void;
}

/** Fills the settings panel once the crate's catalogue is there. */
export function mountControls(host: HTMLElement, store: Store): void {
  store.watch((s) => [s.catalogue] as const, ([catalogue]) => {
    if (catalogue === null) return;
    const controls = catalogue.parameters.map((parameter) => makeControl(parameter, store));
    const groups = Object.entries(GROUPS).map(([group, title]) =>
      h('fieldset', { class: 'group' }, h('legend', {}, title),
        ...controls.filter(({ parameter }) => parameter.key.startsWith(`${group}.`)).map(({ element }) => element)));
    const reset = button("Reset to the paper's values", 'reset-settings', () => {
      const { settings, truth } = store.state;
      // The base belongs to the sample, as its camera does: without it its by and bz have another scale than the truth.
      const kept = truth === null || settings === null ? catalogue.defaults.orientation : { ...catalogue.defaults.orientation, base_mm: settings.orientation.base_mm };
      store.dispatch({ type: 'settings', settings: { ...catalogue.defaults, orientation: kept } });
    });
    fill(host, ...groups, reset);
    store.watch((s) => [s.settings] as const, ([settings]) => {
      if (settings !== null) for (const control of controls) control.show(settings);
    });
  });
}

function makeControl(parameter: Parameter, store: Store): Control {
  const id = `p-${parameter.key.replace('.', '-')}`;
  const set = (value: SettingValue) => {
    const { settings } = store.state;
    if (settings !== null) store.dispatch({ type: 'settings', settings: withSetting(settings, parameter.key, value) });
  };
  const field = makeField(parameter, id, set, store);
  const help = h('p', { class: 'help', id: `${id}-help`, hidden: true }, parameter.help);
  const problem = h('p', { class: 'field-problem', id: `${id}-problem`, role: 'alert' });
  const unused = h('p', { class: 'unused' });
  const reset = button('↺', `reset-${parameter.key}`, () => {
    const { catalogue } = store.state;
    if (catalogue !== null) set(readSetting(catalogue.defaults, parameter.key));
  }, 'Default');
  reset.className = 'icon';
  reset.setAttribute('aria-label', `${parameter.label}: default`);
  const flag = parameter.kind === 'flag';
  const element = h('div', { class: 'control' },
    h('div', { class: 'control-head' },
      ...(flag ? field.elements : []), h('label', { for: id }, parameter.label, parameter.unit === '' ? null : h('span', { class: 'unit' }, ` ${parameter.unit}`)),
      reset, helpButton(parameter, help)),
    ...(flag ? [] : field.elements), problem, unused, help);
  const show = (settings: Settings) => {
    const value = readSetting(settings, parameter.key);
    const defaults = store.state.catalogue?.defaults;
    field.show(value);
    problem.textContent = '';
    reset.hidden = defaults === undefined || readSetting(defaults, parameter.key) === value;
    const reason = unusedBecause(parameter.key, settings);
    unused.textContent = reason ?? '';
    element.classList.toggle('is-unused', reason !== null);
  };
  field.onProblem((text) => { problem.textContent = text; });
  return { parameter, element, show };
}

function helpButton(parameter: Parameter, help: HTMLElement): HTMLButtonElement {
  const made = button('?', `help-${parameter.key}`, () => {
    help.hidden = !help.hidden;
    made.setAttribute('aria-expanded', String(!help.hidden));
  }, parameter.help);
  made.className = 'icon';
  made.setAttribute('aria-expanded', 'false');
  made.setAttribute('aria-controls', help.id);
  made.setAttribute('aria-label', `Help: ${parameter.label}`);
  return made;
}

interface Field {
  elements: HTMLElement[];
  show: (value: SettingValue) => void;
  onProblem: (tell: (text: string) => void) => void;
}

function makeField(parameter: Parameter, id: string, set: (value: SettingValue) => void, store: Store): Field {
  switch (parameter.kind) {
    case 'flag': return flagField(parameter, id, set);
    case 'choice': return choiceField(parameter, parameter.values, id, set);
    default: return numberField(parameter, id, set, store);
  }
}

function flagField(parameter: Parameter, id: string, set: (value: SettingValue) => void): Field {
  const input = h('input', { id, type: 'checkbox', key: parameter.key, aria: { describedby: `${id}-help` } });
  input.addEventListener('change', () => { set(input.checked); });
  return { elements: [input], show: (value) => { input.checked = value === true; }, onProblem: () => undefined };
}

function choiceField(parameter: Parameter, values: readonly string[], id: string, set: (value: SettingValue) => void): Field {
  const select = h('select', { id, key: parameter.key, aria: { describedby: `${id}-help` } });
  for (const value of values) select.append(new Option(choiceName(value), value));
  select.addEventListener('change', () => { set(select.value); });
  return { elements: [select], show: (value) => { select.value = String(value); }, onProblem: () => undefined };
}

const CHOICE_NAMES: Readonly<Record<string, string>> = {
  ground1: 'Ground 1', ground2: 'Ground 2', forstner: 'Förstner', moravec: 'Moravec', dm: 'DM: moments', di: 'DI: invariants',
  maxabs: 'larger magnitude', floor: 'larger magnitude, with floor', keep: 'keep all', first: 'keep the first',
  sum: 'sum', range: 'range', unit: 'grey / 255', square: 'square', circle: 'circle', rigorous: 'rigorous', determinant: 'determinant',
};

function choiceName(value: string): string {
  return CHOICE_NAMES[value] ?? value;
}

type NumberParameter = Extract<Parameter, { kind: 'integer' | 'real' }>;

/** The step of a whole number; null where any number between is allowed. */
function stepOf(parameter: NumberParameter): number | null {
  if (parameter.kind === 'real') return null;
  return parameter.odd ? 2 : 1;
}

function rangeText(parameter: NumberParameter): string {
  const what = { 2: 'an odd number', 1: 'a whole number', any: 'a number' }[stepOf(parameter) ?? 'any'];
  return `${what ?? 'a number'} from ${String(parameter.min)} to ${String(parameter.max)}`;
}

function numberField(parameter: NumberParameter, id: string, set: (value: SettingValue) => void, store: Store): Field {
  const step = stepOf(parameter);
  const input = h('input', { id, type: 'number', key: parameter.key, aria: { describedby: `${id}-help ${id}-problem` } });
  input.inputMode = step === null ? 'decimal' : 'numeric';
  input.min = String(parameter.min);
  input.max = String(parameter.max);
  input.step = step === null ? 'any' : String(step);
  const slider = makeSlider(parameter, step);
  let tell: (text: string) => void = () => undefined;
  const optional = () => store.state.catalogue !== null && readSetting(store.state.catalogue.defaults, parameter.key) === null;
  input.addEventListener('input', () => {
    if (input.value === '' && !input.validity.badInput && optional()) {
      set(null);
      return;
    }
    if (!input.validity.valid || input.value === '') {
      input.setAttribute('aria-invalid', 'true');
      tell(`Allowed: ${rangeText(parameter)}${optional() ? ', or empty' : ''}. The last valid value stays in use.`);
      return;
    }
    set(input.valueAsNumber);
  });
  slider?.addEventListener('input', () => { set(slider.valueAsNumber); });
  const show = (value: SettingValue) => {
    input.removeAttribute('aria-invalid');
    const absent = optional() ? whenEmpty(store, parameter.key) : null;
    input.placeholder = absent === null ? '' : String(absent);
    input.title = absent === null ? '' : `Empty: ${String(absent)}`;
    if (input.value === '' || input.valueAsNumber !== value) input.value = value === null ? '' : String(value);
    const shown = value ?? absent;
    if (slider !== null) slider.value = String(typeof shown === 'number' ? shown : parameter.min);
  };
  return { elements: slider === null ? [input] : [h('div', { class: 'with-slider' }, slider, input)], show, onProblem: (listener) => { tell = listener; } };
}

/** What an empty field stands for: the operator's default, or a word. */
function whenEmpty(store: Store, key: string): number | string {
  const { catalogue, settings } = store.state;
  if (catalogue === null || settings === null) return '';
  if (key === 'orientation.base_mm') return 'from the matches';
  const defaults = catalogue.operatorDefaults[settings.points.operator];
  const value = new Map<string, number>(Object.entries(defaults).map(([field, number]) => [`points.${field}`, number as number])).get(key);
  return value === undefined || (key === 'points.threshold' && settings.points.fraction !== null) ? 'none' : value;
}

function makeSlider(parameter: NumberParameter, step: number | null): HTMLInputElement | null {
  const range = parameter.max - parameter.min;
  if (step === null ? range > WIDEST_SLIDER : range / step > SLIDER_STEPS) return null;
  const slider = h('input', { type: 'range', aria: { label: `${parameter.label}, slider` } });
  slider.min = String(parameter.min);
  slider.max = String(parameter.max);
  slider.step = String(step ?? range / 100);
  return slider;
}
