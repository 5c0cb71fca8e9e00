/** The strategy that compares gradients: its points, its geometry, what it shows of a point; and masks. */

import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { grey_png } from '../../pkg/node.js';
import { again, choose, done, hosted, number, open, pair, part, pngs, ROOT, sample, saved, says, SHOTS, SKIP, SMALL, upload } from './page.js';

hosted();

/** Photographs that only some machines have. */
const FOUNTAIN = ['0003.jpg', '0004.jpg'].map((name) => join(ROOT, '..', 'shared', 'data', 'truth_terrestrial_fountain', name));

/** @param {import('playwright-core').Page} page @param {string} id */
const text = async (page, id) => (await part(page, id).textContent()) ?? '';

/** What the page knows.  @param {import('playwright-core').Page} page */
const everything = async (page) => JSON.parse((await saved(page, 'export-json')).toString());

/** How many pixels of a canvas are neither black nor white nor grey.  @param {import('playwright-core').Locator} canvas */
const coloured = (canvas) =>
  canvas.evaluate((element) => {
    const { width, height } = /** @type {HTMLCanvasElement} */ (element);
    const bytes = /** @type {HTMLCanvasElement} */ (element).getContext('2d')?.getImageData(0, 0, width, height).data ?? [];
    let count = 0;
    for (let i = 0; i < bytes.length; i += 4) if (bytes[i] !== bytes[i + 1] || bytes[i] !== bytes[i + 2]) count++;
    return count;
  });

test('gradients need no offset, and a point shows both descriptors, its candidates and its epipolar line', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await sample(page);
  await choose(page, 'matching.strategy', 'gradient');
  assert.equal(await page.locator('select[data-key="points.operator"] option:checked').textContent(), 'default: many scales');
  assert.ok((await number(page, 'score-right')) > 2900);
  assert.equal(await text(page, 'geometry-kind'), 'calibrated cameras');
  assert.ok((await number(page, 'geometry-sigma')) < (await number(page, 'geometry-threshold')));
  for (const key of ['points.threshold', 'window.side', 'matching.search']) assert.ok(!(await page.locator(`[data-key="${key}"]`).first().isVisible()), key);
  const { points, frames, offset, geometry } = await everything(page);
  assert.deepEqual([frames.left.length, frames.right.length], [points.left.length, points.right.length]);
  assert.ok(frames.left.every((/** @type {number[]} */ [scale]) => (scale ?? 0) > 0.5));
  assert.deepEqual([offset, geometry.model.kind], [null, 'calibrated']);
  await part(page, 'tab-matches').click();
  await page.locator('[data-testid="statistics-row"]').nth(8).click();
  await part(page, 'tab-point').click();
  await part(page, 'point-candidates').waitFor();
  const best = page.locator('[data-testid="point-candidates"] tbody tr');
  assert.equal(await best.count(), 50);
  const distances = (await best.locator('td:nth-child(5)').allTextContents()).map(Number);
  assert.deepEqual(
    distances,
    [...distances].sort((a, b) => a - b),
  );
  assert.equal(Number(await best.nth(1).locator('td:nth-child(6)').textContent()), Number(((distances[0] ?? 0) / (distances[1] ?? 1)).toFixed(3)));
  assert.match(await text(page, 'point-verdict'), /agrees with the geometry/);
  const [patches, descriptors] = ['point-patches', 'point-descriptors'].map((id) => page.locator(`[data-testid="${id}"] canvas`));
  assert.ok(patches && descriptors);
  assert.deepEqual([await patches.count(), await descriptors.count()], [2, 2]);
  assert.equal(await coloured(patches.first()), 0);
  assert.ok((await coloured(descriptors.first())) > 500 && (await coloured(descriptors.last())) > 500, 'the stars of the descriptors');
  assert.match(await text(page, 'point-line'), /epipolar line/);
  await page.screenshot({ path: join(SHOTS, 'gradients.png') });
  await choose(page, 'matching.strategy', 'moments');
  assert.equal(await page.locator('select[data-key="points.operator"] option:checked').textContent(), 'default: Ground 2');
  assert.ok(!(await part(page, 'geometry-section').isVisible()));
  assert.deepEqual(complaints, []);
  await close();
});

test('the matches are the same to the last byte for any number of workers', { skip: SKIP }, async () => {
  /** @type {{ csv: string, workers: number }[]} */
  const found = [];
  for (const workers of [1, 2, 3]) {
    const { page, complaints, close } = await open({ workers });
    await pair(page);
    await choose(page, 'matching.strategy', 'gradient');
    found.push({ csv: (await saved(page, 'export-csv')).toString(), workers: page.workers().length });
    assert.deepEqual(complaints, []);
    await close();
  }
  assert.ok((found[0]?.csv.split('\n').length ?? 0) > 1000);
  assert.ok(found.every(({ csv }) => csv === found[0]?.csv));
  // Those of the images and of the pair are there in any case.
  assert.deepEqual(
    found.map(({ workers }) => workers - (found[0]?.workers ?? 0)),
    [0, 2, 3],
  );
});

test('photos without a base are named and not oriented', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await page.waitForFunction(() => document.querySelector('[data-testid="status"]')?.textContent?.startsWith('Ready'));
  await part(page, 'tab-simulate').click();
  for (const [field, value] of /** @type {const} */ ([
    ['base_mm', '0'],
    ['by_mm', '0'],
    ['bz_mm', '0'],
    ['kappa_deg', '5'],
  ])) {
    await page.locator(`input[data-key="flight.${field}"]:not([type="range"])`).first().fill(value);
  }
  await part(page, 'render-flight').click();
  await done(page);
  await part(page, 'tab-settings').click();
  await choose(page, 'matching.strategy', 'gradient');
  assert.equal(await text(page, 'geometry-kind'), 'rotation');
  assert.match(await text(page, 'degenerate-pure-rotation'), /no base/i);
  assert.match(await text(page, 'orientation-reason'), /no base that can be told \(pure rotation\)/i);
  assert.match(await text(page, 'status'), /Not oriented: no base that can be told \(pure rotation\).* matches of /i);
  assert.equal(await part(page, 'status').getAttribute('data-kind'), 'partial');
  await page.screenshot({ path: join(SHOTS, 'rotation.png') });
  assert.deepEqual(complaints, []);
  await close();
});

test('one photo twice, photos of different ground and a photo of one pixel are told to be that', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  const [left, right] = pngs();
  assert.ok(left && right);
  await page.locator('select[data-key="matching.strategy"]').selectOption('gradient');
  await part(page, 'file-input').setInputFiles([left, { ...left, name: 'copy.png' }]);
  assert.match(await done(page), /Not oriented: no base: both images show the same at the same places \(is it one photo twice\?\)\./);
  assert.equal(await text(page, 'next'), 'Replace the right image …');
  const { width_px: width, height_px: height } = SMALL;
  const noise = Uint8Array.from({ length: width * height }, (_, i) => Math.imul(i ^ (i >>> 7), 2654435761) >>> 24);
  const replace = async (/** @type {ReturnType<typeof upload>} */ file) => {
    const [chooser] = await Promise.all([page.waitForEvent('filechooser'), part(page, 'replace-right').click()]);
    await chooser.setFiles([file]);
  };
  await replace(upload('noise.png', grey_png(width, height, noise), 'image/png'));
  await again(page);
  assert.match(await text(page, 'status'), /Not oriented: .*Do both photos show the same ground\?/);
  // No camera helps them, although none is known.
  assert.equal(await text(page, 'next'), 'Open other photos …');
  assert.equal(await part(page, 'status').getAttribute('data-kind'), 'partial');
  await replace(upload('tiny.png', grey_png(1, 1, new Uint8Array(1)), 'image/png'));
  await page.waitForFunction(() => /^Right image: the image has 1 × 1 px/.test(document.querySelector('[data-testid="status"]')?.textContent ?? ''));
  await replace(right);
  await again(page);
  assert.ok((await number(page, 'count-matches')) > 500, 'it goes on with another image');
  assert.deepEqual(complaints, []);
  await close();
});

test('a focal length that only the matches tell orients the photos and is shown as estimated', {
  skip: SKIP || (FOUNTAIN.every((file) => existsSync(file)) ? false : 'skipped: no photographs'),
}, async () => {
  const { page, complaints, close } = await open();
  await part(page, 'file-input').setInputFiles(FOUNTAIN);
  await done(page);
  await choose(page, 'matching.strategy', 'moments');
  assert.match(await text(page, 'orientation-reason'), /no camera is given/);
  await choose(page, 'matching.strategy', 'gradient');
  const [, focal = NaN, error = NaN] = (/^(\d+) ± (\d+) px$/.exec(await text(page, 'geometry-focal')) ?? []).map(Number);
  // The cameras were calibrated: 2759.48 px at 3072 px width.
  assert.ok(Math.abs(focal - 0.5 * 2759.48) < 5 * error && error < 100, `${focal} ± ${error} px`);
  assert.match(await text(page, 'estimated-focal'), /estimated from the matches/);
  assert.equal(await text(page, 'geometry-kind'), 'cameras with the focal length estimated from the matches');
  assert.ok((await number(page, 'degrees-of-freedom')) > 1000);
  await page.screenshot({ path: join(SHOTS, 'estimated-focal.png') });
  assert.deepEqual(complaints, []);
  await close();
});

test('a mask leaves points out, is shown, and goes with its image; one of another size is refused', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await part(page, 'file-input').setInputFiles(pngs());
  await done(page);
  const all = await number(page, 'count-left-after_suppression');
  await part(page, 'file-input').setInputFiles([upload('left-mask.png', grey_png(40, 30, new Uint8Array(1200)), 'image/png')]);
  await page.waitForFunction(() => /as large as its image/.test(document.querySelector('[data-testid="status"]')?.textContent ?? ''));
  assert.equal(await number(page, 'count-left-after_suppression'), all);
  const middle = SMALL.width_px / 2;
  const half = Uint8Array.from({ length: SMALL.width_px * SMALL.height_px }, (_, i) => (i % SMALL.width_px < middle ? 0 : 255));
  const [chooser] = await Promise.all([page.waitForEvent('filechooser'), part(page, 'mask-left').click()]);
  await chooser.setFiles([upload('half.png', grey_png(SMALL.width_px, SMALL.height_px, half), 'image/png')]);
  await page.waitForFunction(
    (before) => Number(document.querySelector('[data-testid="count-left-after_suppression"]')?.textContent?.replaceAll(/\D/g, '')) < before,
    all,
  );
  assert.match(await done(page), /masks 50\.0 % of the left image/);
  const { points, images } = await everything(page);
  assert.ok(points.left.length > 500 && points.left.every((/** @type {number[]} */ [x]) => (x ?? 0) >= middle));
  assert.ok(points.right.some((/** @type {number[]} */ [x]) => (x ?? 0) < middle));
  assert.deepEqual([images.left.mask, images.right.mask], ['half.png', null]);
  assert.ok((await coloured(part(page, 'layer-masks'))) > 1000, 'the overlay');
  await page.screenshot({ path: join(SHOTS, 'mask.png') });
  await part(page, 'unmask-left').click();
  await page.waitForFunction(
    (before) => Number(document.querySelector('[data-testid="count-left-after_suppression"]')?.textContent?.replaceAll(/\D/g, '')) === before,
    all,
  );
  await done(page);
  assert.equal(await coloured(part(page, 'layer-masks')), 0);
  assert.deepEqual(complaints, []);
  await close();
});

test('of a match that was placed by least squares the right picture is shown, and that no interest point is there', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await sample(page);
  await part(page, 'tab-matches').click();
  const rows = page.locator('[data-testid="statistics-row"]');
  await rows.first().waitFor();
  // What was filled in stands at the end.
  await rows.first().evaluate((row) => row.closest('.rows')?.scrollTo(0, 1e7));
  await page.waitForFunction(
    () => Number([...document.querySelectorAll('[data-testid="statistics-row"]')].at(-1)?.firstElementChild?.textContent?.replaceAll(/\D/g, '')) > 1000,
  );
  await rows.last().click();
  await part(page, 'tab-point').click();
  await says(page, 'point-patches', /Placed by least squares: no interest point here\./);
  await says(page, 'point-verdict', /least squares matching placed it where the matches around it predict it, correlation 0\.\d{4}\.$/);
  assert.match(await text(page, 'point-predicted'), /^The match is none of these/);
  assert.equal(await text(page, 'match-measure'), '–');
  assert.match(await text(page, 'match-correlation'), /^0\.\d{4}$/);
  const canvases = (/** @type {string} */ id) => page.locator(`[data-testid="${id}"] canvas`);
  assert.deepEqual([await canvases('point-patches').count(), await canvases('point-descriptors').count()], [1, 2]);
  const greys = await canvases('point-descriptors')
    .last()
    .evaluate((canvas) => {
      const { data } = /** @type {any} */ (canvas).getContext('2d').getImageData(0, 0, 336, 336);
      return new Set(data).size;
    });
  assert.ok(greys > 50, `${greys} grey values`);
  assert.deepEqual(complaints, []);
  await close();
});
