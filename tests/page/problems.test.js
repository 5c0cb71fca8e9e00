/** What goes wrong, where it is said and when it is over; and that the keyboard is never lost. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { CAMERA, choose, done, hosted, number, open, pair, part, pngs, sample, saved, SKIP } from './page.js';

hosted();

/** @typedef {import('playwright-core').Page} Page */

/** Waits until a part says something.  @param {Page} page @param {string} id @param {RegExp} pattern */
async function says(page, id, pattern) {
  const given = { id, source: pattern.source, flags: pattern.flags };
  await page
    .waitForFunction((p) => new RegExp(p.source, p.flags).test(document.querySelector(`[data-testid="${p.id}"]`)?.textContent ?? ''), given)
    .catch(async () => assert.match((await part(page, id).textContent()) ?? '', pattern));
}

/** Types into a field as a user does.  @param {Page} page @param {string} id @param {string} text */
async function type(page, id, text) {
  await part(page, id).fill(text);
  await part(page, id).press('Enter');
}

/** @param {Page} page @param {string} id */
const invalid = (page, id) => part(page, id).getAttribute('aria-invalid');

/** The test id of what has the keyboard, or its id.  @param {Page} page */
const focused = (page) => page.evaluate(() => document.activeElement?.getAttribute('data-testid') ?? document.activeElement?.tagName);

/** @param {Page} page */
const broken = (page) => part(page, 'file-input').setInputFiles([{ name: 'bad.png', mimeType: 'image/png', buffer: Buffer.from('no image') }]);

test('what was said of a bad file is over with the next deed', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  await broken(page);
  await says(page, 'status', /bad\.png cannot be opened/);
  await part(page, 'view').focus();
  await page.keyboard.press('n');
  await says(page, 'status', /bad\.png/);
  await page.locator('select[data-key="matching.strategy"]').selectOption('invariants');
  await done(page);
  await broken(page);
  await says(page, 'status', /bad\.png cannot be opened/);
  await part(page, 'swap').click();
  await done(page);
  assert.deepEqual(complaints, []);
  await close();
});

test('what is told of a file stands beside the result of the run', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  await part(page, 'file-input').setInputFiles([
    { name: 'camera.json', mimeType: 'application/json', buffer: Buffer.from('{"focal_mm": 153.4, "pixel_mm": 0.2542}') },
  ]);
  await says(page, 'status', /^(Oriented|Weak) .*Camera data from camera\.json\.$/);
  assert.deepEqual(complaints, []);
  await close();
});

test('one mark is told as one', { skip: SKIP }, async () => {
  const { page, close } = await open();
  await says(page, 'status', /^Ready/);
  await part(page, 'file-input').setInputFiles([{ name: 'left.csv', mimeType: 'text/csv', buffer: Buffer.from('col,row,x_mm,y_mm\n1,2,3,4\n') }]);
  await says(page, 'status', /^1 fiducial mark of the left image from left\.csv\.$/);
  await close();
});

test('numbers of the camera, the offset and the origin that are not allowed are said at their fields, and the last valid ones stay', {
  skip: SKIP,
}, async () => {
  const { page, complaints, close } = await open();
  await sample(page);
  await choose(page, 'matching.strategy', 'moments');
  await part(page, 'tab-camera').click();
  for (const [id, text, pattern] of /** @type {const} */ ([
    ['camera-focal', '-5', /^Allowed: above 0, up to 100000, or empty\. The last valid value stays/],
    ['camera-pixel', '0', /^Allowed: 0\.000001 to 10, or empty/],
    ['camera-x0', '1e6', /^Allowed: two numbers from -10000 to 10000/],
  ])) {
    await type(page, id, text);
    assert.equal(await invalid(page, id), 'true', id);
    await says(page, `${id}-problem`, pattern);
  }
  await type(page, 'origin-left-col', '1e12');
  assert.deepEqual([await invalid(page, 'origin-left-col'), await invalid(page, 'origin-left-row')], ['true', null]);
  await says(page, 'origin-left-problem', /^Allowed: two numbers of px from -10000000 to 10000000/);
  await type(page, 'offset-dx', '3');
  assert.deepEqual([await invalid(page, 'offset-dx'), await invalid(page, 'offset-dy')], [null, 'true']);
  await says(page, 'offset-problem', /^Give both numbers, or empty both/);
  // Nothing of it was taken.
  await page.waitForTimeout(400);
  assert.match((await part(page, 'status').textContent()) ?? '', /^Focal length: this value is not allowed/);
  await type(page, 'camera-focal', '150');
  assert.equal(await invalid(page, 'camera-focal'), null);
  assert.equal(await part(page, 'camera-focal-problem').textContent(), '');
  assert.equal(await part(page, 'camera-pixel').inputValue(), '');
  await says(page, 'base', /150\.0 mm/);
  await type(page, 'offset-dy', '1');
  await says(page, 'offset-found', /^Given/);
  await says(page, 'status', /^Origin of the left image in the scan: this value is not allowed/);
  await type(page, 'origin-left-col', '');
  assert.match(await done(page), /^Oriented/);
  assert.deepEqual(complaints, []);
  await close();
});

test('an interior orientation that fails is the status, and figures of the earlier orientation go', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await sample(page);
  await choose(page, 'matching.strategy', 'moments');
  assert.ok((await number(page, 'count-gross-errors')) > 0);
  await part(page, 'histogram-residuals').waitFor();
  await part(page, 'tab-camera').click();
  // A mark without coordinates takes no part yet.
  await part(page, 'add-fiducial-left').click();
  await says(page, 'interior-left', /One mark is incomplete/);
  assert.ok((await number(page, 'count-gross-errors')) > 0);
  // One that lies where another one does.
  const rows = page.locator('[data-testid="fiducials-left"] tbody tr');
  for (const field of [0, 1, 2, 3]) {
    const input = rows.nth(8).locator('input').nth(field);
    await input.fill(await rows.nth(0).locator('input').nth(field).inputValue());
    await input.press('Tab');
  }
  await says(page, 'status', /Not oriented: 1\u202f\d+ matches/);
  assert.equal(await part(page, 'status').getAttribute('data-kind'), 'problem');
  // The reason is that of the settings that are there.
  await part(page, 'orientation-reason').waitFor();
  assert.equal(await page.locator('.is-stale:has([data-testid="orientation-reason"])').count(), 0);
  assert.equal(await part(page, 'count-gross-errors').textContent(), '–');
  await part(page, 'histogram-measure').waitFor();
  await page.waitForFunction(() => document.querySelector('[data-testid="histogram-residuals"]') === null);
  await part(page, 'remove-fiducial-left-8').click();
  await done(page);
  const gross = await number(page, 'count-gross-errors');
  assert.ok(gross > 0);
  // A setting that leaves nothing to match is taken back: the matches are found anew, and the orientation is of them.
  await part(page, 'tab-settings').click();
  const threshold = page.locator('#panel-settings input[type="number"][data-key="points.threshold"]');
  await threshold.fill('1000000000');
  await says(page, 'status', /^Not oriented/);
  await threshold.fill('');
  await says(page, 'status', /^Oriented/);
  assert.equal(await number(page, 'count-gross-errors'), gross);
  await part(page, 'histogram-residuals').waitFor();
  const json = JSON.parse((await saved(page, 'export-json')).toString());
  assert.equal(json.orientation?.rejected.length, gross);
  assert.deepEqual(complaints, []);
  await close();
});

test('true errors of by and bz are at the scale of the base that was used', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await sample(page);
  const errors = async () => ({ by: await number(page, 'deviation-by_mm'), ratio: await number(page, 'deviation-ratio-by_mm') });
  const own = await errors();
  await page.locator('input[data-key="orientation.base_mm"]').fill('184');
  await says(page, 'base', /184\.0 mm/);
  const double = await errors();
  // Both have two digits.
  assert.ok(Math.abs(double.by - 2 * own.by) < 6e-4, JSON.stringify([own, double]));
  assert.equal(double.ratio, own.ratio);
  await page.locator('input[data-key="orientation.base_mm"]').fill('0');
  await says(page, 'orientation-reason', /“Photo base” is 0; allowed/);
  assert.deepEqual(complaints, []);
  await close();
});

test('what is wrong with a flight is said of the flight itself, by the label of its field', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await says(page, 'status', /^Ready/);
  await part(page, 'tab-simulate').click();
  const columns = page.locator('input[data-key="flight.width_px"]');
  await columns.fill('4000');
  await says(page, 'flight-problem', /^“Columns” is 4000; allowed: 16 to 543\.$/);
  assert.equal(await columns.getAttribute('aria-invalid'), 'true');
  await part(page, 'render-flight').click();
  await says(page, 'status', /^The pair could not be rendered: “Columns” is 4000; allowed: 16 to 543\./);
  // As thin as may be: the preview is not coarser than the thinner side allows.
  await columns.fill('16');
  await page.locator('input[data-key="flight.height_px"]').fill('900');
  await page.waitForFunction(() => /** @type {HTMLCanvasElement} */ (document.querySelector('[data-testid="preview-left"]')).width === 16);
  assert.equal(await part(page, 'flight-problem').textContent(), '');
  assert.equal(await columns.getAttribute('aria-invalid'), null);
  assert.deepEqual(complaints, []);
  await close();
});

test('the keyboard stays where it was when what it was on is built anew', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await page.waitForFunction(() => document.querySelector('[data-testid="sample-first"]:enabled') !== null);
  await part(page, 'sample-first').focus();
  await page.keyboard.press('Enter');
  await done(page);
  assert.equal(await focused(page), 'view');
  await part(page, 'tab-matches').click();
  const table = part(page, 'statistics');
  await table.focus();
  for (let i = 0; i < 5; i++) await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  await part(page, 'statistics-selected').waitFor();
  // Asked of the page in one go: a row that a locator has found may be built anew before it is looked at.
  await page.waitForFunction(
    () => document.querySelector('[data-testid="statistics-selected"]')?.id === document.activeElement?.getAttribute('aria-activedescendant'),
  );
  assert.equal(await focused(page), 'statistics');
  // The table keeps it while its rows are built anew, and goes on from the row that was left.
  await page.locator('#panel-matches .rows').evaluate((rows) => {
    rows.scrollTop = 12_000;
  });
  await page.waitForFunction(() => document.querySelector('[data-testid="statistics-selected"]') === null);
  assert.equal(await focused(page), 'statistics');
  await page.keyboard.press('ArrowDown');
  await page.waitForFunction(() =>
    document
      .getElementById(document.activeElement?.getAttribute('aria-activedescendant') ?? '')
      ?.previousElementSibling?.matches('[data-testid="statistics-selected"]'),
  );
  assert.deepEqual(complaints, []);
  await close();
});

test('all is in sight: one row of tools at 1280 px, menus at 360 px, wide choices', { skip: SKIP }, async () => {
  const { page, close } = await open({ fresh: true });
  await says(page, 'status', /^Ready/);
  const box = async (/** @type {string} */ id) => (await part(page, id).boundingBox()) ?? assert.fail(id);
  assert.ok(Math.abs((await box('next-point')).y - (await box('layer-points')).y) < 6);
  await part(page, 'settings').click();
  await part(page, 'tab-simulate').click();
  assert.ok((await box('flight-preset')).width > 200);
  await part(page, 'tab-camera').click();
  assert.ok((await box('fiducial-model')).width > 200);
  await page.setViewportSize({ width: 360, height: 740 });
  await part(page, 'close-settings').click();
  await part(page, 'menu').click();
  for (const id of ['export-png', 'export-report', 'swap']) {
    const { x, width } = await box(id);
    assert.ok(x >= 0 && x + width <= 360, id);
  }
  await page.keyboard.press('Escape');
  await part(page, 'view-menu').click();
  for (const id of ['next-point', 'magnifier']) {
    const { x, width } = await box(id);
    assert.ok(x >= 0 && x + width <= 360, id);
  }
  await close();
});

test('where there is no room drawers make way: details for settings and the other way round, settings for a phone', { skip: SKIP }, async () => {
  const { page, close } = await open({ fresh: true });
  await says(page, 'status', /^Ready/);
  // A drawer makes way when the page hears of its new width, which is after the driver does.
  const seen = (/** @type {boolean} */ settings, /** @type {boolean} */ details) =>
    page.waitForFunction(
      (wanted) => ['tab-settings', 'tab-results'].every((name, at) => document.querySelector(`[data-testid="${name}"]`)?.checkVisibility() === wanted[at]),
      [settings, details],
      { timeout: 10_000 },
    );
  await part(page, 'settings').click();
  await part(page, 'file-input').setInputFiles([...pngs(), CAMERA]);
  await done(page);
  await seen(true, false);
  await part(page, 'details').click();
  await seen(false, true);
  await part(page, 'settings').click();
  await seen(true, false);
  await page.setViewportSize({ width: 1600, height: 900 });
  await part(page, 'details').click();
  await seen(true, true);
  await page.setViewportSize({ width: 1366, height: 768 });
  await seen(false, true);
  await part(page, 'settings').click();
  await page.setViewportSize({ width: 360, height: 740 });
  await page.reload();
  await says(page, 'status', /Restored/);
  await seen(false, false);
  await close();
});

test('bad files are told, those of one reason together, and what was open only where something was', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await page.waitForFunction(() => document.querySelector('[data-testid="sample"]:enabled') !== null);
  const files = ['bad.jpg', 'worse.jpg', 'a.txt'].map((name) => ({ name, mimeType: '', buffer: Buffer.from('nothing of use') }));
  const give = () => part(page, 'file-input').setInputFiles(files);
  await give();
  await says(page, 'status', /a\.txt is no photograph and no table that is known here\. 2 files cannot be opened \(bad\.jpg, worse\.jpg\): [^.]*\.$/);
  assert.doesNotMatch((await part(page, 'status').textContent()) ?? '', /images are kept/);
  // Of two, the one that can be read is shown: only the other is missing.
  const [good] = pngs();
  assert.ok(good && files[0]);
  await part(page, 'file-input').setInputFiles([files[0], good]);
  await says(page, 'status', /^bad\.jpg cannot be opened: [^.]*\.$/);
  await part(page, 'replace-right').waitFor();
  await pair(page);
  await give();
  await says(page, 'status', /a\.txt .*\(bad\.jpg, worse\.jpg\).* The open images are kept\.$/);
  assert.deepEqual(complaints, []);
  await close();
});

test('a stray file among two photos takes neither their verdict nor their pictures away', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await page.waitForFunction(() => document.querySelector('[data-testid="sample"]:enabled') !== null);
  await part(page, 'file-input').setInputFiles([...pngs(), { name: 'notes.txt', mimeType: 'text/plain', buffer: Buffer.from('hello') }]);
  await says(page, 'status', /^(Oriented|Weak|Not oriented).* notes\.txt is no photograph and no table that is known here\./);
  assert.match((await part(page, 'answer').getAttribute('data-verdict')) ?? '', /oriented|weak/);
  assert.deepEqual(complaints, []);
  await close();
});

test('the status line says that a value is not allowed, until it is', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await sample(page);
  await choose(page, 'matching.strategy', 'moments');
  const field = page.locator('input[type="number"][data-key="points.suppression_window"]');
  await field.fill('4');
  await says(page, 'status', /^Suppression window: this value is not allowed\. The last valid one stays in use\.$/);
  assert.equal(await part(page, 'status').getAttribute('data-kind'), 'problem');
  await field.fill('3');
  assert.match(await done(page), /^Oriented/);
  await part(page, 'tab-camera').click();
  await type(page, 'camera-focal', '-5');
  await says(page, 'status', /^Focal length: this value is not allowed/);
  await type(page, 'camera-focal', '153.38');
  assert.match(await done(page), /^Oriented/);
  await part(page, 'mode-block').click();
  const pairs = page.locator('main.block input[type="number"][data-key="multiscale.number"]');
  await pairs.fill('-1');
  await says(page, 'block-status', /is not allowed/);
  await pairs.fill('2000');
  await says(page, 'block-status', /^Open the images/);
  assert.deepEqual(complaints, []);
  await close();
});

test('a simulated pair that is swapped says that its truth is of the other order', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await sample(page);
  assert.ok(await part(page, 'score').isVisible());
  await part(page, 'swap').click();
  await says(page, 'status', /^Oriented .*holds in its own order only: swap again/);
  assert.equal(await part(page, 'score').count(), 0);
  await part(page, 'swap').click();
  await part(page, 'score').waitFor();
  assert.doesNotMatch((await part(page, 'status').textContent()) ?? '', /truth/);
  assert.deepEqual(complaints, []);
  await close();
});
