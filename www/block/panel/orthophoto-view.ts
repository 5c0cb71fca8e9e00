/** The orthophoto on the stage: what is placed on it, the chosen image beside it, and their tools. */
import { toggle, vectorChoice } from '../../shared/panel/choice';
import type { LinkUse } from '../../../pkg/wasm/tiepoint.js';
import { button, fill, h } from '../../shared/panel/dom';
import { passFocus } from '../../shared/panel/focus';
import { unfolded } from '../../shared/panel/menu';
import { fixed } from '../../shared/text/format';
import { declare } from '../../shared/view/commands';
import type { BlockEngine, BlockStore } from '../engine/engine';
import type { Facts } from '../engine/facts';
import { hasKeys, REDO_KEYS, UNDO_KEYS, undoKeys } from '../../shared/panel/history';
import { LinkHands } from '../engine/link-hands';
import { PlaceHands } from '../engine/place-hands';
import type { PlacingEngine } from '../engine/placing';
import { LEAST_LINKS, shownLinks, stepName, useWord } from '../state/steps';
import { linkOf, USES } from '../state/links';
import { takesPlaces } from '../state/places';
import { blockOnOrthophoto, chosenPlaced } from '../state/showing';
import { purposeOf } from '../state/purpose';
import { isBusy } from '../state/state';
import { PlacedImageView } from '../view/orthophoto/image';
import { blockKeys, linkKeys, placeKeys } from '../view/orthophoto/keys';
import type { BlockSteps } from '../view/orthophoto/keys';
import { LINK_STYLES } from '../view/orthophoto/links';
import { OrthophotoPlan } from '../view/orthophoto/plan';
import { placingExports } from './placing-exports';
import { verdictText } from './placing-words';
import { KEYS_ID } from './view';
import type { StageView } from './view';
import { asFigure } from '../../shared/text/direction';
import { say } from '../../shared/text/words';
import { declareLack } from '../../shared/panel/lack';

const KEYS = say('press-a-footprint-to-see');

export interface OrthophotoActions {
  /** Measures the chosen point in images. */
  measure: () => void;
  /** Asks for an orthophoto. */
  open: () => void;
  sample: () => void;
}

export function orthophotoView(engine: BlockEngine, facts: Facts, placing: PlacingEngine, { open, sample, measure }: OrthophotoActions): StageView {
  return {
    name: 'orthophoto',
    title: say('orthophoto'),
    mount: (store, looking) => {
      const host = (testid: string, label: string) =>
        h('div', { class: 'view', testid, tabindex: 0, role: 'group', aria: { roledescription: say('role-picture'), label, describedby: KEYS_ID } });
      const [ground, picture] = [host('ortho-plan', say('orthophoto-with-the-images-that')), host('ortho-image', say('the-chosen-image-with-its'))];
      const [place, at] = [h('p', { class: 'map-place', testid: 'ortho-place' }), h('p', { class: 'map-place', testid: 'ortho-at' })];
      const name = h('p', { class: 'ortho-name' });
      const beside = h('div', { class: 'ortho-pane', testid: 'ortho-beside' }, picture, name, at);
      const chosen = h('p', { class: 'image-point', testid: 'ortho-chosen', role: 'status', aria: { live: 'polite' } });
      const element = h(
        'div',
        { class: 'ortho-view', tabindex: -1 },
        h('div', { class: 'ortho-panes' }, h('div', { class: 'ortho-pane' }, ground, place, invited(store, { open, sample })), beside),
        h('div', { class: 'image-said' }, chosen, legendOf(store)),
      );
      element.addEventListener('focus', () => ground.focus());
      const hands = new LinkHands(store, placing);
      const places = new PlaceHands(store, placing, measure);
      undoKeys(
        // Edits of the block have keys of their own.
        () => place.offsetParent !== null && blockOnOrthophoto(store.state) === null && !takesPlaces(store.state),
        (by) => hands.go(by),
      );
      const steps: BlockSteps = { step: (of, by) => plan.step(of, by), leave: () => looking.choose(null) };
      const keys = declare({
        where: say('orthophoto'),
        host: element,
        list: [...placeKeys(store, places, () => plan.takeMiddle()), ...blockKeys(store, steps), ...linkKeys(store, hands)],
      });
      const plan = new OrthophotoPlan(ground, store, hands, places, keys, placing, looking, facts);
      const image = new PlacedImageView(picture, store, hands, keys, (file) => engine.grey(file));
      plan.image = image;
      image.ground = plan;
      plan.watch(() => fill(place, plan.place === null ? '' : `X ${fixed(plan.place[0], 2)}  Y ${fixed(-plan.place[1], 2)}`));
      image.watch(() => fill(at, image.place === null ? '' : say('column-row', { place: image.place[0], place_2: image.place[1] })));
      follow(store, hands, plan, image, beside, name);
      store.watch(['placing', 'files', 'options', 'shown', 'history'], () => {
        element.classList.toggle('has-block', blockOnOrthophoto(store.state) !== null);
        const text = chosenText(store);
        if (chosen.textContent !== text) chosen.textContent = text;
        element.classList.toggle('picks', store.state.placing.picks || store.state.placing.adds);
      });
      const [residuals, select] = vectorChoice('ortho-residuals', (factor) => {
        image.factor = factor;
      });
      select.value = String(image.factor);
      return { element, tools: [toolsOf(store, placing, plan, residuals), handsOf(store, hands), placesOf(store, places, ground)], zoomable: plan, keys: KEYS };
    },
  };
}

/** Both pictures go where the choice is, which may be made elsewhere. */
function follow(store: BlockStore, hands: LinkHands, plan: OrthophotoPlan, image: PlacedImageView, beside: HTMLElement, name: HTMLElement): void {
  let [of, link] = [store.state.placing.chosen.image, store.state.placing.chosen.link];
  let isMeasured = false;
  store.watch(['placing', 'files', 'options', 'shown'], ([{ chosen, draft }]) => {
    const placed = chosenPlaced(store.state);
    const placement = placed?.result?.placement ?? null;
    beside.hidden = (placed?.result ?? null) === null;
    fill(name, placed?.file.name ?? '');
    if (chosen.image !== of && placement !== null) plan.showImage(placement);
    if (chosen.image === null && of !== null) plan.fit();
    if (chosen.link !== link && chosen.link !== null) for (const picture of [plan, image]) picture.reveal(chosen.link);
    if (draft === null) for (const picture of [plan, image]) picture.predicted = null;
    // One that was kept begins with an end.
    else if (!isMeasured && placed !== null) void hands.expected().then((at) => (draft.at === null ? image.expect(at) : plan.expectPlace(at)));
    isMeasured = draft !== null && placed !== null;
    [of, link] = [chosen.image, chosen.link];
  });
}

/** What is chosen, in words. */
function chosenText({ state }: BlockStore): string {
  const { placing } = state;
  const placed = chosenPlaced(state);
  if (placing.picks) return say('press-the-orthophoto-where-images');
  if (placing.adds) return say('press-the-place-on-the-orthophoto');
  const waiting = state.shown?.given.filter(({ byHand }) => byHand) ?? [];
  if (takesPlaces(state) && blockOnOrthophoto(state) === null && waiting.length > 0)
    return say('places-by-hand-wait', { places: waiting.length, measured: waiting.filter(({ images }) => images >= 2).length });
  if (blockOnOrthophoto(state) !== null) return '';
  if (placed === null && purposeOf(state) === 'block') return say('a-block-that-is-placed');
  if (placed === null) return placing.placed.size > 0 ? say('press-a-footprint-or-a') : '';
  if (placing.draft !== null) {
    const { at, place } = placing.draft;
    if (at === null && place === null) return say('a-new-link-press-the');
    return at === null ? say('press-the-point-in-the') : place === null ? say('press-the-point-on-the') : say('press-again-to-move-an');
  }
  if (placing.adjusting === placed.file.id) return say('adjusting');
  const links = shownLinks(placed);
  const added = links?.count ?? 0;
  if (placed.result?.placement === null && added > 0 && placing.chosen.link === null && placed.result === placed.found)
    return say('of-at-least-links-by', { name: placed.file.name, added, least_links: LEAST_LINKS });
  if (placing.chosen.link === null || links === null || placing.chosen.link >= links.count)
    return `${asFigure(placed.file.name)}: ${verdictText(placed, state)}`;
  const link = linkOf(links, placing.chosen.link);
  const residual = link.residual_px;
  const off =
    residual === null
      ? say('the-image-does-not-see')
      : say('residual-px-px', { residual: residual[0], residual_2: residual[1], hypot: Math.hypot(...residual) });
  return `${say('link-of', {
    link: placing.chosen.link + 1,
    count: links.count,
    what: link.by_hand ? say('measured-by-hand-3') : '',
    name: useWord(placed, placing.chosen.link, link.role),
    off,
  })}X ${fixed(link.place[0], 2)}, Y ${fixed(link.place[1], 2)}, Z ${fixed(link.place[2], 2)}.`;
}

/** What the marks of links, or of the block's places, mean, and which of them are drawn. */
function legendOf(store: BlockStore): HTMLElement {
  const switches = USES.map((use) => {
    const press = toggle(LINK_STYLES[use].name, `links-${use}`, HELP.links[use], (on) => store.dispatch({ type: 'showLinks', use, on }));
    press.prepend(h('span', { class: `link-mark is-${use}`, aria: { hidden: 'true' } }), ' ');
    return press;
  });
  const title = h('span', {});
  const legend = h('p', { class: 'ortho-legend', testid: 'ortho-legend' }, title, ...switches);
  store.watch(['placing', 'files', 'options', 'shown'], ([{ uses }]) => {
    const of = blockOnOrthophoto(store.state) === null ? 'links' : 'places';
    fill(title, of === 'links' ? say('links') : say('places-of-the-block'));
    for (const [i, use] of USES.entries()) {
      const press = switches[i];
      press?.setAttribute('aria-pressed', String(uses.has(use)));
      if (press !== undefined) press.title = HELP[of][use];
    }
    legend.hidden = of === 'links' && (chosenPlaced(store.state)?.result?.placement ?? null) === null;
  });
  return legend;
}

const HELP: Readonly<Record<'links' | 'places', Readonly<Record<LinkUse, string>>>> = {
  links: { used: say('links-by-which-the-image'), check: say('links-that-took-no-part'), rejected: say('links-that-were-rejected-as') },
  places: { used: say('places-by-which-the-block'), check: say('places-that-took-no-part'), rejected: say('places-that-were-rejected') },
};

function toolsOf(store: BlockStore, engine: PlacingEngine, plan: OrthophotoPlan, residuals: HTMLElement): HTMLElement {
  const exports = placingExports(store, engine);
  const near = toggle(say('rough-place'), 'ortho-near', say('the-next-press-on-the'), (picks) => store.dispatch({ type: 'picksPlace', picks }));
  const over = toggle(say('over-the-orthophoto'), 'ortho-over', say('the-chosen-image-on-the'), (on) => {
    plan.isLaid = on;
    over.setAttribute('aria-pressed', String(on));
  });
  const everywhere = button(
    say('everywhere'),
    'ortho-everywhere',
    () => store.dispatch({ type: 'placingOptions', options: { near_x: null, near_y: null } }),
    say('images-are-sought-on-the'),
  );
  const whole = button(
    say('whole-orthophoto'),
    'ortho-whole',
    () => store.dispatch({ type: 'choosePlaced', looked: { image: null, link: null } }),
    say('no-image-is-chosen'),
  );
  store.watch(['placing', 'running', 'notice', 'files', 'shown'], ([placing]) => {
    near.setAttribute('aria-pressed', String(placing.picks));
    near.disabled = placing.orthophoto === null || isBusy(store.state);
    everywhere.hidden = placing.options?.near_x == null && placing.options?.near_y == null;
    whole.hidden = chosenPlaced(store.state) === null;
    over.hidden = (chosenPlaced(store.state)?.result?.placement ?? null) === null;
    // They are of images that are placed by themselves.
    for (const own of [residuals, exports]) own.hidden = blockOnOrthophoto(store.state) !== null;
  });
  return unfolded('ortho-menu', near, everywhere, residuals, over, whole, exports);
}

/** What can be done to links by hand. */
function handsOf(store: BlockStore, hands: LinkHands): HTMLElement {
  const reject = button(say('reject-link'), 'link-reject', () => hands.use('reject'), say('leaves-the-chosen-link-out'));
  const restore = button(say('use-link'), 'link-restore', () => hands.use('restore'), say('lets-the-chosen-link-take'));
  declareLack([reject, restore], () => (store.state.placing.chosen.link === null ? say('no-link-is-chosen') : ''));
  const add = toggle(say('add-link'), 'link-add', say('measures-a-link-by-hand'), () => hands.measure());
  const accept = button(say('accept'), 'link-accept', () => hands.accept(), say('takes-the-link-that-is'));
  const undo = button(say('undo'), 'link-undo', () => hands.go(-1));
  const redo = button(say('redo'), 'link-redo', () => hands.go(1));
  hasKeys(undo, UNDO_KEYS);
  hasKeys(redo, REDO_KEYS);
  store.watch(['placing', 'running', 'notice', 'files', 'options', 'shown'], ([{ chosen, draft, adjusting }]) => {
    const held = document.activeElement;
    const placed = chosenPlaced(store.state);
    const busy = isBusy(store.state);
    for (const press of [reject, restore, add, accept, undo, redo]) press.setAttribute('aria-busy', String(adjusting !== null));
    const link = chosen.link === null || placed === null ? null : shownLinks(placed);
    const use = link === null || chosen.link === null ? null : linkOf(link, chosen.link).role;
    for (const press of [reject, restore, add, accept, undo, redo]) press.disabled = busy;
    reject.hidden = use === null || use === 'rejected';
    restore.hidden = use !== 'rejected';
    add.hidden = placed?.result == null;
    add.setAttribute('aria-pressed', String(draft !== null));
    accept.hidden = placed === null || draft?.at == null || draft.place === null;
    const [last, next] = [placed?.steps[placed.done - 1], placed?.steps[placed.done]];
    undo.hidden = last === undefined;
    redo.hidden = next === undefined;
    undo.title = last === undefined ? '' : say('undo-2', { last: stepName(last) });
    redo.title = next === undefined ? '' : say('redo-2', { next: stepName(next) });
    passFocus(held, [reject, restore, undo, redo, add]);
  });
  return h('div', { class: 'map-tools' }, reject, restore, add, accept, undo, redo);
}

/** Measures places of the orthophoto for the block. */
function placesOf(store: BlockStore, hands: PlaceHands, ground: HTMLElement): HTMLElement {
  const add = toggle(say('add-place'), 'place-add', say('measures-a-place-by-hand'), () => {
    hands.toggle();
    // The cross is moved by keys.
    if (store.state.placing.adds) ground.focus();
  });
  store.watch(['placing', 'running', 'notice', 'files', 'options', 'shown'], ([{ adds }]) => {
    add.hidden = !takesPlaces(store.state);
    add.disabled = !adds && !hands.can;
    add.setAttribute('aria-pressed', String(adds));
  });
  return h('div', { class: 'map-tools' }, add);
}

/** What can be done before there is an orthophoto. */
function invited(store: BlockStore, { open, sample }: Pick<OrthophotoActions, 'open' | 'sample'>): HTMLElement {
  const own = button(say('open-an-orthophoto'), 'ortho-open-first', open);
  own.className = 'primary';
  const simulate = button(say('try-a-sample'), 'ortho-sample', sample);
  const welcome = h(
    'div',
    { class: 'welcome', testid: 'ortho-welcome' },
    h('h2', {}, say('photographs-placed-on-an-orthophoto')),
    h('p', {}, say('drop-an-orthophoto-and-photographs')),
    h('ul', {}, h('li', {}, say('where-each-was-taken-and')), h('li', {}, say('how-precise-that-is-and')), h('li', {}, say('each-photograph-on-the-ground'))),
    h('p', { class: 'buttons' }, own, simulate),
    h('p', { class: 'note' }, say('an-orthophoto-is-a-geotiff')),
  );
  store.watch(['placing', 'running', 'notice', 'catalogue'], ([placing, , , catalogue]) => {
    welcome.hidden = placing.orthophoto !== null;
    for (const press of [own, simulate]) press.disabled = catalogue === null || isBusy(store.state);
  });
  return welcome;
}
