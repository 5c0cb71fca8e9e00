/** Fields for numbers that are no parameters of the crate's catalogue: what is not allowed is said, and the last valid value stays. */
import { h } from './dom';
import { say } from '../text/words';
import { unitText } from '../text/units';

export interface NumberField {
  element: HTMLElement;
  input: HTMLInputElement;
  problem: HTMLElement;
}

const STAYS = say('the-last-valid-value-stays');

/** A number input that tells what it is described by; `change` is called when a number was typed. */
export function numberInput(testid: string, problem: HTMLElement, change: () => void): HTMLInputElement {
  const input = h('input', { id: `c-${testid}`, type: 'number', testid, aria: { describedby: problem.id } });
  input.step = 'any';
  input.inputMode = 'decimal';
  input.addEventListener('change', change);
  return input;
}

/** Where the problem of a field, or of a pair of them, is said. */
export function problemLine(testid: string): HTMLElement {
  return h('p', { class: 'field-problem', id: `c-${testid}-problem`, testid: `${testid}-problem`, role: 'alert' });
}

/** A field with its label; `problem` where another line than its own says what is wrong. */
export function numberField(label: string, unit: string, testid: string, change: () => void, problem?: HTMLElement): NumberField {
  const line = problem ?? problemLine(testid);
  const input = numberInput(testid, line, change);
  const name = h('label', { for: input.id }, label, unit === '' ? null : h('span', { class: 'unit' }, ` ${unitText(unit)}`));
  return { input, problem: line, element: h('div', { class: 'control compact' }, name, input, problem === undefined ? line : null) };
}

/** The first of some fields, by its label, in which something was typed that is not allowed; null where there is none. */
export function firstRefused(fields: readonly (readonly [string, HTMLInputElement])[]): string | null {
  return fields.find(([, input]) => input.getAttribute('aria-invalid') === 'true' && typed(input) !== undefined)?.[0] ?? null;
}

/** The number typed: undefined where the field is empty, NaN where it holds no number. */
export function typed({ value, valueAsNumber, validity }: HTMLInputElement): number | undefined {
  return value === '' && !validity.badInput ? undefined : valueAsNumber;
}

function mark(input: HTMLInputElement, wrong: boolean): void {
  if (wrong) input.setAttribute('aria-invalid', 'true');
  else input.removeAttribute('aria-invalid');
}

/** Shows a number, unless the field already says the same. */
export function showNumber({ input, problem }: Pick<NumberField, 'input' | 'problem'>, value: number | null | undefined): void {
  if (value == null) input.value = '';
  else if (input.valueAsNumber !== value) input.value = String(value);
  mark(input, false);
  problem.textContent = '';
}

/** The number of a field, `last` where it is not allowed; `allowed` says what is instead of a value. */
export function readNumber({ input, problem }: NumberField, allowed: (value: number) => string | null, last: number | undefined): number | undefined {
  const value = typed(input);
  const instead = value === undefined ? null : Number.isNaN(value) ? say('a-number') : allowed(value);
  mark(input, instead !== null);
  problem.textContent = instead === null ? '' : say('allowed-or-empty', { instead, stays: STAYS });
  return instead === null ? value : last;
}

/** Two numbers that are given together: both, null where both fields are empty, undefined where they are no pair, which is then said. */
export function readPair(
  inputs: readonly [HTMLInputElement, HTMLInputElement],
  problem: HTMLElement,
  allowed: (a: number, b: number) => string | null,
): [number, number] | null | undefined {
  const [a, b] = [typed(inputs[0]), typed(inputs[1])];
  const tell = (text: string, wrong: readonly [boolean, boolean]) => {
    problem.textContent = text;
    inputs.forEach((input, i) => {
      mark(input, wrong[i] === true);
    });
  };
  if (a === undefined && b === undefined) {
    tell('', [false, false]);
    return null;
  }
  if (a === undefined || b === undefined) {
    tell(say('give-both-numbers-or-empty', { stays: STAYS }), [a === undefined, b === undefined]);
    return undefined;
  }
  const instead = Number.isNaN(a + b) ? say('two-numbers') : allowed(a, b);
  if (instead === null) {
    tell('', [false, false]);
    return [a, b];
  }
  const alone = [allowed(a, 0) !== null, allowed(0, b) !== null] as const;
  tell(say('allowed', { instead, stays: STAYS }), alone);
  return undefined;
}
