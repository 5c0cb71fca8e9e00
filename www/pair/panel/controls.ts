/** The settings of the run: a control for each, in the order of the pipeline; those without effect under the others are left out. */
import type { Catalogue, Settings } from '../../shared/crate';
import { comparesGradients } from '../state/keys';
import type { Store } from '../state/store';
import { choiceName, makeControl } from '../../shared/panel/control';
import type { Control, Value } from '../../shared/panel/control';
import { button, fill, h } from '../../shared/panel/dom';
import { isUsed } from './relevance';
import { readSetting, withSetting } from './settings';

const GROUPS: Readonly<Record<string, string>> = {
  points: 'Points',
  multiscale: 'Points of many scales',
  window: 'Moments',
  gradient: 'Gradient descriptors',
  matching: 'Matching',
  geometry: 'Geometry of the two views',
  orientation: 'Relative orientation',
};

/** Fills the settings panel once the crate's catalogue is there. */
export function mountControls(host: HTMLElement, store: Store): void {
  store.watch((s) => [s.catalogue] as const, ([catalogue]) => {
    if (catalogue === null) return;
    const controls = catalogue.parameters.map((parameter) => makeControl(parameter, {
      set: (value) => { change(store, parameter.key, value); },
      standard: () => readSetting(catalogue.defaults, parameter.key),
      whenEmpty: () => whenEmpty(store, catalogue, parameter.key),
      refused: () => { store.dispatch({ type: 'refused', part: 'settings', label: parameter.label }); },
    }));
    const groups = Object.entries(GROUPS).map(([group, title]) => {
      const own = controls.filter(({ parameter }) => parameter.key.startsWith(`${group}.`));
      return { own, element: h('fieldset', { class: 'group' }, h('legend', {}, title), ...own.map(({ element }) => element)) };
    });
    const reset = button("Reset to the paper's values", 'reset-settings', () => { resetAll(store, catalogue); });
    fill(host, ...groups.map(({ element }) => element), reset);
    store.watch((s) => [s.settings] as const, ([settings]) => {
      if (settings === null) return;
      const used = ({ parameter }: Control) => isUsed(parameter.key, settings);
      for (const control of controls) {
        control.show(readSetting(settings, control.parameter.key));
        control.element.hidden = !used(control);
      }
      for (const { own, element } of groups) element.hidden = !own.some(used);
    });
  });
}

function change(store: Store, key: string, value: Value): void {
  const { settings, catalogue } = store.state;
  if (settings === null || catalogue === null) return;
  const changed = withSetting(settings, key, value);
  const operator = key === 'matching.strategy' ? usualOperator(settings, changed, catalogue) : null;
  store.dispatch({ type: 'settings', settings: operator === null ? changed : withSetting(changed, 'points.operator', operator) });
  if (operator === null) return;
  const name = choiceName(operator);
  const text = `The operator is now “${name}”, as is usual with this strategy; any other can be chosen under “Points”.`;
  store.dispatch({ type: 'notice', notice: { kind: 'info', text } });
}

/** Gradients describe points of many scales: the operator that goes with a newly chosen strategy; null where it stays. */
function usualOperator(before: Settings, after: Settings, { defaults }: Catalogue): Settings['points']['operator'] | null {
  const usual = (settings: Settings) => (comparesGradients(settings) ? 'multiscale' : defaults.points.operator);
  const { operator } = before.points;
  return operator === usual(before) && operator !== usual(after) ? usual(after) : null;
}

function resetAll(store: Store, { defaults }: Catalogue): void {
  const { settings, truth } = store.state;
  // The base belongs to the simulated pair, as its camera does: without it its by and bz have another scale than the truth.
  const orientation = truth === null || settings === null ? defaults.orientation : { ...defaults.orientation, base_mm: settings.orientation.base_mm };
  store.dispatch({ type: 'settings', settings: { ...defaults, orientation } });
}

/** What an empty field stands for: the operator's default, or a word. */
function whenEmpty(store: Store, catalogue: Catalogue, key: string): number | string {
  const { settings } = store.state;
  if (settings === null) return '';
  if (key === 'orientation.base_mm') return 'from the matches';
  if (key === 'orientation.sigma0_mm') return 'estimated';
  if (key === 'geometry.threshold_px') return 'from the matches';
  if (key === 'matching.ambiguity') return catalogue.ambiguityDefaults[settings.matching.strategy];
  const defaults = catalogue.operatorDefaults[settings.points.operator];
  const value = new Map<string, number>(Object.entries(defaults).map(([field, number]) => [`points.${field}`, number as number])).get(key);
  return value === undefined || (key === 'points.threshold' && settings.points.fraction !== null) ? 'none' : value;
}
