/** The tables of a block, as a surveyor uses them: sorted, searched, chosen from by mouse and keys, saved; in step with the other views. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { block, photos, status, undoIs } from './blocks.js';
import { hosted, part, saved, SKIP } from './page.js';

hosted();

/** @typedef {import('playwright-core').Page} Page */

/** Waits until a part says something.  @param {Page} page @param {string} id @param {RegExp} pattern */
async function says(page, id, pattern) {
  await page.waitForFunction(
    ([at = '', source = '']) => new RegExp(source, 'u').test(document.querySelector(`[data-testid="${at}"]`)?.textContent ?? ''),
    [id, pattern.source],
  );
  return (await part(page, id).textContent()) ?? '';
}

/** Column `at` of the rows that are drawn, read at once.  @param {Page} page @param {string} table @param {number} at @returns {Promise<string[]>} */
const column = (page, table, at) =>
  page.evaluate(
    ([name = '', cell = 0]) =>
      [...document.querySelectorAll(`[data-testid="${name}"] tbody tr:not(.filler)`)].map((row) => row.children[Number(cell)]?.textContent ?? ''),
    [table, at],
  );

/** The rows of a table that are chosen.  @param {Page} page @param {string} table @returns {Promise<string[]>} */
const chosen = (page, table) =>
  page.evaluate(
    (name) => [...document.querySelectorAll(`[data-testid="${name}"] tr[aria-selected="true"]`)].map((row) => row.firstElementChild?.textContent ?? ''),
    table,
  );

test('tables are searched, sorted, chosen from and saved, in step with map and matrix', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  await photos(page);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);

  // Images: a choice in the table is said, and chosen in the matrix; one in the matrix is marked in the table.
  assert.match(await says(page, 'block-images-caption', /^Images: 6$/), /6/);
  await page.locator('[data-testid="block-images"] tbody tr:not(.filler)').nth(2).click();
  await says(page, 'block-chosen', /^photo_00002\.png: /);
  assert.deepEqual(await chosen(page, 'block-images'), ['photo_00002.png']);
  await part(page, 'block-show-matrix').click();
  await part(page, 'block-matrix').focus();
  await page.keyboard.press('ArrowRight');
  await says(page, 'block-chosen', /^photo_00002\.png – photo_00003\.png/);
  assert.deepEqual(await chosen(page, 'block-images'), ['photo_00002.png', 'photo_00003.png']);

  // Pairs: by keys alone; what an image's filter leaves out is gone here too.
  await part(page, 'tab-block-pairs').click();
  await says(page, 'block-pairs-caption', /^Pairs: 15$/);
  assert.deepEqual(await chosen(page, 'block-pairs'), ['photo_00002.png']);
  await part(page, 'block-pairs').focus();
  for (const key of ['Home', 'ArrowDown', 'ArrowDown', 'ArrowUp', 'Enter']) await page.keyboard.press(key);
  await says(page, 'block-chosen', /^photo_00000\.png – photo_00002\.png/);
  const active = await part(page, 'block-pairs').getAttribute('aria-activedescendant');
  assert.equal(await page.locator(`#${active}`).getAttribute('aria-selected'), 'true');
  await part(page, 'tab-block-images').click();
  await part(page, 'block-images-filter-number').fill('2..4');
  await says(page, 'block-images-caption', /^Images: 3 of 6$/);
  await part(page, 'tab-block-pairs').click();
  await page.waitForFunction(() => document.querySelectorAll('[data-testid="block-pairs"] tbody tr:not(.filler)').length === 3);
  await part(page, 'tab-block-images').click();
  await part(page, 'block-images-filter-number').fill('two');
  assert.equal(await part(page, 'block-images-filter-number').getAttribute('aria-invalid'), 'true');
  // What can be typed is said, and the rows stay as they are.
  await says(page, 'block-images-filter-problem', /^“two” is no number or range\. Allowed: 2, 2\.\.5, >2 or ≤0\.5\. The rows stay as they are\.$/);
  const described = await part(page, 'block-images-filter-number').getAttribute('aria-describedby');
  assert.equal(described, await part(page, 'block-images-filter-problem').getAttribute('id'));
  assert.equal(await part(page, 'block-images-caption').textContent(), 'Images: 3 of 6');
  await part(page, 'block-images-clear').click();
  await says(page, 'block-images-caption', /^Images: 6$/);
  assert.equal(await part(page, 'block-images-filter-number').inputValue(), '');
  assert.equal(await part(page, 'block-images-filter-problem').textContent(), '');

  // Tie points: limits, order, several chosen together, columns, and a file of exactly what is shown.
  await part(page, 'tab-block-points').click();
  const [, all = '0'] = /: (\d+)$/.exec(await says(page, 'block-points-caption', /: \d+$/)) ?? [];
  await part(page, 'block-points-filter-point-rays').fill('>2');
  const [, kept = '0'] = /: (\d+) of/.exec(await says(page, 'block-points-caption', /: \d+ of \d+$/)) ?? [];
  assert.ok(Number(kept) > 4 && Number(kept) < Number(all), `${kept} of ${all}`);
  await part(page, 'sort-point-rmse').click();
  await part(page, 'sort-point-rmse').click();
  assert.equal(await page.locator('[data-testid="block-points"] th[data-key="point-rmse"]').getAttribute('aria-sort'), 'descending');
  const rmse = (await column(page, 'block-points', 2)).map(Number);
  assert.deepEqual(
    rmse,
    [...rmse].sort((a, b) => b - a),
  );
  // Scrolled, no row is seen between the heads and their filters.
  const heads = () =>
    page.evaluate(() => {
      const rows = [...document.querySelectorAll('[data-testid="block-points"] thead tr')].map((row) => row.getBoundingClientRect());
      const top = document.querySelector('#panel-block-points .rows')?.getBoundingClientRect().top ?? 0;
      return [(rows[0]?.top ?? NaN) - top, (rows[1]?.top ?? NaN) - (rows[0]?.bottom ?? NaN)].map(Math.round);
    });
  const rest = await heads();
  await page.locator('#panel-block-points .rows').evaluate((rows) => rows.scrollTo(0, 200));
  assert.deepEqual(await heads(), rest);
  assert.ok(Math.abs(rest[1] ?? NaN) < 1, rest.join());
  await page.locator('#panel-block-points .rows').evaluate((rows) => rows.scrollTo(0, 0));
  const names = await column(page, 'block-points', 0);
  await page.locator('[data-testid="block-points"] tbody tr:not(.filler)').first().click();
  await says(page, 'block-chosen', new RegExp(`^point ${names[0]}: \\d+ rays`));
  await page
    .locator('[data-testid="block-points"] tbody tr:not(.filler)')
    .nth(2)
    .click({ modifiers: ['Shift'] });
  await says(page, 'block-chosen', /^3 tie points of /);
  assert.deepEqual(await chosen(page, 'block-points'), names.slice(0, 3));
  // A press ends on the row that it began on, also where the rows are drawn anew meanwhile, as when figures arrive.
  await part(page, 'block-points-filter-point-rays').focus();
  const pressed = await page.locator('[data-testid="block-points"] tbody tr:not(.filler)').nth(1).boundingBox();
  assert.ok(pressed);
  await page.mouse.move(pressed.x + 40, pressed.y + pressed.height / 2);
  await page.mouse.down();
  await part(page, 'block-points-filter-point-rays').evaluate((field) => field.dispatchEvent(new Event('input')));
  await page.mouse.up();
  await says(page, 'block-chosen', new RegExp(`^point ${names[1]}: \\d+ rays`));
  await page.locator('[data-testid="block-points"] tbody tr:not(.filler)').first().click();
  await page
    .locator('[data-testid="block-points"] tbody tr:not(.filler)')
    .nth(2)
    .click({ modifiers: ['Shift'] });
  await says(page, 'block-chosen', /^3 tie points of /);
  await part(page, 'block-points-columns').click();
  await page.locator('.table-bar input[data-key="confidence"]:visible').uncheck();
  await page.keyboard.press('Escape');
  const file = (await saved(page, 'block-points-csv')).toString().trimEnd().split('\n');
  assert.equal(file[0], 'Point,Rays,RMSE [px],X [m],σ X [m],Y [m],σ Y [m],Z [m],σ Z [m],Part');
  assert.equal(file.length - 1, Number(kept));
  assert.deepEqual(
    file.slice(1, 6).map((line) => line.split(',')[0]),
    names.slice(0, 5),
  );
  assert.match(file[1] ?? '', /^\d+,\d+,\d+\.\d\d(,-?\d+\.\d+){6},accepted$/);

  // Observations: all of them, then those of the points that are chosen; one of them is chosen with its image.
  await part(page, 'tab-block-observations').click();
  await says(page, 'block-observations-caption', /: [\d\u202f]{3,}$/u);
  await part(page, 'block-observations-only').click();
  const rays = (await column(page, 'block-observations', 7)).map(Number);
  assert.ok(rays.length >= 9 && rays.every((number) => number > 2), rays.join());
  // What the adjustment says of their reliability: redundancy numbers, w-statistics, and minimal detectable biases that grow as the former fall.
  const head = await page.locator('[data-testid="block-observations"] thead tr').first().locator('th').allTextContents();
  assert.match(head.join('|'), /r x.*\|w x.*\|MDB x.*px.*\|r y.*\|w y.*\|MDB y.*px/);
  const figures = async (/** @type {number} */ at) => (await column(page, 'block-observations', at)).map((text) => Number(text.replace('−', '-')));
  const [redundancy, w, bias] = [await figures(8), await figures(9), await figures(10)];
  assert.ok(redundancy.every((r) => r >= 0 && r <= 1) && redundancy.some((r) => r > 0 && r < 1), redundancy.join());
  assert.ok(w.every((value) => Math.abs(value) < 10) && w.some((value) => value !== 0), w.join());
  const scales = redundancy.flatMap((r, i) => (r > 0.2 ? [(bias[i] ?? NaN) * Math.sqrt(r)] : []));
  assert.ok(scales.length > 3 && Math.max(...scales) < 1.1 * Math.min(...scales), scales.join());
  const drawn = await column(page, 'block-observations', 1);
  const last = drawn.findLastIndex((name) => names.includes(name) && name !== names[0]);
  await page.locator('[data-testid="block-observations"] tbody tr:not(.filler)').nth(last).click();
  await says(page, 'block-chosen', new RegExp(`^photo_0000\\d\\.png, point ${drawn[last]}: \\d+ rays`, 'u'));
  await page.waitForFunction(() => document.querySelectorAll('[data-testid="block-observations"] tr[aria-selected="true"]').length === 1);

  // The table of its point, which was out of sight, has it in sight as it lies: nothing is scrolled.
  await part(page, 'tab-block-points').click();
  await page.waitForFunction(() => document.querySelectorAll('[data-testid="block-points"] tr[aria-selected="true"]').length === 1);
  assert.deepEqual(await chosen(page, 'block-points'), [drawn[last]]);
  assert.equal(await page.locator('#panel-block-points .rows').evaluate((rows) => rows.scrollTop), 0);
  await part(page, 'tab-block-observations').click();

  // The tables are as high as the user wants them, and closed where they are not wanted.
  const height = async () => (await page.locator('.dock').boundingBox())?.height ?? 0;
  const before = await height();
  await part(page, 'block-splitter').focus();
  await page.keyboard.press('ArrowDown');
  assert.ok((await height()) < before);
  await part(page, 'block-table').click();
  assert.ok(await part(page, 'block-observations').isHidden());
  await part(page, 'block-table').click();
  await part(page, 'tab-block-points').click();
  await says(page, 'block-points-caption', new RegExp(`: ${kept} of ${all}$`));
  assert.deepEqual(complaints, []);
  await close();
});

test('an edit is of what is chosen and listed; what a filter leaves out stays as it is, and chosen', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  await photos(page);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);

  // Tie points: all chosen, then some listed.
  await part(page, 'tab-block-points').click();
  const [, all = '0'] = /: (\d+)$/.exec(await says(page, 'block-points-caption', /: \d+$/)) ?? [];
  await part(page, 'block-points').focus();
  await page.keyboard.press('Control+a');
  await says(page, 'block-reject', new RegExp(`^Reject ${all} points$`));
  assert.ok(await part(page, 'block-not-listed').isHidden());
  await part(page, 'block-points-filter-point-rays').fill('>2');
  const [, kept = '0'] = /: (\d+) of/.exec(await says(page, 'block-points-caption', /: \d+ of \d+$/)) ?? [];
  await says(page, 'block-reject', new RegExp(`^Reject ${kept} points$`));
  await says(page, 'block-not-listed', new RegExp(`^${String(Number(all) - Number(kept))} more chosen, not listed$`));
  assert.equal(await part(page, 'block-reject').getAttribute('aria-describedby'), await part(page, 'block-not-listed').getAttribute('id'));
  // By its key it is the same.
  await part(page, 'block-points-filter-point-rays').fill('>4');
  const [, few = '0'] = /: (\d+) of/.exec(await says(page, 'block-points-caption', /: \d+ of \d+$/)) ?? [];
  assert.ok(Number(few) > 1 && Number(few) < Number(kept), `${few} of ${kept}`);
  await part(page, 'block-points').focus();
  await page.keyboard.press('Delete');
  await undoIs(page, new RegExp(`^Undo: reject ${few} points `));
  // Those that were not listed are chosen, and as they were.
  await part(page, 'block-points-clear').click();
  await says(page, 'block-reject', new RegExp(`^Reject ${String(Number(all) - Number(few))} points$`));
  assert.ok(await part(page, 'block-not-listed').isHidden());

  // Images and pairs are the same; a pair is not listed where one of its images is not.
  await part(page, 'tab-block-images').click();
  const rows = page.locator('[data-testid="block-images"] tbody tr:not(.filler)');
  await rows.nth(0).click();
  await rows.nth(3).click({ modifiers: ['Shift'] });
  await says(page, 'block-reject', /^Reject 4 images$/);
  await part(page, 'block-images-filter-number').fill('3..4');
  await says(page, 'block-reject', /^Reject 2 images$/);
  await says(page, 'block-remove-image', /^Remove 2 images$/u);
  await part(page, 'block-images-filter-number').fill('6');
  await says(page, 'block-not-listed', /^4 more chosen, /);
  assert.ok(await part(page, 'block-reject').isDisabled());
  await part(page, 'block-images-clear').click();
  await part(page, 'tab-block-pairs').click();
  await part(page, 'block-pairs').focus();
  await page.keyboard.press('Control+a');
  await says(page, 'block-reject', /^Reject \d+ pairs$/);
  await part(page, 'tab-block-images').click();
  await part(page, 'block-images-filter-number').fill('2..3');
  await says(page, 'block-reject', /^Reject pair$/);
  // What is chosen alone is edited wherever it was chosen.
  await part(page, 'block-images-clear').click();
  await rows.nth(0).click();
  await part(page, 'block-images-filter-number').fill('2..3');
  await says(page, 'block-images-caption', /^Images: 2 of 6$/);
  await says(page, 'block-reject', /^Reject image$/);
  assert.deepEqual(complaints, []);
  await close();
});
