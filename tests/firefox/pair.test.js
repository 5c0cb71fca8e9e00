/** A pair in Firefox: the figures of every other place, the pictures, what is kept, and edits. */

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { file, folder, tiepoint } from '../command/command.js';
import { coloured, shareOfOrange } from '../page/colours.js';
import { CAMERA, done, enabled, number, open, pair, part, partsNamed, pngs, ROOT, sample, saved, says, singleUrl, transferOf, until } from '../page/page.js';
import { hostedInFirefox, SKIP, type } from './firefox.js';

hostedInFirefox('/fire/');

test('the sample pair has the verdict of the command and the matches of the golden file', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ fresh: true });
  assert.match(await sample(page), /^Oriented from 5\u202f039 points, σ₀ 0\.09 px; /);
  assert.equal(await part(page, 'answer').getAttribute('data-verdict'), 'oriented');
  // Its last line is of the orientation.
  const golden = readFileSync(join(ROOT, 'tests', 'golden', 'sample.csv'), 'utf8')
    .split('\n')
    .slice(0, -2)
    .join('\n');
  assert.equal((await saved(page, 'export-csv')).toString().trimEnd(), golden);
  assert.deepEqual(complaints, []);
  await close();
});

test('photographs that are dropped give the project that the command writes, to the byte, and a second tab may look at it', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await enabled(page, 'sample');
  const transfer = await transferOf(page, [...pngs(), CAMERA]);
  for (const kind of ['dragenter', 'dragover', 'drop']) await part(page, 'view').dispatchEvent(kind, { dataTransfer: transfer });
  const line = await done(page);
  const at = folder();
  const [left, right, camera] = [...pngs(), CAMERA].map(({ name, buffer }) => file(at, name, buffer));
  tiepoint('match', left ?? '', right ?? '', '--camera', camera ?? '', '--out', at);
  assert.equal((await saved(page, 'export-project')).toString(), readFileSync(join(at, 'project.tiepoint'), 'utf8'));

  await until(page, 'the results are kept', async () => (await partsNamed(page, 'pair/result')) > 0);
  const other = await page.context().newPage();
  await other.goto(page.url());
  await says(other, 'keeping', /open in another tab/);
  await other.close();
  await page.reload();
  const status = await says(page, 'status', /Restored from this browser: left\.png and right\.png\.$/);
  assert.ok(status.startsWith(line.split('.')[0] ?? ''), `${status} | ${line}`);
  assert.deepEqual(complaints, []);
  await close();
});

test('photographs are drawn in colour where an EXIF segment comes first', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ fresh: true });
  await part(page, 'file-input').setInputFiles(await coloured(page, pngs()));
  await done(page);
  assert.ok((await shareOfOrange(page)) > 0.9);
  assert.deepEqual(complaints, []);
  await close();
});

test('a run is cancelled, a match is rejected and restored, and a setting changes what depends on it', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await enabled(page, 'sample');
  await part(page, 'sample').click();
  await part(page, 'cancel').click();
  await says(page, 'status', /cancel/i);
  await pair(page);
  const before = await number(page, 'count-matches');
  const project = await saved(page, 'export-project');
  await part(page, 'tab-matches').click();
  await part(page, 'statistics-row').nth(3).locator('td').first().click();
  await enabled(page, 'reject');
  await part(page, 'view').focus();
  await page.keyboard.press('Delete');
  await says(page, 'compared-points-now', /\d/);
  assert.equal(await number(page, 'count-matches'), before - 1);
  await page.keyboard.press('Control+z');
  await until(page, 'the match is used again', async () => (await number(page, 'count-matches')) === before);
  await done(page);
  assert.equal((await saved(page, 'export-project')).toString(), project.toString());
  await type(page.locator('#panel-settings [data-key="multiscale.number"]'), '2000');
  await until(page, 'fewer points are matched', async () => (await number(page, 'count-matches')) < 0.8 * before);
  assert.deepEqual(complaints, []);
  await close();
});

test('in Arabic it runs from right to left', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ fresh: true, options: { locale: 'ar-EG' } });
  await enabled(page, 'sample-first');
  assert.deepEqual(await page.evaluate(() => [document.documentElement.lang, document.documentElement.dir]), ['ar', 'rtl']);
  await part(page, 'file-input').setInputFiles([...pngs(), CAMERA]);
  assert.match(await done(page), /^(?:وُجّه الزوج|توجيه ضعيف)/u);
  const [first, second] = await Promise.all(['pane-left', 'pane-right'].map((id) => part(page, id).boundingBox()));
  assert.ok((first?.x ?? 0) < (second?.x ?? 0));
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth));
  assert.deepEqual(complaints, []);
  await close();
});

test('the page in one file runs from a double-click', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ url: singleUrl() });
  await pair(page);
  assert.ok((await number(page, 'count-matches')) > 500);
  assert.match((await saved(page, 'export-csv')).toString(), /^x_left_px,/);
  assert.deepEqual(complaints, []);
  await close();
});
