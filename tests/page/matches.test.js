/** The table of the matches of a pair: filtered, added up and saved as those of a block, in step with the pictures. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { CAMERA, done, hosted, open, pair, part, pngs, saved, says, SKIP, until } from './page.js';

hosted();

/** @typedef {import('playwright-core').Page} Page */

/** How many rows the table shows, of how many.  @param {Page} page @param {RegExp} [pattern] */
async function counts(page, pattern = /^Matches: \d/) {
  const text = (await says(page, 'statistics-caption', pattern)).replaceAll('\u202f', '');
  const [, shown = 'NaN', , all = shown] = /: (\d+)( of (\d+))?$/.exec(text) ?? [];
  return { shown: Number(shown), all: Number(all) };
}

/** Chooses all matches that the left picture shows; says how many.  @param {Page} page */
async function enclosed(page) {
  await part(page, 'view').focus();
  await page.keyboard.press('Escape');
  const box = await part(page, 'pane-left').boundingBox();
  assert.ok(box);
  await page.keyboard.down('Shift');
  await page.mouse.move(box.x + 2, box.y + 60);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.move(box.x + box.width - 2, box.y + box.height - 2);
  await page.mouse.up();
  await page.keyboard.up('Shift');
  return page.locator('[data-testid="statistics"] tr[aria-selected="true"]').count();
}

/** How many px of the marks over the pictures are painted in the colour of gross errors, and at all.  @param {Page} page */
const painted = (page) =>
  page.evaluate(
    () =>
      new Promise((resolve) =>
        requestAnimationFrame(() =>
          requestAnimationFrame(() => {
            const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector('[data-testid="layer-marks"]'));
            const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d')).getImageData(0, 0, canvas.width, canvas.height);
            let [all, orange] = [0, 0];
            for (let i = 0; i < data.length; i += 4) {
              if ((data[i + 3] ?? 0) < 128) continue;
              all += 1;
              if ((data[i] ?? 0) > 200 && (data[i + 2] ?? 0) < 80) orange += 1;
            }
            resolve({ all, orange });
          }),
        ),
      ),
  );

/** The heads of a file, and its rows.  @param {Buffer} file */
function read(file) {
  const fields = (/** @type {string} */ line) => line.split(/,(?=(?:[^"]*"[^"]*")*[^"]*$)/u).map((field) => field.replaceAll('"', ''));
  const [heads = [], ...rows] = file.toString().trimEnd().split('\n').map(fields);
  return { heads, rows };
}

/** The heads of a file of matches in every language. */
const FIGURES = ['Match', 'x [px]', 'y [px]', 'measure', 'correlation', 's(x, y) [px]', 'y-parallax [px]', 'r', 'w', '∇ [px]'];

/** The figure under a column.  @param {Page} page @param {string} key */
const total = async (page, key) => {
  const at = await page
    .locator('[data-testid="statistics"] thead tr')
    .first()
    .locator('th')
    .evaluateAll((heads, wanted) => heads.findIndex((one) => one.dataset.key === wanted), key);
  return (await page.locator('[data-testid="statistics"] tfoot td').nth(at).textContent()) ?? '';
};

test('matches are filtered by any column; the pictures show and choose those alone, totals and file are of them', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  await part(page, 'tab-matches').click();
  const { all } = await counts(page);
  assert.ok(all > 100, String(all));
  const before = await painted(page);
  assert.ok(await part(page, 'statistics-clear').isHidden());

  // By limits: the picture of what is left has less to paint, gross errors among it; a rectangle over all of it chooses what is listed.
  await part(page, 'statistics-filter-w').fill('>3');
  const { shown } = await counts(page, / of [\d\u202f]+$/u);
  assert.ok(shown > 2 && shown < 20, String(shown));
  const after = await until(page, 'the pictures show the filtered matches', async () => {
    const now = await painted(page);
    return now.all < before.all / 4 ? now : null;
  });
  assert.equal(before.orange, 0);
  assert.ok(after.orange > 10, JSON.stringify(after));
  assert.equal(await enclosed(page), shown);

  // From point to point the keys go among them.
  await page.keyboard.press('Escape');
  await page.keyboard.press('n');
  await part(page, 'statistics-selected').waitFor();
  const place = await part(page, 'statistics-selected').textContent();
  for (let i = 0; i < shown; i++) await page.keyboard.press('n');
  await page.waitForFunction((text) => document.querySelector('[data-testid="statistics-selected"]')?.textContent !== text, place);
  assert.equal(await part(page, 'statistics-selected').count(), 1);

  // Two columns together; a text that is not understood changes nothing, and is said.
  await part(page, 'statistics-filter-state').fill('gross');
  const { shown: gross } = await counts(page, / of [\d\u202f]+$/u);
  assert.ok(gross > 0 && gross <= shown);
  await part(page, 'statistics-filter-x').fill('x');
  assert.equal(await part(page, 'statistics-filter-x').getAttribute('aria-invalid'), 'true');
  assert.equal((await counts(page)).shown, gross);
  // All of it is taken away at once, the kind of matches too.
  await part(page, 'statistics-filter').selectOption('used');
  await page.waitForFunction(() => document.querySelectorAll('[data-testid="statistics"] tbody tr:not(.filler)').length === 0);
  assert.ok(await part(page, 'choose-listed').isDisabled());
  await part(page, 'statistics-clear').click();
  assert.deepEqual(await counts(page, /^Matches: [\d\u202f]+$/u), { shown: all, all });
  assert.equal(await part(page, 'statistics-filter').inputValue(), 'all');
  assert.equal(await part(page, 'statistics-filter-w').inputValue(), '');
  await until(page, 'the pictures show all matches', async () => (await painted(page)).all > 0.9 * before.all);

  // The file is what is shown: its rows in their order, its columns but those that are hidden, units in the heads. The foot adds up the same.
  await part(page, 'statistics-filter-w').fill('1..5');
  await part(page, 'sort-w').click();
  await part(page, 'sort-w').click();
  await part(page, 'statistics-columns').click();
  for (const key of ['influence', 'weight', 'model_x', 'model_y', 'model_z'])
    await page.locator(`#panel-matches .table-bar input[data-key="${key}"]`).uncheck();
  await page.keyboard.press('Escape');
  assert.ok(await part(page, 'statistics-columns').evaluate((press) => press === document.activeElement));
  const { heads, rows } = read(await saved(page, 'statistics-csv'));
  assert.deepEqual(heads, [...FIGURES, 'state']);
  assert.equal(rows.length, (await counts(page, / of /)).shown);
  const at = (/** @type {string} */ name) => rows.map((row) => Number(row[heads.indexOf(name)]));
  const w = at('w');
  assert.ok(w.length > 5 && w.every((value, i) => value >= 1 && value <= 5 && (i === 0 || value <= (w[i - 1] ?? NaN))), w.join());
  const rms = Math.sqrt(w.reduce((sum, value) => sum + value * value, 0) / w.length);
  const [, said = ''] = /^RMS ([\d.]+)$/.exec(await total(page, 'w')) ?? [];
  assert.ok(Math.abs(Number(said) - rms) < 0.01, `${said}, ${rms}`);
  const [, redundancy = ''] = /^Σ ([\d.]+)$/.exec(await total(page, 'r')) ?? [];
  assert.ok(Math.abs(Number(redundancy) - at('r').reduce((sum, r) => sum + r, 0)) < 0.1, redundancy);
  assert.equal(await total(page, 'x'), '');

  // Another pair is not filtered by what was typed over this one.
  await part(page, 'swap').click();
  await done(page);
  assert.equal((await counts(page, /^Matches: [\d\u202f]+$/u)).shown > 0, true);
  assert.equal(await part(page, 'statistics-filter-w').inputValue(), '');
  assert.deepEqual(complaints, []);
  await close();
});

test('an edit is of the chosen matches that are listed; the others stay chosen', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  await part(page, 'tab-matches').click();
  const { all } = await counts(page);
  await part(page, 'choose-listed').click();
  const figure = (/** @type {string} */ text) => Number(text.replace(/\D/gu, ''));
  assert.equal(figure(await says(page, 'reject', /^Reject [\d\u202f]+$/u)), all);
  assert.ok(await part(page, 'not-listed').isHidden());

  // Fewer are listed: the button is of those, and says how many more are chosen.
  await part(page, 'statistics-filter-w').fill('>3');
  const { shown } = await counts(page, / of [\d\u202f]+$/u);
  assert.ok(shown > 2 && shown < all / 2, String(shown));
  assert.equal(figure(await says(page, 'not-listed', /more chosen, not listed$/u)), all - shown);
  assert.equal(await part(page, 'reject').textContent(), `Reject ${String(shown)}`);
  assert.equal(await part(page, 'tool-reject').textContent(), `Reject ${String(shown)}`);
  await part(page, 'reject').click();
  await says(page, 'undo', new RegExp(`^Undo: reject ${String(shown)} matches$`, 'u'));

  // None of the chosen ones listed is none to edit; without the filter all are there again.
  await part(page, 'statistics-filter-w').fill('>100000');
  await counts(page, /: 0 of /u);
  assert.ok(await part(page, 'reject').isDisabled());
  await part(page, 'statistics-clear').click();
  assert.equal(figure(await says(page, 'reject', /^Reject [\d\u202f]+$/u)), all - shown);
  await says(page, 'restore', new RegExp(`^Restore ${String(shown)}$`, 'u'));
  assert.ok(await part(page, 'not-listed').isHidden());
  assert.deepEqual(complaints, []);
  await close();
});

test('in Arabic the table of matches is filtered by its own words, and its file has what is shown', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ options: { locale: 'ar-EG' } });
  await part(page, 'file-input').setInputFiles([...pngs(), CAMERA]);
  await done(page);
  await part(page, 'tab-matches').click();
  await says(page, 'statistics-caption', /\d$/);
  const before = (await part(page, 'statistics-caption').textContent()) ?? '';
  await part(page, 'statistics-filter-state').fill('جسيم');
  await page.waitForFunction((text) => document.querySelector('[data-testid="statistics-caption"]')?.textContent !== text, before);
  const { heads, rows } = read(await saved(page, 'statistics-csv'));
  assert.deepEqual([heads.length, heads.at(0), heads.at(1), heads.at(-1)], [FIGURES.length + 6, '\u{feff}رقم المطابقة', 'x [بكسل]', 'الحالة'], heads.join());
  assert.ok(rows.length > 0 && rows.every((row) => row.at(-1)?.includes('جسيم')), rows.join('\n'));
  // The list of columns lies within a phone's screen.
  await part(page, 'close-settings').click();
  await page.setViewportSize({ width: 360, height: 740 });
  await part(page, 'statistics-columns').click();
  const box = await page.locator('#panel-matches .table-bar .menu').boundingBox();
  assert.ok(box && box.x >= 0 && box.x + box.width <= 360, JSON.stringify(box));
  assert.deepEqual(complaints, []);
  await close();
});
