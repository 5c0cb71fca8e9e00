/** What the browser keeps of a pair: a reload, a crash, a full storage, a second tab and damage lose nothing. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isDeepStrictEqual } from 'node:util';
import { grey_png } from '../../pkg/node.js';
import { again, choose, done, hosted, number, open, pair, part, pngs, sample, saved, SKIP, SMALL, until, upload } from './page.js';

hosted('/kept/');

/** @typedef {import('playwright-core').Page} Page */

/** Calls of workers that compute a stage of the pair. */
const STAGES = ['detect', 'features', 'describe', 'offset', 'constantOffset', 'match', 'nearest', 'interior', 'orient', 'score'];

/** A page that notes the calls that its workers get.  @param {Parameters<typeof open>[0]} [how] */
async function noting(how) {
  const opened = await open(how);
  await opened.page.context().addInitScript(() => {
    /** @type {string[]} */
    const calls = [];
    const post = Worker.prototype.postMessage;
    Object.assign(window, { calls });
    Worker.prototype.postMessage = function (/** @type {any[]} */ ...given) {
      if (typeof given[0]?.call === 'string') calls.push(given[0].call);
      return Reflect.apply(post, this, given);
    };
  });
  return opened;
}

/** The page's address. */
async function address() {
  const { page, close } = await open();
  const url = page.url();
  await close();
  return url;
}

/** The stages that were computed since the page was loaded.  @param {Page} page @returns {Promise<string[]>} */
const computed = (page) => page.evaluate((stages) => /** @type {any} */ (window).calls.filter((/** @type {string} */ call) => stages.includes(call)), STAGES);

/** Waits until a part says something.  @param {Page} page @param {string} id @param {RegExp} pattern */
async function says(page, id, pattern) {
  await page.waitForFunction(
    ([at = '', source = '']) => new RegExp(source).test(document.querySelector(`[data-testid="${at}"]`)?.textContent ?? ''),
    [id, pattern.source],
  );
  return (await part(page, id).textContent()) ?? '';
}

/** Types into a field as a user does.  @param {Page} page @param {string} id @param {string} text */
async function type(page, id, text) {
  await part(page, id).fill(text);
  await part(page, id).press('Enter');
}

/**
 * The rows of a store, those of the pair with their text; none while there is no database, which must not come of the question.
 * @param {Page} page @param {'projects' | 'parts'} store @param {boolean} [briefly] of the results only what they are of: their text has megabytes @returns {Promise<any[]>}
 */
const stored = (page, store, briefly = false) =>
  page.evaluate(
    ([name, short]) =>
      new Promise((resolve) => {
        const opening = indexedDB.open('tiepoint');
        opening.onupgradeneeded = () => opening.transaction?.abort();
        opening.onerror = () => resolve([]);
        opening.onsuccess = () => {
          const db = opening.result;
          const reading = db.transaction(name).objectStore(name).getAll();
          const text = (/** @type {string} */ part, /** @type {any} */ value) => {
            if (part === 'pair/result') return JSON.stringify(short ? { of: value.of, typed: value.typed } : value);
            return part === 'pair' ? JSON.stringify(value) : '';
          };
          reading.onsuccess = () => {
            db.close();
            resolve(reading.result.map((row) => ({ ...row, value: undefined, text: text(row.part, row.value) })));
          };
        };
      }),
    /** @type {const} */ ([store, briefly]),
  );

/** The parts of the project of a tab, results as briefly as `stored` has them: those of a pair that was put aside are whole, whatever the tab has.  @param {Page} page */
async function own(page) {
  const project = await page.evaluate(() => sessionStorage.getItem('tiepoint-project'));
  return (await stored(page, 'parts', true)).filter((row) => row.project === project);
}

/** Waits until the project of a tab is kept with a part in which a text stands.  @param {Page} page @param {string} name @param {string} [text] */
async function kept(page, name, text = '') {
  await until(page, `${name} with ${text} is kept`, async () => (await own(page)).some((row) => row.part.startsWith(name) && row.text.includes(text)));
}

/** Waits until the project of a tab is kept with the results of its files and fields.  @param {Page} page */
async function whole(page) {
  await until(page, 'the results are kept', async () => {
    const parts = await own(page);
    const [given, result] = ['pair', 'pair/result'].map((name) => JSON.parse(parts.find((row) => row.part === name)?.text || 'null'));
    const files = given && [given.images.left, given.images.right, given.masks.left, given.masks.right].map((file) => file?.file ?? null);
    return result !== null && result.of === JSON.stringify(files) && isDeepStrictEqual(result.typed, given.typed);
  });
}

/** Changes rows of the storage.  @param {Page} page @param {'projects' | 'parts'} store @param {Record<string, any>} which fields of the rows @param {Record<string, any>} change */
const damage = (page, store, which, change) =>
  page.evaluate(
    ([name, fields, changed]) =>
      new Promise((resolve) => {
        const opening = indexedDB.open('tiepoint');
        opening.onsuccess = () => {
          const db = opening.result;
          const transaction = db.transaction(name, 'readwrite');
          const reading = transaction.objectStore(name).openCursor();
          reading.onsuccess = () => {
            const cursor = reading.result;
            if (cursor === null) return;
            if (Object.entries(fields).every(([field, value]) => cursor.value[field] === value)) cursor.update({ ...cursor.value, ...changed });
            cursor.continue();
          };
          transaction.oncomplete = () => {
            db.close();
            resolve(null);
          };
        };
      }),
    /** @type {const} */ ([store, which, change]),
  );

/** All that the panels of results and the exports show.  @param {Page} page */
async function shown(page) {
  const panels = [];
  for (const id of ['results', 'matches', 'camera', 'settings']) {
    await part(page, `tab-${id}`).click();
    const panel = page.locator(`[aria-labelledby="tab-${id}"]`);
    // Rows are made a frame later; only those in sight exist, and a longer status line leaves less room for them.
    if (id === 'matches') await panel.locator('tbody tr:not(.filler)').first().waitFor();
    const text = await panel.innerText();
    panels.push(id === 'matches' ? text.slice(0, 400) : text);
    panels.push(await panel.locator('input, select').evaluateAll((fields) => fields.map((field) => /** @type {HTMLInputElement} */ (field).value)));
  }
  return { panels, everything: JSON.parse((await saved(page, 'export-json')).toString()) };
}

test('after a reload a pair is as it was, and no stage is computed again', { skip: SKIP }, async () => {
  const { page, complaints, close } = await noting();
  await part(page, 'file-input').setInputFiles([...pngs(), upload('camera.json', Buffer.from('{"focal_mm": 92, "pixel_mm": 0.015}'), 'application/json')]);
  const line = await done(page);
  const before = await shown(page);
  await whole(page);
  await page.reload();
  const status = await says(page, 'status', /Restored from this browser: left\.png and right\.png\.$/);
  assert.ok(status.startsWith(line.replace(/ Camera data.*$/, '')), `${status} | ${line}`);
  assert.deepEqual(await shown(page), before);
  assert.deepEqual(await computed(page), []);
  // What is changed now is computed from what was kept.
  await page.locator('select[data-key="matching.strategy"]').selectOption('moments');
  await page.waitForFunction(() => /** @type {any} */ (window).calls.includes('match'));
  await done(page);
  await page.locator('select[data-key="matching.strategy"]').selectOption('auto');
  await done(page);
  assert.deepEqual(complaints, []);
  await close();
});

test('a simulated pair keeps its truth', { skip: SKIP }, async () => {
  const { page, complaints, close } = await noting();
  await sample(page);
  const before = await shown(page);
  await whole(page);
  await page.reload();
  await says(page, 'status', /Restored from this browser: sample left and sample right\.$/);
  assert.deepEqual(await shown(page), before);
  assert.ok((await number(page, 'score-right')) > 500);
  assert.deepEqual(await computed(page), []);
  assert.deepEqual(complaints, []);
  await close();
});

test('mask, marks, offset and the order of the images are kept, and the results that follow from them', { skip: SKIP }, async () => {
  const { page, complaints, close } = await noting();
  const { width_px: width, height_px: height } = SMALL;
  const half = Uint8Array.from({ length: width * height }, (_, i) => (i % width < width / 2 ? 0 : 255));
  const marks = `col,row,x_mm,y_mm\n10.5,10.5,-3,5\n260.5,10.5,3,5\n260.5,390.5,3,-5\n10.5,390.5,-3,-5\n`;
  await part(page, 'file-input').setInputFiles([
    ...pngs(),
    upload('left_mask.png', grey_png(width, height, half), 'image/png'),
    upload('left.csv', Buffer.from(marks), 'text/csv'),
    upload('right.csv', Buffer.from(marks), 'text/csv'),
    upload('camera.json', Buffer.from('{"focal_mm": 9}'), 'application/json'),
  ]);
  await done(page);
  await choose(page, 'matching.strategy', 'moments');
  await part(page, 'tab-camera').click();
  await type(page, 'offset-dx', '1');
  await type(page, 'offset-dy', '-2');
  await again(page);
  await part(page, 'swap').click();
  await again(page);
  await whole(page);
  const before = await shown(page);
  assert.equal(before.everything.images.right.mask, 'left_mask.png');
  assert.deepEqual(before.everything.given_offset, [-1, 2]);
  await page.reload();
  await says(page, 'status', /Restored from this browser: right\.png and left\.png\.$/);
  assert.deepEqual(await shown(page), before);
  // Where it failed, the orientation is tried again.
  assert.deepEqual(
    (await computed(page)).filter((call) => call !== 'orient'),
    [],
  );
  assert.deepEqual(complaints, []);
  await close();
});

test('a project file whose images are not there is kept as it was opened', { skip: SKIP }, async () => {
  const { page, complaints, close } = await noting();
  await pair(page);
  const project = await saved(page, 'export-project');
  await part(page, 'file-input').setInputFiles([upload('pair.tiepoint', project)]);
  await says(page, 'status', /pair\.tiepoint was opened/);
  await whole(page);
  const before = await shown(page);
  await page.reload();
  await says(page, 'status', /Restored from this browser: left\.png and right\.png\.$/);
  assert.deepEqual(await shown(page), before);
  assert.deepEqual(await computed(page), []);
  assert.equal((await saved(page, 'export-project')).toString(), project.toString());
  assert.deepEqual(complaints, []);
  await close();
});

test('what was typed is kept within a second, in the middle of a run and after a crash of the tab', { skip: SKIP }, async () => {
  const { page, close } = await open();
  await part(page, 'file-input').setInputFiles(pngs());
  await kept(page, 'pair/file/');
  await part(page, 'tab-camera').click();
  await type(page, 'camera-focal', '91.5');
  await type(page, 'camera-pixel', '0.015');
  await kept(page, 'pair', '"pixel_mm":0.015');
  await page.reload();
  await part(page, 'tab-camera').click();
  await says(page, 'name-left', /left\.png/);
  assert.equal(await part(page, 'camera-focal').inputValue(), '91.5');
  assert.match(await says(page, 'status', /Restored from this browser/), /(matches|Step)/);
  await done(page);
  await whole(page);
  await type(page, 'camera-focal', '93.25');
  await kept(page, 'pair', '"focal_mm":93.25');

  // The tab breaks off while it writes and computes; another one goes on with what was kept.
  const context = page.context();
  const session = await context.newCDPSession(page);
  await Promise.race([session.send('Page.crash').catch(() => undefined), page.waitForEvent('crash')]);
  const next = await context.newPage();
  await next.goto(page.url());
  await says(next, 'status', /Restored from this browser: left\.png and right\.png\.$/);
  await part(next, 'tab-camera').click();
  assert.equal(await part(next, 'camera-focal').inputValue(), '93.25');
  await done(next);
  assert.ok((await number(next, 'count-matches')) > 500);
  await close();
});

test('a full storage is said at once, and what was kept before stays whole', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await part(page, 'file-input').setInputFiles(pngs());
  await done(page);
  await whole(page);
  await page.evaluate(() => {
    const put = IDBObjectStore.prototype.put;
    Object.assign(window, { room: false });
    IDBObjectStore.prototype.put = function (/** @type {any[]} */ ...given) {
      if (!(/** @type {any} */ (window).room)) throw new DOMException('no room', 'QuotaExceededError');
      return Reflect.apply(put, this, given);
    };
  });
  await part(page, 'tab-camera').click();
  await type(page, 'camera-focal', '77');
  await says(page, 'keeping', /storage of this browser is full.*whole/);
  const rows = await stored(page, 'parts');
  assert.ok(rows.some(({ part: name }) => name === 'pair/result') && rows.every(({ text }) => !text.includes('"focal_mm":77')));
  // As soon as there is room all is kept again.
  await page.evaluate(() => Object.assign(window, { room: true }));
  await type(page, 'camera-pixel', '0.02');
  await kept(page, 'pair', '"focal_mm":77');
  await part(page, 'keeping').waitFor({ state: 'hidden' });
  await page.evaluate(() => Object.assign(window, { room: false }));
  await type(page, 'camera-focal', '78');
  await says(page, 'keeping', /storage of this browser is full/);
  await page.reload();
  await says(page, 'status', /Restored from this browser: left\.png and right\.png\.$/);
  await part(page, 'tab-camera').click();
  assert.equal(await part(page, 'camera-focal').inputValue(), '77');
  await done(page);
  assert.deepEqual(complaints, []);
  await close();
});

test('damage never stops the page: it is said, a new project begins, and what is kept can be saved', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  await whole(page);
  await damage(page, 'parts', { part: 'pair/result' }, { value: { project: 'cut', typed: 1 } });
  await page.reload();
  await says(page, 'keeping', /“left\.png and right\.png” cannot be restored: .*It stays in the storage as it is/);
  await says(page, 'status', /^Ready/);
  assert.equal(await saved(page, 'keeping-save').then((bytes) => bytes.subarray(0, 2).toString()), 'PK');
  await part(page, 'keeping-close').click();
  await part(page, 'file-input').setInputFiles(pngs());
  await done(page);
  await kept(page, 'pair/file/');
  assert.equal((await stored(page, 'projects')).length, 2);
  await page.reload();
  await says(page, 'status', /Restored from this browser: left\.png and right\.png\.$/);

  // A later form is refused as it is.
  await damage(page, 'projects', {}, { form: 99 });
  const before = await stored(page, 'projects');
  await page.reload();
  await says(page, 'keeping', /“left\.png and right\.png” cannot be restored: a later version of this page wrote it/);
  await says(page, 'status', /^Ready/);
  assert.deepEqual(await stored(page, 'projects'), before);
  assert.deepEqual(complaints, []);
  await close();
});

test('a project with which the page broke off again and again is opened only when the user asks', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await part(page, 'file-input').setInputFiles(pngs());
  await done(page);
  await whole(page);
  const [project] = await stored(page, 'projects');
  const url = page.url();
  const context = page.context();
  await page.close();
  const next = await context.newPage();
  await next.addInitScript((id) => localStorage.setItem('tiepoint-broke-off', `${id} 2`), project.id);
  await next.goto(url);
  await says(next, 'keeping', /“left\.png and right\.png” was not opened: the page broke off/);
  await says(next, 'status', /^Ready/);
  await part(next, 'keeping-open').click();
  await says(next, 'status', /Restored from this browser: left\.png and right\.png\.$/);
  assert.deepEqual(complaints, []);
  await close();
});

test('where the browser keeps nothing the page says so once and works', { skip: SKIP }, async () => {
  const { page, close } = await open({ url: 'about:blank' });
  await page.addInitScript(() => {
    IDBFactory.prototype.open = () => {
      throw new DOMException('blocked', 'SecurityError');
    };
  });
  await page.goto(await address());
  await says(page, 'keeping', /keeps nothing/);
  await part(page, 'keeping-close').click();
  await pair(page);
  assert.ok(await part(page, 'keeping').isHidden());
  await close();
});

for (const locks of [true, false])
  test(`a second tab is told that the project is open, and can take it over; neither writes over the other${locks ? '' : ', where there are no locks'}`, {
    skip: SKIP,
  }, async () => {
    const { page, complaints, close } = await open();
    // As on plain http from another machine.
    if (!locks) await page.context().addInitScript(() => Object.defineProperty(navigator, 'locks', { value: undefined }));
    await page.reload();
    await part(page, 'file-input').setInputFiles(pngs());
    await done(page);
    await whole(page);
    const second = await page.context().newPage();
    await second.goto(page.url());
    await says(second, 'keeping', /“left\.png and right\.png” is open in another tab/);
    await says(second, 'status', /^Ready/);
    // It can be looked at as it is kept; what is changed there stays there.
    await part(second, 'keeping-look').click();
    await says(second, 'status', /Restored from this browser: left\.png and right\.png\.$/);
    await says(second, 'keeping', /what that tab has kept so far/);
    await part(page, 'tab-camera').click();
    await type(page, 'camera-focal', '44');
    await kept(page, 'pair', '"focal_mm":44');
    await part(second, 'tab-camera').click();
    await type(second, 'camera-focal', '33');
    await done(second);
    await part(second, 'keeping-look').click();
    await second.waitForFunction(() => /** @type {HTMLInputElement} */ (document.querySelector('[data-testid="camera-focal"]')).value === '44');
    assert.ok((await stored(page, 'parts')).every(({ text }) => !text.includes('"focal_mm":33')));
    await part(second, 'keeping-take').click();
    await part(second, 'keeping').waitFor({ state: 'hidden' });
    assert.equal(await part(second, 'camera-focal').inputValue(), '44');
    await says(page, 'keeping', /Another tab has taken “left\.png and right\.png” over/);
    // What the first tab changes is its own.
    await part(page, 'tab-camera').click();
    await type(page, 'camera-focal', '55');
    await part(second, 'tab-camera').click();
    await type(second, 'camera-focal', '66');
    await kept(second, 'pair', '"focal_mm":66');
    assert.ok((await stored(page, 'parts')).every(({ text }) => !text.includes('"focal_mm":55')));
    await part(page, 'keeping-new').click();
    await kept(page, 'pair', '"focal_mm":55');
    await kept(second, 'pair', '"focal_mm":66');
    assert.equal((await stored(page, 'projects')).length, 2);
    assert.ok(await part(page, 'keeping').isHidden());
    assert.deepEqual(complaints, []);
    await close();
  });

test('photographs that were matched stay in the list where another pair takes their place', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await part(page, 'file-input').setInputFiles(pngs());
  await done(page);
  await whole(page);
  await sample(page);
  await says(page, 'status', /left\.png and right\.png stay under Projects\.$/);
  await part(page, 'projects').click();
  await part(page, 'project').nth(1).waitFor();
  await page.getByRole('button', { name: 'left.png and right.png', exact: true }).click();
  await says(page, 'status', /Restored from this browser: left\.png and right\.png\.$/);
  // A simulated pair can be made again.
  await sample(page);
  await part(page, 'file-input').setInputFiles(pngs());
  await done(page);
  await says(page, 'name-left', /left\.png/);
  await part(page, 'projects').click();
  await part(page, 'project').nth(1).waitFor();
  assert.equal(await part(page, 'project').count(), 3);
  assert.deepEqual(complaints, []);
  await close();
});

test('projects are opened, renamed, duplicated and deleted by the keyboard', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await sample(page);
  await whole(page);
  await part(page, 'anew').click();
  await says(page, 'status', /^Ready/);
  assert.ok(await part(page, 'welcome').isVisible());
  await part(page, 'file-input').setInputFiles(pngs());
  await done(page);
  await whole(page);
  await part(page, 'projects').focus();
  await page.keyboard.press('Enter');
  await part(page, 'project').nth(1).waitFor();
  assert.match((await part(page, 'project').nth(0).textContent()) ?? '', /^left\.png and right\.png2 images · .* · on the page/);
  assert.match((await part(page, 'project-room').textContent()) ?? '', /take about [\d.]+ [kM]B/);
  await page.getByRole('button', { name: 'Rename: sample left and sample right' }).press('Enter');
  await page.keyboard.type('Flight one');
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: 'Duplicate: Flight one' }).press('Enter');
  await page.getByRole('button', { name: 'Delete: Flight one (copy)' }).press('Enter');
  await part(page, 'project-delete').press('Enter');
  await page.waitForFunction(() => document.querySelectorAll('[data-testid="project"]').length === 2);
  await page.getByRole('button', { name: 'Flight one', exact: true }).press('Enter');
  await says(page, 'status', /Restored from this browser: sample left and sample right\.$/);
  assert.ok(await part(page, 'projects-dialog').isHidden());
  await page.reload();
  await says(page, 'status', /Restored from this browser: sample left and sample right\.$/);
  assert.equal((await stored(page, 'projects')).find(({ name }) => name === 'Flight one')?.mode, 'pair');
  assert.deepEqual(complaints, []);
  await close();
});
