/** What Firefox keeps of a pair: two tabs with one project, and a project file that is opened where nothing is kept any more. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { done, open, pair, part, partsNamed, rowsKept, saved, says, until, upload } from '../page/page.js';
import { hostedInFirefox, SKIP, type } from './firefox.js';

hostedInFirefox('/kept/');

/** @typedef {import('playwright-core').Page} Page */

/** Whether a focal length is kept.  @param {Page} page @param {number} focal */
const isKept = async (page, focal) =>
  (await rowsKept(page, 'pair')).some(({ part: name, value }) => name === 'pair' && JSON.stringify(value).includes(`"focal_mm":${focal}`));

/** @param {Page} page @param {number} focal */
async function typeFocal(page, focal) {
  await part(page, 'tab-camera').click();
  await type(part(page, 'camera-focal'), String(focal));
}

test('a project of another tab is looked at without being changed, and taken over', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  await until(page, 'the results are kept', async () => (await partsNamed(page, 'pair/result')) > 0);
  const second = await page.context().newPage();
  await second.goto(page.url());
  await says(second, 'keeping', /is open in another tab/);
  await part(second, 'keeping-look').click();
  await says(second, 'status', /Restored from this browser/);
  await typeFocal(second, 33);
  await done(second);
  await typeFocal(page, 44);
  await until(page, 'what the first tab changes is kept', () => isKept(page, 44));
  assert.equal(await isKept(page, 33), false);
  await part(second, 'keeping-take').click();
  await part(second, 'keeping').waitFor({ state: 'hidden' });
  await says(page, 'keeping', /Another tab has taken .* over/);
  await typeFocal(second, 66);
  await until(second, 'what the second tab changes is kept', () => isKept(second, 66));
  await typeFocal(page, 55);
  await done(page);
  assert.equal(await isKept(second, 55), false);
  assert.deepEqual(complaints, []);
  await close();
});

test('a project file is opened after the data of the site were cleared, with its edits, and written again to the byte', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  await part(page, 'tab-matches').click();
  await part(page, 'statistics-row').nth(3).locator('td').first().click();
  await page.keyboard.press('Delete');
  await says(page, 'undo', /^Undo: reject 1 match$/);
  await done(page);
  const project = await saved(page, 'export-project');
  const url = page.url();
  // No page of the site has it open, as where its settings clear it.
  await page.goto(new URL('no-such-page', url).href);
  await page.evaluate(async () => {
    localStorage.clear();
    for (const name of await caches.keys()) await caches.delete(name);
    await new Promise((resolve, reject) => {
      const deleting = indexedDB.deleteDatabase('tiepoint');
      deleting.onsuccess = () => resolve(null);
      deleting.onerror = () => reject(deleting.error);
    });
  });
  complaints.length = 0;
  await page.goto(url);
  await says(page, 'status', /^Ready/);
  await part(page, 'file-input').setInputFiles([upload('saved.tiepoint', project)]);
  await says(page, 'undo', /^Undo: reject 1 match$/);
  await done(page);
  assert.deepEqual(await saved(page, 'export-project'), project);
  assert.deepEqual(complaints, []);
  await close();
});
