/** The browser's storage is cleared while the page is open: what is on the page is kept again, or it is said plainly that it cannot be. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { block, photos, status } from './blocks.js';
import { done, hosted, keptEdits, open, pair, part, saved, says, SKIP, until } from './page.js';

hosted('/kept-cleared/');

/** @typedef {import('playwright-core').Page} Page */

/** What a browser says in English of a connection that is closed. */
const RAW = /Failed to execute|closing|IDBDatabase/;

/** Clears all that the browser keeps of the page, as its settings do.  @param {Page} page */
async function clear(page) {
  const session = await page.context().newCDPSession(page);
  await session.send('Storage.clearDataForOrigin', { origin: new URL(page.url()).origin, storageTypes: 'all' });
}

/** Deletes the database from another page of the same origin.  @param {Page} page */
async function deleted(page) {
  const other = await page.context().newPage();
  await other.goto(new URL('no-such-page', page.url()).href);
  await other.evaluate(
    () =>
      new Promise((resolve, reject) => {
        const deleting = indexedDB.deleteDatabase('tiepoint');
        deleting.onsuccess = () => resolve(null);
        deleting.onerror = () => reject(deleting.error);
      }),
  );
  await other.close();
}

/** The parts that are kept; none while there is no database, which must not come of the question.  @param {Page} page @returns {Promise<{ part: string, text: string }[]>} */
const rows = (page) =>
  page.evaluate(
    () =>
      new Promise((resolve) => {
        const opening = indexedDB.open('tiepoint');
        opening.onupgradeneeded = () => opening.transaction?.abort();
        opening.onerror = () => resolve([]);
        opening.onsuccess = () => {
          const db = opening.result;
          const reading = db.transaction('parts').objectStore('parts').getAll();
          reading.onsuccess = () => {
            db.close();
            resolve(reading.result.map(({ part: name, value }) => ({ part: name, text: name === 'pair' ? JSON.stringify(value) : '' })));
          };
        };
      }),
  );

/** @param {Page} page @param {string} name @param {number} least */
const kept = (page, name, least = 1) =>
  until(page, `${name} is kept`, async () => (await rows(page)).filter(({ part: one }) => one.startsWith(name)).length >= least);

/** @param {Page} page @param {string} focal */
async function typeFocal(page, focal) {
  await part(page, 'tab-camera').click();
  await part(page, 'camera-focal').fill(focal);
  await part(page, 'camera-focal').press('Enter');
}

/** Waits until the page is kept with a focal length.  @param {Page} page @param {number} focal */
const keptFocal = (page, focal) =>
  until(page, `${focal} mm are kept`, async () => (await rows(page)).some(({ part: name, text }) => name === 'pair' && text.includes(`"focal_mm":${focal}`)));

for (const [how, take] of /** @type {const} */ ([
  ['site data is cleared', clear],
  ['another page deletes the database', deleted],
]))
  test(`a pair is kept again where ${how}`, { skip: SKIP }, async () => {
    const { page, close } = await open();
    await pair(page);
    await kept(page, 'pair/result');
    // Once as it was given, once as it was read.
    for (const focal of [91, 92]) {
      await take(page);
      await typeFocal(page, String(focal));
      await done(page);
      await keptFocal(page, focal);
      await kept(page, 'pair/result');
      await kept(page, 'pair/file/', 2);
      assert.ok(await part(page, 'keeping').isHidden());
      await page.reload();
      await says(page, 'status', /Restored from this browser: left\.png and right\.png\.$/);
      await part(page, 'tab-camera').click();
      assert.equal(await part(page, 'camera-focal').inputValue(), String(focal));
      await done(page);
    }
    // Nothing needs to be changed for that.
    await take(page);
    await kept(page, 'pair/file/', 2);
    await kept(page, 'pair/result');
    await close();
  });

test('a block is kept again where site data is cleared, with its edits', { skip: SKIP }, async () => {
  const { page, close } = await block();
  await photos(page);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation)/);
  await kept(page, 'block/shown');
  await clear(page);
  await part(page, 'block-show-map').click();
  await part(page, 'block-map').focus();
  await page.keyboard.press('n');
  await page.keyboard.press('Delete');
  await kept(page, 'block/shown');
  await keptEdits(page, 'block/edits', 1, 1);
  await kept(page, 'block/file/', 6);
  await kept(page, 'block/record/');
  assert.ok(await part(page, 'keeping').isHidden());
  await page.reload();
  await status(page, /Restored from this browser: photo_00000\.png and 5 more images\.$/);
  assert.match((await part(page, 'block-undo').getAttribute('title')) ?? '', /reject/i);
  await close();
});

test('where what was deleted cannot be kept again this is said, and the project is saved as a file', { skip: SKIP }, async () => {
  const { page, close } = await open();
  await pair(page);
  await kept(page, 'pair/result');
  await page.evaluate(() => {
    const put = IDBObjectStore.prototype.put;
    Object.assign(window, { room: false });
    IDBObjectStore.prototype.put = function (/** @type {any[]} */ ...given) {
      if (!(/** @type {any} */ (window).room)) throw new DOMException('Failed to execute', 'UnknownError');
      return Reflect.apply(put, this, given);
    };
  });
  await clear(page);
  const text = await says(page, 'keeping', /^What this browser had kept was deleted, and “left\.png and right\.png” could not be kept again: /);
  assert.match(text, /: the storage of this browser failed \(UnknownError\)\. Save the project as a file before you leave\./);
  assert.doesNotMatch(text, RAW);
  assert.match((await saved(page, 'keeping-save-project')).toString(), /"images"/);
  // As soon as it can be written all of it is.
  await page.evaluate(() => Object.assign(window, { room: true }));
  await typeFocal(page, '93');
  await keptFocal(page, 93);
  await kept(page, 'pair/file/', 2);
  await part(page, 'keeping').waitFor({ state: 'hidden' });
  await close();
});

test('a storage that cannot be opened again is named as what it is', { skip: SKIP }, async () => {
  const { page, close } = await open();
  await pair(page);
  await kept(page, 'pair/result');
  await page.evaluate(() => {
    IDBFactory.prototype.open = () => {
      throw new DOMException('Failed to execute', 'SecurityError');
    };
  });
  await clear(page);
  const text = await says(page, 'keeping', /^The browser has closed its storage, and it cannot be opened again: /);
  assert.match(text, /the storage of this browser failed \(SecurityError\)\. What was kept may be gone\. Save the project as a file/);
  assert.doesNotMatch(text, RAW);
  assert.match((await saved(page, 'keeping-save-project')).toString(), /"images"/);
  await close();
});
