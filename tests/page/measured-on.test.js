/** A point that is being measured by hand outlives a reload and New: it is measured on in the images that were shown, which are few where nothing says where it lies. */

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { block, status, surveyedFolder } from './blocks.js';
import { hosted, part, partsKept, partsNamed, says, SHOTS, SKIP, until, upload } from './page.js';

hosted('/measured-on/');

/** @typedef {import('playwright-core').Page} Page */

/** The images that are shown, by their numbers.  @param {Page} page */
const shown = (page) =>
  page.evaluate(() => [...document.querySelectorAll('[data-testid^="pane-image-"]')].map((pane) => Number(pane.getAttribute('data-testid')?.slice(11))));

/** Places the point in the middle of the pane of an image.  @param {Page} page @param {number} image */
async function place(page, image) {
  const box = await part(page, `pane-image-${image}`).boundingBox();
  assert.ok(box !== null);
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
}

test('a point that is being measured is measured on after a reload and after New, beside few images where nothing predicts its place', {
  skip: SKIP,
}, async () => {
  const { page, complaints, close } = await block({ options: { viewport: { width: 1366, height: 900 } } });
  const { folder, points } = surveyedFolder();
  await part(page, 'block-folder-input').setInputFiles(folder);
  await status(page, /^6 images/);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  await part(page, 'block-control-input').setInputFiles(upload('points.csv', new TextEncoder().encode(points)));
  await part(page, 'tab-block-surveyed').click();
  await page.locator('[data-testid="block-surveyed"] tbody tr').filter({ hasText: 'G0' }).first().click();
  await part(page, 'block-measure').click();
  await says(page, 'block-edit-text', /^G0: placed in 0 images/);
  await page.waitForFunction(() => document.querySelectorAll('[data-testid^="pane-image-"]').length === 4);
  await page.screenshot({ path: join(SHOTS, 'measured-on-begun.png') });

  // The other images come in place of those in which it is not placed.
  const [first = -1] = await shown(page);
  await place(page, first);
  await says(page, 'block-edit-text', /^G0: placed in 1 image/);
  const before = await shown(page);
  await part(page, 'images-other').click();
  const after = await shown(page);
  assert.ok(after.includes(first) && after.some((image) => !before.includes(image)), `${before}, then ${after}`);

  const other = after.find((image) => image !== first && !before.includes(image)) ?? -1;
  await place(page, other);
  await says(page, 'block-edit-text', /^G0: placed in 2 images/);
  const isKept = () =>
    until(page, 'both places are kept', async () => ((await partsKept(page, 'block/draft')).get('block/draft')?.places.length === 2 ? true : null));
  await isKept();
  await page.reload();
  await status(page, /Restored from this browser/);
  await says(page, 'block-edit-text', /^G0: placed in 2 images/);
  await page.waitForFunction((count) => document.querySelectorAll('[data-testid^="pane-image-"]').length === count, after.length);
  await until(page, 'the images in which it is placed come first', async () =>
    String((await shown(page)).slice(0, 2)) === String([first, other]) ? true : null,
  );

  await part(page, 'block-clear').click();
  await status(page, /The edited block stays under Projects\./);
  assert.ok(await part(page, 'block-edit-bar').isHidden());
  await part(page, 'projects').click();
  await page.locator('[data-testid="project"]:not([aria-current]) .link').first().click();
  await says(page, 'block-edit-text', /^G0: placed in 2 images/);
  await page.screenshot({ path: join(SHOTS, 'measured-on-again.png') });
  await part(page, 'block-accept').click();
  await page.waitForFunction(() => /^Undo: measure G0 in 2 images/u.test(document.querySelector('[data-testid="block-undo"]')?.getAttribute('title') ?? ''));
  await until(page, 'no place is kept', async () => ((await partsNamed(page, 'block/draft')) === 0 ? true : null));
  assert.deepEqual(complaints, []);
  await close();
  rmSync(folder, { recursive: true });
});
