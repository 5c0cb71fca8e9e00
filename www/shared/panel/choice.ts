/** Choices in the bar over a picture. */
import { button, h } from './dom';
import { say } from '../text/words';

/** How much longer than they are residuals may be drawn; 0: not at all. */
const VECTOR_FACTORS = [0, 10, 20, 50, 100, 200, 500, 1000];

/** A list of which one is chosen, with its label; gives both. */
export function choice(
  label: string,
  testid: string,
  options: readonly (readonly [string, string])[],
  onChange: (value: string) => void,
): [HTMLElement, HTMLSelectElement] {
  const select = h('select', { testid });
  for (const [value, text] of options) select.append(new Option(text, value));
  select.addEventListener('change', () => onChange(select.value));
  return [h('label', { class: 'choice' }, h('span', {}, label), select), select];
}

/** A button that is pressed or not. */
export function toggle(label: string, testid: string, title: string, onChange: (on: boolean) => void): HTMLButtonElement {
  const made = button(label, testid, () => onChange(made.getAttribute('aria-pressed') !== 'true'), title);
  made.setAttribute('aria-pressed', 'false');
  return made;
}

/** The list of how much longer residuals are drawn. */
export function vectorChoice(testid: string, onChange: (factor: number) => void): [HTMLElement, HTMLSelectElement] {
  const factors = VECTOR_FACTORS.map((factor) => [String(factor), factor === 0 ? say('no-residuals') : `× ${String(factor)}`] as const);
  return choice(say('residuals'), testid, factors, (value) => onChange(Number(value)));
}
