/** What is given for images on an orthophoto: its files, its heights, near which place images were taken, and how they are placed. */
import type { Value } from '../../shared/panel/control';
import { button, fill, h } from '../../shared/panel/dom';
import { numberInput, problemLine } from '../../shared/panel/numberfield';
import { fileButton } from '../../shared/panel/picker';
import { makeSections } from '../../shared/panel/sections';
import { withSetting } from '../../shared/panel/settings';
import type { BlockStore } from '../engine/engine';
import { filmFields } from './film-settings';
import type { BlockFiles } from '../files/files';
import { orthophotoText } from '../files/ground';
import { unitOfOrthophoto } from '../state/orthophoto-unit';
import { isLookedAtAlone } from '../state/placing';
import type { Placing, Purpose } from '../state/placing';
import { purposeOf } from '../state/purpose';
import { isBusy } from '../state/state';
import { message } from '../../shared/text/messages';
import { say } from '../../shared/text/words';
import { fixed } from '../../shared/text/format';
import { unitText, withUnit } from '../../shared/text/units';
import { declareLack } from '../../shared/panel/lack';
import { lackOfOrthophoto } from '../state/lacks';

const ORTHOPHOTO = say('none-a-geotiff-in-a');
const HEIGHTS = say('none-the-ground-is-level');

/** What asks for files from elsewhere. */
export interface PlacingPickers {
  orthophoto: () => void;
  heights: () => void;
}

/** `measureMarks`: of scans of film. */
export function mountPlacingSettings(host: HTMLElement, store: BlockStore, files: BlockFiles, measureMarks: () => void): PlacingPickers {
  const accept = 'image/*,.tif,.tiff,.tfw,.jgw,.pgw,.wld,.prj,.asc,.txt';
  const [orthophoto, orthophotoInput] = fileButton(
    say('orthophoto-2'),
    { testid: 'block-orthophoto', label: say('file-orthophoto'), multiple: true, accept },
    (given) => void files.takeGround(given),
  );
  const [heights, heightsInput] = fileButton(
    say('heights'),
    { testid: 'block-heights', label: say('file-heights'), multiple: true, accept: '.tif,.tiff,.asc,.txt,.tfw,.wld,.prj,image/tiff' },
    (given) => void files.takeGround(given, true),
  );
  declareLack([heights], () => lackOfOrthophoto(store.state));
  const remove = button(say('remove'), 'block-orthophoto-remove', () => store.dispatch({ type: 'orthophoto', orthophoto: null }));
  remove.setAttribute('aria-label', say('remove-orthophoto'));
  const name = h('p', { class: 'note', testid: 'block-orthophoto-name' });
  const model = h('p', { class: 'note', testid: 'block-heights-name' });
  const [level, problem] = levelField(store, files);
  const given = h(
    'fieldset',
    { class: 'group' },
    h('legend', {}, say('orthophoto')),
    h('div', { class: 'control' }, h('div', { class: 'buttons' }, orthophoto, remove), name, orthophotoInput),
    h('div', { class: 'control' }, h('div', { class: 'buttons' }, heights), model, heightsInput, level, problem),
    purposeField(store),
  );
  store.watch(['placing', 'running', 'notice'], ([placing]) => {
    const busy = isBusy(store.state);
    orthophoto.disabled = busy;
    remove.hidden = placing.orthophoto === null;
    remove.disabled = busy;
    heights.disabled = busy || placing.orthophoto === null;
    fill(name, placing.orthophoto === null ? ORTHOPHOTO : orthophotoText(placing.orthophoto));
    const [from, to] = placing.orthophoto?.info.heights ?? [];
    const unit = unitText(unitOfOrthophoto(placing.orthophoto));
    fill(model, heightsText(placing, from, to, unit));
  });
  store.watch(['catalogue'], ([catalogue]) => {
    if (catalogue === null) return;
    const sections = makeSections(catalogue.placingParameters, {
      change: (key: string, value: Value) => {
        const { options } = store.state.placing;
        if (options !== null) store.dispatch({ type: 'placingOptions', options: withSetting({ placing: options }, key, value).placing });
      },
      defaults: () => ({ placing: catalogue.placing }),
      refused: (parameter) => store.dispatch({ type: 'refused', parameter }),
    });
    fill(host, given, filmFields(store, files, measureMarks), ...sections.elements);
    store.watch(
      (s) => [s.placing.options] as const,
      ([options]) => {
        if (options !== null) sections.show({ placing: options });
      },
    );
  });
  return { orthophoto: () => orthophotoInput.click(), heights: () => heightsInput.click() };
}

function heightsText({ heights, orthophoto }: Placing, from: number | undefined, to: number | undefined, unit: string): string {
  if (heights.kind === 'model') return say('from-to', { name: heights.model.name, from, to, unit });
  if (heights.by !== 'block') return HEIGHTS;
  return `${HEIGHTS} ${say('level-of-block', { height: withUnit(fixed(heights.height, 1), unitOfOrthophoto(orthophoto)) })}`;
}

const PURPOSES: readonly (readonly [Purpose, string])[] = [
  ['block', say('purpose-block')],
  ['images', say('purpose-images')],
  ['map', say('purpose-map')],
];

/** What is done with the orthophoto. */
function purposeField(store: BlockStore): HTMLElement {
  const select = h('select', { id: 'orthophoto-purpose', testid: 'orthophoto-purpose' });
  // Nothing is chosen as long as the user is to say it.
  fill(select, new Option('–', ''), ...PURPOSES.map(([purpose, text]) => new Option(text, purpose)));
  select.addEventListener('change', () => {
    const purpose = PURPOSES.find(([own]) => own === select.value)?.[0];
    if (purpose !== undefined) store.dispatch({ type: 'purpose', purpose });
  });
  store.watch(['placing', 'files', 'shown', 'running', 'notice'], ([{ orthophoto }]) => {
    select.disabled = orthophoto === null || isLookedAtAlone(orthophoto) || orthophoto.ofBlock !== null || isBusy(store.state);
    select.value = purposeOf(store.state) ?? '';
  });
  return h('div', { class: 'control compact' }, h('label', { for: select.id }, say('what-is-done-with-it')), select);
}

/** One height for level ground. */
function levelField(store: BlockStore, files: BlockFiles): [HTMLElement, HTMLElement] {
  const problem = problemLine('block-level');
  const unit = h('span', { class: 'unit' });
  const input = numberInput('block-level', problem, () => {
    const { valueAsNumber: height } = input;
    const allowed = store.state.catalogue?.levelParameter;
    if (allowed?.kind !== 'real') return;
    const isHeight = height >= allowed.min && height <= allowed.max;
    problem.textContent = isHeight ? '' : say('allowed-the-last-valid-value', { parameter: message('allowed', allowed), what: '' });
    if (isHeight) void files.takeLevel(height);
  });
  store.watch(
    (s) => [s.placing.heights, s.placing.orthophoto] as const,
    ([heights, orthophoto]) => {
      input.disabled = orthophoto === null;
      if (document.activeElement !== input) input.value = heights.kind === 'level' ? String(heights.height) : '';
      unit.textContent = ` ${unitText(unitOfOrthophoto(orthophoto))}`;
    },
  );
  const label = h('label', { for: input.id }, say('level-ground-at'), unit);
  return [h('div', { class: 'control compact' }, label, input), problem];
}
