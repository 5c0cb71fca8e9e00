/** The map of the block on the stage: what it shows, its legend, and the same in words. */
import { choice, toggle } from '../../shared/panel/choice';
import { button, fill, h } from '../../shared/panel/dom';
import { unfolded } from '../../shared/panel/menu';
import { asFigure } from '../../shared/text/direction';
import { fixed } from '../../shared/text/format';
import type { BlockStore } from '../engine/engine';
import type { Facts } from '../engine/facts';
import type { PlacingEngine } from '../engine/placing';
import { medianGsd, systemOf } from '../state/ground';
import type { System } from '../state/ground';
import { NEAR_PX } from '../state/cells';
import { placeUnder, whyNotLaid } from '../state/laid';
import { isLookedAtAlone } from '../state/placing';
import { resultSystem } from '../state/result-system';
import { isInSystemOf } from '../state/showing';
import { imagesOfBlock, isBusy } from '../state/state';
import { countedPoints } from '../state/point-kinds';
import { inverse, mapped } from '../../shared/state/plane-map';
import { unitText, withUnit } from '../../shared/text/units';
import type { BlockView, Layout } from '../state/view';
import { mostMatches } from '../state/words';
import { colouredPoints, GRADIENT } from '../view/map/colouring';
import { lengthText } from '../view/map/frame';
import { longestText, offsetsOf } from '../view/map/ground';
import type { Colouring, MapLook } from '../view/map/look';
import { BlockMap } from '../view/map/map';
import { KEYS_ID } from './view';
import type { StageView } from './view';
import { say } from '../../shared/text/words';
import { declareLack } from '../../shared/panel/lack';
import { lackOfOrthophoto } from '../state/lacks';

const LAYOUTS: Readonly<Record<Layout['kind'], string>> = {
  oriented: say('oriented-positions-from-above'),
  recorded: say('gnss-positions-from-above'),
  connections: say('arranged-by-connections-positions-have'),
};

const SYSTEMS: Readonly<Record<System, string>> = {
  geographic: say('metres-east-and-north-of'),
  surveyed: say('system-of-the-control-points'),
  own: say('the-blocks-own-system-without'),
};

const COLOURINGS: readonly (readonly [Colouring, string])[] = [
  ['residual', say('by-residual')],
  ['rays', say('by-rays')],
  ['height', say('by-height')],
  ['none', say('not-shown')],
];

const KEYS = say('press-an-image-a-point');

/** They say as much as centimetres. */
const DIGITS_OF_DEGREES = 7;

export function mapView(facts: Facts, placing: PlacingEngine, mosaic: () => void): StageView {
  return {
    name: 'map',
    title: say('map'),
    mount: (store, looking) => {
      const words = h('p', { class: 'visually-hidden', id: 'block-map-words', testid: 'block-map-words' });
      const canvas = h('div', {
        class: 'view block-view',
        testid: 'block-map',
        tabindex: 0,
        role: 'group',
        aria: { roledescription: say('map-of-the-block'), label: say('images-and-tie-points-of'), describedby: `${words.id} ${KEYS_ID}` },
      });
      const map = new BlockMap(canvas, store, looking, facts, placing);
      const place = h('p', { class: 'map-place', testid: 'map-place' });
      const legend = h('span', { class: 'note map-legend', testid: 'block-layout' });
      const bar = h('span', { class: 'map-scale', aria: { hidden: 'true' } });
      bar.style.background = GRADIENT;
      map.watch(() => {
        const { shown } = store.state;
        setText(place, placeText(map, shown?.view ?? null));
        showLegend(legend, bar, map, shown?.view ?? null);
        setText(words, shown === null ? '' : inWords(map, shown.view));
      });
      const element = h('div', { class: 'map', tabindex: -1 }, canvas, place, words);
      element.addEventListener('focus', () => canvas.focus());
      return { element, tools: [toolsOf(store, map, mosaic)], legend, zoomable: map, keys: KEYS };
    },
  };
}

function setText(element: HTMLElement, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

function toolsOf(store: BlockStore, map: BlockMap, mosaic: () => void): HTMLElement {
  const [points, select] = choice(say('tie-points'), 'map-points', COLOURINGS, (colouring) => map.show({ colouring: colouring as Colouring }));
  const switches: readonly (readonly [Exclude<keyof MapLook, 'colouring'>, HTMLButtonElement])[] = [
    ['connections', toggle(say('pairs'), 'map-connections', say('lines-between-connected-images-wider'), (connections) => map.show({ connections }))],
    ['photos', toggle(say('photos'), 'map-photos', say('small-photos-where-they-have'), (photos) => map.show({ photos }))],
    ['footprints', toggle(say('footprints'), 'map-footprints', say('what-each-image-covers-of'), (footprints) => map.show({ footprints }))],
    ['offsets', toggle(say('offsets'), 'map-offsets', say('gnss-positions-and-differences-of'), (offsets) => map.show({ offsets }))],
    ['orthophoto', toggle(say('orthophoto'), 'map-orthophoto', say('the-orthophoto-that-is-given'), (orthophoto) => map.show({ orthophoto }))],
    ['lasso', toggle(say('lasso'), 'map-lasso', say('shift-and-a-drag-chooses'), (lasso) => map.show({ lasso }))],
  ];
  declareLack(
    switches.flatMap(([name, press]) => (name === 'orthophoto' ? press : [])),
    () => lackOfOrthophoto(store.state),
  );
  map.watch(() => {
    const { shows } = map;
    select.value = shows.colouring;
    for (const [name, press] of switches) press.setAttribute('aria-pressed', String(shows[name]));
  });
  const make = button(say('orthomosaic-2'), 'map-mosaic', mosaic, say('makes-a-quick-orthomosaic-of'));
  map.watch(() => {
    const press = switches.find(([name]) => name === 'orthophoto')?.[1];
    if (press === undefined) return;
    press.hidden = map.laid() === null;
    // An orthomosaic of the block itself is not the orthophoto that the view of this name is about.
    const isOwn = map.orthophoto?.ofBlock != null;
    setText(press, say(isOwn ? 'orthomosaic-2' : 'orthophoto'));
    press.title = say(isOwn ? 'the-orthomosaic-of-the-block' : 'the-orthophoto-that-is-given');
  });
  store.watch(['shown', 'files', 'placing', 'running', 'notice'], ([shown, , { orthophoto }]) => {
    // One of an earlier run is made anew; one that was given stays.
    make.hidden = shown?.view.layout.kind !== 'oriented' || (orthophoto !== null && (orthophoto.ofBlock === null || orthophoto.ofBlock === shown.key));
    make.disabled = isBusy(store.state) || imagesOfBlock(store.state).length === 0;
  });
  store.watch(['shown'], ([shown]) => {
    const oriented = shown?.view.layout.kind === 'oriented';
    for (const part of [points, ...switches.filter(([name]) => name === 'footprints' || name === 'offsets' || name === 'lasso').map(([, press]) => press)])
      part.hidden = !oriented;
  });
  return unfolded('map-menu', points, ...switches.map(([, press]) => press), make);
}

/** What places, lines and colours mean. */
function showLegend(legend: HTMLElement, bar: HTMLElement, map: BlockMap, view: BlockView | null): void {
  const scale = view === null || view.layout.kind !== 'oriented' ? undefined : colouredPoints(view.points, map.shows.colouring)?.scale;
  const text = view === null ? '' : legendText(view, map);
  const ends = scale === undefined ? [] : [scale.from, scale.to].map((value) => withUnit(fixed(value, scale.digits), scale.unit));
  const now = [text, ...ends].join('|');
  if (legend.dataset.text === now) return;
  legend.dataset.text = now;
  fill(legend, text, ...(scale === undefined ? [] : [h('span', { class: 'map-colours' }, `${scale.title}: ${ends[0] ?? ''}`, bar, ends[1] ?? '')]));
}

/** What the coordinates of a block are, in words. */
function systemText(view: BlockView, map: BlockMap): string {
  const { name } = resultSystem(view);
  if (name !== '') return asFigure(name);
  const system = systemOf(view, map.ground());
  return system === 'surveyed' && isInSystemOf(view) ? say('system-of-the-orthophoto') : SYSTEMS[system];
}

function legendText(view: BlockView, map: BlockMap): string {
  const most = view.connections.reduce((high, { shared }) => Math.max(high, shared), 0);
  const matches = mostMatches(view);
  const widest = most > 0 ? say('common-points', { most }) : say('matches', { matches });
  const system = view.layout.kind === 'connections' ? '' : ` (${systemText(view, map)})`;
  return `${LAYOUTS[view.layout.kind]}${system}.${orthophotoNote(map, view)} ${map.shows.connections && most + matches > 0 ? say('widest-line', { widest }) : ''}`;
}

/** How the orthophoto came under the map, or what brings it there. */
function orthophotoNote(map: BlockMap, view: BlockView): string {
  const { orthophoto } = map;
  if (orthophoto === null || view.layout.kind !== 'oriented') return '';
  const laid = map.laid();
  if (laid === null) {
    if (orthophoto.ofBlock !== null) return say('the-orthomosaic-is-of-an');
    const why = whyNotLaid(orthophoto, view);
    return why === '' ? say('the-orthophoto-is-in-another') : why;
  }
  if (map.shows.orthophoto && laid.crs !== null) {
    const { departs } = laid.sheet;
    return say('orthophoto-laid-under-by-positions', { crs: laid.crs, departs: departs > NEAR_PX ? departs : null });
  }
  if (!map.shows.orthophoto || laid.images === 0) return '';
  return say('orthophoto-laid-under-by-placed', { images: laid.images });
}

function placeText(map: BlockMap, view: BlockView | null): string {
  const { place } = map;
  if (view === null || place === null) return '';
  const system = systemOf(view, map.ground());
  const { code, toBlock, unit: units, more } = resultSystem(view);
  if (toBlock !== null) {
    // A plane map: to the px of any screen.
    const there = mapped(inverse(toBlock), place[0], place[1]);
    const [x = '', y = ''] = there.map((value) => fixed(value, 2 + more));
    return `${withUnit(`X ${x}  Y ${y}`, units[0])}  ${code}`;
  }
  const unit = system === 'own' ? '' : ' m';
  const own = `${system === 'geographic' ? 'E' : 'X'} ${fixed(place[0], 2)}${unit}  ${system === 'geographic' ? 'N' : 'Y'} ${fixed(place[1], 2)}${unit}`;
  const laid = map.laid();
  if (laid === null || laid.crs === null) return own;
  const [x, y] = placeUnder(laid, view, place).map((value) => fixed(value, isLookedAtAlone(map.orthophoto) ? DIGITS_OF_DEGREES : 2));
  return `${own}  ${laid.crs} ${x ?? ''} ${y ?? ''}`;
}

/** The map for those who do not see it. */
function inWords(map: BlockMap, view: BlockView): string {
  const ground = map.ground();
  const system = systemOf(view, ground);
  const connected = view.connections.filter(({ outcome }) => outcome.kind === 'connected').length;
  const parts = [say('images-oriented-connected-pairs', { view: legendText(view, map), images: view.images.length, oriented: view.oriented, connected })];
  const coloured = colouredPoints(view.points, map.shows.colouring);
  if (coloured !== null) {
    const { title, from, to, digits, unit } = coloured.scale;
    const { tie, gone } = countedPoints(view);
    parts.push(
      say('tie-points-from-to', {
        taking: tie.points,
        what: gone > 0 ? say('and-rejected-by-hand', { gone }) : '',
        title,
        from: fixed(from, digits),
        to: fixed(to, digits),
        unit: unitText(unit),
      }).trimEnd(),
    );
  }
  if (view.layout.kind !== 'connections') parts.push(extentText(view, system));
  const gsd = medianGsd(view, ground);
  if (gsd !== null) parts.push(say('ground-sample-distance', { gsd: lengthText(gsd, system) }));
  const { longest } = offsetsOf(view, ground);
  if (longest.gnss.plan > 0) parts.push(say('gnss-positions-differ-by-up', { gnss: longestText(longest.gnss, system) }));
  if (longest.surveyed.plan > 0)
    parts.push(say('surveyed-points-differ-by-up', { surveyed: view.surveyed.length, surveyed_2: longestText(longest.surveyed, system) }));
  return `${parts.join('. ')}.`;
}

/** Images that are not oriented are drawn beside the others, and have no place of their own. */
function extentText({ layout: { kind, places }, images }: BlockView, system: System): string {
  const span = (axis: number) => {
    const own = places.filter((_, i) => i % 2 === axis && (kind !== 'oriented' || images[Math.floor(i / 2)]?.oriented === true));
    return own.length === 0 ? 0 : own.reduce((high, value) => Math.max(high, value), -Infinity) - own.reduce((low, value) => Math.min(low, value), Infinity);
  };
  return say('the-images-lie-within-by', {
    length_text: lengthText(Math.max(span(0), 1e-9), system),
    length_text_2: lengthText(Math.max(span(1), 1e-9), system),
  });
}
