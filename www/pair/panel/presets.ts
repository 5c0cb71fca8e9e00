/** Ready-made settings: chosen all at once, and named where those in force are one of them. */
import type { Catalogue, PairPreset, Settings } from '../../shared/crate';
import { fill, h } from '../../shared/panel/dom';
import { known, say } from '../../shared/text/words';

/** What can be chosen: the names of their texts. */
const TEXTS: Readonly<Record<PairPreset | 'defaults', string>> = {
  defaults: 'preset-defaults',
  'many-points': 'preset-many-points',
  'little-in-common': 'preset-little-in-common',
  'zahran-2007': 'preset-zahran-2007',
};
/** What is shown of settings that are not ready made. */
const OWN = 'own';

export interface Presets {
  element: HTMLElement;
  /** `standard`: the defaults of the pair that is there. */
  show: (settings: Settings, standard: Settings) => void;
}

export function makePresets(presets: Catalogue['presets'], take: (settings: Settings) => void): Presets {
  let offered = new Map<string, Settings>();
  const names = ['defaults' as const, ...presets.map(({ name }) => name)];
  const help = h('p', { class: 'help', id: 'preset-help', testid: 'preset-help' });
  const select = h('select', { id: 'preset', testid: 'preset', aria: { describedby: help.id } });
  const own = new Option(say('preset-own'), OWN);
  own.hidden = true;
  own.disabled = true;
  select.append(...names.map((name) => new Option(say(TEXTS[name]), name)), own);
  select.addEventListener('change', () => {
    const chosen = offered.get(select.value);
    if (chosen !== undefined) take(chosen);
  });
  const show = (settings: Settings, standard: Settings) => {
    // The base belongs to the pair, not to the method.
    const { base_mm } = standard.orientation;
    const ready = presets.map(({ name, settings: of }) => [name, { ...of, orientation: { ...of.orientation, base_mm } }] as const);
    offered = new Map<string, Settings>([['defaults', standard], ...ready]);
    const now = JSON.stringify(settings);
    const found = names.find((name) => JSON.stringify(offered.get(name)) === now);
    select.value = found ?? OWN;
    fill(help, found === undefined ? '' : (known(TEXTS[found], 'help') ?? ''));
  };
  const element = h('div', { class: 'control' }, h('div', { class: 'control-head' }, h('label', { for: 'preset' }, say('ready-made-settings'))), select, help);
  return { element, show };
}
