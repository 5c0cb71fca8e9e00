/** The page's own map and table of tie points over a block that is made, and how long they take of a frame. Runs in the page. */

import type { BlockEngine, BlockStore } from '../../../www/block/engine/engine';
import { Facts } from '../../../www/block/engine/facts';
import type { PlacingEngine } from '../../../www/block/engine/placing';
import { rowsOf } from '../../../www/block/state/columns';
import { reduceBlock } from '../../../www/block/state/reducer';
import { pointsOf } from '../../../www/block/state/selection';
import { BLOCK_INITIAL } from '../../../www/block/state/state';
import type { ViewGround } from '../../../www/block/state/ground';
import type { BlockView, ViewConnection, ViewImage, ViewPoints } from '../../../www/block/state/view';
import type { Looking } from '../../../www/block/view/looking';
import { BlockMap } from '../../../www/block/view/map/map';
import { Table } from '../../../www/shared/panel/table';
import { Holder } from '../../../www/shared/state/store';

/** Distance of neighbouring images, m. */
const BASE = 100;
const HEIGHT = 300;

/** What an action takes, in ms: its handlers, and the frame after it with its layout and paint. The wait for the frame is left out. */
async function taking(action: () => void): Promise<number> {
  const frame = new Promise<number>((resolve) => {
    requestAnimationFrame(() => {
      const began = performance.now();
      const { port1, port2 } = new MessageChannel();
      port1.onmessage = () => resolve(performance.now() - began);
      port2.postMessage(null);
    });
  });
  const began = performance.now();
  action();
  const handled = performance.now() - began;
  return handled + (await frame);
}

async function repeated(number: number, action: (i: number) => void): Promise<number[]> {
  const all: number[] = [];
  for (let i = 0; i < number; i++) all.push(await taking(() => action(i)));
  return all;
}

/** A square of images, and points spread over it by a fixed sequence. */
function madeView(count: number, images: number): BlockView {
  let state = 1;
  const noise = () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
  const side = Math.round(Math.sqrt(images));
  const centre = (i: number): [number, number, number] => [BASE * (i % side), BASE * Math.floor(i / side), HEIGHT];
  const made = (length: number, value: (i: number) => number) => Float64Array.from({ length }, (_, i) => value(i));
  const image = (i: number): ViewImage => ({
    name: `image_${String(i)}.jpg`,
    width: 4000,
    height: 3000,
    camera: 0,
    features: 4000,
    places: 9,
    rays: 900,
    rmsePx: 0.3,
    oriented: true,
    position: centre(i),
    exifOrientation: null,
    why: '',
  });
  const connection = (i: number): ViewConnection => ({
    images: [i % images, (i + (i < images ? 1 : side)) % images],
    rule: 'all',
    outcome: { kind: 'connected', matches: 500 },
    reason: '',
    geometry: null,
    shared: 300,
    chosen: 90,
    rejected: false,
  });
  const points: ViewPoints = {
    count,
    taking: count,
    sources: made(count, (i) => 3 * i),
    lost: new Set(),
    numbers: Uint32Array.from({ length: count }, (_, i) => i + 1),
    rays: Uint16Array.from({ length: count }, () => 2 + Math.floor(8 * noise())),
    rmsePx: made(count, noise),
    positions: made(3 * count, (i) => (i % 3 === 2 ? 20 : BASE * side) * noise()),
    errors: made(3 * count, noise),
    confidence: made(count, noise),
  };
  return {
    partial: false,
    images: Array.from({ length: images }, (_, i) => image(i)),
    leftOut: [],
    strayMasks: [],
    strayMarks: [],
    remarks: [],
    cameras: [],
    connections: Array.from({ length: 2 * images }, (_, i) => connection(i)),
    groups: [],
    layout: { kind: 'oriented', places: made(2 * images, (i) => centre(i >> 1)[i % 2] ?? NaN) },
    points,
    found: null,
    refinement: null,
    byRays: [],
    oriented: images,
    verdict: null,
    orthophoto: null,
    origin: null,
    crs: null,
    geoidM: null,
    rmsePx: 0.3,
    sigma0Px: 0.3,
    surveyed: [],
    givenControl: 0,
    components: [],
    checks: null,
    score: null,
    warnings: [],
    formats: [],
  };
}

/** Only what the map asks for: where the images lie on the ground never comes. */
const ENGINE = { ground: () => new Promise<ViewGround>(() => undefined) } as unknown as BlockEngine;
/** There is no orthophoto. */
const PLACING = {} as unknown as PlacingEngine;

function must<T>(found: T | null | undefined, what: string): T {
  if (found === null || found === undefined) throw new Error(`the workbench has no ${what}`);
  return found;
}

/** What was done, and the times of its repetitions, ms. */
export type Taken = [what: string, times: number[]][];

export async function measured(count: number, images: number, steps: number, brushes: number): Promise<Taken> {
  const view = madeView(count, images);
  const shown = { key: '', view, found: view, tiePoints: '', edits: [], given: [], files: [], steps: {}, seconds: 0, ground: null };
  const store: BlockStore = new Holder({ ...BLOCK_INITIAL, shown }, reduceBlock);
  const looking: Looking = {
    choose: (choice) => store.dispatch({ type: 'choose', choice }),
    point: (choice) => store.dispatch({ type: 'point', choice }),
    open: () => undefined,
  };
  const box = (className: string, height: string) => Object.assign(document.createElement('div'), { className, style: `height: ${height}` });
  const [host, dock] = [box('view block-view', '560px'), box('dock', '320px')];
  document.body.append(host, dock);
  new BlockMap(host, store, looking, new Facts(store, ENGINE), PLACING);
  let chosen = pointsOf(null);
  const table = new Table(dock, {
    testid: 'bench',
    words: { table: 'Tie points', region: 'Table' },
    file: 'points.csv',
    filter: (filter) => store.dispatch({ type: 'filter', subject: 'points', filter }),
    choose: () => undefined,
    isChosen: (row) => chosen.includes(row),
  });
  const rows = rowsOf('points', { view, given: [] });
  store.watch(['selection'], ([{ filters }]) => table.show(rows.count, rows.columns, undefined, filters.points));
  store.watch(['selection'], ([{ chosen: choice }]) => {
    chosen = pointsOf(choice);
    table.redraw();
  });
  // Events of a bench are of no pointer that could be held.
  host.setPointerCapture = () => undefined;
  const { left, top, width, height } = host.getBoundingClientRect();
  const event = (type: string, x: number, y: number, more: PointerEventInit = {}) =>
    host.dispatchEvent(new PointerEvent(type, { pointerId: 1, button: 0, bubbles: true, clientX: left + x, clientY: top + y, ...more }));
  await repeated(5, () => event('pointermove', 100, 100));
  event('pointerdown', width / 2, height / 2);
  const pan = await repeated(steps, (i) => event('pointermove', width / 2 + 200 * Math.sin(i / 8), height / 2 + 100 * Math.cos(i / 8)));
  event('pointerup', width / 2, height / 2);
  const hover = await repeated(steps, (i) => event('pointermove', (37 * i) % width, (53 * i) % height));
  const brush: number[] = [];
  for (let i = 0; i < brushes; i++) {
    const shift = { shiftKey: true };
    event('pointerdown', 5 + i, 5, shift);
    event('pointermove', width / 2, height / 2, shift);
    await taking(() => event('pointermove', width - 5, height - 5, shift));
    brush.push(await taking(() => event('pointerup', width - 5, height - 5, shift)));
  }
  // Last on the map: it leaves few points in view.
  const wheel = { bubbles: true, cancelable: true, clientX: left + width / 2, clientY: top + height / 2 };
  const zoom = await repeated(steps, (i) => host.dispatchEvent(new WheelEvent('wheel', { deltaY: i % 40 < 20 ? -120 : 120, ...wheel })));
  const scroller = must(dock.querySelector('.rows'), 'rows');
  const scroll = await repeated(steps, (i) => {
    scroller.scrollTop = (7919 * 24 * i) % (24 * count);
  });
  const heads = [...dock.querySelectorAll<HTMLElement>('button.sort')];
  const sort = await repeated(brushes, (i) => must(heads[i % heads.length], 'heads').click());
  const field = must(dock.querySelector<HTMLInputElement>('input.filter[data-key="point-rmse"]'), 'filter of the RMSE');
  const filter = await repeated(brushes, (i) => {
    field.value = `>0.${String(i % 9)}`;
    field.dispatchEvent(new Event('input', { bubbles: true }));
  });
  return [
    ['pan', pan],
    ['zoom', zoom],
    ['the point under the pointer', hover],
    ['a rectangle, seen in the table', brush],
    ['table: a jump of the scroll bar', scroll],
    ['table: sort by a column', sort],
    ['table and map: a filter', filter],
  ];
}
