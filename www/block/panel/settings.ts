/** What the user chooses of a run: pairs, points, recorded positions, cameras. */
import { makeControl } from '../../shared/panel/control';
import type { Value } from '../../shared/panel/control';
import { button, fill, h } from '../../shared/panel/dom';
import type { BlockSettings, Parameter } from '../../../pkg/wasm/tiepoint.js';
import type { BlockStore } from '../engine/engine';
import type { BlockFiles } from '../files/files';
import { problemsOf } from '../state/given';
import type { Given, GivenText } from '../state/given';

type Groups = Record<string, Record<string, Value | undefined>>;

/** Groups of parameters, by the first part of their keys. */
const GROUPS: readonly (readonly [string, string])[] = [['pairs', 'Pairs'], ['multiscale', 'Features'], ['selection', 'Points'], ['refinement', 'Refinement of rays'], ['block', 'Multi-ray points'], ['placing', 'Exactness of positions']];

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
      refused: () => { store.dispatch({ type: 'refused', label: parameter.label }); },
    }));
    const groups = GROUPS.map(([group, title]) => {
      const own = controls.filter(({ parameter }) => parameter.key.startsWith(`${group}.`));
      return h('fieldset', { class: 'group' }, h('legend', {}, title), ...own.map(({ element }) => element));
    });
    fill(host, positions(store), ...groups, besides(store, files));
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

const CAMERAS = 'From EXIF. A JSON file says it better: {"cameras": [{"images": "DJI_*.JPG", "focal_px": 3666.7}]}, with principal_point_px, radial, tangential, fixed where known.';
const CONTROL = 'None. Two files place the block by surveyed points: lines of name, x, y, z and perhaps two standard errors, and lines of image, point, column, row.';

/** Files that say more of the block than its images do. */
function besides(store: BlockStore, files: BlockFiles): HTMLElement {
  return h('fieldset', { class: 'group' }, h('legend', {}, 'Files'),
    textFile(store, files, 'cameras', 'Cameras', CAMERAS, '.json,application/json'),
    textFile(store, files, 'control', 'Control points', CONTROL, '.txt,.csv,text/*'),
    textFile(store, files, 'marks', 'Their marks in images', '', '.txt,.csv,text/*'),
    masks(store, files));
}

const MASKS = 'None. Images of the same size, black where no features are wanted; IMG_1.png, IMG_1_mask.png or IMG_1.jpg.png is the mask of IMG_1.jpg.';

/** What is wrong with what was given, beside where it is given. */
function problemOf(store: BlockStore, given: Given): HTMLElement {
  const line = h('p', { class: 'field-problem', testid: `block-${given}-problem` });
  store.watch((s) => [s.files, s.options] as const, () => {
    const text = problemsOf(store.state)[given] ?? '';
    if (line.textContent !== text) line.textContent = text;
  });
  return line;
}

function masks(store: BlockStore, files: BlockFiles): HTMLElement {
  const input = h('input', { type: 'file', class: 'visually-hidden', tabindex: -1, testid: 'block-masks-input', aria: { label: 'Files: Masks' } });
  input.accept = 'image/*,.tif,.tiff,.pgm,.pnm';
  input.multiple = true;
  input.addEventListener('change', () => {
    const given = [...(input.files ?? [])];
    if (given.length > 0) files.takeMasks(given);
    input.value = '';
  });
  const name = h('p', { class: 'note', testid: 'block-masks-name' });
  const remove = button('Remove', 'block-masks-remove', () => { store.dispatch({ type: 'options', options: { masks: [] } }); });
  remove.setAttribute('aria-label', 'Remove: Masks');
  store.watch((s) => [s.options.masks] as const, ([given]) => {
    fill(name, given.length === 0 ? MASKS : given.length === 1 ? (given[0]?.name ?? '') : `${String(given.length)} masks: ${given.slice(0, 3).map((mask) => mask.name).join(', ')}${given.length > 3 ? ' …' : ''}`);
    remove.hidden = given.length === 0;
  });
  return h('div', { class: 'control' }, h('div', { class: 'buttons' }, button('Masks …', 'block-masks', () => { input.click(); }), remove), name, problemOf(store, 'masks'), input);
}

function textFile(store: BlockStore, files: BlockFiles, option: GivenText, title: string, none: string, accept: string): HTMLElement {
  const input = h('input', { type: 'file', class: 'visually-hidden', tabindex: -1, testid: `block-${option}-input`, aria: { label: `File: ${title}` } });
  input.accept = accept;
  input.addEventListener('change', () => {
    const file = input.files?.[0];
    if (file !== undefined) void files.takeText(option, file);
    input.value = '';
  });
  const name = h('p', { class: 'note', testid: `block-${option}-name` });
  const remove = button('Remove', `block-${option}-remove`, () => { store.dispatch({ type: 'options', options: { [option]: null } }); });
  remove.setAttribute('aria-label', `Remove: ${title}`);
  store.watch((s) => [s.options[option]] as const, ([given]) => {
    fill(name, given?.name ?? none);
    remove.hidden = given === null;
  });
  return h('div', { class: 'control' }, h('div', { class: 'buttons' }, button(`${title} …`, `block-${option}`, () => { input.click(); }), remove), name, problemOf(store, option), input);
}
