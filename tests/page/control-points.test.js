/** Control and check points of a block in a system: counted and named apart from tie points, saved in that system, and in sight with what an edit of them says. */

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { strFromU8, unzipSync } from 'fflate';
import { block, FLIGHT, photos, status, surveyedFolder } from './blocks.js';
import { flatGeoid, pointsInSystem } from './georeferenced.js';
import { hosted, part, saved, says, SHOTS, SKIP, until, upload } from './page.js';

hosted('/control-points/');

const CRS = 'EPSG:32632';
const GEOID_M = 47;

/** @param {string} text */
const bytesOf = (text) => new TextEncoder().encode(text);

/** @typedef {import('playwright-core').Page} Page */

/** A number as the page writes it.  @param {string | undefined} text */
const figure = (text) => Number((text ?? '').replaceAll('\u202f', ''));

/** What a format of the block saves, file by file.  @param {Page} page @param {string} format */
async function archive(page, format) {
  await part(page, 'block-export-kind').selectOption(format);
  const files = unzipSync(new Uint8Array(await saved(page, 'block-export')));
  return new Map(Object.entries(files).map(([name, bytes]) => [name, strFromU8(bytes)]));
}

test('control and check points are no tie points, their differences have a height, and tables are saved in the system of the results', {
  skip: SKIP,
}, async () => {
  const { folder, points, marks } = surveyedFolder();
  rmSync(folder, { recursive: true });
  const { page, complaints, close } = await block({ options: { viewport: { width: 1366, height: 768 } } });
  await photos(page);
  const crs = page.locator('input[data-key="placing.crs"]').first();
  await crs.fill(CRS);
  await crs.blur();
  const give = (/** @type {string} */ given, /** @type {string} */ name, /** @type {Uint8Array} */ content) =>
    part(page, `block-${given}-input`).setInputFiles(upload(name, content));
  await give('geoid', 'flat.gtx', flatGeoid());
  await give('control', 'points.csv', bytesOf(pointsInSystem(points, FLIGHT, CRS, GEOID_M)));
  await give('marks', 'marks.csv', bytesOf(marks));
  await part(page, 'block-run').click();
  await part(page, 'close-block-settings').click();
  const surveyed = points.trim().split('\n').length - 1;

  const told = await status(page, /tie points selected/u);
  const [, tied] = /([\d\u202f]+) of [\d\u202f]+ tie points selected, ([\d\u202f]+) control and check points\./u.exec(told) ?? [];
  assert.match(told, new RegExp(`selected, ${surveyed} control and check points\\.`, 'u'));
  assert.match(await says(page, 'block-map-words', /tie points/u), new RegExp(`\\. ${tied} tie points; `, 'u'));
  assert.match(
    await says(page, 'block-map-words', /check points differ/u),
    /GNSS positions differ by up to [\d.]+ c?m in plan, [\d.]+ c?m in height\. \d+ ground control and check points differ by up to [\d.]+ (?:cm|mm|m) in plan, [\d.]+ (?:cm|mm|m) in height\./u,
  );
  assert.equal(figure(/^[\d\u202f]+/u.exec((await part(page, 'block-points-count').textContent()) ?? '')?.[0]), figure(tied));
  assert.match((await part(page, 'block-surveyed-count').textContent()) ?? '', new RegExp(`^${surveyed}, \\d+ observations$`, 'u'));

  // In their table control points have root mean squares of their own.
  await part(page, 'tab-block-surveyed').click();
  const sums = await page
    .locator('[data-testid="block-surveyed"] tfoot tr')
    .evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent)));
  assert.deepEqual(
    sums.map((cells) => cells[1]),
    ['control', 'check'],
  );
  const heads = await page.locator('[data-testid="block-surveyed"] thead tr:first-child th').allTextContents();
  const differences = heads.flatMap((text, at) => (/^Δ[XYZ]\b(?! left)/u.test(text) ? [at] : []));
  const rmsOf = (/** @type {number} */ line) => differences.map((at) => Math.abs(Number(/[\d.]+$/u.exec(sums[line]?.[at] ?? '')?.[0])));

  // What the check point says of the block stands with its verdict: of one point each mean is as large as its root mean square.
  const ofAxes = async (/** @type {string} */ id) =>
    [...((await part(page, id).textContent()) ?? '').replaceAll('−', '-').matchAll(/-?\d+\.\d{3}/gu)].map(Number);
  const [rmse, mean] = [await ofAxes('block-checks'), await ofAxes('block-checks-mean')];
  assert.deepEqual(mean.map(Math.abs), rmse.slice(0, 3));
  const [dx = NaN, dy = NaN, dz = NaN] = rmse;
  assert.deepEqual(rmsOf(1), [dx, dy, dz]);
  assert.ok(
    rmsOf(0).every((value, axis) => value >= 0 && value !== rmse[axis]),
    rmsOf(0).join(),
  );
  const judged = await says(page, 'block-figures', /check point/u);
  const [, plan, height] = /([\d.]+) · ([\d.]+) m/u.exec(judged) ?? [];
  assert.match(judged, /1 check point, RMSE in plan · in height/u);
  assert.ok(Math.abs(Number(plan) - Math.hypot(dx, dy)) < 0.0015 && Number(height) === dz, `${judged}: ${rmse.join()}`);

  // In the table of all points they have their names.
  await part(page, 'tab-block-points').click();
  await says(page, 'block-points-caption', new RegExp(`^Points: ${figure(tied) + surveyed}$`, 'u'));
  await part(page, 'block-points-filter-point-kind').fill('tie');
  await says(page, 'block-points-caption', new RegExp(`^Points: ${tied} of `, 'u'));
  await part(page, 'block-points-filter-point-kind').fill('check');
  await page.waitForFunction(() => document.querySelector('[data-testid="block-points"] tbody tr:not(.filler)')?.children[0]?.textContent === 'G1');
  await part(page, 'block-points-clear').click();

  // Tables by themselves are those of all files, in the system of the remark.
  assert.match((await part(page, 'block-remarks').textContent()) ?? '', /images\.csv, points\.csv and surveyed\.csv are in WGS 84 \/ UTM zone 32N/u);
  const tables = await archive(page, 'csv');
  const all = await archive(page, 'everything');
  assert.deepEqual([...tables.keys()].sort(), ['images.csv', 'pairs.csv', 'points.csv', 'rays.csv', 'surveyed.csv']);
  for (const [name, text] of tables) assert.equal(text, all.get(name), name);
  const [, east, north] = (tables.get('points.csv') ?? '').split('\n')[1]?.split(',').map(Number) ?? [];
  assert.ok((east ?? 0) > 427_000 && (east ?? 0) < 430_000 && (north ?? 0) > 5_538_000 && (north ?? 0) < 5_541_000, `${east} ${north}`);

  // What was stated stands beside the residuals, a row for each group, as the file of the orientation has it.
  const shown = await page
    .locator('[data-testid="components"] tbody tr')
    .evaluateAll((rows) => rows.map((row) => [...row.children].slice(0, 2).map((cell) => cell.textContent)));
  assert.deepEqual(
    shown.map(([group]) => group),
    ['image measurements', 'GNSS positions, horizontal', 'GNSS positions, vertical', 'control points, horizontal', 'control points, vertical'],
  );
  const [model] = JSON.parse(all.get('orientation.json') ?? '').models;
  assert.deepEqual(
    shown.map(([, factor]) => factor),
    model.adjusted.components.map((/** @type {{ factor: number, held: boolean }} */ one) => (one.held ? '–' : one.factor.toFixed(2))),
  );

  // The bar over the observations lies in one line beside the tabs, and the sums are in sight.
  await part(page, 'tab-block-observations').click();
  await says(page, 'block-observations-caption', /: [\d\u202f]+$/u);
  await until(page, 'the buttons of the bar are pressed where they are seen', () =>
    page.evaluate(() =>
      ['columns', 'copy', 'csv'].every((name) => {
        const button = document.querySelector(`[data-testid="block-observations-${name}"]`);
        const { left, top, width, height } = button?.getBoundingClientRect() ?? new DOMRect();
        return button?.contains(document.elementFromPoint(left + width / 2, top + height / 2)) === true;
      }),
    ),
  );
  await page.locator('.dock .panel:not([hidden]) tfoot td').first().waitFor();
  const { foot, stage } = await page.evaluate(() => ({
    foot: document.querySelector('.dock .panel:not([hidden]) tfoot td')?.getBoundingClientRect().bottom ?? NaN,
    stage: document.querySelector('main.block .stage')?.getBoundingClientRect().bottom ?? NaN,
  }));
  assert.ok(foot <= stage + 1, `${foot} ${stage}`);
  assert.match((await saved(page, 'block-observations-csv')).toString(), /^Image,Point,x \[px\],/u);

  // What an edit says leaves the legend whole, and moves nothing.
  await part(page, 'tab-block-surveyed').click();
  const map = await part(page, 'block-map').boundingBox();
  await page.locator('[data-testid="block-surveyed"] tbody tr').filter({ hasText: 'G2' }).first().click();
  await part(page, 'block-use').selectOption('check');
  await says(page, 'block-edit-text', /^σ₀ .*check points .* m \(1 → 2 points\)$/u);
  const whole = () =>
    page.evaluate(() => {
      const legends = document.querySelector('.legends');
      const text = document.querySelector('[data-testid="block-edit-text"]');
      return [legends, text?.parentElement].every((box) => box != null && box.scrollHeight <= box.clientHeight + 1 && box.scrollWidth <= box.clientWidth + 1);
    });
  await page.screenshot({ path: join(SHOTS, 'control-points-edited.png') });
  assert.deepEqual(await part(page, 'block-map').boundingBox(), map);
  assert.ok(await whole(), 'the legend is cut');
  await part(page, 'block-details').click();
  for (const width of [1366, 1250, 1180]) {
    await page.setViewportSize({ width, height: 768 });
    assert.ok(await whole(), `at ${width} px the legend is cut`);
  }
  assert.deepEqual(complaints, []);
  await close();
});
