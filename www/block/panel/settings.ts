/** What the user chooses of a run: pairs, points, recorded positions, cameras. */
import { acting_block_parameters } from '../../shared/crate';
import type { Parameter } from '../../shared/crate';
import { button, fill, h } from '../../shared/panel/dom';
import { fileButton } from '../../shared/panel/picker';
import type { Picked } from '../../shared/panel/picker';
import { makeFolded, settingsText } from '../../shared/panel/sections';
import type { Value } from '../../shared/panel/control';
import { withSetting } from '../../shared/panel/settings';
import type { BlockStore } from '../engine/engine';
import type { BlockFiles } from '../files/files';
import { problemsOf } from '../state/given';
import type { Given, GivenText } from '../state/given';
import { waitsForMarks } from '../state/marks';
import { optionsOfOwn, ownSettings, USE_GNSS } from '../state/own-settings';
import type { OwnSettings } from '../state/own-settings';
import { BLOCK_INITIAL } from '../state/state';
import { controlText } from '../state/words';
import { readable } from '../../shared/text/names';
import { say } from '../../shared/text/words';

/** The coordinate reference system of what is given. */
const SYSTEM = 'placing.crs';

/** `opener` opens the settings, and says how many were changed. */
export function mountSettings(host: HTMLElement, store: BlockStore, files: BlockFiles, opener: HTMLElement): void {
  store.watch(['catalogue'], ([catalogue]) => {
    if (catalogue === null) return;
    const defaults = ownSettings(catalogue.defaults, BLOCK_INITIAL.options.gps);
    const take = (own: object) => store.dispatch({ type: 'options', options: optionsOfOwn(own as OwnSettings) });
    const bound = {
      change: (key: string, value: Value) => {
        const { settings, gps } = store.state.options;
        if (settings !== null) take(withSetting(ownSettings(settings, gps), key, value));
      },
      defaults: () => defaults,
      refused: (parameter: Parameter) => store.dispatch({ type: 'refused', parameter }),
    };
    const sections = makeFolded([...catalogue.parameters, USE_GNSS], bound, {
      title: say('method'),
      first: ['pairs.rule', 'refinement.method', USE_GNSS.key],
      of: 'block',
      take,
      changed: (count) => fill(opener, settingsText(count)),
    });
    const [back, method, ...others] = sections.elements;
    fill(host, back ?? null, method ?? null, waiting(files), besides(store, files), ...others);
    store.watch(
      (s) => [s.options.settings, s.options.gps] as const,
      ([settings, gps]) => {
        if (settings === null) return;
        sections.show(ownSettings(settings, gps), [...acting_block_parameters(settings), USE_GNSS.key]);
        const { crs } = problemsOf(store.state);
        if (crs !== undefined) sections.controls.find(({ parameter }) => parameter.key === SYSTEM)?.refuse(readable(catalogue.labels, crs));
      },
    );
  });
}

/** Whether images that are given wait for Run. */
function waiting(files: BlockFiles): HTMLElement {
  const input = h('input', { id: 'block-wait', type: 'checkbox', testid: 'block-wait' });
  input.checked = files.waits;
  input.addEventListener('change', () => {
    files.waits = input.checked;
  });
  return h(
    'div',
    { class: 'control' },
    h('div', { class: 'control-head' }, input, h('label', { for: input.id }, say('wait-for-run'))),
    h('p', { class: 'help' }, say('images-that-are-given-wait')),
  );
}

const CAMERAS = say('from-exif-a-json-file', { example: '{"cameras": [{"images": "DJI_*.JPG", "focal_px": 3666.7}]}' });
const CONTROL = say('none-two-files-georeference-the');

/** Files that say more of the block than its images do. */
function besides(store: BlockStore, files: BlockFiles): HTMLElement {
  return h(
    'fieldset',
    { class: 'group' },
    h('legend', {}, say('files')),
    textFile(store, files, 'cameras', say('cameras'), CAMERAS, '.json,application/json'),
    textFile(store, files, 'control', say('ground-control-points'), CONTROL, '.txt,.csv,text/*'),
    textFile(store, files, 'marks', say('image-measurements'), '', '.txt,.csv,text/*'),
    textFile(store, files, 'positions', say('image-positions'), say('none-positions-of-images'), '.txt,.csv,text/*'),
    masks(store, files),
    geoid(store, files),
  );
}

const MASKS = say('none-images-of-the-same');

/** What is wrong with what was given, beside where it is given. */
function problemOf(store: BlockStore, given: Given): HTMLElement {
  const line = h('p', { class: 'field-problem', testid: `block-${given}-problem` });
  store.watch(['files', 'options', 'marks'], () => {
    const found = problemsOf(store.state)[given] ?? (given === 'control' && waitsForMarks(store.state) ? controlText(store.state) : '');
    const text = readable(store.state.catalogue?.labels ?? null, found);
    if (line.textContent !== text) line.textContent = text;
  });
  return line;
}

function masks(store: BlockStore, files: BlockFiles): HTMLElement {
  const part = besideField(
    store,
    'masks',
    say('masks'),
    { multiple: true, accept: 'image/*,.tif,.tiff,.pgm,.pnm' },
    (given) => files.beside.takeMasks(given),
    () => store.dispatch({ type: 'options', options: { masks: [] } }),
  );
  store.watch(
    (s) => [s.options.masks] as const,
    ([given]) => {
      const names = given
        .slice(0, 3)
        .map(({ name }) => name)
        .join(', ');
      part.show(
        given.length === 0 ? null : given.length === 1 ? names : say('masks-2', { given: given.length, names, what: given.length > 3 ? ' …' : '' }),
        MASKS,
      );
    },
  );
  return part.element;
}

/** A geoid is too large for text, and is read in the run. */
function geoid(store: BlockStore, files: BlockFiles): HTMLElement {
  const part = besideField(
    store,
    'geoid',
    say('geoid'),
    { accept: '.gtx,.tif,.tiff,.pgm' },
    ([file]) => {
      if (file !== undefined) files.beside.takeGeoid(file);
    },
    () => store.dispatch({ type: 'options', options: { geoid: null } }),
  );
  store.watch(
    (s) => [s.options.geoid] as const,
    ([given]) => part.show(given?.name ?? null, say('none-a-file-from-which')),
  );
  return part.element;
}

function textFile(store: BlockStore, files: BlockFiles, option: GivenText, title: string, none: string, accept: string): HTMLElement {
  const part = besideField(
    store,
    option,
    title,
    { accept },
    ([file]) => {
      if (file !== undefined) void files.beside.takeText(option, file);
    },
    () => store.dispatch({ type: 'options', options: { [option]: null } }),
  );
  store.watch(
    (s) => [s.options[option]] as const,
    ([given]) => part.show(given?.name ?? null, none),
  );
  return part.element;
}

/** A file or files beside the images: a button that asks for them, their names, what is wrong with them, and a button that takes them away. */
function besideField(
  store: BlockStore,
  given: Given,
  title: string,
  how: Pick<Picked, 'accept' | 'multiple'>,
  take: (files: File[]) => void,
  clear: () => void,
): { element: HTMLElement; show: (name: string | null, none: string) => void } {
  const [press, input] = fileButton(`${title} …`, { testid: `block-${given}`, label: say('file', { title }), ...how }, take);
  const remove = button(say('remove'), `block-${given}-remove`, clear);
  remove.setAttribute('aria-label', say('remove-2', { title }));
  const name = h('p', { class: 'note', testid: `block-${given}-name` });
  return {
    element: h('div', { class: 'control' }, h('div', { class: 'buttons' }, press, remove), name, problemOf(store, given), input),
    show: (text, none) => {
      fill(name, text ?? none);
      remove.hidden = text === null;
    },
  };
}
