/** What the user chooses of a run: pairs, points, recorded positions, cameras. */
import { makeControl } from '../panel/control';
import type { Value } from '../panel/control';
import { button, fill, h } from '../panel/dom';
import type { BlockSettings, Parameter } from '../../pkg/wasm/tiepoint.js';
import type { BlockStore } from './engine';
import type { BlockFiles } from './files';

type Groups = Record<string, Record<string, Value | undefined>>;

/** Groups of parameters, by the first part of their keys. */
const GROUPS: readonly (readonly [string, string])[] = [['pairs', 'Pairs'], ['multiscale', 'Features'], ['selection', 'Points'], ['block', 'Multi-ray points']];

/** Parameters that matter for one rule of pairs alone. */
const OF_RULE: readonly string[] = ['near', 'sequence', 'alike'];

export function mountSettings(host: HTMLElement, store: BlockStore, files: BlockFiles): void {
  store.watch((s) => [s.catalogue] as const, ([catalogue]) => {
    if (catalogue === null) return;
    const { defaults } = catalogue;
    const controls = catalogue.parameters.map((parameter) => makeControl(parameter, {
      set: (value) => {
        const { settings } = store.state.options;
        if (settings !== null) store.dispatch({ type: 'options', options: { settings: withValue(settings, parameter, value) } });
      },
      standard: () => readValue(defaults, parameter),
      whenEmpty: () => 'by itself',
    }));
    const groups = GROUPS.map(([group, title]) => {
      const own = controls.filter(({ parameter }) => parameter.key.startsWith(`${group}.`));
      return h('fieldset', { class: 'group' }, h('legend', {}, title), ...own.map(({ element }) => element));
    });
    fill(host, positions(store), cameras(store, files), ...groups);
    store.watch((s) => [s.options.settings] as const, ([settings]) => {
      if (settings === null) return;
      for (const { parameter, element, show } of controls) {
        show(readValue(settings, parameter));
        const [, field = ''] = parameter.key.split('.');
        const rule = settings.pairs?.rule ?? null;
        element.hidden = OF_RULE.includes(field) && rule !== null && rule !== field;
      }
    });
  });
}

/** The group of a parameter; those of features lie a step deeper. */
function groupOf(settings: BlockSettings, { key }: Parameter): [Record<string, Value | undefined>, string, string] {
  const [group = '', field = ''] = key.split('.');
  const at = group === 'multiscale' ? settings.features : settings;
  const found = (at as unknown as Groups)[group];
  if (found === undefined) throw new Error(`there is no setting ${key}`);
  return [found, group, field];
}

function readValue(settings: BlockSettings, parameter: Parameter): Value {
  const [group, , field] = groupOf(settings, parameter);
  return group[field] ?? null;
}

function withValue(settings: BlockSettings, parameter: Parameter, value: Value): BlockSettings {
  const [before, group, field] = groupOf(settings, parameter);
  const changed = { [group]: { ...before, [field]: value } };
  const features = settings.features;
  return group === 'multiscale' && features !== undefined ? { ...settings, features: { ...features, ...changed } } : { ...settings, ...changed };
}

/** Whether recorded positions are used. */
function positions(store: BlockStore): HTMLElement {
  const input = h('input', { id: 'block-gps', type: 'checkbox', testid: 'block-gps' });
  input.addEventListener('change', () => { store.dispatch({ type: 'options', options: { gps: input.checked ? 'use' : 'ignore' } }); });
  store.watch((s) => [s.options.gps] as const, ([gps]) => { input.checked = gps === 'use'; });
  return h('div', { class: 'control' }, h('div', { class: 'control-head' }, input, h('label', { for: input.id }, 'Use recorded positions (GPS)')),
    h('p', { class: 'help' }, 'To choose near pairs, and to place the block on the earth.'));
}

/** A file of cameras in place of EXIF. */
function cameras(store: BlockStore, files: BlockFiles): HTMLElement {
  const input = h('input', { type: 'file', class: 'visually-hidden', tabindex: -1, testid: 'block-cameras-input', aria: { label: 'File of cameras' } });
  input.accept = '.json,application/json';
  input.addEventListener('change', () => {
    const file = input.files?.[0];
    if (file !== undefined) void files.takeCameras(file);
    input.value = '';
  });
  const name = h('p', { class: 'note', testid: 'block-cameras-name' });
  const remove = button('Remove', 'block-cameras-remove', () => { store.dispatch({ type: 'options', options: { cameras: null } }); });
  store.watch((s) => [s.options.cameras] as const, ([given]) => {
    fill(name, given === null ? 'From EXIF. A JSON file says it better: {"cameras": [{"images": "DJI_*.JPG", "focal_px": 3666.7}]}, with principal_point_px, radial, tangential, fixed where known.' : given.name);
    remove.hidden = given === null;
  });
  return h('fieldset', { class: 'group' }, h('legend', {}, 'Cameras'), name,
    h('div', { class: 'buttons' }, button('Cameras file …', 'block-cameras', () => { input.click(); }), remove), input);
}
