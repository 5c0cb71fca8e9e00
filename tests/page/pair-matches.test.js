/** Matches that are rejected and measured by hand in a pair of a block go into the block, a step of its edits each. */

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { block, photos, status } from './blocks.js';
import { done, enabled, hosted, keptEdits, part, says, SHOTS, SKIP } from './page.js';

hosted();

/** @typedef {import('playwright-core').Page} Page */

/** σ0 of the block, as the line over its views compares it.  @param {string} text */
const sigmas = (text) => /σ₀ ([\d.]+) → ([\d.]+) px/u.exec(text)?.slice(1) ?? [];

/** Waits until undo of the block would take back this.  @param {Page} page @param {RegExp} pattern */
const undoIs = (page, pattern) =>
  page.waitForFunction(
    ([source]) => {
      const adjusting = document.querySelector('[data-testid="block-edit-text"]')?.textContent === 'Adjusting the block …';
      return !adjusting && new RegExp(source ?? '', 'u').test(document.querySelector('[data-testid="block-undo"]')?.getAttribute('title') ?? '');
    },
    [pattern.source],
  );

/** Waits until a button is there, or is not.  @param {Page} page @param {string} id @param {'visible' | 'hidden'} state */
const button = (page, id, state) => part(page, id).waitFor({ state });

test('matches rejected in a pair are rejected in the block as one step, which is undone there, and kept', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block({ options: { viewport: { width: 1366, height: 800 } } });
  await photos(page);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  await part(page, 'tab-block-pairs').click();
  const row = page.locator('[data-testid="block-pairs"] tbody tr:not(.filler)').first();
  await row.click();
  const listed = await row.textContent();
  await part(page, 'block-open-pair').click();
  await done(page);
  await says(page, 'of-block', /: connected/);
  await button(page, 'matches-to-block', 'hidden');
  await button(page, 'measured-to-block', 'hidden');

  await part(page, 'tab-matches').click();
  await part(page, 'statistics-filter-x').fill('0..200');
  await part(page, 'choose-listed').click();
  await says(page, 'reject', /^Reject \d+$/);
  await part(page, 'reject').click();
  const offered = await says(page, 'matches-to-block', /^Reject [1-9]\d* matches in the block, too$/);
  const [, without, rejected] =
    /Rejected here without a tie point in the block: (\d+) of (\d+)\./.exec((await part(page, 'of-block').textContent()) ?? '') ?? [];
  const matches = Number(/\d+/.exec(offered)?.[0]);
  // The block is adjusted by few of its tie points, and has rejected the observations of some already.
  assert.ok(matches >= 5 && Number(without) > matches && Number(without) + matches <= Number(rejected), `${offered} ${without} ${rejected}`);
  // What is undone in the pair is not offered.
  await part(page, 'undo').click();
  await button(page, 'matches-to-block', 'hidden');
  await part(page, 'redo').click();
  await button(page, 'matches-to-block', 'visible');
  await done(page);
  await page.screenshot({ path: join(SHOTS, 'pair-matches.png') });
  await part(page, 'matches-to-block').click();
  const told = await says(page, 'of-block', /In the block: reject \d+ observations; σ₀ [\d.]+ → [\d.]+ px · RMSE/u);
  await button(page, 'matches-to-block', 'hidden');
  assert.equal(await page.evaluate(() => document.activeElement?.getAttribute('data-testid')), 'back-to-block');
  const observations = Number(/reject (\d+) observations/.exec(told)?.[1]);
  assert.ok(observations % 2 === 0 && observations >= 10 && observations <= 2 * matches, `${observations} of ${matches}`);
  const [before, after] = sigmas(told);
  assert.notEqual(before, after);
  // The table of the block, which was out of sight meanwhile, is of the block as it is now.
  await part(page, 'back-to-block').click();
  const relisted = await row.textContent();
  await part(page, 'tab-block-images').click();
  await part(page, 'tab-block-pairs').click();
  assert.equal(relisted, await row.textContent());
  assert.notEqual(relisted, listed);
  await part(page, 'mode-pair').click();
  // It is said until they are others.
  await says(page, 'of-block', /In the block: reject/);
  await part(page, 'undo').click();
  await says(page, 'of-block', /^(?!.*In the block:)/);
  await part(page, 'redo').click();

  // A match that is measured becomes a tie point.
  await part(page, 'statistics-clear').click();
  await part(page, 'tool-measure').click();
  const pane = await part(page, 'pane-left').boundingBox();
  assert.ok(pane);
  await page.mouse.click(pane.x + 0.55 * pane.width, pane.y + 0.45 * pane.height);
  await says(page, 'draft-text', /predicted/);
  await enabled(page, 'draft-fit');
  await part(page, 'draft-fit').click();
  await enabled(page, 'draft-accept');
  await part(page, 'draft-accept').click();
  await says(page, 'measured-to-block', /^Take 1 measured match into the block$/);
  await part(page, 'measured-to-block').click();
  await says(page, 'of-block', /In the block: add 1 point in 2 images; /);
  await button(page, 'measured-to-block', 'hidden');

  // Both are steps of the block, as others are.
  await part(page, 'back-to-block').click();
  await undoIs(page, /^Undo: add 1 point in 2 images \(/);
  await keptEdits(page, 'block/edits', 2, 2);
  await page.reload();
  await undoIs(page, /^Undo: add 1 point in 2 images \(/);
  await part(page, 'mode-pair').click();
  await says(page, 'of-block', /without a tie point in the block/);
  await button(page, 'matches-to-block', 'hidden');
  await button(page, 'measured-to-block', 'hidden');
  await part(page, 'back-to-block').click();
  await part(page, 'block-undo').click();
  await undoIs(page, new RegExp(`^Undo: reject ${observations} observations \\(`));
  await part(page, 'block-undo').click();
  await page.waitForFunction(() => document.querySelector('[data-testid="block-undo"]')?.hasAttribute('disabled'));
  await part(page, 'block-redo').click();
  assert.deepEqual(sigmas(await says(page, 'block-edit-text', /σ₀ [\d.]+ → [\d.]+ px/u)), [before, after]);
  await part(page, 'block-undo').click();
  await page.waitForFunction(() => document.querySelector('[data-testid="block-edit-text"]')?.textContent === '');
  // Without the step the pair offers it again.
  await part(page, 'mode-pair').click();
  await says(page, 'matches-to-block', new RegExp(`^Reject ${matches} matches in the block, too$`));
  await button(page, 'measured-to-block', 'visible');
  assert.deepEqual(complaints, []);
  await close();
});
