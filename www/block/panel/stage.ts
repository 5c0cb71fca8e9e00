/** The middle of the block's page: its picture or its matrix, and what is said of what is pointed at or chosen. */
import { button, fill, h } from '../../shared/panel/dom';
import { zoomButtons } from '../../shared/panel/zoom';
import { count } from '../../shared/text/format';
import type { BlockStore } from '../engine/engine';
import type { Looking } from '../view/looking';
import { Matrix } from '../view/matrix';
import { Picture } from '../view/picture';
import { isBusy } from '../state/state';
import type { Choice } from '../state/state';
import type { BlockView, Layout } from '../state/view';
import { describe, matchesOf } from '../state/words';

const LAYOUTS: Readonly<Record<Layout['kind'], string>> = {
  oriented: 'Oriented positions, from above',
  recorded: 'GNSS positions, from above',
  connections: 'Arranged by connections: positions have no meaning',
};

/** What the invitation offers. */
export interface Invitation {
  /** Photographs a block and runs it. */
  sample: () => void;
  /** Asks for images. */
  open: () => void;
}

export function mountStage(host: HTMLElement, store: BlockStore, looking: Omit<Looking, 'point'>, invitation: Invitation): void {
  const pictureHost = h('div', {
    class: 'view block-view',
    id: 'block-view',
    testid: 'block-picture',
    tabindex: 0,
    role: 'group',
    aria: {
      roledescription: 'plan of the block',
      label: 'Images of the block, joined by lines whose width grows with their common points',
      describedby: 'block-keys',
    },
  });
  const matrixHost = h('div', {
    class: 'view block-matrix',
    testid: 'block-matrix',
    tabindex: 0,
    hidden: true,
    role: 'group',
    aria: { roledescription: 'matrix of matches', label: 'Images by images; arrow keys choose a pair', describedby: 'block-keys' },
  });
  const pointed = h('p', { class: 'pointed', testid: 'block-pointed' });
  const chosen = h('p', { class: 'chosen', testid: 'block-chosen', role: 'status', aria: { live: 'polite' } });
  const open = button('Open this pair', 'block-open-pair', () => {
    const { choice } = store.state;
    if (choice?.kind === 'pair') looking.open(choice.images);
  });
  const hint = 'Point at an image, a line or a cell to see what it is and why a pair is not connected.';
  let pointedAt: Choice | null = null;
  const showPointed = () => {
    say(pointed, store, pointedAt, hint);
    // What is chosen is said already.
    if (pointed.textContent === chosen.textContent) pointed.textContent = '';
  };
  const looks = {
    ...looking,
    point: (choice: Choice | null) => {
      pointedAt = choice;
      showPointed();
    },
  };
  const picture = new Picture(pictureHost, store, looks);
  const matrix = new Matrix(matrixHost, store, looks);
  const layout = h('span', { class: 'note', testid: 'block-layout' });
  const cells = h('span', { class: 'note', testid: 'block-cells', hidden: true });
  const switched = switcher([
    ['Picture', pictureHost, layout],
    ['Matrix', matrixHost, cells],
  ]);
  const tools = h('div', { class: 'actions' }, ...zoomButtons('block-', 'Whole block', () => (matrixHost.hidden ? picture : matrix)));
  host.append(
    h('div', { class: 'toolbar', role: 'toolbar', aria: { label: 'View of the block' } }, switched.element, tools, layout, cells),
    welcomed(pictureHost, store, invitation),
    matrixHost,
    h('div', { class: 'said' }, h('div', {}, chosen, pointed), open),
    h(
      'p',
      { class: 'keys', id: 'block-keys' },
      'Press an image, a line or a cell to choose it; press a pair again, or Enter, to open it. Drag pans · wheel and + − zoom · 0 fit. Picture: N P images · C pairs of an image · arrows pan. Matrix: arrows choose.',
    ),
  );
  looks.point(null);
  // The invitation lies over the picture.
  store.watch(['shown'], ([shown]) => {
    if (shown === null) switched.show(0);
  });
  store.watch(['choice', 'shown', 'running', 'notice'], ([choice, shown]) => {
    say(chosen, store, choice, '');
    showPointed();
    open.hidden = choice?.kind !== 'pair' || shown === null;
    open.disabled = isBusy(store.state);
    fill(layout, shown === null ? '' : legend(shown.view));
    fill(cells, shown === null ? '' : cellLegend(shown.view));
  });
}

function mostMatches({ connections }: BlockView): number {
  return connections.reduce((high, connection) => Math.max(high, matchesOf(connection)), 0);
}

/** What cells mean. */
function cellLegend(view: BlockView): string {
  return `Strongest cell: ${count(mostMatches(view))} matches. Small square: not connected. Blank: not tried.`;
}

/** What places and lines mean. */
function legend(view: BlockView): string {
  const most = view.connections.reduce((high, { shared }) => Math.max(high, shared), 0);
  const matches = mostMatches(view);
  const widest = most > 0 ? `${count(most)} common points` : `${count(matches)} matches`;
  return `${LAYOUTS[view.layout.kind]}. ${most + matches > 0 ? `Widest line: ${widest}.` : ''}`;
}

function say(element: HTMLElement, store: BlockStore, choice: Choice | null, otherwise: string): void {
  const { shown } = store.state;
  const text = choice === null || shown === null ? otherwise : describe(shown.view, choice);
  if (element.textContent !== text) element.textContent = text;
}

/** Buttons of which one is pressed: its part is shown, with the tools that belong to it. */
function switcher(parts: readonly (readonly [string, HTMLElement, HTMLElement])[]): { element: HTMLElement; show: (part: number) => void } {
  const buttons = parts.map(([name], i) => button(name, `block-show-${name.toLowerCase()}`, () => show(i)));
  const show = (shown: number) => {
    parts.forEach(([, part, tools], i) => {
      part.hidden = i !== shown;
      tools.hidden = i !== shown;
      buttons[i]?.setAttribute('aria-pressed', String(i === shown));
    });
  };
  return { element: h('div', { class: 'mode', role: 'group', aria: { label: 'Shown' } }, ...buttons), show };
}

/** The picture with the invitation over it while there is no block. */
function welcomed(host: HTMLElement, store: BlockStore, { sample, open }: Invitation): HTMLElement {
  const own = button('Open your photos …', 'block-open-first', open);
  own.className = 'primary';
  const simulate = button('Try a sample block', 'block-simulate-first', sample);
  const list = h('p', { class: 'note', testid: 'block-given' });
  const gains = [
    'where each photo was taken and how it was turned',
    'points that several photos show, in space, and how precise they are',
    'a plain word on whether the result can be trusted, and why',
    'files for other programs: COLMAP, MicMac, OpenSfM, Agisoft and more',
  ];
  const welcome = h(
    'div',
    { class: 'welcome', testid: 'block-welcome' },
    h('h2', {}, 'Where did each photo stand?'),
    h('p', {}, 'Drop the photographs of a flight or of a walk around something, or a folder of them, anywhere on this page. You get:'),
    h('ul', {}, ...gains.map((gain) => h('li', {}, gain))),
    h('p', { class: 'buttons' }, own, simulate),
    list,
    h(
      'p',
      { class: 'note' },
      'Nothing leaves this computer. Work is kept in this browser: a run that was cancelled, or ended with its tab, goes on from there.',
    ),
  );
  host.append(welcome);
  store.watch(['shown', 'files', 'running', 'notice', 'catalogue'], ([shown, given, , , catalogue]) => {
    welcome.hidden = shown !== null;
    for (const press of [own, simulate]) press.disabled = catalogue === null || isBusy(store.state);
    const names = given.map(({ name }) => name);
    fill(list, names.length === 0 ? '' : `${String(names.length)} images: ${names.slice(0, 8).join(', ')}${names.length > 8 ? ' …' : ''}`);
  });
  return host;
}
