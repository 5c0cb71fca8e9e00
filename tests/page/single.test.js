import assert from 'node:assert/strict';
import { copyFileSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { DIST, hosted, number, open, sample, saved, SHOTS, SKIP } from './page.js';

hosted();

test('the page in one file runs from a double-click, alone and offline', { skip: SKIP }, async () => {
  const folder = mkdtempSync(join(tmpdir(), 'tiepoint-stick-'));
  const file = join(folder, 'tiepoint.html');
  copyFileSync(join(DIST, 'tiepoint.html'), file);
  const { page, complaints, close } = await open({ url: pathToFileURL(file).href, options: { offline: true } });
  await sample(page);
  assert.ok(await number(page, 'count-matches') > 500);
  assert.match((await saved(page, 'export-csv')).toString(), /^x_left_px,/);
  await page.screenshot({ path: join(SHOTS, 'single.png') });
  assert.deepEqual(complaints, []);
  await close();
  rmSync(folder, { recursive: true });
});
