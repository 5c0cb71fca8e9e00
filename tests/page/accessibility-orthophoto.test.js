/** What axe finds with an orthophoto under a block, and in the report of such a block: nothing, in both themes and from both sides. */

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { unzipSync } from 'fflate';
import { looker } from './axe.js';
import { block } from './blocks.js';
import { hosted, part, saved, SHOTS, SKIP, upload } from './page.js';
import { blockGround, blockPhotos } from './rendered.js';
import { reportTab } from './report.js';

hosted('/accessibility-orthophoto/');

/** Large enough photos that each lies on the orthophoto. */
const FLIGHT = { strips: 2, exposures: 3, width_px: 480, height_px: 360, pixel_mm: 0.075 };
const GSD_M = 0.8;

/** Presses a tab, in a drawer that another button opens.  @param {import('playwright-core').Page} page @param {string} tab @param {string} drawer */
async function opened(page, tab, drawer) {
  if (!(await part(page, tab).isVisible())) await part(page, drawer).click();
  await part(page, tab).click();
}

/** Looks at what a placed block adds to the page, and at its report.  @param {import('playwright-core').Page} page @param {(where: string, within?: string) => Promise<void>} look @param {Map<string, string>} found @param {string} language */
async function placed(page, look, found, language) {
  await look(`map over an orthophoto (${language})`);
  await page.screenshot({ path: join(SHOTS, `accessibility-orthophoto-${language}.png`) });
  await opened(page, 'tab-block-orthophoto', 'block-settings');
  await look(`settings of the orthophoto (${language})`, '#panel-block-orthophoto');
  await part(page, 'close-block-settings').click();
  await opened(page, 'tab-block-surveyed', 'block-table');
  await look(`places as control points (${language})`, '#panel-block-surveyed');
  await part(page, 'block-show-orthophoto').click();
  await part(page, 'ortho-plan').focus();
  await page.keyboard.press('n');
  await look(`orthophoto, a place chosen (${language})`, '#block-view, #panel-block-surveyed');
  await part(page, 'block-show-plots').click();
  await look(`plots of a placed block (${language})`, '#block-view');
  await page.screenshot({ path: join(SHOTS, `accessibility-plots-${language}.png`) });
  await part(page, 'block-export-kind').selectOption('everything');
  const report = unzipSync(new Uint8Array(await saved(page, 'block-export')))['report.html'];
  assert.ok(report);
  const tab = await reportTab(page, report);
  await looker(tab, found)(`report of a placed block (${language})`);
  await tab.close();
}

test('a block in the system of an orthophoto, and its report, in English and in Arabic', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block({ fresh: true });
  await page.locator('#block-wait').uncheck();
  await part(page, 'block-files-input').setInputFiles([
    ...blockPhotos(FLIGHT).map(({ name, bytes }) => upload(name, bytes, 'image/png')),
    ...blockGround(FLIGHT, GSD_M).map(({ name, bytes }) => upload(name, bytes, 'image/tiff')),
  ]);
  // The block is placed once it is found; in another language it is as it was.
  const isPlaced = () =>
    page.waitForFunction(
      () =>
        document.querySelector('[data-testid="map-orthophoto"]')?.getAttribute('aria-pressed') === 'true' &&
        document.querySelector('[data-testid="block-answer"]')?.getAttribute('data-verdict') === 'oriented',
    );
  /** @type {Map<string, string>} */
  const found = new Map();
  const look = looker(page, found);
  await isPlaced();
  await placed(page, look, found, 'en');
  await part(page, 'language').click();
  await page.waitForFunction(() => document.documentElement.lang === 'ar');
  await part(page, 'block-show-map').click();
  await isPlaced();
  await placed(page, look, found, 'ar');
  assert.deepEqual([...found.values()], []);
  assert.deepEqual(complaints, []);
  await close();
});
