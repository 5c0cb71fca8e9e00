import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { unzipSync } from 'fflate';
import { BlockScene } from '../../pkg/node.js';
import { greyPng } from '../../pkg/command/png.js';
import { DIST, done, hosted, number, open, part, saved, SHOTS, SKIP } from './page.js';

hosted('/block/');

/** Small photos: six of them are rendered and matched in a few seconds. */
const FLIGHT = { strips: 2, exposures: 3, width_px: 480, height_px: 360, pixel_mm: 0.15 };

/** @typedef {import('playwright-core').Page} Page */

/** @param {Page} page @param {RegExp} pattern @returns {Promise<string>} the status line once it is so */
async function status(page, pattern) {
  await page.waitForFunction(([source]) => new RegExp(source ?? '').test(document.querySelector('[data-testid="block-status"]')?.textContent ?? ''), [pattern.source], { timeout: 40_000 });
  return (await part(page, 'block-status').textContent()) ?? '';
}

/** A page that shows its part for blocks.  @param {Parameters<typeof open>[0]} [how] */
async function block(how) {
  const opened = await open(how);
  await part(opened.page, 'mode-block').click();
  await opened.page.waitForFunction(() => document.querySelector('[data-testid="block-simulate"]')?.hasAttribute('disabled') === false);
  return opened;
}

/** Photographs the flight in the page.  @param {Page} page */
async function photograph(page, flight = FLIGHT) {
  await part(page, 'tab-block-flight').click();
  for (const [field, value] of Object.entries(flight)) await page.locator(`input[data-key="block_flight.${field}"]`).first().fill(String(value));
  await part(page, 'block-photograph').click();
  await status(page, /Press Run/);
}

/** A folder with photos of the flight and what is no image.  @param {number} count */
function photoFolder(count) {
  const folder = mkdtempSync(join(tmpdir(), 'tiepoint-photos-'));
  const scene = new BlockScene(FLIGHT);
  for (let index = 0; index < count; index++) {
    const { width, height, grey } = scene.photo(index);
    writeFileSync(join(folder, `photo_${index}.png`), greyPng(width, height, grey));
  }
  scene.free();
  writeFileSync(join(folder, 'truth.json'), '{}');
  return folder;
}

/** Drops files of these names that hold no image.  @param {Page} page @param {string[]} names */
async function drop(page, names) {
  const transfer = await page.evaluateHandle((given) => {
    const data = new DataTransfer();
    for (const name of given) data.items.add(new File(['no image'], name));
    return data;
  }, names);
  for (const type of ['dragenter', 'dragover', 'drop']) await part(page, 'block-picture').dispatchEvent(type, { dataTransfer: transfer });
}

test('a simulated block is matched; picture, matrix, pair and exports answer', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  await photograph(page);
  await part(page, 'block-run').click();
  assert.match(await status(page, /^(Done|The block was)/), /^Done: 6 images/);
  assert.ok(await number(page, 'block-points-count') > 0);
  const [right = 0, all = 1] = ((await part(page, 'score-points').textContent()) ?? '').split(' of ').map(Number);
  assert.ok(right > 0.9 * all, `${right} of ${all}`);
  assert.match((await part(page, 'stage-pairs').textContent()) ?? '', /15 of 15/);

  await part(page, 'block-picture').focus();
  await page.keyboard.press('n');
  assert.match((await part(page, 'block-chosen').textContent()) ?? '', /photo_00000\.png: .*connected with/);
  await page.keyboard.press('c');
  assert.match((await part(page, 'block-chosen').textContent()) ?? '', /photo_00000\.png – photo_00001\.png: connected by \d+ matches/);
  const box = await part(page, 'block-picture').boundingBox();
  assert.ok(box);
  // Somewhere on a raster over the picture the pointer meets an image or a line.
  let said = '';
  for (let i = 0; i < 144 && !/connected/.test(said); i++) {
    await page.mouse.move(box.x + box.width * (0.05 + 0.08 * (i % 12)), box.y + box.height * (0.05 + 0.08 * Math.floor(i / 12)));
    said = (await part(page, 'block-pointed').textContent()) ?? '';
    if (/^Point at/.test(said)) said = '';
  }
  assert.match(said, /connected/);
  await page.screenshot({ path: join(SHOTS, 'block-picture.png') });

  await part(page, 'block-show-matrix').click();
  await part(page, 'block-matrix').focus();
  await page.keyboard.press('ArrowRight');
  const cell = await part(page, 'block-chosen').textContent();
  assert.match(cell ?? '', / – .*: (connected by|not connected: )/);
  await page.screenshot({ path: join(SHOTS, 'block-matrix.png') });

  await part(page, 'block-open-pair').click();
  assert.match(await done(page), /matches/);
  assert.ok(await number(page, 'count-matches') > 50);
  assert.match((await part(page, 'of-block').textContent()) ?? '', /photo_0000\d\.png – photo_0000\d\.png/);
  await page.screenshot({ path: join(SHOTS, 'block-pair.png') });
  await part(page, 'back-to-block').click();
  assert.equal(await part(page, 'block-chosen').textContent(), cell);

  await part(page, 'tab-block-points').click();
  await part(page, 'sort-point-rays').click();
  await part(page, 'sort-point-rays').click();
  const rays = (await page.locator('[data-testid="block-points"] tbody tr:not(.filler) td:nth-child(2)').allTextContents()).map(Number);
  assert.deepEqual(rays, [...rays].sort((a, b) => b - a));
  assert.ok((rays[0] ?? 0) >= 3 && rays.length < 100);

  await part(page, 'block-export-kind').selectOption('colmap');
  const archive = unzipSync(new Uint8Array(await saved(page, 'block-export')));
  assert.ok(Object.keys(archive).some((name) => name.endsWith('cameras.txt')), Object.keys(archive).join());
  await part(page, 'block-export-kind').selectOption('project');
  const project = await saved(page, 'block-export');
  await status(page, /was saved/);
  await part(page, 'block-clear').click();
  assert.ok(await part(page, 'block-welcome').isVisible());
  await part(page, 'block-files-input').setInputFiles([{ name: 'block.tiepoint', mimeType: 'application/octet-stream', buffer: project }]);
  await status(page, /was opened/);
  assert.match((await part(page, 'block-connected').textContent()) ?? '', /of 15 tried/);
  await part(page, 'block-files-input').setInputFiles([{ name: 'cut.tiepoint', mimeType: 'application/octet-stream', buffer: project.subarray(0, 100) }]);
  await status(page, /cut\.tiepoint cannot be opened/);
  assert.deepEqual(complaints, []);
  await close();
});

test('a run that was cancelled goes on, and an image that cannot be read is listed', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  const folder = photoFolder(4);
  await part(page, 'block-folder-input').setInputFiles(folder);
  await status(page, /^4 images in the block\. 1 file left aside/);
  await drop(page, ['broken.jpg', 'notes.txt']);
  await status(page, /^5 images in the block\. 1 file left aside/);
  await part(page, 'block-run').click();
  // What cannot be read is not kept: the second is.
  await page.waitForFunction(() => /^Images: features[2-4] of 5/.test(document.querySelector('[data-testid="stage-images"]')?.textContent ?? ''), undefined, { polling: 10 });
  await part(page, 'block-cancel').click();
  await status(page, /^Cancelled/);
  await part(page, 'block-run').click();
  assert.match(await status(page, /^(Done|The block was)/), /^Done: 4 images.*1 left out/);
  assert.match((await part(page, 'stage-images').textContent()) ?? '', /5 of 5, [1-4] of them from before/);
  assert.match((await part(page, 'block-left-out').textContent()) ?? '', /broken\.jpg: .+/);
  await part(page, 'tab-block-images').click();
  const rows = await page.locator('[data-testid="block-images"] tbody tr:not(.filler)').allTextContents();
  assert.equal(rows.length, 5);
  assert.ok(rows.some((text) => text.startsWith('broken.jpg')));
  rmSync(folder, { recursive: true });
  assert.deepEqual(complaints, []);
  await close();
});

test('the page in one file runs a block offline', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block({ url: pathToFileURL(join(DIST, 'tiepoint.html')).href, options: { offline: true } });
  await photograph(page, { ...FLIGHT, strips: 1 });
  await part(page, 'block-run').click();
  assert.match(await status(page, /^(Done|The block was)/), /^Done: 3 images/);
  assert.deepEqual(complaints, []);
  await close();
});

for (const [name, width, height, colorScheme] of /** @type {const} */ ([['narrow', 390, 844, 'dark'], ['tablet', 1024, 768, 'light']])) {
  test(`a ${name} screen shows the block without scrolling sideways`, { skip: SKIP }, async () => {
    const { page, complaints, close } = await block({ options: { viewport: { width, height }, colorScheme } });
    await page.screenshot({ path: join(SHOTS, `block-${name}.png`) });
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth));
    for (const id of ['mode-pair', 'block-files', 'block-run', 'block-export-kind']) assert.ok(await part(page, id).isVisible(), id);
    assert.deepEqual(complaints, []);
    await close();
  });
}
