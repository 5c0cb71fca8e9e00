/** What the browser keeps of a block; and how images that are too many for a pair become one. */

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { test } from 'node:test';
import { block, photoFolder, photos, status } from './blocks.js';
import { done, hosted, number, open, part, partsNamed, pngs, SKIP, says, transferOf, until, upload } from './page.js';

hosted('/kept-block/');

/** @typedef {import('playwright-core').Page} Page */

/** How the status line of a block begins that a run ended with. */
const FINISHED = /^(Oriented|Weak orientation|Not oriented|The block was)/;

/** Waits until so many parts of a name are kept.  @param {Page} page @param {string} name @param {number} least */
async function kept(page, name, least = 1) {
  await until(page, `${name} is kept`, async () => (await partsNamed(page, name)) >= least);
}

/** All that the panels of a block show.  @param {Page} page */
async function shown(page) {
  const panels = [];
  for (const id of ['block-settings', 'block-results', 'block-images', 'block-points']) {
    await part(page, `tab-${id}`).click();
    // Rows are made a frame later.
    if (/images|points/.test(id)) await page.locator(`[data-testid="${id}"] tbody tr:not(.filler)`).first().waitFor();
    const text = await page.locator(`[aria-labelledby="tab-${id}"]`).innerText();
    // Only rows in sight exist, and a longer status line leaves less room for them.
    panels.push(id === 'block-points' ? text.slice(0, 400) : text);
  }
  return panels;
}

test('after a reload a block is as it was, its pairs open, and nothing is computed twice', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  await photos(page);
  await part(page, 'block-run').click();
  const line = await status(page, FINISHED);
  const before = await shown(page);
  await kept(page, 'block/shown');
  await page.reload();
  assert.equal(await status(page, /Restored from this browser/), `${line} Restored from this browser: photo_00000.png and 5 more images.`);
  assert.equal(await page.evaluate(() => document.body.dataset.mode), 'block');
  assert.deepEqual(await shown(page), before);
  await part(page, 'block-run').click();
  await page.waitForFunction(() => /6 of 6, 6 from an earlier run/.test(document.querySelector('[data-testid="stage-images"]')?.textContent ?? ''));
  await status(page, FINISHED);
  const again = await shown(page);
  await part(page, 'block-show-matrix').click();
  await part(page, 'block-matrix').focus();
  await page.keyboard.press('ArrowRight');
  await part(page, 'block-open-pair').click();
  await done(page);
  const matches = await number(page, 'count-matches');
  await kept(page, 'pair/result');
  await page.reload();
  await done(page);
  assert.equal(await number(page, 'count-matches'), matches);
  assert.match((await part(page, 'of-block').textContent()) ?? '', /photo_0000\d\.png – photo_0000\d\.png/);
  await part(page, 'back-to-block').click();
  await status(page, /Restored from this browser/);
  assert.deepEqual(await shown(page), again);
  assert.deepEqual(complaints, []);
  await close();
});

test('a run that a reload breaks off goes on where it stood, by itself', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  const folder = photoFolder(4);
  await part(page, 'block-folder-input').setInputFiles(folder);
  await kept(page, 'block/file/', 4);
  await part(page, 'block-run').click();
  await kept(page, 'block/record/');
  await page.reload();
  assert.match(await status(page, FINISHED), /^(Oriented|Weak orientation): .*\. 4 images/);
  assert.match((await part(page, 'stage-images').textContent()) ?? '', /4 of 4, [1-4] from an earlier run/);
  // A block that is removed stays under Projects, and is kept no longer where it is deleted there.
  await part(page, 'block-clear').click();
  await status(page, /The oriented block stays under Projects\./);
  await part(page, 'projects').click();
  await page.locator('[data-testid="project"]:not([aria-current]) [data-testid^="project-delete-"]').click();
  await part(page, 'project-delete').click();
  await until(page, 'nothing of the block is kept', async () => (await partsNamed(page, 'block/')) === 0);
  rmSync(folder, { recursive: true });
  assert.deepEqual(complaints, []);
  await close();
});

test('more than two images given for a pair are a block', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  const [left, right] = pngs();
  assert.ok(left && right);
  await part(page, 'file-input').setInputFiles([left, right, upload('third.png', left.buffer, 'image/png')]);
  assert.match(await status(page, /in the block/), /^More than two images are a block\. 3 images in the block\. Press Run\.$/);
  assert.equal(await page.evaluate(() => document.body.dataset.mode), 'block');
  assert.ok(!(await part(page, 'block-run').isDisabled()));
  assert.deepEqual(complaints, []);
  await close();
});

test('files that are dropped before the program has loaded are opened when it has', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ url: 'about:blank' });
  const other = await open();
  const url = other.page.url();
  await other.close();
  /** @type {() => void} */
  let load = () => {};
  const loaded = new Promise((resolve) => {
    load = () => resolve(null);
  });
  // Neither the program of the page nor the module is there.
  await page.route(/\/program\.js$|\.wasm$/, async (route) => {
    await loaded;
    await route.continue();
  });
  await page.goto(url);
  const transfer = await transferOf(page, pngs());
  for (const type of ['dragover', 'drop']) await part(page, 'view').dispatchEvent(type, { dataTransfer: transfer });
  await says(page, 'status', /Loading the program … 2 files wait to be opened\./);
  load();
  await page.waitForFunction(() => /matches/.test(document.querySelector('[data-testid="status"]')?.textContent ?? ''));
  assert.ok((await number(page, 'count-matches')) > 500);
  assert.deepEqual(
    complaints.filter((complaint) => !complaint.includes(new URL(url).origin)),
    [],
  );
  await close();
});

test('a pair beside a block goes to a project of its own where another takes its place: nothing is lost, and no file is kept twice', {
  skip: SKIP,
}, async () => {
  const { page, complaints, close } = await block();
  await photos(page);
  await part(page, 'block-run').click();
  await status(page, FINISHED);
  await kept(page, 'block/shown');
  const files = () => partsNamed(page, 'block/file/');
  const before = await files();
  await part(page, 'mode-pair').click();
  await part(page, 'file-input').setInputFiles(pngs());
  await done(page);
  await kept(page, 'pair/result');
  // A simulated pair takes its place in the view of pairs.
  await part(page, 'sample').click();
  await page.waitForFunction(() => /left\.png and right\.png stay under Projects\.$/.test(document.querySelector('[data-testid="status"]')?.textContent ?? ''));
  assert.equal(await files(), before);
  await part(page, 'projects').click();
  await part(page, 'project').nth(1).waitFor();
  assert.equal(await part(page, 'project').count(), 2);
  await page.getByRole('button', { name: 'left.png and right.png', exact: true }).click();
  await says(page, 'status', /Restored from this browser: left\.png and right\.png\.$/);
  // The block is in the other project, whole, and takes no pair of another one along.
  await part(page, 'projects').click();
  await page.getByRole('button', { name: 'photo_00000.png and 5 more images', exact: true }).click();
  await part(page, 'mode-block').click();
  await status(page, FINISHED);
  // A pair of the block takes the place of one of the user's own.
  await part(page, 'mode-pair').click();
  await part(page, 'file-input').setInputFiles(pngs().map(({ name, mimeType, buffer }) => ({ name: `own-${name}`, mimeType, buffer })));
  await done(page);
  await until(page, 'its result is kept', async () => (await partsNamed(page, 'pair/result')) >= 2);
  await part(page, 'mode-block').click();
  await part(page, 'block-show-matrix').click();
  await part(page, 'block-matrix').focus();
  await page.keyboard.press('ArrowRight');
  await part(page, 'block-open-pair').click();
  await page.waitForFunction(() =>
    /own-left\.png and own-right\.png stay under Projects/.test(document.querySelector('[data-testid="status"]')?.textContent ?? ''),
  );
  assert.equal(await files(), before);
  assert.deepEqual(complaints, []);
  await close();
});
