/** What axe finds with an orthophoto under a block, and in the report of such a block: nothing, in both themes and from both sides. */

import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { unzipSync } from 'fflate';
import { looker } from './axe.js';
import { block } from './blocks.js';
import { hosted, part, saved, SHOTS, SKIP, upload } from './page.js';
import { blockGround, blockPhotos } from './rendered.js';

hosted('/accessibility-orthophoto/');

/** Large enough photos that each lies on the orthophoto. */
const FLIGHT = { strips: 2, exposures: 3, width_px: 480, height_px: 360, pixel_mm: 0.075 };
const GSD_M = 0.8;

/** Presses a tab, in a drawer that another button opens.  @param {import('playwright-core').Page} page @param {string} tab @param {string} drawer */
async function opened(page, tab, drawer) {
  if (!(await part(page, tab).isVisible())) await part(page, drawer).click();
  await part(page, tab).click();
}

for (const locale of ['en-GB', 'ar-EG'])
  test(`a block in the system of an orthophoto, and its report: ${locale}`, { skip: SKIP }, async () => {
    const { page, complaints, close } = await block({ fresh: true, options: { locale } });
    await page.locator('#block-wait').uncheck();
    await part(page, 'block-files-input').setInputFiles([
      ...blockPhotos(FLIGHT).map(({ name, bytes }) => upload(name, bytes, 'image/png')),
      ...blockGround(FLIGHT, GSD_M).map(({ name, bytes }) => upload(name, bytes, 'image/tiff')),
    ]);
    // The block is placed once it is found.
    await page.waitForFunction(
      () =>
        document.querySelector('[data-testid="map-orthophoto"]')?.getAttribute('aria-pressed') === 'true' &&
        document.querySelector('[data-testid="block-answer"]')?.getAttribute('data-verdict') === 'oriented',
    );
    /** @type {Map<string, string>} */
    const found = new Map();
    const look = looker(page, found);
    await look('map over an orthophoto');
    await page.screenshot({ path: join(SHOTS, `accessibility-orthophoto-${locale}.png`) });
    await opened(page, 'tab-block-orthophoto', 'block-settings');
    await look('settings of the orthophoto');
    await part(page, 'close-block-settings').click();
    await opened(page, 'tab-block-surveyed', 'block-table');
    await look('places as control points');
    await part(page, 'block-show-orthophoto').click();
    await part(page, 'ortho-plan').focus();
    await page.keyboard.press('n');
    await look('orthophoto, a place chosen');
    await part(page, 'block-show-plots').click();
    await look('plots of a placed block');
    await page.screenshot({ path: join(SHOTS, `accessibility-plots-${locale}.png`) });
    await part(page, 'block-export-kind').selectOption('everything');
    const report = unzipSync(new Uint8Array(await saved(page, 'block-export')))['report.html'];
    assert.ok(report);
    const folder = mkdtempSync(join(tmpdir(), 'tiepoint-report-'));
    writeFileSync(join(folder, 'report.html'), report);
    const tab = await page.context().newPage();
    await tab.goto(pathToFileURL(join(folder, 'report.html')).href);
    await looker(tab, found)('report of a placed block');
    rmSync(folder, { recursive: true });
    assert.deepEqual([...found.values()], []);
    assert.deepEqual(complaints, []);
    await close();
  });
