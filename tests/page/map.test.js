/** The map of a block, as a surveyor uses it: by mouse, by keys and in words; in step with the tables. */

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { block, photos, status } from './blocks.js';
import { hosted, part, says, SHOTS, SKIP } from './page.js';

hosted();

/** @typedef {import('playwright-core').Page} Page */

/** Draws a rectangle with Shift, between shares of the map.  @param {Page} page @param {number} from @param {number} to */
async function brush(page, from, to) {
  const box = await part(page, 'block-map').boundingBox();
  assert.ok(box);
  const at = (/** @type {number} */ share) => /** @type {[number, number]} */ ([box.x + box.width * share, box.y + box.height * share]);
  await page.keyboard.down('Shift');
  await page.mouse.move(...at(from));
  await page.mouse.down();
  await page.mouse.move(...at((from + to) / 2));
  await page.mouse.move(...at(to));
  await page.mouse.up();
  await page.keyboard.up('Shift');
}

/** The map's picture.  @param {Page} page @returns {Promise<string>} */
const picture = (page) => page.evaluate(() => /** @type {HTMLCanvasElement} */ (document.querySelector('[data-testid="layer-map"]')).toDataURL());

/** Waits until the map's picture is another one.  @param {Page} page @param {string} before */
async function changes(page, before) {
  await page.waitForFunction((was) => /** @type {HTMLCanvasElement} */ (document.querySelector('[data-testid="layer-map"]')).toDataURL() !== was, before);
}

test('the map says what it shows, tells the place of the pointer, and a rectangle chooses tie points in all views', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  await photos(page);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  const words = await says(page, 'block-map-words', /Median ground sample distance/);
  assert.match(
    words,
    /^Oriented positions, from above \(metres east and north of the origin\)\. .*6 images, 6 oriented, .* tie points; RMSE of the residuals from 0\.00 to /,
  );
  // From some 800 m with a focal length of 567 px.
  const [, gsd = ''] = /Median ground sample distance ([\d.]+) m/.exec(words) ?? [];
  assert.ok(Number(gsd) > 1.3 && Number(gsd) < 1.5, words);
  assert.match(words, /GNSS positions differ by up to [\d.]+ (m|cm|mm)/);
  await says(page, 'block-layout', /RMSE of the residuals: 0\.00 px0?\.?\d*/);

  const box = await part(page, 'block-map').boundingBox();
  assert.ok(box);
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await says(page, 'map-place', /^E −?\d+\.\d\d m {2}N −?\d+\.\d\d m$/);

  // All points, then those that a filter keeps: a rectangle chooses what is seen.
  await part(page, 'tab-block-points').click();
  const [, all = ''] = /: (\d+)$/.exec(await says(page, 'block-points-caption', /: \d+$/)) ?? [];
  await brush(page, 0.01, 0.99);
  await says(page, 'block-chosen', new RegExp(`^${all} tie points of `));
  await page.screenshot({ path: join(SHOTS, 'block-map-brushed.png') });
  await part(page, 'block-points-filter-point-rays').fill('>2');
  const [, kept = ''] = /: (\d+) of/.exec(await says(page, 'block-points-caption', /: \d+ of \d+$/)) ?? [];
  await brush(page, 0.99, 0.01);
  await says(page, 'block-chosen', new RegExp(`^${kept} tie points of `));
  assert.equal(
    await page.evaluate(() => document.querySelectorAll('[data-testid="block-points"] tbody tr:not(.filler):not([aria-selected="true"])').length),
    0,
  );
  // A lasso about the left half: some of them.
  await part(page, 'map-lasso').click();
  await page.keyboard.down('Shift');
  await page.mouse.move(box.x + 4, box.y + 4);
  await page.mouse.down();
  for (const [x, y] of /** @type {const} */ ([
    [0.5, 0.01],
    [0.55, 0.5],
    [0.5, 0.99],
    [0.01, 0.99],
  ]))
    await page.mouse.move(box.x + box.width * x, box.y + box.height * y, { steps: 3 });
  await page.mouse.up();
  await page.keyboard.up('Shift');
  const [, held = ''] = /^(\d+) tie points/.exec(await says(page, 'block-chosen', new RegExp(`^(?!${kept} )\\d+ tie points of `))) ?? [];
  assert.ok(Number(held) > 0 && Number(held) < Number(kept), `${held} of ${kept}`);
  await part(page, 'map-lasso').click();
  await part(page, 'block-points-clear').click();

  // Keys: images one after the other, their pairs, arrows and signs.
  await part(page, 'block-map').focus();
  await page.keyboard.press('Escape');
  await says(page, 'block-chosen', /^$/);
  await page.keyboard.press('n');
  await says(page, 'block-chosen', /^photo_00000\.png: .*; GSD [\d.]+ m; /);
  await page.keyboard.press('c');
  await says(page, 'block-chosen', /^photo_00000\.png – photo_00001\.png: connected/);
  for (const key of ['ArrowRight', '+', '0']) {
    const before = await picture(page);
    await page.keyboard.press(key);
    await changes(page, before);
  }

  // What it shows.
  for (const id of ['map-footprints', 'map-connections', 'map-offsets']) {
    const before = await picture(page);
    const pressed = await part(page, id).getAttribute('aria-pressed');
    await part(page, id).click();
    assert.equal(await part(page, id).getAttribute('aria-pressed'), pressed === 'true' ? 'false' : 'true');
    await changes(page, before);
  }
  await part(page, 'map-points').selectOption('height');
  await says(page, 'block-layout', /Z: −?[\d.]+/);
  await part(page, 'map-points').selectOption('none');
  await page.waitForFunction(() => !/ Z: | residuals: /.test(document.querySelector('[data-testid="block-layout"]')?.textContent ?? ''));
  // Nothing is chosen of what is not shown.
  await brush(page, 0.01, 0.99);
  await says(page, 'block-chosen', /^photo_00000\.png – photo_00001\.png/);

  // The address names what is shown: gone to, it shows that again.
  assert.match(page.url(), /#view=map&image=photo_00000\.png&image=photo_00001\.png$/);
  await page.evaluate(() => {
    window.location.hash = '#view=matrix&image=photo_00004.png';
  });
  await says(page, 'block-chosen', /^photo_00004\.png: /);
  await part(page, 'block-matrix').waitFor();
  assert.deepEqual(complaints, []);
  await close();
});
