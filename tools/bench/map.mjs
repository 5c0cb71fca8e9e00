/** The workbench of a block at 100,000 tie points in headless Chromium: what pan, zoom, a rectangle, and the tables take of a frame. */

import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import { build } from 'vite';
import { ROOT } from '../lib/paths.mjs';
import { findChromium } from '../lib/setup.mjs';

const POINTS = 100_000;
const IMAGES = 400;
/** How often each thing is done. */
const STEPS = 100;
const BRUSHES = 20;
const STYLES = ['shared/style/base', 'shared/style/layout', 'shared/style/panels', 'shared/style/view', 'block/style/block'];

export async function map() {
  console.log(`Map and tables of ${POINTS.toLocaleString('en')} tie points in Chromium, 1440 x 900`);
  const executablePath = findChromium();
  if (!executablePath) return console.log('  skipped: no Chromium (install it or name it in CHROMIUM)');
  const browser = await chromium.launch({ executablePath, args: ['--no-sandbox', '--disable-quic', '--no-first-run'] });
  const tab = await browser.newPage({ viewport: { width: 1440, height: 900 } });
  for (const style of STYLES) await tab.addStyleTag({ content: readFileSync(join(ROOT, 'www', `${style}.css`), 'utf8') });
  await tab.addScriptTag({ content: await workbench() });
  /** @type {[string, number[]][]} */
  const taken = await tab.evaluate(
    (sizes) => /** @type {any} */ (window).workbench.measured(...sizes),
    /** @type {[number, number, number, number]} */ ([POINTS, IMAGES, STEPS, BRUSHES]),
  );
  await browser.close();
  for (const [what, times] of taken) {
    const sorted = [...times].sort((a, b) => a - b);
    const at = (/** @type {number} */ share) => (sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? NaN).toFixed(1);
    console.log(`  ${what.padEnd(38)} median ${at(0.5).padStart(6)} ms, p95 ${at(0.95).padStart(6)} ms, of ${sorted.length}`);
  }
}

/** The page's own map and table over a made block, as one script. */
async function workbench() {
  const folder = mkdtempSync(join(tmpdir(), 'tiepoint-workbench-'));
  try {
    const entry = join(folder, 'entry.js');
    writeFileSync(entry, ENTRY.replaceAll('WWW', join(ROOT, 'www')));
    const result = await build({
      configFile: false,
      root: folder,
      logLevel: 'warn',
      build: { write: false, minify: false, lib: { entry, formats: ['iife'], name: 'workbench' } },
    });
    const [built] = Array.isArray(result) ? result : [result];
    const chunk = built && 'output' in built ? built.output[0] : undefined;
    if (chunk?.type !== 'chunk') throw new Error('the workbench was not built');
    return chunk.code;
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** It runs in the page. */
const ENTRY = `
import { Holder } from 'WWW/shared/state/store.ts';
import { Table } from 'WWW/shared/panel/table.ts';
import { keptBy, rowsOf } from 'WWW/block/state/columns.ts';
import { reduceBlock } from 'WWW/block/state/reducer.ts';
import { pointsOf } from 'WWW/block/state/selection.ts';
import { BLOCK_INITIAL } from 'WWW/block/state/state.ts';
import { BlockMap } from 'WWW/block/view/map/map.ts';

/** What an action takes: its handlers, and the frame after it with its layout and paint. The wait for the frame is left out. */
async function taking(action) {
  const frame = new Promise((resolve) => {
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

function madeView(count, images) {
  let state = 1;
  const noise = () => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32;
  const side = Math.round(Math.sqrt(images));
  const centre = (i) => [100 * (i % side), 100 * Math.floor(i / side), 300];
  const made = (length, value) => Float64Array.from({ length }, value);
  return {
    partial: false,
    images: Array.from({ length: images }, (_, i) => ({ name: 'image_' + i + '.jpg', width: 4000, height: 3000, camera: 0, features: 4000, places: 9, rays: 900, rmsePx: 0.3, oriented: true, position: centre(i), why: '' })),
    leftOut: [], strayMasks: [], strayMarks: [], remarks: [], cameras: [], warnings: [], formats: [], byRays: [], surveyed: [], groups: [],
    connections: Array.from({ length: 2 * images }, (_, i) => ({ images: [i % images, (i + (i < images ? 1 : side)) % images], outcome: { kind: 'connected', matches: 500 }, reason: '', geometry: '', shared: 300, chosen: 90 })),
    layout: { kind: 'oriented', places: made(2 * images, (_, i) => centre(i >> 1)[i % 2]) },
    points: {
      count, taking: count,
      sources: made(count, (_, i) => 3 * i),
      rays: Uint16Array.from({ length: count }, () => 2 + Math.floor(8 * noise())),
      rmsePx: made(count, () => noise()),
      positions: made(3 * count, (_, i) => (i % 3 === 2 ? 20 * noise() : 100 * side * noise())),
      errors: made(3 * count, () => noise()),
      confidence: made(count, () => noise()),
    },
    found: null, refinement: null, oriented: images, verdict: null, rmsePx: 0.3, sigma0Px: 0.3, checks: null, score: null,
  };
}

export async function measured(count, images, steps, brushes) {
  const view = madeView(count, images);
  const store = new Holder({ ...BLOCK_INITIAL, shown: { key: '', view, found: view, edits: [], files: [], steps: {}, seconds: 0 } }, reduceBlock);
  const looking = { choose: (choice) => store.dispatch({ type: 'choose', choice }), point: (choice) => store.dispatch({ type: 'point', choice }), open: () => undefined };
  const host = document.createElement('div');
  const dock = document.createElement('div');
  host.className = 'view block-view';
  dock.className = 'dock';
  host.style.height = '560px';
  dock.style.height = '320px';
  document.body.append(host, dock);
  const facts = { watch: () => undefined, ground: () => null };
  new BlockMap(host, store, looking, facts);
  let chosen = new Set();
  const table = new Table(dock, { testid: 'bench', words: { table: 'Tie points', region: 'Table' }, file: 'points.csv', filter: (filter) => store.dispatch({ type: 'filter', subject: 'points', filter }), choose: () => undefined, isChosen: (row) => chosen.has(row) });
  const rows = rowsOf('points', view);
  store.watch((s) => [s.selection.filters], ([filters]) => table.show(rows.count, rows.columns, undefined, filters.points));
  store.watch((s) => [s.selection.chosen], ([choice]) => { chosen = new Set(pointsOf(choice)); table.redraw(); });
  // Events of a bench are of no pointer that could be held.
  host.setPointerCapture = () => undefined;
  const { left, top, width, height } = host.getBoundingClientRect();
  const event = (type, x, y, more = {}) => host.dispatchEvent(new PointerEvent(type, { pointerId: 1, button: 0, bubbles: true, clientX: left + x, clientY: top + y, ...more }));
  const times = async (number, action) => {
    const all = [];
    for (let i = 0; i < number; i++) all.push(await taking(() => action(i)));
    return all;
  };
  await times(5, () => event('pointermove', 100, 100));
  event('pointerdown', width / 2, height / 2);
  const pan = await times(steps, (i) => event('pointermove', width / 2 + 200 * Math.sin(i / 8), height / 2 + 100 * Math.cos(i / 8)));
  event('pointerup', width / 2, height / 2);
  const wheel = (i) => host.dispatchEvent(new WheelEvent('wheel', { deltaY: i % 40 < 20 ? -120 : 120, bubbles: true, cancelable: true, clientX: left + width / 2, clientY: top + height / 2 }));
  const zoom = await times(steps, wheel);
  const hover = await times(steps, (i) => event('pointermove', (37 * i) % width, (53 * i) % height));
  const brush = [];
  for (let i = 0; i < brushes; i++) {
    const shift = { shiftKey: true };
    event('pointerdown', 5 + i, 5, shift);
    event('pointermove', width / 2, height / 2, shift);
    await taking(() => event('pointermove', width - 5, height - 5, shift));
    brush.push(await taking(() => event('pointerup', width - 5, height - 5, shift)));
  }
  const scroller = dock.querySelector('.rows');
  const scroll = await times(steps, (i) => { scroller.scrollTop = (7919 * 24 * i) % (24 * count); });
  const heads = [...dock.querySelectorAll('button.sort')];
  const sort = await times(brushes, (i) => heads[i % heads.length].click());
  const field = dock.querySelector('input.filter[data-key="point-rmse"]');
  const filter = await times(brushes, (i) => { field.value = '>0.' + (i % 9); field.dispatchEvent(new Event('input', { bubbles: true })); });
  return [
    ['pan', pan], ['zoom', zoom], ['the point under the pointer', hover], ['a rectangle, seen in the table', brush],
    ['table: a jump of the scroll bar', scroll], ['table: sort by a column', sort], ['table and map: a filter', filter],
  ];
}
`;
