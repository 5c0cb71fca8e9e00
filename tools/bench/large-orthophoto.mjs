/** An orthophoto of 400 million pixels in the page: how soon it is opened and looked at, what memory that takes, how soon a photograph of 12 million is placed on it. */

import { mkdtempSync, readdirSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import { inParts } from '../../pkg/command/files.js';
import { OrthophotoReference } from '../../pkg/node.js';
import { servePage } from '../lib/page-server.mjs';
import { readJson, ROOT } from '../lib/paths.mjs';
import { must, run } from '../lib/process.mjs';
import { findChromium } from '../lib/setup.mjs';
import { watchMemory } from './page-memory.mjs';
import { PYTHON, pythonLacks } from './python.mjs';

const SIDE = 20_000;
const GSD_M = 0.2;
const FLIGHT = ['--strips', '1', '--exposures', '3', '--width-px', '4000', '--height-px', '3000', '--pixel-mm', '0.009', '--orthophoto', String(GSD_M)];
const FLAGS = ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'];
const COMMAND = join(ROOT, 'pkg', 'bin', 'tiepoint.js');

export async function largeOrthophoto() {
  console.log(`Orthophoto of ${SIDE} x ${SIDE} px in the page`);
  const executablePath = findChromium();
  if (!executablePath) return console.log('  skipped: no Chromium (install it or name it in CHROMIUM)');
  const lacks = pythonLacks({ rasterio: 'rasterio' });
  if (lacks) return console.log(`  skipped: ${lacks}`);
  const folder = mkdtempSync(join(tmpdir(), 'tiepoint-large-orthophoto-'));
  try {
    for (const seed of [1, 2])
      await must(process.execPath, [COMMAND, 'simulate', '--block', '--out', join(folder, `town${seed}`), ...FLIGHT, '--seed', String(seed)], { quiet: true });
    for (const compression of ['JPEG', 'DEFLATE']) {
      const file = join(folder, `${compression}.tif`);
      const towns = [1, 2].map((seed) => join(folder, `town${seed}`, 'orthophoto.tif'));
      await must(PYTHON, [join(ROOT, 'tools', 'bench', 'large_orthophoto.py'), file, String(SIDE), ...towns, compression], { quiet: true });
      await measured(executablePath, file, join(folder, 'town1'));
    }
    await beside(join(folder, 'JPEG.tif'), join(folder, 'town1'));
    await kinds(folder, join(folder, 'town1', 'orthophoto.tif'));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** @param {string} executablePath @param {string} orthophoto @param {string} town */
async function measured(executablePath, orthophoto, town) {
  const server = await servePage();
  const browser = await chromium.launch({ executablePath, args: FLAGS });
  try {
    const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
    const memory = await watchMemory(page);
    await page.goto(server.url);
    const part = (/** @type {string} */ id) => page.locator(`[data-testid="${id}"]`);
    await part('mode-block').click();
    await part('block-files-input').waitFor({ state: 'attached' });
    await page.waitForFunction(() => document.querySelector('[data-testid="block-simulate"]:not([disabled])'));
    const started = performance.now();
    await part('block-files-input').setInputFiles(orthophoto);
    await isPainted(page);
    const opened = performance.now() - started;
    // Into the middle, step by step, until pixels of the file are shown one by one.
    const views = [];
    const box = await part('ortho-plan').boundingBox();
    if (!box) throw new Error('the orthophoto is not drawn');
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    for (let step = 0; step < 12; step += 1) {
      const before = performance.now();
      await page.mouse.wheel(0, -400);
      await isStill(page);
      views.push(performance.now() - before);
    }
    const { wasm, heaps } = await memory();
    const size = statSync(orthophoto).size / 1e6;
    console.log(
      `  ${size.toFixed(0)} MB: on the screen ${(opened / 1000).toFixed(2)} s after it was given; zoomed in, ${Math.max(...views).toFixed(0)} ms a step at most until all is drawn`,
    );
    console.log(`    memory: ${wasm.toFixed(0)} MiB of wasm, ${heaps.toFixed(0)} MiB of heaps`);

    // It is placed as soon as it is given.
    const before = performance.now();
    await part('block-files-input').setInputFiles([join(town, 'heights.tif'), join(town, 'photos', photoOf(town))]);
    await page.waitForFunction(() => /^Placed by/.test(document.querySelector('[data-testid="block-status"]')?.textContent ?? ''), undefined, {
      timeout: 300_000,
    });
    const after = await memory();
    console.log(
      `    a photograph of 12 MP placed ${((performance.now() - before) / 1000).toFixed(1)} s after it was given; then ${after.wasm.toFixed(0)} MiB of wasm`,
    );
  } finally {
    await browser.close();
    await server.close();
  }
}

/** @param {string} town */
const photoOf = (town) => readdirSync(join(town, 'photos')).sort()[1] ?? '';

/** Waits until the orthophoto is drawn.  @param {import('playwright-core').Page} page */
const isPainted = (page) =>
  page.waitForFunction(
    () => {
      const canvas = document.querySelector('[data-testid="ortho-plan"] [data-testid="layer-picture"]');
      if (!(canvas instanceof HTMLCanvasElement) || canvas.width < 10) return false;
      const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d')).getImageData(0, 0, canvas.width, canvas.height);
      const seen = new Set();
      for (let i = 0; i < data.length && seen.size < 40; i += 4 * 97) if ((data[i + 3] ?? 0) > 0) seen.add(data[i]);
      return seen.size >= 40;
    },
    undefined,
    { timeout: 120_000 },
  );

/** Waits until the canvas shows the same in two turns of the page, some time apart.  @param {import('playwright-core').Page} page */
const isStill = (page) =>
  page.evaluate(async () => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector('[data-testid="ortho-plan"] [data-testid="layer-picture"]'));
    const shown = () => canvas.toDataURL();
    for (let [last, now] = ['', shown()]; last !== now; [last, now] = [now, shown()]) await new Promise((resolve) => setTimeout(resolve, 30));
  });

/** The command and OpenCV on the same picture, one after the other.  @param {string} orthophoto @param {string} town */
async function beside(orthophoto, town) {
  const [heights, photo, truth] = [join(town, 'heights.tif'), join(town, 'photos', photoOf(town)), join(town, 'truth.json')];
  const started = performance.now();
  const { code, output } = await run(process.execPath, [COMMAND, 'place', photo, '--orthophoto', orthophoto, '--heights', heights, '--json'], { quiet: true });
  const taken = ((performance.now() - started) / 1000).toFixed(1);
  if (code !== 0 && code !== 3) throw new Error(`placing ended with ${code}\n${output.slice(-2000)}`);
  const [placed] = JSON.parse(output.slice(output.indexOf('{'))).images;
  const { images } = readJson(truth).block;
  const at = images.find((/** @type {{ name: string }} */ { name }) => name === photoOf(town)).pose.position;
  const off = Math.hypot(...placed.placement.pose.position.map((/** @type {number} */ v, /** @type {number} */ axis) => v - at[axis]));
  console.log(`  the command (one thread, camera not known): ${placed.verdict.links} links, projection centre off by ${off.toFixed(2)} m, in ${taken} s`);
  const rival = await run(PYTHON, [join(ROOT, 'tools', 'bench', 'rivals', 'orthophoto.py'), orthophoto, heights, photo, truth], { quiet: true });
  console.log(rival.code === 0 ? `  ${rival.output.trim().split('\n').at(-1)}` : '  OpenCV: skipped (pip install opencv-python-headless rasterio)');
}

/** What lies within so many px of nothing is not shown. */
const EDGE = 8;

/** Large orthophotos of many kinds, whose pixels are those that GDAL reads.  @param {string} folder @param {string} own */
async function kinds(folder, own) {
  const { code, output } = await run(PYTHON, [join(ROOT, 'tools', 'bench', 'orthophoto_kinds.py'), folder, own], { quiet: true });
  if (code !== 0) throw new Error(`orthophoto_kinds.py ended with ${code}\n${output.slice(-2000)}`);
  console.log('  grey values and what is shown, beside GDAL:');
  for (const line of output.split('\n').filter((line) => line.startsWith('{'))) {
    const { name, file, part, grey, mask } = JSON.parse(line);
    const reference = OrthophotoReference.open(inParts(file));
    const found = reference.picture(part.column, part.row, part.width, part.height, 0);
    const isInParts = reference.info().in_parts;
    reference.free();
    const [wanted, shown] = [readFileSync(grey), readFileSync(mask)];
    let [most, number, wrong] = [0, 0, 0];
    for (let k = 0; k < found.length; k += 1) {
      const value = found[k] ?? 0;
      if (value > 0 && shown[k] === 0) wrong += 1;
      else if (value === 0 && shown[k] === 1) wrong += isNearNothing(shown, k, part.width) ? 0 : 1;
      else if (value > 0) [most, number] = [Math.max(most, Math.abs(value - Math.max(wanted[k] ?? 0, 1))), number + 1];
    }
    console.log(`    ${name.padEnd(24)} ${isInParts ? 'in parts' : 'whole'}: ${number} px shown, off by ${most} at most; ${wrong} px shown or hidden wrongly`);
  }
}

/** Whether nothing is shown near a pixel.  @param {Buffer} shown @param {number} k @param {number} width */
function isNearNothing(shown, k, width) {
  for (let down = -EDGE; down <= EDGE; down += 1) for (let right = -EDGE; right <= EDGE; right += 1) if (shown[k + down * width + right] === 0) return true;
  return false;
}
