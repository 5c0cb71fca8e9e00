/** The search for actions finds those of all views, goes where they are, and says why one cannot be done. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { block, photos, status } from './blocks.js';
import { hosted, open, part, pair, says, SKIP } from './page.js';

hosted('/finding/');

/** @typedef {import('playwright-core').Page} Page */

const rows = (/** @type {Page} */ page) => page.locator('[data-testid="search-list"] li');

/** Opens the search and waits until all parts of the page are there; looks for words.  @param {Page} page @param {string} words */
async function find(page, words) {
  await page.keyboard.press('Control+k');
  await page.waitForFunction(() => document.querySelector('[data-testid="search-list"]')?.getAttribute('aria-busy') === 'false');
  await part(page, 'search-text').fill(words);
}

/** The first action that is found, with whether it can be done.  @param {Page} page @returns {Promise<[name: string, more: string, can: boolean]>} */
const first = (page) =>
  rows(page)
    .first()
    .evaluate((row) => [row.children[0]?.textContent ?? '', row.children[1]?.textContent ?? '', row.getAttribute('aria-disabled') !== 'true']);

/** What cannot be done and does not say why.  @param {Page} page @param {string} words @returns {Promise<string[]>} */
async function unexplained(page, words) {
  await find(page, words);
  const rows = await page.locator('[data-testid="search-list"] [aria-disabled="true"]').evaluateAll((all) => all.map((row) => row.textContent ?? ''));
  await page.keyboard.press('Escape');
  return rows.filter((text) => !/not possible now · \p{Ll}/u.test(text));
}

/** Does what is found first by words.  @param {Page} page @param {string} words @param {string} name */
async function act(page, words, name) {
  await find(page, words);
  const [own, , can] = await first(page);
  assert.deepEqual([own, can], [name, true], words);
  await page.keyboard.press('Enter');
  assert.ok(await part(page, 'search').isHidden());
}

const pressed = (/** @type {Page} */ page, /** @type {string} */ id) => part(page, id).getAttribute('aria-pressed');

test('from the map actions of the images, plots and tables are found and done', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block({ fresh: true, options: { viewport: { width: 1366, height: 768 } } });
  await photos(page, undefined, /./);
  await status(page, /^(Oriented|Weak orientation)/);
  assert.equal(await pressed(page, 'block-show-map'), 'true');
  // A view that was never shown has its buttons, lists and keys.
  await find(page, 'loupe images');
  const [name, more, can] = await first(page);
  assert.deepEqual([name, can], ['Loupe', true]);
  assert.match(more, /^Images · /);
  await page.keyboard.press('Enter');
  assert.deepEqual([await pressed(page, 'block-show-images'), await pressed(page, 'images-loupe')], ['true', 'true']);

  // A command of its keys is run once the view has its size.
  await part(page, 'block-show-map').click();
  await act(page, 'next tie point active', 'Chooses the next tie point of the active image');
  await says(page, 'image-point', /^Tie point .* rays/);
  assert.equal(await page.evaluate(() => document.activeElement?.getAttribute('data-testid')), 'block-panes');

  // What waits for a choice says so, and is not done.
  await page.keyboard.press('Escape');
  await part(page, 'block-show-map').click();
  await find(page, 'measures the chosen point');
  assert.deepEqual(await first(page), ['Measures the chosen point', 'not possible now · no point is chosen · Images · Images of a block, measuring', false]);
  await page.keyboard.press('Enter');
  assert.ok(await part(page, 'search').isVisible());
  await part(page, 'search-text').fill('undo');
  assert.match((await first(page)).join(), /^Undo,not possible now · there is no edit to undo/);
  await page.keyboard.press('Escape');

  // Whatever cannot be done says what it lacks, which begins with a small letter; what it belongs to, with a capital one.
  assert.deepEqual(await unexplained(page, ''), []);
  await find(page, 'split');
  assert.match((await first(page)).join(), /^Split,not possible now · no point is chosen that can be split/);
  // Buttons of settings, by their names and by what they belong to.
  for (const words of ['measure marks', 'scanned film measure', 'ARABIC']) {
    await part(page, 'search-text').fill(words);
    assert.match((await first(page)).join(), words === 'ARABIC' ? /^العربية,.*,true$/ : /^Measure marks …,.*,true$/, words);
  }
  // An image is no point.
  await page.keyboard.press('Escape');
  await act(page, 'chooses the next image map', 'Chooses the next image');
  await find(page, 'matches least squares other');
  assert.deepEqual((await first(page))[2], false);
  await page.keyboard.press('Escape');

  // Tables in a closed drawer, behind another tab.
  assert.ok(await part(page, 'block-points').isHidden());
  const [saved] = await Promise.all([page.waitForEvent('download'), act(page, 'csv tables points', 'CSV')]);
  assert.equal(saved.suggestedFilename(), 'block-points.csv');
  assert.ok(await part(page, 'block-points').isVisible());

  // A choice of a list of another view.
  await find(page, 'plot residuals');
  const plot = (await first(page))[0];
  await page.keyboard.press('Enter');
  assert.equal(await pressed(page, 'block-show-plots'), 'true');
  assert.equal(`Plot: ${await part(page, 'plot-name').evaluate((list) => /** @type {HTMLSelectElement} */ (list).selectedOptions[0]?.text)}`, plot);
  assert.deepEqual(complaints, []);
  await close();
});

test('actions of the block are found in the pair before the block was ever shown, and the other way round', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ fresh: true });
  await pair(page);
  assert.deepEqual(await unexplained(page, ''), []);
  await find(page, 'footprints');
  assert.match((await first(page)).join(), /^Footprints,not possible now · needs a finished block · Block · .*,false$/);
  await part(page, 'search-text').fill('strips setting');
  assert.deepEqual(await first(page), ['Strips', 'Block · Setting · Flight', true]);
  await page.keyboard.press('Enter');
  assert.equal(await page.evaluate(() => document.body.dataset.mode), 'block');
  await page.waitForFunction(() => document.activeElement?.getAttribute('data-key')?.includes('strips'));

  await act(page, 'magnifier enlarge', 'Magnifier');
  assert.equal(await page.evaluate(() => document.body.dataset.mode), 'pair');
  assert.equal(await pressed(page, 'magnifier'), 'true');
  await part(page, 'mode-block').click();
  await act(page, 'selects the next point', 'Selects the next point');
  await says(page, 'selected', /^Left point \d+/);

  // What is typed meanwhile stays, and so does what is gone through, while the block arrives.
  await page.reload();
  await says(page, 'status', /Restored/);
  await page.keyboard.press('Control+k');
  await part(page, 'search-text').fill('pictures');
  await page.keyboard.press('ArrowDown');
  const chosen = await page.locator('[data-testid="search-list"] [aria-selected="true"] > span').first().textContent();
  await page.waitForFunction(() => document.querySelector('[data-testid="search-list"]')?.getAttribute('aria-busy') === 'false');
  assert.equal(await part(page, 'search-text').inputValue(), 'pictures');
  assert.equal(await page.locator('[data-testid="search-list"] [aria-selected="true"] > span').first().textContent(), chosen);
  assert.deepEqual(complaints, []);
  await close();
});

test('nothing that is found does nothing without a word: before there is anything, keys of pictures are not possible', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block({ fresh: true });
  await find(page, 'chooses');
  const found = await rows(page).evaluateAll((all) => all.map((row) => [row.textContent, row.getAttribute('aria-disabled')]));
  assert.ok(found.length > 8);
  assert.deepEqual(
    found.filter(([, disabled]) => disabled !== 'true'),
    [],
  );
  assert.ok(found.some(([text]) => /needs a finished block/.test(text ?? '')) && found.some(([text]) => /needs two photos/.test(text ?? '')));
  assert.deepEqual(complaints, []);
  await close();
});
