/** The middle of the block's page: one of its views, and what is said of what is pointed at or chosen. */
import { beforeSearch } from '../../shared/panel/actions';
import { button, fill, h } from '../../shared/panel/dom';
import { drawerButton } from '../../shared/panel/drawers';
import { declareLack } from '../../shared/panel/lack';
import { declarePlace } from '../../shared/panel/reach';
import { zoomButtons } from '../../shared/panel/zoom';
import type { BlockStore } from '../engine/engine';
import type { Facts } from '../engine/facts';
import type { Looking } from '../view/looking';
import { gsdText } from '../view/map/frame';
import { gsdOf } from '../state/ground';
import { isBusy } from '../state/state';
import type { ViewName } from '../state/state';
import { isSame } from '../state/selection';
import type { Choice } from '../state/selection';
import { describe } from '../state/words';
import { KEYS_ID } from './view';
import type { MountedView, StageView } from './view';
import { say } from '../../shared/text/words';
import { byKeys } from '../../shared/panel/scrolled';
import { lackOfBlock, lackOfOrthophoto } from '../state/lacks';

/** What the invitation offers. */
export interface Invitation {
  /** Photographs a block and runs it. */
  sample: () => void;
  /** The same, and places the photos on the orthophoto of its scene. */
  placedSample: () => void;
  /** Asks for images. */
  open: () => void;
}

/** Gives the line over the views that what is done to a choice stands in: as high with a choice as without. */
export function mountStage(
  host: HTMLElement,
  store: BlockStore,
  looking: Looking,
  facts: Facts,
  views: readonly StageView[],
  dock: HTMLElement,
  invitation: Invitation,
): HTMLElement {
  const shelf = h('div', { class: 'views', id: 'block-view', tabindex: -1 }, invited(store, invitation));
  const tools = h('div', { class: 'view-tools' });
  const legends = h('div', { class: 'legends' });
  const line = h('div', { class: 'edit-line' }, legends);
  const keys = h('p', { class: 'keys', id: KEYS_ID });
  const mounted = new Map<ViewName, MountedView>();
  const now = () => mounted.get(store.state.onStage);
  const buttons = views.map((view) => ({
    view,
    press: button(view.title, `block-show-${view.name}`, () => store.dispatch({ type: 'stage', view: view.name })),
  }));
  const switched = h('div', { class: 'mode', role: 'group', aria: { label: say('view-2') } }, ...buttons.map(({ press }) => press));
  const zoom = h(
    'div',
    { class: 'actions' },
    ...zoomButtons('block-', say('whole-block'), () => ({ fit: () => now()?.zoomable.fit(), zoomMiddle: (factor) => now()?.zoomable.zoomMiddle(factor) })),
  );
  // The link that skips to the view, and the way back from a pair, lead here.
  shelf.addEventListener('focus', () => now()?.element.focus());
  host.append(
    h(
      'div',
      { class: 'toolbar', role: 'toolbar', aria: { label: say('view-of-the-block') } },
      switched,
      drawerButton('table', say('table-2'), 'block-table', dock),
      zoom,
      tools,
    ),
    line,
    shelf,
    said(store, looking, facts),
    dock,
    keys,
  );
  const lacksBlock = () => lackOfBlock(store.state);
  declareLack([line], lacksBlock);
  /** `isShown`: now. */
  const make = ({ name, title, mount }: StageView, isShown: boolean) => {
    if (mounted.has(name)) return;
    const made = mount(store, looking);
    mounted.set(name, made);
    const parts = partsOf(made);
    for (const part of parts) part.hidden = !isShown;
    declarePlace(parts, { title, show: () => store.dispatch({ type: 'stage', view: name }) });
    // Images are placed on an orthophoto without a block, too.
    declareLack(parts, name === 'orthophoto' ? () => lackOfOrthophoto(store.state) : lacksBlock);
    shelf.append(made.element);
    tools.append(...made.tools);
    if (made.legend !== undefined) legends.append(made.legend);
  };
  store.watch(['onStage'], ([onStage]) => {
    const wanted = views.find(({ name }) => name === onStage) ?? views[0];
    if (wanted === undefined) return;
    for (const { view, press } of buttons) press.setAttribute('aria-pressed', String(view === wanted));
    make(wanted, true);
    for (const [name, view] of mounted) for (const part of partsOf(view)) part.hidden = name !== wanted.name;
    fill(keys, mounted.get(wanted.name)?.keys ?? '');
  });
  // What views that were never shown offer is found too.
  beforeSearch(() => {
    for (const view of views) make(view, false);
  });
  return line;
}

/** What is seen while a view is shown. */
const partsOf = ({ element, tools, legend }: MountedView): readonly HTMLElement[] => [element, ...tools, ...(legend === undefined ? [] : [legend])];

/** The line that says what is chosen, and what is pointed at. */
function said(store: BlockStore, looking: Looking, facts: Facts): HTMLElement {
  const pointedAt = h('p', { class: 'pointed', testid: 'block-pointed' });
  const chosenNow = h('p', { class: 'chosen', testid: 'block-chosen', role: 'status', aria: { live: 'polite' } });
  const open = button(say('open-this-pair'), 'block-open-pair', () => {
    const { chosen } = store.state.selection;
    if (chosen?.kind === 'pair') looking.open(chosen.images);
  });
  const describeNow = () => {
    const { selection, onStage } = store.state;
    const { chosen, pointed } = selection;
    tell(chosenNow, store, facts, chosen, '');
    // Plots have neither lines nor cells of pairs.
    tell(pointedAt, store, facts, pointed, onStage === 'plots' ? '' : say('point-at-an-image-a'));
    // What is chosen is said already.
    if (pointed !== null && isSame(pointed, chosen)) pointedAt.textContent = '';
  };
  // What the ground says comes later.
  facts.watch(describeNow);
  store.watch(['selection', 'shown', 'running', 'notice', 'placing', 'onStage'], ([{ chosen }, shown]) => {
    describeNow();
    open.hidden = chosen?.kind !== 'pair' || shown === null;
    open.disabled = isBusy(store.state);
  });
  const text = h('div', {}, chosenNow, pointedAt);
  const line = h('div', { class: 'said' }, text, open);
  // On a narrow screen long texts are scrolled.
  const sized = new ResizeObserver(() => byKeys(line));
  for (const element of [text, line]) sized.observe(element);
  return line;
}

function tell(element: HTMLElement, store: BlockStore, facts: Facts, choice: Choice | null, otherwise: string): void {
  const { shown } = store.state;
  const gsd = choice?.kind === 'image' && shown !== null ? gsdOf(shown.view, facts.ground(), choice.image) : null;
  const text = choice === null || shown === null ? otherwise : describe(shown, choice, gsd === null ? '' : gsdText(gsd));
  if (element.textContent !== text) element.textContent = text;
}

/** The invitation, which lies over the views while there is no block. */
function invited(store: BlockStore, { sample, placedSample, open }: Invitation): HTMLElement {
  const own = button(say('open-your-photos'), 'block-open-first', open);
  const simulate = button(say('try-a-sample-block'), 'block-simulate-first', sample);
  const placed = button(say('try-a-sample-orthophoto'), 'block-place-first', placedSample);
  const list = h('p', { class: 'note', testid: 'block-given' });
  const gains = [
    say('where-each-photo-was-taken'),
    say('points-that-several-photos-show'),
    say('a-plain-word-on-whether'),
    say('files-for-other-programs-colmap'),
  ];
  const welcome = h(
    'div',
    { class: 'welcome', testid: 'block-welcome' },
    h('h2', {}, say('where-did-each-photo-stand')),
    h('p', {}, say('drop-the-photographs-of-a')),
    h('ul', {}, ...gains.map((gain) => h('li', {}, gain))),
    h('p', { class: 'buttons' }, own, simulate, placed),
    list,
    h('p', { class: 'note' }, say('nothing-leaves-this-computer-work')),
  );
  store.watch(['shown', 'files', 'running', 'notice', 'catalogue', 'onStage', 'placing'], ([shown, given, , , catalogue, onStage, placing]) => {
    welcome.hidden = shown !== null || onStage === 'orthophoto';
    for (const press of [own, simulate, placed]) press.disabled = catalogue === null || isBusy(store.state);
    const names = given.map(({ name }) => name);
    // Photos that are there are to be run.
    own.classList.toggle('primary', names.length < 2);
    const there = say('images-3', { names: names.length, join: names.slice(0, 8).join(', '), what: names.length > 8 ? ' …' : '' });
    const onOrthophoto = placing.placed.size;
    fill(list, names.length === 0 ? '' : onOrthophoto === 0 ? there : `${there} ${say('are-placed-on-the-orthophoto', { placed: onOrthophoto })}`);
  });
  return welcome;
}
