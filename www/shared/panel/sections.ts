/** A control for each parameter, under the headings that the crate gives them. */
import type { Parameter } from '../crate';
import { makeControl } from './control';
import type { Control, Value } from './control';
import { h } from './dom';
import { readSetting } from './settings';

/** What the controls read and change. */
export interface Bound {
  change: (key: string, value: Value) => void;
  defaults: () => object;
  /** The settings as they act, where absent ones follow from others. */
  resolved?: () => object;
  /** Told the label of a field that holds a value which is not allowed and not used. */
  refused?: (label: string) => void;
}

export interface Sections {
  controls: readonly Control[];
  elements: readonly HTMLElement[];
  /** Shows values; only those of `acting` where that is given. */
  show: (settings: object, acting?: readonly string[]) => void;
}

export function makeSections(parameters: readonly Parameter[], { change, defaults, resolved, refused }: Bound): Sections {
  const controls = parameters.map((parameter) =>
    makeControl(parameter, {
      set: (value) => change(parameter.key, value),
      standard: () => readSetting(defaults(), parameter.key),
      whenEmpty: () => (resolved === undefined ? null : readSetting(resolved(), parameter.key)),
      refused: () => refused?.(parameter.label),
    }),
  );
  const groups = [...new Set(parameters.map(({ section }) => section))].map((section) => {
    const own = controls.filter(({ parameter }) => parameter.section === section);
    return { own, element: h('fieldset', { class: 'group' }, h('legend', {}, section), ...own.map(({ element }) => element)) };
  });
  const show = (settings: object, acting?: readonly string[]) => {
    const used = ({ parameter }: Control) => acting === undefined || acting.includes(parameter.key);
    for (const control of controls) {
      control.show(readSetting(settings, control.parameter.key));
      control.element.hidden = !used(control);
    }
    for (const { own, element } of groups) element.hidden = !own.some(used);
  };
  return { controls, elements: groups.map(({ element }) => element), show };
}
