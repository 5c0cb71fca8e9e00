/** Control and check points on the page, as a surveyor measures and uses them; points that are joined and split. */

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { block, status, surveyedFolder, undoIs } from './blocks.js';
import { hosted, keptEdits, part, saved, says, SHOTS, SKIP, upload } from './page.js';

hosted('/surveyed/');

/** @typedef {import('playwright-core').Page} Page */

/** A cell of the row of a surveyed point says something.  @param {Page} page @param {string} name @param {number} column @param {string} text */
const cellIs = (page, name, column, text) =>
  page.waitForFunction(
    ([of, at, wanted]) =>
      [...document.querySelectorAll('[data-testid="block-surveyed"] tbody tr')].some(
        ({ children }) => children[0]?.textContent === of && children[Number(at)]?.textContent === wanted,
      ),
    [name, column, text],
  );

/** Presses the row of a surveyed point.  @param {Page} page @param {string} name */
const row = (page, name) => page.locator('[data-testid="block-surveyed"] tbody tr').filter({ hasText: name }).first();

test('a control point is measured where it is predicted, used as check point, left out and used again; points are joined and split', {
  skip: SKIP,
}, async () => {
  const { page, complaints, close } = await block({ options: { viewport: { width: 1366, height: 900 } } });
  const { folder, points, marks, first } = surveyedFolder();
  assert.ok(first.length >= 4, `${first.length} images show the point`);
  await part(page, 'block-folder-input').setInputFiles(folder);
  await status(page, /^6 images/);
  await part(page, 'block-control-input').setInputFiles(upload('points.csv', new TextEncoder().encode(points)));
  await part(page, 'block-marks-input').setInputFiles(upload('marks.csv', new TextEncoder().encode(marks)));
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  await part(page, 'block-show-images').click();
  await part(page, 'tab-block-surveyed').click();
  await cellIs(page, 'G0', 2, '2');

  // Chosen in its table it is shown in every image: where it is measured, and where it is expected.
  await row(page, 'G0').click();
  await says(page, 'image-point', /^G0 · X Y Z .* · 2 rays/);
  await page.waitForFunction((count) => document.querySelectorAll('[data-testid^="pane-image-"]').length === count, first.length);
  await says(page, 'figures-2', /^predicted, not measured$/);
  await part(page, 'block-panes').focus();
  await page.keyboard.press('e');
  await page.keyboard.press('o');
  for (const images of [1, 2]) {
    await page.keyboard.press('o');
    await page.keyboard.press('Enter');
    await says(page, 'block-edit-text', new RegExp(`placed in ${images} image`));
  }
  await page.screenshot({ path: join(SHOTS, 'surveyed-measured.png') });
  await page.keyboard.press('Enter');
  await undoIs(page, /^Undo: measure G0 in 2 images \(/);
  await cellIs(page, 'G0', 2, '4');
  assert.match(await says(page, 'figures-2', /by hand/), /^v −?0\.\d\d /);

  // What it is for.
  await part(page, 'block-use').selectOption('check');
  await undoIs(page, /^Undo: use G0 as check point \(/);
  await cellIs(page, 'G0', 1, 'check');
  await part(page, 'block-use').selectOption('');
  await undoIs(page, /^Undo: leave G0 out \(/);
  await cellIs(page, 'G0', 1, 'not used');
  assert.match(await says(page, 'block-chosen', /rejected by hand/), /^G0: /);
  await row(page, 'G0').click();
  await page.keyboard.press('r');
  await undoIs(page, /^Undo: restore G0 \(/);
  await cellIs(page, 'G0', 1, 'check');

  // A tie point is split by the images that are shown, and is one again when both parts are joined.
  await part(page, 'images-unmeasured').click();
  await part(page, 'tab-block-points').click();
  await part(page, 'block-points-filter-point-rays').fill('4');
  const before = await says(page, 'block-points-caption', /: [\d\u202f]+ of [\d\u202f]+$/u);
  // One without a rejected observation, whose rays would be told apart by chance: it is shown in no other image.
  let [at, told] = [0, ''];
  do {
    await page.locator('[data-testid="block-points"] tbody tr:not(.filler)').nth(at++).click();
    told = await says(page, 'image-point', new RegExp(`^Tie point (?!${/\d+/.exec(told)} )[\\d\\u202f]+ .* 4 rays`, 'u'));
  } while (told.includes(' rejected'));
  assert.ok(await part(page, 'block-split').isHidden());
  for (let i = 0; i < 2; i++) await page.locator('[data-testid^="close-image-"]').first().click();
  await part(page, 'block-split').click();
  await undoIs(page, /^Undo: split 1 point into 2 \(/);
  await says(page, 'image-point', /^Point by hand [\d\u202f]+ .* 2 rays/u);
  await page.screenshot({ path: join(SHOTS, 'surveyed-split.png') });
  // One step also where its file is opened elsewhere.
  await part(page, 'block-export-kind').selectOption('project');
  const project = await saved(page, 'block-export');
  const other = await block();
  await part(other.page, 'block-files-input').setInputFiles(upload('split.tiepoint', project));
  await undoIs(other.page, /^Undo: split 1 point into 2 \(/);
  assert.deepEqual(other.complaints, []);
  await other.close();
  await part(page, 'block-points-filter-point-rays').fill('');
  await part(page, 'block-points-filter-point-part').fill('accepted');
  await page.locator('[data-testid="block-points"]').focus();
  await page.keyboard.press('End');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Shift+ArrowUp');
  await says(page, 'image-point', /^2 tie points of 2 rays/);
  await part(page, 'block-join').click();
  await undoIs(page, /^Undo: join 2 points \(/);
  await says(page, 'image-point', /^Point by hand [\d\u202f]+ .* 4 rays/u);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await undoIs(page, /^Undo: restore G0 \(/);
  await part(page, 'block-points-filter-point-part').fill('');
  await part(page, 'block-points-filter-point-rays').fill('4');
  await says(page, 'block-points-caption', new RegExp(`${before.replaceAll(/[\u202f ]/gu, '.')}$`));

  // All holds for a new run that finds the same tie points. Of one that finds others, what was done to surveyed points holds; what was done to tie
  // points does not, and stays with the former block.
  await page.locator('[data-testid="block-points"]').focus();
  for (const key of ['Home', 'Enter']) await page.keyboard.press(key);
  await says(page, 'image-point', /^Tie point [\d\u202f]+ .* 4 rays/u);
  await page.keyboard.press('Delete');
  await undoIs(page, /^Undo: reject 1 point \(/);
  await part(page, 'block-points-clear').click();
  // A reload forgets none of it.
  const edits = await page.locator('[data-testid="block-history"] li').count();
  await keptEdits(page, 'block/edits', edits - 1, 5);
  await page.reload();
  await status(page, /Restored from this browser/);
  assert.equal(await part(page, 'tab-block-points').getAttribute('aria-selected'), 'true');
  await part(page, 'block-run').click();
  await status(page, /[2-9] edits by hand were kept\.$/);
  await undoIs(page, /^Undo: reject 1 point \(/);
  if (await page.locator('#panel-block-settings').isHidden()) await part(page, 'block-settings').click();
  const unfold = part(page, 'block-all-settings');
  if ((await unfold.textContent()) === 'Unfold all') await unfold.click();
  await page.locator('#panel-block-settings [data-key="multiscale.number"]').first().fill('300');
  await part(page, 'close-block-settings').click();
  await part(page, 'block-run').click();
  await status(page, /edits by hand were kept\. 1 edit of points of the former block does not apply to the new one\. The former block stays under Projects\./);
  await part(page, 'tab-block-surveyed').click();
  await cellIs(page, 'G0', 1, 'check');
  await cellIs(page, 'G0', 2, '4');
  rmSync(folder, { recursive: true });
  assert.deepEqual(complaints, []);
  await close();
});
