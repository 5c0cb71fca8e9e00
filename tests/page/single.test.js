import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { hosted, number, open, sample, saved, SHOTS, singleUrl, SKIP } from './page.js';

hosted();

test('the page in one file runs from a double-click, alone and offline', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ url: singleUrl(), options: { offline: true } });
  await sample(page);
  assert.ok(await number(page, 'count-matches') > 500);
  assert.match((await saved(page, 'export-csv')).toString(), /^x_left_px,/);
  await page.screenshot({ path: join(SHOTS, 'single.png') });
  assert.deepEqual(complaints, []);
  await close();
});
