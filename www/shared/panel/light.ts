/** The sliders of brightness and contrast over pictures. Layers of pictures and of loupes are changed (`view.css`), what is drawn over them is not. */
import { isOwnLight, OWN_LIGHT } from '../state/light';
import type { Light } from '../state/light';
import { say } from '../text/words';
import { button, h } from './dom';
import { passFocus } from './focus';
import { declareLack } from './lack';

/** A slider goes from the one share to the other in even steps of their ratio. */
const MOST = 3;

/**
 * `prefix` of the test ids; `host` shows the pictures. `show` shows the light that holds, with a mark on `presses`, the buttons that unfold the sliders, by their
 * labels: pictures that are not as their files have them are known as such while the sliders are folded.
 */
export function makeLight(
  prefix: string,
  host: HTMLElement,
  set: (light: Partial<Light>) => void,
  presses: readonly (readonly [press: HTMLElement, label: string])[],
): { elements: HTMLElement[]; show: (light: Light) => void } {
  const brightness = slider(say('brightness'), `${prefix}brightness`, (share) => set({ brightness: share }));
  const contrast = slider(say('contrast'), `${prefix}contrast`, (share) => set({ contrast: share }));
  const reset = button(say('light-reset'), `${prefix}light-reset`, () => {
    set(OWN_LIGHT);
    passFocus(reset, [brightness.input]);
  });
  reset.title = say('light-reset-title');
  declareLack([reset], () => (reset.disabled ? say('nothing-is-changed') : ''));
  return {
    elements: [brightness.element, contrast.element, reset],
    show: (light) => {
      brightness.show(light.brightness);
      contrast.show(light.contrast);
      reset.disabled = isOwnLight(light);
      for (const [press, label] of presses) markChanged(press, label, light);
      host.style.setProperty('--light', isOwnLight(light) ? 'none' : `brightness(${String(light.brightness)}) contrast(${String(light.contrast)})`);
    },
  };
}

function markChanged(press: HTMLElement, label: string, light: Light): void {
  const text = isOwnLight(light) ? label : say('light-changed', { label, brightness: percentOf(light.brightness), contrast: percentOf(light.contrast) });
  press.classList.toggle('has-own-light', !isOwnLight(light));
  press.title = text;
  press.setAttribute('aria-label', text);
}

const percentOf = (share: number): number => Math.round(100 * share);

function slider(
  label: string,
  testid: string,
  onChange: (share: number) => void,
): { element: HTMLElement; input: HTMLInputElement; show: (share: number) => void } {
  const input = h('input', { type: 'range', testid });
  Object.assign(input, { min: '-1', max: '1', step: '0.05', value: '0' });
  input.addEventListener('input', () => onChange(MOST ** Number(input.value)));
  input.addEventListener('dblclick', () => onChange(1));
  const show = (share: number) => {
    input.value = String(Math.log(share) / Math.log(MOST));
    input.setAttribute('aria-valuetext', say('light-percent', { percent: percentOf(share) }));
  };
  return { element: h('label', { class: 'choice' }, h('span', {}, label), input), input, show };
}
