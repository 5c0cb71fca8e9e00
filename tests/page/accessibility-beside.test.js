/** Lines over a pair that go with a block, and the panel of brightness and contrast, looked at with axe in both directions. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { looker } from './axe.js';
import { FLIGHT, photos } from './blocks.js';
import { done, enabled, hosted, open, part, SKIP, until, upload } from './page.js';
import { blockPhotos } from './rendered.js';

hosted('/accessibility-beside/');

/** @typedef {import('playwright-core').Page} Page */

/** Whatever the language says.  @param {Page} page @param {RegExp} kinds */
const ended = (page, kinds) =>
  page.waitForFunction(
    ([source]) => new RegExp(source ?? '', 'u').test(document.querySelector('[data-testid="block-status"]')?.getAttribute('data-kind') ?? ''),
    [kinds.source],
  );

/** A page for a block, and what axe finds there.  @param {string} locale */
async function looked(locale) {
  const { page, complaints, close } = await open({ options: { locale, viewport: { width: 1366, height: 768 } } });
  /** @type {Map<string, string>} */
  const found = new Map();
  await part(page, 'mode-block').click();
  await enabled(page, 'block-simulate');
  return { page, look: looker(page, found), found, complaints, close };
}

for (const [locale, direction] of /** @type {const} */ ([
  ['en-GB', 'from left to right'],
  ['ar-EG', 'from right to left'],
])) {
  test(`axe finds nothing in what a pair offers its block, and in the sliders of its pictures, ${direction}`, { skip: SKIP }, async () => {
    const { page, look, found, complaints, close } = await looked(locale);
    await photos(page, undefined, locale === 'en-GB' ? undefined : /اضغط «تشغيل»/u);
    await part(page, 'block-run').click();
    await ended(page, /^(?:done|partial)$/u);
    await part(page, 'tab-block-pairs').click();
    await page.locator('[data-testid="block-pairs"] tbody tr:not(.filler)').first().click();
    await part(page, 'block-open-pair').click();
    await done(page);
    await part(page, 'tab-matches').click();
    await part(page, 'statistics-filter-x').fill('0..200');
    await part(page, 'choose-listed').click();
    await until(page, 'matches are chosen', async () => /\d/u.test((await part(page, 'reject').textContent()) ?? ''));
    await part(page, 'reject').click();
    await part(page, 'matches-to-block').waitFor();
    await page.locator('button[data-testid="view-light"]').click();
    await part(page, 'view-brightness').fill('0.4');
    await look('rejected matches are offered to the block, in another light');
    await page.keyboard.press('Escape');
    await part(page, 'matches-to-block').click();
    await part(page, 'matches-to-block').waitFor({ state: 'hidden' });
    await look('what the block did with them');
    assert.deepEqual([...found.values()], []);
    assert.deepEqual(complaints, []);
    await close();
  });

  test(`axe finds nothing in what is said of the marks of scans, ${direction}`, { skip: SKIP }, async () => {
    const { page, look, found, complaints, close } = await looked(locale);
    const camera = upload('film.json', Buffer.from(JSON.stringify({ focal_mm: 40 })), 'application/json');
    const scans = blockPhotos({ ...FLIGHT, strips: 1 }).map(({ name, bytes }) => upload(name, bytes, 'image/png'));
    await part(page, 'block-files-input').setInputFiles([...scans, camera]);
    await part(page, 'tab-block-orthophoto').click();
    await enabled(page, 'block-film-measure');
    await part(page, 'block-film-measure').click();
    await part(page, 'of-scans').waitFor();
    await look('no mark is measured');
    const corners = /** @type {const} */ ([
      [0.4, 0.4],
      [0.6, 0.4],
      [0.6, 0.6],
      [0.4, 0.6],
    ]);
    for (const [i, [x, y]] of corners.entries()) {
      // What is said above the pictures moves them.
      const pane = (await part(page, 'pane-left').boundingBox()) ?? assert.fail('no pane');
      await page.mouse.click(pane.x + x * pane.width, pane.y + y * pane.height);
      await page.waitForFunction((rows) => document.querySelectorAll('[data-testid="fiducials-left"] tbody tr').length >= rows, i + 1);
      await page.keyboard.press('n');
    }
    await look('marks without places on the film');
    await part(page, 'tab-camera').click();
    for (const [index, [x, y]] of corners.entries()) {
      const fields = page.locator('[data-testid="fiducials-left"] tbody tr').nth(index).locator('input');
      // One of them fits the others badly.
      await fields.nth(2).fill(String(100 * (x - 0.5) + (index === 0 ? 2.4 : 0)));
      await fields.nth(3).fill(String(100 * (0.5 - y)));
      await fields.nth(3).press('Tab');
    }
    await part(page, 'marks-to-block').waitFor();
    await look('marks that can be used and fit badly');
    await part(page, 'marks-to-block').click();
    await part(page, 'marks-to-block').waitFor({ state: 'hidden' });
    await look('marks that the block has');
    assert.deepEqual([...found.values()], []);
    assert.deepEqual(complaints, []);
    await close();
  });
}
