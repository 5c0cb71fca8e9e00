import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { again, choose, done, hosted, number, open, pair, part, pngs, ROOT, sample, saved, says, SHOTS, SKIP, transferOf, upload, verdicts } from './page.js';

hosted('/some/folder/');

test('the sample pair is matched and oriented, from a subfolder under the policy, and its report is that of the crate', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await sample(page);
  assert.ok((await number(page, 'count-matches')) > 500);
  assert.equal(await verdicts(page), await number(page, 'count-left-after_suppression'));
  await page.screenshot({ path: join(SHOTS, 'sample.png') });
  const report = (await saved(page, 'export-report')).toString();
  const tracked = readFileSync(join(ROOT, 'docs', 'sample-report.html'), 'utf8');
  assert.ok(report === tracked, `${report.length} characters, tracked ${tracked.length}`);
  assert.deepEqual(complaints, []);
  await close();
});

test('the browser finds the matches of the golden files', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await sample(page);
  /** @param {string} name */
  const same = async (name) => {
    // The golden file ends with a line of the orientation.
    const golden = readFileSync(join(ROOT, 'tests', 'golden', name), 'utf8')
      .split('\n')
      .slice(0, -2)
      .join('\n');
    assert.equal((await saved(page, 'export-csv')).toString().trimEnd(), golden);
  };
  await same('sample.csv');
  await part(page, 'tab-settings').click();
  await choose(page, 'matching.strategy', 'moments');
  const field = page.locator('input[data-key="points.fraction"]:not([type="range"])').first();
  await field.fill('0.148');
  await field.press('Enter');
  await again(page);
  await same('sample-moments.csv');
  await choose(page, 'matching.strategy', 'least-squares');
  await same('sample-least-squares.csv');
  await choose(page, 'matching.strategy', 'correlation');
  await choose(page, 'matching.refine', 'least-squares');
  await page.locator('input[data-key="matching.epipolar"]').check();
  await again(page);
  await same('sample-correlation.csv');
  await choose(page, 'matching.refine', 'none');
  await choose(page, 'matching.strategy', 'gradient');
  assert.equal(await page.locator('select[data-key="points.operator"] option:checked').textContent(), 'default: many scales');
  await same('sample-gradient.csv');
  assert.equal(await verdicts(page), await number(page, 'count-left-after_suppression'));
  const everything = JSON.parse((await saved(page, 'export-json')).toString());
  assert.ok(everything !== null && typeof everything === 'object');
  assert.equal((await saved(page, 'export-png')).subarray(1, 4).toString(), 'PNG');
  assert.deepEqual(complaints, []);
  await close();
});

test('the table of matches sorts, filters, and is linked to the images both ways', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  await part(page, 'tab-matches').click();
  const rows = page.locator('[data-testid="statistics"] tbody tr:not(.filler)');
  const column = async (/** @type {number} */ at) =>
    (await rows.locator(`td:nth-child(${at})`).allTextContents()).map((text) => Number(text.replace('−', '-')));
  const heads = await page.locator('[data-testid="statistics"] thead th').allTextContents();
  const w = heads.findIndex((text) => text.trim() === 'w') + 1;
  assert.ok(w > 0, heads.join());
  await part(page, 'sort-w').click();
  const rising = await column(w);
  assert.deepEqual(
    rising,
    [...rising].sort((a, b) => a - b),
  );
  await part(page, 'sort-w').click();
  const falling = await column(w);
  assert.deepEqual(
    falling,
    [...falling].sort((a, b) => b - a),
  );
  assert.ok((falling[0] ?? 0) > 3.29);
  // Only the rows in sight exist.
  assert.ok((await rows.count()) < 100);
  // The largest of all is a gross error.
  await rows.first().locator(`td:nth-child(${w})`).click();
  await part(page, 'statistics-selected').waitFor();
  await part(page, 'tab-point').click();
  assert.match((await part(page, 'point-verdict').textContent()) ?? '', /rejected from the relative orientation/);
  assert.ok((await number(page, 'match-w')) > 3.29);
  await part(page, 'tab-matches').click();
  await part(page, 'statistics-filter').selectOption('rejected');
  assert.match((await part(page, 'statistics-caption').textContent()) ?? '', new RegExp(`: ${await number(page, 'count-gross-errors')} of `));
  await part(page, 'statistics-filter').selectOption('all');
  await part(page, 'view').focus();
  for (let i = 0; i < 40; i++) await page.keyboard.press('n');
  await page.waitForTimeout(300);
  await page.screenshot({ path: join(SHOTS, 'statistics.png') });
  assert.deepEqual(complaints, []);
  await close();
});

/** A y-parallax that its neighbours refuse is told with what it is and what is allowed.  @param {import('playwright-core').Page} page */
async function beyondNeighbours(page) {
  await part(page, 'tab-results').click();
  for (const code of await page.locator('[data-testid^="show-"]').all()) await code.setChecked((await code.getAttribute('data-testid')) === 'show-6');
  await part(page, 'view').focus();
  for (let i = 0; i < 20 && !/y-parallax/.test((await part(page, 'selected').textContent()) ?? ''); i++) await page.keyboard.press('n');
  const [, off = NaN, allowed = NaN] =
    /differs from that of its nearest matches by ([\d.]+) px; ([\d.]+) px is allowed/.exec(await says(page, 'selected', /nearest matches by/))?.map(Number) ??
    [];
  assert.ok(off > allowed && allowed >= 1, `${off} ${allowed}`);
}

test('grey values: settings that have no effect are left out, a point shows what was compared', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await sample(page);
  await choose(page, 'matching.strategy', 'moments');
  const setting = (/** @type {string} */ key) => page.locator(`[data-key="${key}"]`).first();
  assert.ok((await setting('matching.max_measure').isVisible()) && !(await setting('matching.template').isVisible()));
  await choose(page, 'matching.strategy', 'least-squares');
  assert.ok(!(await setting('matching.max_measure').isVisible()) && (await setting('matching.template').isVisible()));
  assert.ok((await number(page, 'score-right')) > 2000 && (await number(page, 'score-strict')) > 1800);
  assert.ok(Math.abs(await number(page, 'deviation-ratio-omega_deg')) < 5);
  assert.ok((await number(page, 'condition')) > 1);
  await part(page, 'condition-name').click();
  assert.match((await page.locator('#condition-help').textContent()) ?? '', /eigenvalue/);
  assert.equal(await page.locator('[data-testid="correlations"] g').count(), 25);
  await part(page, 'tab-matches').click();
  await page.locator('[data-testid="statistics-row"]').nth(5).click();
  await part(page, 'tab-point').click();
  await part(page, 'match-standard_error').waitFor();
  assert.equal(await page.locator('[data-testid="point-windows"] canvas').count(), 2);
  assert.equal(await part(page, 'point-moments').count(), 0);
  assert.match((await part(page, 'point-verdict').textContent()) ?? '', /Correlation 0\.\d+/);
  await page.screenshot({ path: join(SHOTS, 'grey-values.png') });
  await choose(page, 'matching.strategy', 'moments');
  await beyondNeighbours(page);
  assert.deepEqual(complaints, []);
  await close();
});

test('a flight is simulated with a live preview, and what cannot be flown is said', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await page.waitForFunction(() => document.querySelector('[data-testid="status"]')?.textContent?.startsWith('Ready'));
  await part(page, 'tab-simulate').click();
  const painted = () =>
    page.evaluate(() => {
      const canvas = document.querySelector('[data-testid="preview-left"]');
      if (!(canvas instanceof HTMLCanvasElement)) return '';
      return canvas.toDataURL();
    });
  const blank = await painted();
  await page.waitForFunction(
    (before) => /** @type {HTMLCanvasElement} */ (document.querySelector('[data-testid="preview-left"]')).toDataURL() !== before,
    blank,
  );
  const first = await painted();
  await part(page, 'flight-preset').selectOption('lively');
  await page.waitForFunction(
    (before) => /** @type {HTMLCanvasElement} */ (document.querySelector('[data-testid="preview-left"]')).toDataURL() !== before,
    first,
  );
  const relief = page.locator('input[data-key="flight.relief_m"]:not([type="range"])').first();
  await relief.fill('400');
  await page.waitForFunction(() => /relief/i.test(document.querySelector('[data-testid="flight-problem"]')?.textContent ?? ''));
  await relief.fill('20');
  await page.waitForFunction(() => document.querySelector('[data-testid="flight-problem"]')?.textContent === '');
  await part(page, 'render-flight').click();
  await done(page);
  assert.match((await part(page, 'name-left').textContent()) ?? '', /lively left/);
  assert.ok((await number(page, 'score-right')) > 500);
  await page.screenshot({ path: join(SHOTS, 'simulate.png') });
  assert.deepEqual(complaints, []);
  await close();
});

test('the module is compiled beside the page, and one that is not there is said', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await page.waitForFunction(() => document.querySelector('[data-testid="status"]')?.textContent?.startsWith('Ready'));
  const url = page.url();
  // On the thread of the page it would hold up what the user does.
  await page.addInitScript(() => {
    for (const name of /** @type {const} */ (['compile', 'compileStreaming', 'instantiateStreaming']))
      WebAssembly[name] = () => {
        throw new Error('on the thread of the page');
      };
  });
  await page.reload();
  await page.waitForFunction(() => document.querySelector('[data-testid="status"]')?.textContent?.startsWith('Ready'));
  assert.deepEqual(complaints, []);
  await page.route('**/*.wasm', (route) => route.fulfill({ status: 503 }));
  await page.goto(url);
  await page.waitForFunction(() =>
    /tiepoint_bg\.wasm could not be loaded \(HTTP 503\)/.test(document.querySelector('[data-testid="status"]')?.textContent ?? ''),
  );
  await close();
});

test('two files are opened, matched, and a parameter recomputes what depends on it', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await part(page, 'file-input').setInputFiles(pngs({}));
  await done(page);
  await choose(page, 'matching.strategy', 'moments');
  const before = { points: await number(page, 'count-left-after_suppression'), matches: await number(page, 'count-matches') };
  assert.ok(before.matches > 500);
  const field = page.locator('input[data-key="matching.max_measure"]:not([type="range"])').first();
  await field.fill('2');
  await field.press('Enter');
  await page.waitForFunction(
    (matches) => Number(document.querySelector('[data-testid="count-matches"]')?.textContent?.replaceAll(/\D/g, '')) !== matches,
    before.matches,
  );
  assert.ok((await number(page, 'count-matches')) < before.matches);
  assert.equal(await number(page, 'count-left-after_suppression'), before.points);
  assert.deepEqual(complaints, []);
  await close();
});

test('dropped files are opened', { skip: SKIP }, async () => {
  const { page, close } = await open();
  const transfer = await transferOf(page, pngs());
  for (const type of ['dragenter', 'dragover', 'drop']) await part(page, 'view').dispatchEvent(type, { dataTransfer: transfer });
  await done(page);
  assert.ok((await number(page, 'count-matches')) > 500);
  await close();
});

test('a bad file is named and what was there stays', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  const matches = await number(page, 'count-matches');
  const [good] = pngs();
  assert.ok(good);
  const cut = upload('cut.png', good.buffer.subarray(0, 2000), 'image/png');
  await part(page, 'file-input').setInputFiles([cut]);
  await page.waitForFunction(() => document.body.textContent?.includes('cut.png'));
  await page.waitForTimeout(500);
  assert.match((await page.locator('body').textContent()) ?? '', /cut\.png/);
  assert.equal(await number(page, 'count-matches'), matches);
  await page.screenshot({ path: join(SHOTS, 'bad-file.png') });
  assert.deepEqual(
    complaints.filter((c) => c.startsWith('uncaught')),
    [],
  );
  await close();
});

test('a run can be cancelled and started again', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await part(page, 'sample').click();
  await part(page, 'cancel').click();
  await page.waitForFunction(() => /cancel/i.test(document.querySelector('[data-testid="status"]')?.textContent ?? ''));
  const again = part(page, 'run');
  if (await again.isVisible()) await again.click();
  else await part(page, 'sample').click();
  await done(page);
  assert.ok((await number(page, 'count-matches')) > 500);
  assert.deepEqual(complaints, []);
  await close();
});

test('a click and a key choose points, which tell their rule, moments and candidates', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  await choose(page, 'matching.strategy', 'moments');
  await part(page, 'layer-unmatched').click();
  await part(page, 'view').focus();
  await page.keyboard.press('n');
  await part(page, 'tab-point').click();
  // The first point lies at the upper border, where no window fits.
  await page.waitForFunction(() => /nothing to compare/.test(document.querySelector('[data-testid="point-verdict"]')?.textContent ?? ''));
  const box = await part(page, 'view').boundingBox();
  assert.ok(box);
  await page.mouse.click(box.x + box.width * 0.25, box.y + box.height * 0.5);
  await part(page, 'point-candidates').waitFor();
  assert.ok((await page.locator('[data-testid="point-candidates"] tbody tr').count()) > 0);
  assert.match((await part(page, 'point-moments').textContent()) ?? '', /µ/);
  await page.screenshot({ path: join(SHOTS, 'point.png') });
  assert.deepEqual(complaints, []);
  await close();
});

for (const [name, width, height, colorScheme] of /** @type {const} */ ([
  ['narrow', 360, 740, 'light'],
  ['tablet', 820, 1180, 'dark'],
  ['wide', 3840, 2160, 'light'],
])) {
  test(`a ${name} screen shows everything without scrolling sideways`, { skip: SKIP }, async () => {
    const { page, complaints, close } = await open({ fresh: true, options: { viewport: { width, height }, colorScheme } });
    await pair(page);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth));
    await page.screenshot({ path: join(SHOTS, `${name}.png`) });
    assert.deepEqual(complaints, []);
    await close();
  });
}
