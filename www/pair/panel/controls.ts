/** The settings of the run: a control for each, in the order of the pipeline; those without effect under the others are hidden. */
import { acting_parameters, resolved } from '../../shared/crate';
import type { Catalogue, Settings } from '../../shared/crate';
import type { Store } from '../state/store';
import type { Value } from '../../shared/panel/control';
import { button, fill } from '../../shared/panel/dom';
import { makeSections } from '../../shared/panel/sections';
import { withSetting } from '../../shared/panel/settings';

/** Fills the settings panel once the crate's catalogue is there. */
export function mountControls(host: HTMLElement, store: Store): void {
  store.watch(['catalogue'], ([catalogue]) => {
    if (catalogue === null) return;
    let acts: Settings = resolved(catalogue.defaults);
    const { elements, show } = makeSections(catalogue.parameters, {
      change: (key, value) => change(store, key, value),
      defaults: () => catalogue.defaults,
      resolved: () => acts,
      refused: (label) => store.dispatch({ type: 'refused', part: 'settings', label }),
    });
    fill(
      host,
      ...elements,
      button("Reset to the paper's values", 'reset-settings', () => resetAll(store, catalogue)),
    );
    store.watch(['settings'], ([settings]) => {
      if (settings === null) return;
      acts = resolved(settings);
      show(settings, acting_parameters(settings));
    });
  });
}

/** A threshold and a fraction of candidates exclude each other: setting one clears the other. */
const EXCLUSIVE: Readonly<Record<string, string>> = { 'points.threshold': 'points.fraction', 'points.fraction': 'points.threshold' };

function change(store: Store, key: string, value: Value): void {
  const { settings } = store.state;
  if (settings === null) return;
  const other = value === null ? undefined : EXCLUSIVE[key];
  const free = other === undefined ? settings : withSetting(settings, other, null);
  store.dispatch({ type: 'settings', settings: withSetting(free, key, value) });
}

function resetAll(store: Store, { defaults }: Catalogue): void {
  const { settings, truth } = store.state;
  // The base belongs to the simulated pair, as its camera does: without it its by and bz have another scale than the truth.
  const orientation = truth === null || settings === null ? defaults.orientation : { ...defaults.orientation, base_mm: settings.orientation.base_mm };
  store.dispatch({ type: 'settings', settings: { ...defaults, orientation } });
}
