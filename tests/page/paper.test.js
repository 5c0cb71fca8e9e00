/** The paper's own figures stand beside results that have something in common with them, and beside no others. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { choose, done, hosted, open, part, pngs, sample, SKIP } from './page.js';

hosted();

test('the paper is set beside pairs of its camera and counts by its rules', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  const shown = () => page.locator('th.paper').count();
  await sample(page);
  assert.equal(await shown(), 0);
  await choose(page, 'matching.strategy', 'moments');
  assert.equal(await shown(), 1);
  await part(page, 'file-input').setInputFiles(pngs());
  await page.waitForFunction(() => /left\.png/.test(document.querySelector('[data-testid="name-left"]')?.textContent ?? ''));
  await done(page);
  assert.equal(await shown(), 0);
  assert.deepEqual(complaints, []);
  await close();
});
