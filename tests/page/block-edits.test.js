/** A finished block is edited by hand, as a person does it. */

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { block, inside, photoFolder, photos, status, undoIs } from './blocks.js';
import { hosted, keptEdits, part, saved, says, SHOTS, SKIP } from './page.js';

hosted('/block-edits/');

/** @typedef {import('playwright-core').Page} Page */

/** The block as a project file.  @param {Page} page */
async function project(page) {
  await part(page, 'block-export-kind').selectOption('project');
  return saved(page, 'block-export');
}

test('observations and images are rejected, a point is measured by keyboard, all of it is undone after a reload to the byte', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block({ options: { viewport: { width: 1366, height: 768 } } });
  const folder = photoFolder(6);
  await part(page, 'block-folder-input').setInputFiles(folder);
  await status(page, /6 images in the block/);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  const found = await project(page);
  await status(page, /was saved/);

  // An observation of the first image's first point.
  await part(page, 'block-show-images').click();
  await part(page, 'block-panes').focus();
  await page.keyboard.press('n');
  const before = await says(page, 'image-point', / rays/);
  // The user looks closer, and goes on looking there.
  const pane = await part(page, 'pane-image-0').boundingBox();
  assert.ok(pane);
  await page.mouse.move(pane.x + pane.width / 2, pane.y + pane.height / 2);
  await page.keyboard.press('+');
  await page.keyboard.press('ArrowRight');
  const place = await says(page, 'image-place', / px/);
  await part(page, 'block-reject').focus();
  await page.keyboard.press('Enter');
  await undoIs(page, /^Undo: reject 1 observation in photo_0\.png \(/);
  // The keyboard is where the press is taken back.
  await page.waitForFunction(() => document.activeElement?.getAttribute('data-testid') === 'block-restore');
  assert.equal((await says(page, 'image-place', / px · ground/)).split(' px')[0], place.split(' px')[0]);
  assert.match(await says(page, 'block-edit-text', /^σ₀/), /^σ₀ \d+\.\d{3} → \d+\.\d{3} px · RMSE \d+\.\d{3} → \d+\.\d{3} px$/);
  // It is the same point still.
  assert.equal((await says(page, 'image-point', / rays/)).split(' · ')[0], before.split(' · ')[0]);
  await says(page, 'figures-0', /rejected by hand/);
  await page.keyboard.press('Enter');
  await undoIs(page, /^Undo: restore 1 observation in photo_0\.png \(/);
  await page.waitForFunction(() => document.activeElement?.getAttribute('data-testid') === 'block-reject');
  await says(page, 'figures-0', /^v /);

  // A new point in three images, by the keyboard alone, within 20 s.
  await part(page, 'block-panes').focus();
  await inside(page);
  const began = Date.now();
  await page.keyboard.press('a');
  await page.keyboard.press('Enter');
  await says(page, 'block-edit-text', /^New point: placed in 1 image\./);
  for (const images of [2, 3]) {
    await page.keyboard.press('o');
    await page.keyboard.press('Shift+ArrowRight');
    await page.keyboard.press('ArrowLeft');
    await says(page, 'block-edit-text', new RegExp(`placed in ${images} images`));
  }
  await page.screenshot({ path: join(SHOTS, 'block-edits-draft.png') });
  // Least squares matching takes it from there.
  await page.keyboard.press('f');
  await says(page, 'block-status', /Matched in [12345] of \d images\. Enter accepts\./);
  await page.keyboard.press('Enter');
  await undoIs(page, /^Undo: add 1 point in \d images/);
  assert.ok(Date.now() - began < 20_000, `${Date.now() - began} ms`);
  assert.match(await says(page, 'image-point', / rays/), /^Point by hand 2[\s0]+1 · X Y Z .* · [3-6] rays · RMSE/);
  await says(page, 'figures-0', /by hand/);
  await page.screenshot({ path: join(SHOTS, 'block-edits-point.png') });

  // A point that was rejected stays in sight, chosen: in the images, in its table and on the map it is restored by the same key.
  await part(page, 'block-show-images').click();
  await page.waitForFunction(() => /view=images&point=/.test(window.location.hash));
  const address = new URL(page.url()).hash;
  await page.keyboard.press('Shift+Delete');
  await undoIs(page, /^Undo: reject 1 point \(/);
  // It has its number still, by which the address names it.
  assert.equal(new URL(page.url()).hash, address);
  await says(page, 'figures-0', /rejected by hand/);
  await part(page, 'tab-block-points').click();
  await part(page, 'block-points-filter-point-part').fill('hand');
  await says(page, 'block-points-caption', /: 1 of \d+$/);
  await page.screenshot({ path: join(SHOTS, 'block-edits-rejected.png') });
  await page.locator('[data-testid="block-points"] tbody tr:not(.filler)').click();
  await page.keyboard.press('r');
  await undoIs(page, /^Undo: restore 1 point \(/);
  await says(page, 'block-points-caption', /: 0 of \d+$/);
  await part(page, 'block-points-clear').click();
  await page.keyboard.press('Control+z');
  await undoIs(page, /^Undo: reject 1 point \(/);
  await part(page, 'block-show-map').click();
  await says(page, 'block-map-words', / tie points and 1 rejected by hand; /);
  assert.match((await part(page, 'block-chosen').textContent()) ?? '', /rejected by hand/);
  await part(page, 'block-restore').click();
  await undoIs(page, /^Undo: restore 1 point \(/);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await undoIs(page, /^Undo: add 1 point/);

  // An image, chosen on the map.
  await part(page, 'block-map').focus();
  await page.keyboard.press('n');
  await page.keyboard.press('Delete');
  await undoIs(page, /^Undo: reject photo_0\.png \(/);
  await status(page, /: 5 of 6 images/);
  const edited = await project(page);
  assert.notDeepEqual(edited, found);
  await status(page, /was saved/);

  // Reload: what was done is there, and is undone to the last byte.
  await keptEdits(page, 'block/edits', 4, 4);
  // The view that the address names is shown with the block, not once the edits are made again: who works on would be carried off.
  await part(page, 'block-show-images').click();
  await page.waitForFunction(() => /view=images/.test(window.location.hash));
  await page.addInitScript(() => {
    const seen = Object.assign(window, { strayed: 0 });
    const at = (/** @type {string} */ id) => document.querySelector(`[data-testid="${id}"]`);
    new MutationObserver(() => {
      if (at('block-answer')?.getAttribute('data-verdict') && at('block-show-map')?.getAttribute('aria-pressed') === 'true') seen.strayed += 1;
    }).observe(document, { subtree: true, childList: true, attributes: true });
  });
  await page.reload();
  await status(page, /: 5 of 6 images/);
  assert.equal(await page.evaluate(() => Number(/** @type {{ strayed?: number }} */ (/** @type {unknown} */ (window)).strayed)), 0);
  await part(page, 'block-show-map').click();
  await undoIs(page, /^Undo: reject photo_0\.png \(/);
  await page.keyboard.press('Control+z');
  await status(page, /: 6 of 6 images/);
  await page.keyboard.press('Control+Shift+z');
  await status(page, /: 5 of 6 images/);
  // A button and its key are one action; what many tables have is told apart.
  await page.keyboard.press('Control+k');
  await part(page, 'search-text').fill('undo');
  const undoing = part(page, 'search-list').locator('li');
  const [undo, ...others] = await undoing.allTextContents();
  assert.equal(undo, 'Undo: reject photo_0.pngEdits by handCtrl+Z');
  // What nothing was done to has nothing to undo.
  assert.ok(others.length > 0 && others.every((text) => /not possible now/.test(text)), others.join());
  await part(page, 'search-text').fill('edit anywhere');
  assert.equal(await undoing.count(), 0);
  await part(page, 'search-text').fill('copy tables');
  const copies = await undoing.allTextContents();
  assert.ok(copies.length > 3 && new Set(copies).size === copies.length, copies.join('\n'));
  // So are the choices of lists.
  await part(page, 'search-text').fill('format bingo');
  await page.keyboard.press('Enter');
  assert.equal(await part(page, 'block-export-kind').inputValue(), 'bingo');
  await part(page, 'tab-block-edits').click();
  assert.equal((await part(page, 'block-rejected').textContent())?.trim(), 'photo_0.png Restore');
  await part(page, 'block-history-0').click();
  await status(page, /: 6 of 6 images/);
  await page.waitForFunction(() => document.querySelector('[data-testid="block-undo"]')?.hasAttribute('disabled'));
  await page.waitForFunction(() => document.querySelector('[data-testid="block-edit-text"]')?.textContent === '');
  assert.deepEqual(await project(page), found);

  // What was edited is not lost with the images: it stays in the list of projects.
  await part(page, 'block-clear').click();
  await status(page, /The edited block stays under Projects\./);
  await part(page, 'projects').click();
  await page.locator('[data-testid="project"]:not([aria-current]) .link').first().click();
  await status(page, /: 6 of 6 images/);
  await page.waitForFunction(() => document.querySelector('[data-testid="block-redo"]')?.getAttribute('title')?.startsWith('Redo: reject 1 observation'));
  // Nor is it when another one is opened; what is done while that is read is done to the former one.
  const open = part(page, 'block-files-input');
  await open.setInputFiles([{ name: 'found.tiepoint', mimeType: 'application/octet-stream', buffer: found }]);
  await page.evaluate(() => /** @type {HTMLButtonElement} */ (document.querySelector('[data-testid="block-redo"]')).click());
  await status(page, /found\.tiepoint was opened.* The former block stays under Projects\./);
  assert.ok(await part(page, 'block-undo').isHidden());
  assert.deepEqual(await project(page), found);

  // A file holds the edits, each of which can be undone.
  await open.setInputFiles([{ name: 'edited.tiepoint', mimeType: 'application/octet-stream', buffer: edited }]);
  await status(page, /edited\.tiepoint was opened/);
  await undoIs(page, /^Undo: reject photo_0\.png \(/);
  // The last two images are no block without the others: that is said, and nothing changes.
  await part(page, 'block-map').focus();
  let refused = false;
  for (let i = 0; i < 6 && !refused; i++) {
    await page.keyboard.press('n');
    if (await part(page, 'block-reject').isHidden()) continue;
    const done = await page.locator('[data-testid="block-history"] li').count();
    await page.keyboard.press('Delete');
    await page.waitForFunction(
      ([count = 0]) =>
        document.querySelector('[data-testid="block-edit-text"]')?.textContent !== 'Adjusting the block …' &&
        (document.querySelectorAll('[data-testid="block-history"] li').length > count ||
          /not made/.test(document.querySelector('[data-testid="block-status"]')?.textContent ?? '')),
      [done],
    );
    await page.waitForFunction(() => document.querySelector('[data-testid="block-edit-text"]')?.textContent !== 'Adjusting the block …');
    refused = /The edit was not made: .*The block is unchanged\.$/.test((await part(page, 'block-status').textContent()) ?? '');
    if (refused) assert.equal(await page.locator('[data-testid="block-history"] li').count(), done);
  }
  assert.ok(refused);
  rmSync(folder, { recursive: true });
  assert.deepEqual(complaints, []);
  await close();
});

test('pairs are rejected and restored together, from their table, and undone to the byte', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block({ options: { viewport: { width: 1366, height: 768 } } });
  await photos(page);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): 6 of 6 images/);
  const found = await project(page);
  await status(page, /was saved/);

  // The weakest of the connected pairs: the block holds without them.
  await part(page, 'tab-block-pairs').click();
  await part(page, 'block-pairs-filter-matches').fill('>0');
  await part(page, 'sort-matches').click();
  await page.waitForFunction(() => document.querySelector('[data-testid="block-pairs"] th[data-key="matches"]')?.getAttribute('aria-sort') === 'ascending');
  const row = (/** @type {number} */ at) => page.locator('[data-testid="block-pairs"] tbody tr:not(.filler)').nth(at);
  const [first, second] = await row(0).locator('td, th').allTextContents();
  await row(0).click();
  await says(page, 'block-reject', /^Reject pair$/);
  await row(1).click({ modifiers: ['Control'] });
  await says(page, 'block-chosen', /^2 pairs: /);
  await part(page, 'block-reject').click();
  await undoIs(page, /^Undo: reject 2 pairs \(/);
  await says(page, 'block-restore', /^Restore 2 pairs$/);
  await part(page, 'block-pairs-filter-reason').fill('hand');
  await says(page, 'block-pairs-caption', /: 2 of 15$/);

  // One of them by its key; the other in the details.
  await row(0).click();
  await page.keyboard.press('r');
  await undoIs(page, /^Undo: restore photo_\d+\.png – photo_\d+\.png \(/);
  await says(page, 'block-pairs-caption', /: 1 of 15$/);
  await part(page, 'block-pairs-clear').click();
  await part(page, 'tab-block-edits').click();
  assert.match((await part(page, 'block-rejected').textContent()) ?? '', /^\S+ – \S+ Restore$/);
  await part(page, 'block-rejected').locator('button').click();
  await page.waitForFunction(() => document.querySelector('[data-testid="block-rejected"]')?.textContent === 'nothing');
  // The key acts in the matrix, too: a pair is hollow there.
  await part(page, 'block-show-matrix').click();
  await part(page, 'tab-block-pairs').click();
  await row(0).click();
  await part(page, 'block-matrix').focus();
  await page.keyboard.press('Delete');
  await undoIs(page, new RegExp(`^Undo: reject ${String(first)} – ${String(second)} \\(`));
  await page.screenshot({ path: join(SHOTS, 'block-edits-pairs.png') });
  await part(page, 'tab-block-edits').click();
  await part(page, 'block-history-0').click();
  await page.waitForFunction(() => document.querySelector('[data-testid="block-undo"]')?.hasAttribute('disabled'));
  await page.waitForFunction(() => document.querySelector('[data-testid="block-edit-text"]')?.textContent === '');
  assert.deepEqual(await project(page), found);
  assert.deepEqual(complaints, []);
  await close();
});

test('observations are rejected together, those that are listed, by one step; places of a point are taken back before any step', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block({ options: { viewport: { width: 1366, height: 768 } } });
  await photos(page);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);

  // A place is taken back where nothing was edited yet: the button says which.
  await part(page, 'block-show-images').click();
  await part(page, 'block-panes').focus();
  await inside(page);
  await page.keyboard.press('a');
  await page.keyboard.press('Enter');
  await says(page, 'block-edit-text', /^New point: placed in 1 image\./);
  assert.match((await part(page, 'block-undo').getAttribute('title')) ?? '', /^Undo: place the point in photo_0000\d\.png \(/);
  await page.keyboard.press('Control+z');
  await says(page, 'block-edit-text', /^New point: placed in 0 images\./);
  await page.keyboard.press('Escape');

  await part(page, 'tab-block-observations').click();
  const rows = page.locator('[data-testid="block-observations"] tbody tr:not(.filler)');
  await rows.nth(0).click();
  await rows.nth(3).click({ modifiers: ['Shift'] });
  await says(page, 'block-chosen', /^4 observations of \d points?\./);
  await says(page, 'block-reject', /^Reject 4 observations$/);
  await part(page, 'block-observations').focus();
  await page.keyboard.press('Control+a');
  await says(page, 'block-reject', /^Reject [\d\u202f]{2,} observations$/);
  await part(page, 'block-observations-filter-observation-v').fill('>0.1');
  const [, listed = '0'] = /: (\d+) of/.exec(await says(page, 'block-observations-caption', /: \d+ of \d+$/)) ?? [];
  assert.ok(Number(listed) > 1, listed);
  await says(page, 'block-reject', new RegExp(`^Reject ${listed} observations$`));
  await says(page, 'block-not-listed', /more chosen, not listed/);
  await part(page, 'block-observations').focus();
  await page.keyboard.press('Delete');
  await undoIs(page, new RegExp(`^Undo: reject ${listed} observations `));
  await page.screenshot({ path: join(SHOTS, 'block-edits-observations.png') });
  await page.keyboard.press('Control+z');
  await undoIs(page, /^Undo \(/);
  assert.deepEqual(complaints, []);
  await close();
});
