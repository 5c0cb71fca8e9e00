/** Reports that the page saves in Arabic: whole, from right to left, with nothing mirrored that must not be, and without what axe finds. */

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { unzipSync } from 'fflate';
import { english, texts } from './arabic.js';
import { looker } from './axe.js';
import { photos } from './blocks.js';
import { CAMERA, done, enabled, hosted, open, part, pngs, saved, SHOTS, SKIP } from './page.js';
import { reportTab } from './report.js';

hosted();

/** @typedef {import('playwright-core').Page} Page */

const ARABIC = { options: { locale: 'ar-EG' } };

/** What is wrong with a report: English in it, and what axe finds.  @param {Page} page @param {string} name */
async function wrongIn(page, name) {
  assert.deepEqual(await page.evaluate(() => [document.documentElement.lang, document.documentElement.dir]), ['ar', 'rtl']);
  // Values of options stand beside their keys as files have them.
  await page.evaluate(() => {
    for (const value of document.querySelectorAll('.settings td')) value.setAttribute('lang', 'en');
  });
  const found = new Map();
  await looker(page, found)(name);
  for (const width of [390, 1366]) {
    await page.setViewportSize({ width, height: 900 });
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth), `${name} is wider than ${String(width)} px`);
    await page.screenshot({ path: join(SHOTS, `${name}-${String(width)}.png`), fullPage: true });
  }
  return [...english(await texts(page)), ...found.values()];
}

/** Whether each minus of a report stands at the left of its number.  @param {Page} page */
const minuses = (page) =>
  page.evaluate(() => {
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    const range = document.createRange();
    const leftOf = (/** @type {Node} */ node, /** @type {number} */ at) => {
      range.setStart(node, at);
      range.setEnd(node, at + 1);
      return range.getBoundingClientRect().left;
    };
    /** @type {boolean[]} */
    const found = [];
    for (let node = walker.nextNode(); node !== null; node = walker.nextNode())
      for (const { index } of (node.textContent ?? '').matchAll(/−\d/gu)) found.push(leftOf(node, index) < leftOf(node, index + 1));
    return found;
  });

test('the report of a pair is in the language of the page', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open(ARABIC);
  await enabled(page, 'sample-first');
  await part(page, 'file-input').setInputFiles([...pngs(), CAMERA]);
  await done(page);
  const report = await reportTab(page, await saved(page, 'export-report'));
  assert.match(await report.title(), /تقرير Tiepoint/u);
  assert.deepEqual(await wrongIn(report, 'report-of-pair'), []);
  // The left image stays on the left, and a minus before its number.
  const [left, right] = await Promise.all([0, 1].map((at) => report.locator('.pair').first().locator('figure').nth(at).boundingBox()));
  assert.ok((left?.x ?? 0) < (right?.x ?? 0));
  const signs = await minuses(report);
  assert.ok(signs.length > 10 && !signs.includes(false), signs.join());
  assert.deepEqual(complaints, []);
  await close();
});

test('the report of a block is in the language of the page', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open(ARABIC);
  await part(page, 'mode-block').click();
  await enabled(page, 'block-simulate');
  await photos(page, undefined, /اضغط «تشغيل»/u);
  await part(page, 'block-run').click();
  await page.waitForFunction(() => document.querySelector('[data-testid="block-answer"]')?.getAttribute('data-verdict'));
  await part(page, 'block-export-kind').selectOption('everything');
  const files = unzipSync(new Uint8Array(await saved(page, 'block-export')));
  const report = await reportTab(page, files['report.html'] ?? new Uint8Array());
  assert.deepEqual(await wrongIn(report, 'report-of-block'), []);
  const signs = await minuses(report);
  assert.ok(signs.length > 10 && !signs.includes(false), signs.join());
  // Other files are for programs.
  assert.match(new TextDecoder().decode(files['summary.json']), /"text": "(?:Oriented|Weak)/u);
  assert.deepEqual(complaints, []);
  await close();
});
