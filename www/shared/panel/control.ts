/** A control for a parameter that the crate names: label, unit, range and help come from there. */
import type { Parameter } from '../crate';
import { button, h } from './dom';
import { message } from '../text/messages';
import { say } from '../text/words';

export type Value = number | string | boolean | null;

/** What a control reads and changes. */
export interface Binding {
  set: (value: Value) => void;
  /** The default; null where an empty field is one. */
  standard: () => Value;
  /** The value that an empty field stands for; null where there is no single one. */
  whenEmpty: () => Value;
  /** Told that the field holds a value that is not allowed and not used. */
  refused?: () => void;
}

export interface Control {
  parameter: Parameter;
  element: HTMLElement;
  show: (value: Value) => void;
  /** Says that the value shown is not allowed beside the others. */
  refuse: (text: string) => void;
}

/** Beyond this many steps, or this range of a real number, a slider is too coarse to be of use. */
const SLIDER_STEPS = 200;
const WIDEST_SLIDER = 20;

export function makeControl(parameter: Parameter, binding: Binding): Control {
  const id = `p-${parameter.key.replace('.', '-')}`;
  const field = makeField(parameter, id, binding);
  const help = h('p', { class: 'help', id: `${id}-help`, hidden: true }, parameter.help);
  const problem = h('p', { class: 'field-problem', id: `${id}-problem`, role: 'alert' });
  const reset = button('↺', `reset-${parameter.key}`, () => binding.set(binding.standard()), say('default'));
  reset.className = 'icon';
  reset.setAttribute('aria-label', say('default-2', { label: parameter.label }));
  const flag = parameter.kind === 'flag';
  const element = h(
    'div',
    { class: 'control' },
    h(
      'div',
      { class: 'control-head' },
      ...(flag ? field.elements : []),
      h('label', { for: id }, parameter.label, parameter.unit === '' ? null : h('span', { class: 'unit' }, ` ${parameter.unit}`)),
      reset,
      helpButton(parameter, help),
    ),
    ...(flag ? [] : field.elements),
    problem,
    help,
  );
  const show = (value: Value) => {
    field.show(value);
    problem.textContent = '';
    const changed = binding.standard() !== value;
    reset.hidden = !changed;
    element.classList.toggle('is-changed', changed);
  };
  field.onProblem((text) => {
    problem.textContent = text;
    binding.refused?.();
  });
  const refuse = (text: string) => {
    problem.textContent = text;
    element.querySelector(`[id="${id}"]`)?.setAttribute('aria-invalid', 'true');
  };
  return { parameter, element, show, refuse };
}

function helpButton(parameter: Parameter, help: HTMLElement): HTMLButtonElement {
  const made = button(
    '?',
    `help-${parameter.key}`,
    () => {
      help.hidden = !help.hidden;
      made.setAttribute('aria-expanded', String(!help.hidden));
    },
    parameter.help,
  );
  made.className = 'icon';
  made.setAttribute('aria-expanded', 'false');
  made.setAttribute('aria-controls', help.id);
  made.setAttribute('aria-label', say('help', { label: parameter.label }));
  return made;
}

interface Field {
  elements: HTMLElement[];
  show: (value: Value) => void;
  onProblem: (tell: (text: string) => void) => void;
}

function makeField(parameter: Parameter, id: string, binding: Binding): Field {
  const { key } = parameter;
  switch (parameter.kind) {
    case 'flag':
      return flagField(parameter, id, binding);
    case 'choice':
      return choiceField(parameter, id, binding);
    case 'integer':
    case 'real':
      return numberField(parameter, id, binding);
    default:
      return textField(key, id, binding);
  }
}

/** Words, which the check of the settings reads; none where it is empty. */
function textField(key: string, id: string, { set }: Binding): Field {
  const input = h('input', { id, type: 'text', key, aria: { describedby: `${id}-help ${id}-problem` } });
  // Codes keep their direction among words from right to left.
  input.dir = 'ltr';
  input.spellcheck = false;
  input.addEventListener('change', () => set(input.value.trim() || null));
  const show = (value: Value) => {
    input.removeAttribute('aria-invalid');
    input.value = String(value ?? '');
  };
  return { elements: [input], show, onProblem: () => undefined };
}

function flagField(parameter: Parameter, id: string, { set }: Binding): Field {
  const input = h('input', { id, type: 'checkbox', key: parameter.key, aria: { describedby: `${id}-help` } });
  input.addEventListener('change', () => set(input.checked));
  return {
    elements: [input],
    show: (value) => {
      input.checked = value === true;
    },
    onProblem: () => undefined,
  };
}

function choiceField(parameter: ChoiceParameter, id: string, { set, standard, whenEmpty }: Binding): Field {
  const { key, values, labels, absent } = parameter;
  const select = h('select', { id, key, aria: { describedby: `${id}-help` } });
  const empty = new Option(say('default-4'), '');
  empty.title = absent;
  if (standard() === null) select.append(empty);
  values.forEach((value, i) => {
    select.append(new Option(labels[i] ?? value, value));
  });
  select.addEventListener('change', () => set(select.value === '' ? null : select.value));
  const show = (value: Value) => {
    const meant = labels[values.indexOf(String(whenEmpty()))];
    empty.text = meant === undefined ? say('default-4') : say('default-3', { meant });
    select.value = String(value ?? '');
  };
  return { elements: [select], show, onProblem: () => undefined };
}

type ChoiceParameter = Extract<Parameter, { kind: 'choice' }>;
type NumberParameter = Extract<Parameter, { kind: 'integer' | 'real' }>;

/** The step of a whole number; null where any number between is allowed. */
function stepOf(parameter: NumberParameter): number | null {
  if (parameter.kind === 'real') return null;
  return parameter.odd ? 2 : 1;
}

function numberField(parameter: NumberParameter, id: string, { set, standard, whenEmpty }: Binding): Field {
  const step = stepOf(parameter);
  const input = h('input', { id, type: 'number', key: parameter.key, aria: { describedby: `${id}-help ${id}-problem` } });
  input.inputMode = step === null ? 'decimal' : 'numeric';
  input.min = String(parameter.min);
  input.max = String(parameter.max);
  input.step = step === null ? 'any' : String(step);
  const slider = makeSlider(parameter, step);
  let tell: (text: string) => void = () => undefined;
  const optional = () => standard() === null;
  input.addEventListener('input', () => {
    if (input.value === '' && !input.validity.badInput && optional()) {
      set(null);
      return;
    }
    if (!input.validity.valid || input.value === '') {
      input.setAttribute('aria-invalid', 'true');
      tell(say('allowed-the-last-valid-value', { parameter: message('allowed', parameter), what: optional() ? say('or-empty') : '' }));
      return;
    }
    set(input.valueAsNumber);
  });
  slider?.addEventListener('input', () => set(slider.valueAsNumber));
  const show = (value: Value) => {
    input.removeAttribute('aria-invalid');
    const absent = optional() ? whenEmpty() : null;
    input.placeholder = optional() ? String(absent ?? say('default-4')) : '';
    input.title = optional() ? say('empty', { absent: absent ?? parameter.absent }) : '';
    if (input.value === '' || input.valueAsNumber !== value) input.value = value === null ? '' : String(value);
    const shown = value ?? absent;
    if (slider !== null) slider.value = String(typeof shown === 'number' ? shown : parameter.min);
  };
  return {
    elements: slider === null ? [input] : [h('div', { class: 'with-slider' }, slider, input)],
    show,
    onProblem: (listener) => {
      tell = listener;
    },
  };
}

function makeSlider(parameter: NumberParameter, step: number | null): HTMLInputElement | null {
  const range = parameter.max - parameter.min;
  if (step === null ? range > WIDEST_SLIDER : range / step > SLIDER_STEPS) return null;
  const slider = h('input', { type: 'range', aria: { label: say('slider', { label: parameter.label }) } });
  slider.min = String(parameter.min);
  slider.max = String(parameter.max);
  slider.step = String(step ?? range / 100);
  return slider;
}
