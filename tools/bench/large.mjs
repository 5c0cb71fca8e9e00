/** Large images in the page: a pair of 12 MP from the files to the orientation, and one image of 100 MP. */

import { existsSync, mkdirSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { photoFile } from '../../pkg/block/photo.js';
import { block_flight_preset, BlockScene, grey_png } from '../../pkg/node.js';
import { DATA, TARGET } from '../lib/paths.mjs';
import { processOfPage, watchMemory } from './page-memory.mjs';

/**
 * @typedef {import('playwright-core').Page} Page
 * @typedef {import('playwright-core').Browser} Browser
 * @typedef {() => Promise<Browser>} Launch
 */

const PHOTOGRAPHS = ['IMG_9401.jpg', 'IMG_9402.jpg'].map((name) => join(DATA, 'pair_full_caliterra', name));
/** Of the pair that stands in where there are no photographs. */
const FLIGHT = { ...block_flight_preset('features'), strips: 1, exposures: 2, width_px: 4000, height_px: 3000, pixel_mm: 0.018 };
/** What the bench makes is kept: rendering takes its time. */
const MADE = join(TARGET, 'bench');
/** Of the large image, px, and of the picture that fills it. */
const SIDE = 10_000;
const TILE = 2_500;
const PATIENCE_MS = 300_000;

/** @param {string} url of the page @param {Launch} launch a browser of its own for each figure, so that memory is not what others left */
export async function largeImages(url, launch) {
  console.log('  a pair of 12 MP by gradients, two workers: files to orientation, drawn');
  await report(url, launch, await pairFiles(), (tab) =>
    tab.waitForFunction(() => document.querySelector('[data-testid="status"][data-kind="done"]'), undefined, { timeout: PATIENCE_MS }),
  );
  const png = await made('large.png', mosaic);
  for (const file of [png, await made('large.jpg', () => asJpeg(png, launch))]) {
    console.log(
      `  one image of 100 MP, ${file.slice(-3)} of ${(statSync(file).size / 1e6).toFixed(0)} MB, two workers: opened, points of many scales found, drawn`,
    );
    await report(url, launch, [file], (tab) =>
      tab.waitForFunction(
        () =>
          document.querySelector('[data-testid="status"]')?.textContent?.startsWith('One image') &&
          /\d/.test(document.querySelector('[data-testid="count-left-after_suppression"]')?.textContent ?? ''),
        undefined,
        { timeout: PATIENCE_MS },
      ),
    );
  }
}

/** @param {string} url @param {Launch} launch @param {string[]} files @param {(tab: Page) => Promise<unknown>} finished */
async function report(url, launch, files, finished) {
  const browser = await launch();
  try {
    const context = await browser.newContext({ viewport: { width: 1440, height: 900 } });
    const tab = await context.newPage();
    await tab.addInitScript(() => Object.defineProperty(navigator, 'hardwareConcurrency', { get: () => 2 }));
    await tab.goto(url);
    const memory = await watchMemory(tab);
    await tab.waitForFunction(() => document.querySelector('[data-testid="sample"]:not([disabled])'));
    await tab.locator('select[data-key="matching.strategy"]').selectOption('gradient');
    await watchPauses(tab);
    const before = await processOfPage(browser);
    const started = performance.now();
    await tab.locator('[data-testid="file-input"]').setInputFiles(files);
    await finished(tab);
    // Drawn with the frame after the next.
    await tab.evaluate(
      () =>
        new Promise((resolve) => {
          requestAnimationFrame(() => requestAnimationFrame(resolve));
        }),
    );
    const seconds = (performance.now() - started) / 1000;
    const pause = await tab.evaluate(() => /** @type {Window & { longestPause?: number }} */ (window).longestPause ?? NaN);
    const after = await processOfPage(browser);
    const { wasm, heaps } = await memory();
    const status = (await tab.locator('[data-testid="status"]').textContent()) ?? '';
    console.log(
      `    ${seconds.toFixed(1)} s, ${(after.seconds - before.seconds).toFixed(1)} s of processor time; longest pause of the page ${pause.toFixed(0)} ms; wasm ${wasm.toFixed(0)} MiB and heaps ${heaps.toFixed(0)} MiB${Number.isNaN(after.peak) ? '' : `; its process at most ${after.peak.toFixed(0)} MiB`}`,
    );
    console.log(`    ${status}`);
  } finally {
    await browser.close();
  }
}

/** The longest time between two ticks: an input would have waited so long.  @param {Page} tab */
export async function watchPauses(tab) {
  await tab.evaluate(() => {
    const watch = /** @type {Window & { longestPause?: number }} */ (window);
    let last = performance.now();
    watch.longestPause = 0;
    setInterval(() => {
      const now = performance.now();
      watch.longestPause = Math.max(watch.longestPause ?? 0, now - last);
      last = now;
    }, 4);
  });
}

/** @param {string} name @param {() => Uint8Array | Promise<Uint8Array>} make @returns {Promise<string>} the path of a file that is made once */
async function made(name, make) {
  const path = join(MADE, name);
  mkdirSync(MADE, { recursive: true });
  if (!existsSync(path)) writeFileSync(path, await make());
  return path;
}

/** The two photos of a pair of 12 MP.  @returns {Promise<string[]>} */
export async function pairFiles() {
  if (PHOTOGRAPHS.every((file) => existsSync(file))) return PHOTOGRAPHS;
  console.log('    simulated: no photographs are there (TIEPOINT_DATA names their place)');
  return [
    await made('pair-12mp-0.png', () => photoFile({ flight: FLIGHT, index: 0 })),
    await made('pair-12mp-1.png', () => photoFile({ flight: FLIGHT, index: 1 })),
  ];
}

/** A simulated photo beside its mirror images, so that it goes on without an edge. */
function mosaic() {
  const scene = new BlockScene({ ...FLIGHT, width_px: TILE, height_px: TILE });
  const { grey } = scene.photo(0);
  scene.free();
  const folded = (/** @type {number} */ at) => (Math.floor(at / TILE) % 2 === 0 ? at % TILE : TILE - 1 - (at % TILE));
  const large = new Uint8Array(SIDE * SIDE);
  for (let row = 0; row < SIDE; row += 1) {
    const from = folded(row) * TILE;
    for (let col = 0; col < SIDE; col += 1) large[row * SIDE + col] = grey[from + folded(col)] ?? 0;
  }
  return grey_png(SIDE, SIDE, large);
}

/** The same image as a browser writes it.  @param {string} png @param {Launch} launch @returns {Promise<Buffer>} */
async function asJpeg(png, launch) {
  const browser = await launch();
  try {
    const tab = await browser.newPage();
    await tab.setContent('<input type="file">');
    await tab.locator('input').setInputFiles([png]);
    const base64 = await tab.evaluate(async () => {
      const file = document.querySelector('input')?.files?.[0];
      if (!file) throw new Error('the image did not arrive');
      const bitmap = await createImageBitmap(file);
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      canvas.getContext('2d')?.drawImage(bitmap, 0, 0);
      const reader = new FileReader();
      reader.readAsDataURL(await canvas.convertToBlob({ type: 'image/jpeg', quality: 0.9 }));
      await new Promise((resolve) => {
        reader.onload = resolve;
      });
      return String(reader.result).replace(/^[^,]*,/, '');
    });
    return Buffer.from(base64, 'base64');
  } finally {
    await browser.close();
  }
}
