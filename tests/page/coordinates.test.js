/** Control points of which coordinates alone are given: measured in the images, kept, and taken into the block. */

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { block, FLIGHT, status, surveyedFolder } from './blocks.js';
import { enabled, hosted, part, saved, says, SHOTS, SKIP, upload } from './page.js';

hosted('/coordinates/');

/** @typedef {import('playwright-core').Page} Page */

/** @param {Page} page @param {string} name */
const row = (page, name) => page.locator('[data-testid="block-surveyed"] tbody tr').filter({ hasText: name }).first();

/** What a cell of a point's row says.  @param {Page} page @param {string} name @param {number} column */
const cell = async (page, name, column) => (await row(page, name).locator('td, th').nth(column).textContent()) ?? '';

/** Waits until the row of a point says what it is for.  @param {Page} page @param {string} name @param {RegExp} pattern */
const useIs = (page, name, pattern) =>
  page.waitForFunction(
    ([of, source]) =>
      [...document.querySelectorAll('[data-testid="block-surveyed"] tbody tr')].some(
        ({ children }) => children[0]?.textContent === of && new RegExp(source ?? '', 'u').test(children[1]?.textContent ?? ''),
      ),
    [name, pattern.source],
  );

/** Presses a place of an image that is shown whole.  @param {Page} page @param {number} image @param {number} x @param {number} y */
async function press(page, image, x, y) {
  // Nothing says which images show the point: few are shown, and the others come in place of those in which it is not placed.
  for (let turn = 0; turn < 3 && (await part(page, `pane-image-${image}`).count()) === 0; turn++) {
    await part(page, 'images-other').click();
    await page.keyboard.press('0');
  }
  await page.waitForTimeout(200);
  const box = await part(page, `pane-image-${image}`).boundingBox();
  assert.ok(box, `image ${image} is shown`);
  const scale = Math.min(box.width / FLIGHT.width_px, box.height / FLIGHT.height_px);
  let at = [box.x + box.width / 2 + scale * (x - FLIGHT.width_px / 2), box.y + box.height / 2 + scale * (y - FLIGHT.height_px / 2)];
  // The line below the images says where the pointer is: what is missing is made good.
  for (let i = 0; i < 2; i++) {
    await page.mouse.move(at[0] ?? 0, at[1] ?? 0);
    const said = await says(page, 'image-place', /px/);
    const [, column = NaN, line = NaN] = (/([\d.]+)[ ,]+([\d.]+) px/u.exec(said) ?? []).map(Number);
    at = [(at[0] ?? 0) + scale * (x - column), (at[1] ?? 0) + scale * (y - line)];
  }
  await page.mouse.click(at[0] ?? 0, at[1] ?? 0);
}

test('coordinates alone are taken; three points measured in two images each, with a reload on the way, take the control into the block', {
  skip: SKIP,
}, async () => {
  const { page, complaints, close } = await block({ options: { viewport: { width: 1366, height: 900 } } });
  const { folder, points, marks } = surveyedFolder();
  const places = marks
    .trim()
    .split('\n')
    .map((line) => line.split(','));
  await part(page, 'block-folder-input').setInputFiles(folder);
  await status(page, /^6 images/);
  await part(page, 'block-control-input').setInputFiles(upload('points.csv', new TextEncoder().encode(points)));
  await status(page, /take no part yet: none is measured/);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  await part(page, 'block-show-images').click();
  await part(page, 'tab-block-surveyed').click();
  const names = (await page.locator('[data-testid="block-images"] tbody tr:not(.filler)').allTextContents()).length;
  assert.equal(names, 6);
  await useIs(page, 'G0', /^control · not measured$/u);
  const measured = ['G0', 'G2', 'G3'];
  for (const [i, name] of measured.entries()) {
    await row(page, name).click();
    await part(page, 'block-measure').click();
    await page.keyboard.press('0');
    const own = places.filter(([, point]) => point === name).slice(0, 2);
    for (const [image = '', , x, y] of own) {
      const index = [...new Set(places.map(([of = '']) => of))].sort().indexOf(image);
      await press(page, index, Number(x), Number(y));
    }
    await says(page, 'block-edit-text', new RegExp(`^${name}: placed in 2 images`));
    if (i === 0) await page.screenshot({ path: join(SHOTS, 'coordinates-measuring.png') });
    if (i === 1) {
      // Undo takes the latest place back; who goes on to another point keeps what was placed.
      await part(page, 'block-undo').click();
      await says(page, 'block-edit-text', /^G2: placed in 1 image\b/);
      const [image = '', , x, y] = own[1] ?? [];
      await press(page, [...new Set(places.map(([of = '']) => of))].sort().indexOf(image), Number(x), Number(y));
      await says(page, 'block-edit-text', /^G2: placed in 2 images/);
      await row(page, 'G3').click();
      await status(page, /G2 was accepted as it was placed in 2 images; ↶ takes it back\./);
    } else await part(page, 'block-accept').click();
    await useIs(page, name, /^control · measured in 2 images$/u);
    if (i > 0) continue;
    await part(page, 'block-undo').click();
    await useIs(page, name, /^control · not measured$/u);
    await part(page, 'block-redo').click();
    await useIs(page, name, /^control · measured in 2 images$/u);
    // It is no part of the block, and of its project file.
    await part(page, 'block-export-kind').selectOption('project');
    await saved(page, 'block-export');
    await status(page, /was saved\. 1 measured point is not in the block, nor in the file/);
    await page.waitForTimeout(1500);
    await page.reload();
    await status(page, /take no part yet: 1 is measured/);
    await enabled(page, 'block-show-images');
    await part(page, 'block-show-images').click();
    await part(page, 'tab-block-surveyed').click();
    await useIs(page, name, /^control · measured in 2 images$/u);
  }
  await status(page, /^3 points are measured in two images or more/);
  await page.screenshot({ path: join(SHOTS, 'coordinates-complete.png') });
  await part(page, 'block-next').click();
  await status(page, /^(Oriented|Weak orientation): /);
  await useIs(page, 'G0', /^control$/u);
  for (const column of [6, 7, 8]) assert.match(await cell(page, 'G2', column), /^.?\d+\.\d{3}$/u);
  await page.screenshot({ path: join(SHOTS, 'coordinates-taken.png') });
  rmSync(folder, { recursive: true });
  assert.deepEqual(complaints, []);
  await close();
});
