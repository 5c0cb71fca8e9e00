/** What axe finds in every state of the page: nothing, in both themes, on a laptop and on a phone. */

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { test } from 'node:test';
import { unzipSync } from 'fflate';
import { forcedLooker, looker } from './axe.js';
import { block, photoFolder, status } from './blocks.js';
import { reportTab } from './report.js';
import { done, hosted, open, pair, part, pngs, saved, says, SKIP, upload } from './page.js';

hosted();

test('axe finds nothing in any state of a pair', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ fresh: true });
  /** @type {Map<string, string>} */
  const found = new Map();
  const look = looker(page, found);
  const lookForced = forcedLooker(page, found);
  await says(page, 'status', /^Ready/);
  await look('welcome');
  await lookForced('welcome');
  await part(page, 'file-input').setInputFiles([upload('cut.png', pngs()[0]?.buffer.subarray(0, 2000) ?? new Uint8Array(), 'image/png')]);
  await says(page, 'status', /cut\.png/);
  await look('a file that cannot be read', '#answer, #welcome');
  await part(page, 'file-input').setInputFiles(pngs());
  await done(page);
  await look('a pair, drawers closed');

  await part(page, 'settings').click();
  await part(page, 'pair-all-settings').click();
  await look('settings');
  const field = page.locator('#panel-settings input[type="number"]:visible').first();
  const before = await field.inputValue();
  await field.fill('-7e9');
  await page.locator('#panel-settings [aria-invalid="true"]').waitFor();
  await look('a value out of range', '#panel-settings');
  await field.fill(before);
  for (const tab of ['camera', 'simulate']) {
    await part(page, `tab-${tab}`).click();
    await look(tab, `#panel-${tab}`);
  }
  await part(page, 'close-settings').click();
  await done(page);
  await part(page, 'details').click();
  await look('results');
  await part(page, 'view').focus();
  await page.keyboard.press('n');
  await part(page, 'tab-point').click();
  await look('a point', '#stage, #panel-point');
  await part(page, 'tab-matches').click();
  await page.locator('[data-testid="statistics-row"]').nth(2).click();
  await page.keyboard.press('Delete');
  await look('matches, one of them rejected');
  await lookForced('matches, one of them rejected');
  await part(page, 'statistics-filter-x').fill('>x');
  await part(page, 'statistics-filter').selectOption('used');
  await part(page, 'statistics-columns').click();
  await look('matches, filtered, with their columns', '#panel-matches');
  await part(page, 'statistics-clear').click();
  await part(page, 'view').focus();
  await page.keyboard.press('a');
  await page.keyboard.press('Enter');
  await look('a match that is measured', '#stage');
  await page.keyboard.press('Escape');
  await part(page, 'export-menu').click();
  await look('exports');
  // What is chosen by keys folds the menu; the keyboard stays at its button.
  await part(page, 'export-csv').focus();
  await Promise.all([page.waitForEvent('download'), page.keyboard.press('Enter')]);
  assert.equal(await page.evaluate(() => document.activeElement?.id), 'export-menu');

  await page.locator('[data-testid="view"]').focus();
  await page.keyboard.press('?');
  assert.match((await part(page, 'keys-dialog').textContent()) ?? '', /Pictures of a pair.*Delrejects|Del or Backspacerejects the chosen matches/);
  // What is needed most stands first.
  assert.equal(await part(page, 'keys-dialog').locator('h3').nth(1).textContent(), 'Pictures of a pair');
  await look('list of keys', 'dialog[open]');
  await part(page, 'keys-close').click();
  // An action is found by a word and run by keys alone; a setting opens where it is.
  await page.keyboard.press('Control+k');
  // All of them are listed.
  const said = Number.parseInt(await says(page, 'search-said', / actions$/), 10);
  assert.ok(said > 40);
  assert.equal(await part(page, 'search-list').locator('li').count(), said);
  // What there is of each image names it.
  const listed = await part(page, 'search-list').locator('li').allInnerTexts();
  assert.deepEqual(
    listed.filter((text) => /^(?:Mask …|Add mark|Measure in the image|Load CSV …)/u.test(text)),
    [],
  );
  for (const name of ['Left image: Mask …', 'Right image: Mask …', 'Left image: Add mark', 'Replace the left image'])
    assert.equal(listed.filter((text) => text.startsWith(name)).length, 1, name);
  // Those of one name say which is which.
  const seen = new Set();
  for (const row of await part(page, 'search-list').locator('li').all()) {
    const [name = '', more = ''] = await row.locator('> span:first-child, > small').allTextContents();
    if (listed.filter((text) => text.split('\n')[0] === name).length > 1) assert.ok(more !== '', name);
    assert.ok(!seen.has(`${name} (${more})`), `${name} (${more})`);
    seen.add(`${name} (${more})`);
  }
  await part(page, 'search-text').fill('magnifier');
  await look('search for an action', 'dialog[open]');
  await page.keyboard.press('Enter');
  assert.equal(await part(page, 'search').isVisible(), false);
  await page.keyboard.press('Control+k');
  await part(page, 'search-text').fill('strategy setting');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.activeElement?.getAttribute('data-key') === 'matching.strategy');
  await part(page, 'close-settings').click();
  await page.keyboard.press('Control+k');
  await part(page, 'search-text').fill('no such thing');
  await says(page, 'search-said', /No action/);
  await part(page, 'search-close').click();
  await part(page, 'about').click();
  await look('about', 'dialog[open]');
  await part(page, 'about-close').click();

  await part(page, 'projects').click();
  await part(page, 'project').first().waitFor();
  await look('projects', 'dialog[open]');
  await page.locator('[data-testid^="project-rename-"]').first().click();
  await look('a project is renamed', 'dialog[open]');
  await part(page, 'project-name-cancel').click();
  await page.locator('[data-testid^="project-delete-"]').first().click();
  await look('a project is deleted', 'dialog[open]');
  await part(page, 'project-keep').click();
  await part(page, 'projects-close').click();
  const second = await page.context().newPage();
  await second.goto(page.url());
  await says(second, 'keeping', /open in another tab/);
  await looker(second, found)('a project that another tab has');
  await part(second, 'keeping-look').click();
  await says(second, 'keeping', /kept so far/);
  await looker(second, found)('a project that is looked at');
  assert.deepEqual([...found.values()], []);
  assert.deepEqual(complaints, []);
  await close();
});

test('axe finds nothing in any state of a block, and in its report', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block({ fresh: true });
  /** @type {Map<string, string>} */
  const found = new Map();
  const look = looker(page, found);
  await look('block, welcome');
  await part(page, 'block-settings').click();
  await look('block, settings');
  await part(page, 'tab-block-flight').click();
  await look('block, flight', '#panel-block-flight');
  await part(page, 'close-block-settings').click();
  const folder = photoFolder(6);
  await part(page, 'block-folder-input').setInputFiles(folder);
  await status(page, /^(Oriented|Weak orientation): /);
  rmSync(folder, { recursive: true });
  await look('map');
  await part(page, 'block-details').click();
  await look('block, results');
  await part(page, 'block-export-kind').selectOption('everything');
  const report = unzipSync(new Uint8Array(await saved(page, 'block-export')))['report.html'];
  assert.ok(report);
  const tab = await reportTab(page, report);
  await looker(tab, found)('report of a block');
  await tab.close();
  await part(page, 'block-show-matrix').click();
  await part(page, 'block-matrix').focus();
  await page.keyboard.press('ArrowRight');
  await look('matrix, a pair chosen');
  await part(page, 'block-show-images').click();
  await part(page, 'block-panes').focus();
  await page.keyboard.press('n');
  await says(page, 'image-point', / rays/);
  await look('images at a tie point', '#block-view');
  await part(page, 'images-menu').click();
  await look('menu of the images');
  await page.keyboard.press('Escape');
  await part(page, 'block-panes').focus();
  await page.keyboard.press('Delete');
  await says(page, 'block-edit-text', /^σ₀/);
  await part(page, 'tab-block-edits').click();
  await look('block, an observation rejected');
  await page.keyboard.press('Escape');
  if (!(await part(page, 'block-images').isVisible())) await part(page, 'block-table').click();
  for (const table of ['images', 'pairs', 'points', 'observations']) {
    await part(page, `tab-block-${table}`).click();
    await look(`table of ${table}`, `#panel-block-${table}`);
  }
  await part(page, 'block-show-map').click();
  await forcedLooker(page, found)('map with a table');
  // Colours that mean something stay what they are.
  await page.emulateMedia({ forcedColors: 'active' });
  assert.match(await page.locator('.map-scale').evaluate((scale) => getComputedStyle(scale).backgroundImage), /gradient/);
  await page.emulateMedia({ forcedColors: 'none' });
  await part(page, 'block-observations-columns').click();
  await look('columns of a table', '#panel-block-observations');
  assert.deepEqual([...found.values()], []);
  assert.deepEqual(complaints, []);
  await close();
});

test('axe finds nothing in the report of a pair', { skip: SKIP }, async () => {
  /** @type {Map<string, string>} */
  const found = new Map();
  const { page, complaints, close } = await open();
  await pair(page);
  await looker(await reportTab(page, await saved(page, 'export-report')), found)('report of a pair');
  assert.deepEqual([...found.values()], []);
  assert.deepEqual(complaints, []);
  await close();
});
