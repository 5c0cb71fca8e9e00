/** Images of the block on the stage: the panes with their names and figures, their tools, and what is known of a place. */
import { choice, toggle, vectorChoice } from '../../shared/panel/choice';
import { button, fill, h } from '../../shared/panel/dom';
import { passFocus } from '../../shared/panel/focus';
import { makeLight } from '../../shared/panel/light';
import { mountMenu } from '../../shared/panel/menu';
import { labelled } from '../../shared/panel/zoom';
import { asFigure } from '../../shared/text/direction';
import { count, fixed } from '../../shared/text/format';
import type { BlockEngine, BlockStore } from '../engine/engine';
import type { Facts } from '../engine/facts';
import type { PlacingEngine } from '../engine/placing';
import type { PointDetail } from '../../../pkg/wasm/tiepoint.js';
import { groundAt, photoMm } from '../state/observed';
import { MOST_PANES, shownImages } from '../state/panes';
import type { Look } from '../state/panes';
import { isBusy } from '../state/state';
import { coordinatesText } from '../state/result-system';
import { inUnitOf } from '../state/scale';
import type { BlockView } from '../state/view';
import { describe } from '../state/words';
import { ImagesView } from '../view/images/images';
import { PlaceCrop } from '../view/images/place-crop';
import type { Looking } from '../view/looking';
import type { At, Pane } from '../view/images/scene';
import type { Measures } from './edit-bar';
import { imageLegend } from './image-legend';
import { KEYS_ID } from './view';
import type { StageView } from './view';
import { say } from '../../shared/text/words';
import { declareLack } from '../../shared/panel/lack';

const KEYS = say('press-a-point-every-image');

/** `addImages` asks for files; `ready` is given what measures points. */
export function imagesView(engine: BlockEngine, placing: PlacingEngine, facts: Facts, addImages: () => void, ready: (measures: Measures) => void): StageView {
  return {
    name: 'images',
    title: say('images-2'),
    mount: (store, looking) => {
      const host = h('div', {
        class: 'view image-panes',
        testid: 'block-panes',
        tabindex: 0,
        role: 'group',
        aria: { roledescription: say('images-of-the-block-2'), label: say('images-side-by-side-with'), describedby: KEYS_ID },
      });
      const place = h('p', { class: 'image-place', testid: 'image-place' });
      const point = h('p', { class: 'image-point', testid: 'image-point', role: 'status', aria: { live: 'polite' } });
      const element = h(
        'div',
        { class: 'images-view', tabindex: -1 },
        h('div', { class: 'image-row' }, cropOf(store, placing), h('div', { class: 'image-scroll' }, host)),
        h('div', { class: 'image-said' }, point, place),
      );
      element.addEventListener('focus', () => host.focus());
      const view = new ImagesView(host, store, looking, facts, engine);
      mountFrames(host, view, store, addImages);
      ready({
        toggle: (anew) => {
          view.measuring.toggle(anew);
          if (view.measuring.draft === null) return;
          view.opening.showDraft();
          // What is measured is placed by keys too.
          host.focus();
        },
        match: () => view.match(),
        matchAlone: () => view.matchAlone(),
      });
      view.watch(() => {
        setText(place, placeText(store, view));
        setText(point, pointText(store, view));
      });
      return { element, tools: [toolsOf(host, store, view, looking)], legend: imageLegend('image-legend', view), zoomable: view.moving, keys: KEYS };
    },
  };
}

/** The orthophoto about the place that is measured, as the first of the pictures. */
function cropOf(store: BlockStore, placing: PlacingEngine): HTMLElement {
  const picture = h('div', { class: 'view', testid: 'place-crop-picture', role: 'img', aria: { label: say('the-place-on-the-orthophoto') } });
  const crop = h('div', { class: 'place-crop', testid: 'place-crop' }, picture, h('p', { class: 'ortho-name' }, say('orthophoto')));
  crop.hidden = true;
  new PlaceCrop(crop, picture, store, placing);
  return crop;
}

function setText(element: HTMLElement, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

interface Frame {
  element: HTMLElement;
  show: (pane: Pane) => void;
}

/** The name of each image with what it says of the chosen point, over its pane. */
function mountFrames(host: HTMLElement, view: ImagesView, store: BlockStore, addImages: () => void): void {
  let frames = new Map<number, Frame>();
  let of: BlockView | null = null;
  view.watch(() => {
    const found = store.state.shown?.found ?? null;
    const panes = view.seen.panes();
    // Edits leave the images what they are, and the keyboard where it is.
    const known = found === of ? frames : new Map<number, Frame>();
    of = found;
    const next = new Map(panes.map((pane) => [pane.image, known.get(pane.image) ?? frameOf(pane.image, view, store, addImages)]));
    for (const [image, { element }] of frames) if (next.get(image)?.element !== element) element.remove();
    for (const [, { element }] of next) if (element.parentElement === null) host.append(element);
    frames = next;
    for (const pane of panes) frames.get(pane.image)?.show(pane);
  });
}

function frameOf(image: number, view: ImagesView, store: BlockStore, addImages: () => void): Frame {
  const name = h('span', {});
  const figures = h('span', { class: 'pane-figures', testid: `figures-${String(image)}` });
  const close = button('×', `close-image-${String(image)}`, () => {
    const { panes, shown } = store.state;
    if (shown !== null) store.dispatch({ type: 'showImages', images: shownImages(panes, shown.view).filter((other) => other !== image) });
    passFocus(close, [view.host]);
  });
  const absent = h('div', { class: 'pane-absent' });
  const add = button(say('add-images'), `add-image-${String(image)}`, addImages);
  add.className = 'invitation';
  const head = h('div', { class: 'pane-head' }, h('span', { class: 'pane-name' }, name), figures, close);
  const element = h('div', { class: 'pane-frame', testid: `pane-image-${String(image)}` }, head, absent);
  let said = '';
  return {
    element,
    show: (pane) => {
      const { left, top, width, height } = pane.rect;
      Object.assign(element.style, { left: `${String(left)}px`, top: `${String(top)}px`, width: `${String(width)}px`, height: `${String(height)}px` });
      const { panes, shown } = store.state;
      const own = shown?.view.images[image]?.name ?? '';
      setText(name, own);
      close.setAttribute('aria-label', say('close', { own }));
      close.hidden = shown === null || shownImages(panes, shown.view).length < 2;
      element.classList.toggle('is-active', panes.active === image);
      const figure = view.measuring.marks().has(image) ? say('measured') : figuresOf(view.seen.chosen()?.detail ?? null, image);
      setText(figures, figure);
      head.title = figure === '' ? own : `${asFigure(own)}: ${figure}`;
      const why = pane.file === null ? say('the-file-of-this-image') : view.hasFailed(pane) ? say('this-image-cannot-be-decoded') : '';
      if (why === said) return;
      said = why;
      fill(absent, ...(why === '' ? [] : [h('p', {}, why), ...(pane.file === null ? [add] : [])]));
    },
  };
}

type Part = PointDetail['observations'][number]['part'];

/** Why an observation takes no part in the adjustment. */
const PARTS: Readonly<Record<Part, string>> = {
  accepted: '',
  gross_error: say('rejected-gross-error'),
  behind: say('rejected-behind-the-image'),
  lost_point: say('rejected-its-point-has-too'),
  does_not_fit: say('rejected-does-not-fit'),
  rejected_by_hand: say('rejected-by-hand-2'),
  not_adjusted: say('not-adjusted'),
};

/** Of column and row the larger one in size. */
function largest(pair: readonly (number | null)[] | null): number | null {
  const known = pair?.filter((value) => value !== null) ?? [];
  return known.length === 0 ? null : Math.max(...known.map(Math.abs));
}

/** Residual, w and smallest detectable error of the chosen point in an image. */
function figuresOf(detail: PointDetail | null, image: number): string {
  const observation = detail?.observations.find((own) => own.image === image);
  if (observation === undefined) return detail?.elsewhere.some((other) => other.image === image) === true ? say('predicted-not-measured') : '';
  const { residual_px: residual, part, by_hand } = observation;
  const [w, mdb] = [largest(observation.w), largest(observation.detectable_px)];
  const parts = [
    residual === null ? '' : say('v-px', { residual: residual[0], residual_2: residual[1] }),
    w === null ? '' : `w ${fixed(w, 1)}`,
    mdb === null ? '' : say('mdb-px', { mdb }),
    PARTS[part],
    by_hand ? say('by-hand') : '',
  ];
  return parts.filter((part) => part !== '').join(' · ');
}

/** The point that is chosen alone, by its figures. */
function pointText({ state }: BlockStore, view: ImagesView): string {
  const chosen = view.seen.chosen();
  if (state.shown === null) return '';
  // Figures of a point come a moment later.
  if (chosen === null) return state.selection.chosen === null ? '' : describe(state.shown, state.selection.chosen);
  const { view: shown } = state.shown;
  const { id, name, position, errors, rmse_px, observations, elsewhere } = chosen.detail;
  const panes = shownImages(state.panes, shown);
  const seen = observations.filter(({ image }) => panes.includes(image)).length;
  // As its table counts them: of a point that takes part, those that do; of another one, those that would.
  const of = (...parts: readonly Part[]) => observations.filter(({ part }) => parts.includes(part)).length;
  const taking = of('accepted') || of('lost_point', 'rejected_by_hand') || observations.length;
  const rejected = observations.length - taking;
  const [worst] = observations.map(({ image, w }) => ({ image, w: largest(w) ?? 0 })).sort((a, b) => b.w - a.w);
  const parts = [
    name ?? `${id !== null && 'manual' in id ? say('point-by-hand') : say('tie-point')} ${count(shown.points.numbers[chosen.point] ?? null)}`,
    position === null ? say('not-intersected') : coordinatesText(shown, position, 3),
    errors === null ? '' : inUnitOf(shown, `± ${errors.map((value) => fixed(value, 3)).join(' ')}`),
    say('rays', {
      observations: taking,
      what: (rejected > 0 ? say('rays-rejected', { rejected }) : '') + (seen < observations.length ? say('shown', { seen }) : ''),
    }),
    rmse_px === null ? '' : say('rmse-px-3', { rmse_px }),
    worst === undefined || worst.w === 0 ? '' : say('largest-w-in', { w: worst.w, name: shown.images[worst.image]?.name ?? '' }),
    elsewhere.length === 0 ? '' : say('not-measured-in-more', { elsewhere: elsewhere.length }),
  ];
  return parts.filter((part) => part !== '').join(' · ');
}

/** What is known of the place under the pointer: in px, in mm on the photo, on the ground. */
function placeText({ state }: BlockStore, view: ImagesView): string {
  const pointed = view.pointedAt();
  const shown = state.shown?.view;
  return pointed === null || shown === undefined ? '' : textOfPlace(pointed, shown, view);
}

function textOfPlace({ image, at }: At, shown: BlockView, view: ImagesView): string {
  const { name = '', camera = -1 } = shown.images[image] ?? {};
  const of = shown.cameras[camera];
  const mm = of === undefined ? null : photoMm(of, at);
  const points = view.seen.panes().find((pane) => pane.image === image)?.points ?? null;
  const ground = points === null ? null : groundAt(points, shown.points, ...at);
  const parts = [
    say('px', { name, at: at[0], at_2: at[1] }),
    mm === null ? '' : say('mm', { mm: mm[0], mm_2: mm[1] }),
    ground === null ? '' : say('ground-about', { join: coordinatesText(shown, ground, 2) }),
  ];
  return parts.filter((part) => part !== '').join(' · ');
}

function toolsOf(host: HTMLElement, store: BlockStore, view: ImagesView, looking: Looking): HTMLElement {
  const set = (look: Partial<Look>) => store.dispatch({ type: 'look', look });
  const points = toggle(say('points'), 'images-points', say('show-the-observations-of-tie'), (on) => set({ points: on }));
  const [vectors, vectorSelect] = vectorChoice('images-vectors', (factor) => set({ vectors: factor }));
  const linked = toggle(say('linked'), 'images-linked', say('pan-and-zoom-all-images'), (on) => set({ linked: on }));
  const loupe = toggle(say('loupe'), 'images-loupe', say('enlarge-what-is-under-the'), (on) => set({ loupe: on }));
  const unmeasured = toggle(say('unmeasured'), 'images-unmeasured', say('show-a-chosen-point-where'), (on) => set({ unmeasured: on }));
  const [adding, addSelect] = choice(say('show'), 'images-add', [['', say('image')]], (value) => {
    const { panes, shown } = store.state;
    addSelect.value = '';
    if (shown === null || value === '') return;
    const before = shownImages(panes, shown.view);
    store.dispatch({ type: 'showImages', images: [...before.slice(0, MOST_PANES - 1), Number(value)] });
  });
  const pair = button(say('open-as-pair'), 'images-pair', () => {
    const images = pairOf(store);
    if (images !== null) looking.open(images);
  });
  declareLack([pair], () => (pairOf(store) === null ? say('needs-two-shown') : ''));
  pair.title = say('match-the-two-images-that');
  const unfold = h('button', { type: 'button', class: 'menu-button', testid: 'images-menu' }, say('view'));
  const light = makeLight('images-', host, set, [[unfold, say('view-2')]]);
  const more = h(
    'div',
    { class: 'more image-more', id: 'images-more' },
    labelled('1:1', 'images-actual', say('n-1-1-one-image-pixel'), () => view.moving.actualSize()),
    ...light.elements,
    adding,
    imageLegend('images-menu-legend', view),
  );
  const other = button(say('other-images'), 'images-other', () => view.turn(1), say('other-images-title'));
  mountMenu(unfold, more);
  store.watch(['panes', 'shown'], ([panes, shown]) => {
    const { look } = panes;
    for (const [made, on] of [
      [points, look.points],
      [linked, look.linked],
      [loupe, look.loupe],
      [unmeasured, look.unmeasured],
    ] as const)
      made.setAttribute('aria-pressed', String(on));
    vectorSelect.value = String(look.vectors);
    light.show(look);
    pair.hidden = pairOf(store) === null;
    other.hidden = shown === null || shownImages(panes, shown.view).length >= shown.view.images.length;
    const names = shown?.view.images.map(({ name }) => name) ?? [];
    if (addSelect.dataset.names === names.join('\n')) return;
    addSelect.dataset.names = names.join('\n');
    fill(addSelect, new Option(say('image'), ''), ...names.map((name, image) => new Option(name, String(image))));
  });
  store.watch(['running', 'notice', 'placing'], () => {
    pair.disabled = isBusy(store.state);
  });
  return h('div', { class: 'image-tools' }, points, vectors, linked, loupe, unmeasured, pair, other, unfold, more);
}

/** The two images that are shown; null where they are not two. */
function pairOf({ state: { panes, shown } }: BlockStore): [number, number] | null {
  const [a, b, ...more] = shown === null ? [] : shownImages(panes, shown.view);
  return a === undefined || b === undefined || more.length > 0 ? null : [a, b];
}
