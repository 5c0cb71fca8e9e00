/** The settings of the run: a control for each, in the order of the pipeline; those without effect under the others are hidden. */
import { acting_parameters, resolved } from '../../shared/crate';
import type { Catalogue, Parameter, Settings } from '../../shared/crate';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import type { Value } from '../../shared/panel/control';
import { makePresets } from './presets';
import { fill } from '../../shared/panel/dom';
import { whenQuiet } from '../../shared/engine/breath';
import { makeFolded, settingsText } from '../../shared/panel/sections';
import { withSetting } from '../../shared/panel/settings';
import { say } from '../../shared/text/words';

/** Fills the settings panel once the crate's catalogue is there; `opener` opens it, and says how many settings were changed. */
export function mountControls(host: HTMLElement, store: Store, opener: HTMLElement): void {
  store.watch(['catalogue'], ([catalogue]) => {
    if (catalogue !== null) whenQuiet(() => show(catalogue));
  });
  // Some hundred fields: who starts the page waits for none of them.
  function show(catalogue: Catalogue): void {
    let acts: Settings = resolved(catalogue.defaults);
    const bound = {
      change: (key: string, value: Value) => change(store, key, value),
      defaults: () => standardOf(store.state, catalogue),
      resolved: () => acts,
      refused: ({ label }: Parameter) => store.dispatch({ type: 'refused', part: 'settings', label }),
    };
    const { elements, show: showValues } = makeFolded(catalogue.parameters, bound, {
      title: say('method'),
      first: ['matching.strategy', 'matching.refine'],
      of: 'pair',
      take: (settings) => store.dispatch({ type: 'settings', settings: settings as Settings }),
      changed: (count) => fill(opener, settingsText(count)),
    });
    const presets = makePresets(catalogue.presets, (settings) => store.dispatch({ type: 'settings', settings }));
    fill(host, presets.element, ...elements);
    store.watch(['settings', 'truth'], ([settings]) => {
      if (settings === null) return;
      acts = resolved(settings);
      showValues(settings, acting_parameters(settings));
      presets.show(settings, standardOf(store.state, catalogue));
    });
  }
}

/** A threshold and a fraction of candidates exclude each other: setting one clears the other. */
const EXCLUSIVE: Readonly<Record<string, string>> = { 'points.threshold': 'points.fraction', 'points.fraction': 'points.threshold' };

/** A threshold is in the unit of its operator: that of another one, the default too, means nothing to it. */
const OF_ANOTHER: Readonly<Record<string, string>> = { 'points.operator': 'points.threshold' };

function change(store: Store, key: string, value: Value): void {
  const { settings } = store.state;
  if (settings === null) return;
  const other = OF_ANOTHER[key] ?? (value === null ? undefined : EXCLUSIVE[key]);
  const free = other === undefined ? settings : withSetting(settings, other, null);
  store.dispatch({ type: 'settings', settings: withSetting(free, key, value) });
}

/** The defaults. The base belongs to the simulated pair, as its camera does: without it by and bz would have another scale than the truth. */
function standardOf({ truth }: State, { defaults }: Catalogue): Settings {
  return truth === null ? defaults : { ...defaults, orientation: { ...defaults.orientation, base_mm: truth.baseMm === 0 ? null : truth.baseMm } };
}
