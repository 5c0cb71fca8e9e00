/** The plots of a block, in step with its other views. */

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { block, FLIGHT, photos, status } from './blocks.js';
import { hosted, part, saved, says, SHOTS, SKIP } from './page.js';

hosted('/plots/');

test('nothing below the answer moves when a saved file is named there, however wide the window is', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block({ fresh: true });
  await photos(page, FLIGHT, /^(Oriented|Weak orientation): /);
  await part(page, 'block-show-plots').click();
  const line = part(page, 'block-status');
  const high = () => part(page, 'block-answer').evaluate((answer) => answer.getBoundingClientRect().height);
  /** @type {Map<number, number>} */
  const before = new Map();
  const widths = Array.from({ length: 30 }, (_, i) => 740 + 20 * i);
  for (const width of widths) {
    await page.setViewportSize({ width, height: 800 });
    before.set(width, await high());
  }
  assert.equal(await line.locator('.done-since').count(), 0);
  await saved(page, 'plot-png');
  await status(page, /block-images\.png was saved\.$/);
  /** @type {string[]} */
  const moved = [];
  for (const width of widths) {
    await page.setViewportSize({ width, height: 800 });
    if ((await high()) !== before.get(width)) moved.push(`${width}: ${before.get(width)} to ${await high()}`);
  }
  assert.deepEqual(moved, []);
  assert.deepEqual(complaints, []);
  await close();
});

test('plots say what they show, choose by press and rectangle in all views, and are saved as picture and table', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  await photos(page);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  await part(page, 'block-show-plots').click();
  await says(page, 'block-plot-words', /^6 values over image\. RMSE of the residuals: median 0\.\d{3}, from 0\.\d{3} to 0\.\d{3} px\.$/);
  const box = await part(page, 'block-plot').boundingBox();
  assert.ok(box);
  const at = (/** @type {number} */ x, /** @type {number} */ y) =>
    /** @type {const} */ ([(box?.x ?? 0) + x * (box?.width ?? 0), (box?.y ?? 0) + y * (box?.height ?? 0)]);
  // The bar in the middle is one of an image; what the pointer is over is said.
  await page.mouse.move(...at(0.5, 0.7));
  await says(page, 'block-pointed', /^photo_0000[23]\.png: /);
  await page.screenshot({ path: join(SHOTS, 'plots-images.png') });
  await page.mouse.click(...at(0.5, 0.7));
  await says(page, 'block-chosen', /^photo_0000[23]\.png: /);
  const table = (await saved(page, 'plot-csv')).toString().trimEnd().split('\n');
  await status(page, /block-images\.csv was saved\.$/);
  // The room of what is said was there before.
  assert.deepEqual(await part(page, 'block-plot').boundingBox(), box);
  assert.equal(table[0], 'Image,RMSE of the residuals [px]');
  assert.match(table[1] ?? '', /^photo_00000\.png,0\.\d+$/);
  assert.equal(table.length, 7);

  // All points, by a rectangle over their standard errors; then those of one number of rays.
  await part(page, 'plot-name').selectOption('sigma-height');
  const [, points = ''] = /^(\d+) values over [XY]\. Standard error in height: /.exec(await says(page, 'block-plot-words', /height/)) ?? [];
  assert.ok(Number(points) > 20, points);
  await page.keyboard.down('Shift');
  await page.mouse.move(...at(0.01, 0.01));
  await page.mouse.down();
  await page.mouse.move(...at(0.5, 0.5));
  await page.mouse.move(...at(0.99, 0.99));
  await page.mouse.up();
  await page.keyboard.up('Shift');
  await says(page, 'block-chosen', new RegExp(`^${points} tie points of `));
  await page.screenshot({ path: join(SHOTS, 'plots-sigma.png') });
  await part(page, 'plot-name').selectOption('rays');
  await says(page, 'block-plot-words', / values over rays\. Tie points: /);
  await page.mouse.click(...at(0.15, 0.7));
  await says(page, 'block-chosen', /^\d+ tie points of 2 rays/);
  // The same points in the map, and the same plot after it.
  await part(page, 'block-show-map').click();
  await says(page, 'block-chosen', /^\d+ tie points of 2 rays/);
  await part(page, 'block-show-plots').click();
  await part(page, 'plot-name').selectOption('residuals');
  await says(page, 'block-plot-words', /^[\d\u202f]+ values over residual vx\. Residual vy: /u);
  // Each residual with its image and its point.
  assert.match((await saved(page, 'plot-csv')).toString(), /^Image,Point,Residual vx \[px\],Residual vy \[px\]\nphoto_0000\d\.png,\d+,-?\d/u);
  assert.deepEqual([...(await saved(page, 'plot-png')).subarray(1, 4)], [...Buffer.from('PNG')]);
  assert.doesNotMatch(await status(page, /block-residuals\.png was saved\.$/), /csv/);
  await page.screenshot({ path: join(SHOTS, 'plots-residuals.png') });
  // Reliability: w-statistics beside those of normal errors, and minimal detectable biases over images; a rectangle chooses the points of both.
  await part(page, 'plot-name').selectOption('w');
  await says(page, 'block-plot-words', /^[\d\u202f]+ values over w of normally distributed errors\. W-statistic: median −?0\.\d{3}, /iu);
  await page.screenshot({ path: join(SHOTS, 'plots-w.png') });
  await page.keyboard.down('Shift');
  await page.mouse.move(...at(0.01, 0.01));
  await page.mouse.down();
  await page.mouse.move(...at(0.5, 0.3));
  await page.mouse.move(...at(0.99, 0.49));
  await page.mouse.up();
  await page.keyboard.up('Shift');
  await says(page, 'block-chosen', /^\d+ tie points of /);
  await part(page, 'plot-name').selectOption('detectable');
  await says(page, 'block-plot-words', /^[\d\u202f]+ values over image\. Minimal detectable bias: median \d+\.\d{3}, from /u);
  await page.screenshot({ path: join(SHOTS, 'plots-detectable.png') });
  const biases = (await saved(page, 'plot-csv')).toString().trimEnd().split('\n');
  assert.equal(biases[0], 'Point,Image,Minimal detectable bias [px]');
  assert.match(biases[1] ?? '', /^\d+,photo_0000\d\.png,\d+(\.\d+)?$/);
  await part(page, 'plot-name').selectOption('gnss');
  await says(page, 'block-plot-words', /^6 values over image\. GNSS minus adjusted position: /);
  await part(page, 'plot-name').selectOption('surveyed-plan');
  await says(page, 'block-plot-words', /^There are no such values: this block has none\.$/);
  assert.ok(await part(page, 'plot-csv').isDisabled());
  assert.match(page.url(), /#view=plots/);
  assert.deepEqual(complaints, []);
  await close();
});
