/** The view of a pair beside a block: while it has no images, it offers two of the block's. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { block, photos, status } from './blocks.js';
import { done, hosted, part, says, SKIP } from './page.js';

hosted();

test('an empty pair beside a block offers the two images with most matches', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  await part(page, 'mode-pair').click();
  assert.equal(await part(page, 'open-strongest').isVisible(), false);
  await part(page, 'mode-block').click();
  await photos(page);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  await part(page, 'tab-block-pairs').click();
  const rows = page.locator('[data-testid="block-pairs"] tbody tr:not(.filler)');
  await rows.first().waitFor();
  const cells = await rows.evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent ?? '')));
  const matches = cells.map((row) => Number(row[2]?.replaceAll(/\D/gu, '')));
  const [first, second] = cells[matches.indexOf(Math.max(...matches))] ?? [];

  await part(page, 'mode-pair').click();
  await says(page, 'of-block', new RegExp(`^Pairs of the block open here, too: ${first} – ${second} has most matches`));
  assert.equal(await part(page, 'back-to-block').isVisible(), false);
  await part(page, 'open-strongest').click();
  await done(page);
  await says(page, 'name-left', new RegExp(`^${first}`));
  await says(page, 'name-right', new RegExp(`^${second}`));
  await says(page, 'of-block', /: connected/);
  assert.ok(await part(page, 'back-to-block').isVisible());
  assert.equal(await part(page, 'open-strongest').isVisible(), false);
  assert.deepEqual(complaints, []);
  await close();
});
