/** In a low window the picture keeps room beside whatever is open, and the tables under it stay within reach. */

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { block, photos, status } from './blocks.js';
import { hosted, part, SHOTS, SKIP, until } from './page.js';

hosted('/low-window/');

test('between open settings, details and table the map keeps 200 px, and rows are in sight or scrolled to', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block({ options: { viewport: { width: 1366, height: 768 } } });
  await photos(page);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  const box = async (/** @type {string} */ of) => {
    const found = await page.locator(of).first().boundingBox();
    assert.ok(found !== null, of);
    return { ...found, bottom: found.y + found.height };
  };
  assert.ok(await page.locator('#panel-block-settings').isVisible());
  assert.ok((await box('[data-testid="block-map"]')).height >= 200);
  // The table is drawn a moment later.
  await until(page, 'its first row and its foot are in sight', async () => {
    const [stage, row, foot] = [await box('main.block .stage'), await box('[data-testid="block-images"] tbody tr:not(.filler)'), await box('.dock tfoot td')];
    return row.bottom <= foot.y + 1 && foot.bottom <= stage.bottom + 1;
  });
  await page.screenshot({ path: join(SHOTS, 'low-window.png') });

  await page.setViewportSize({ width: 1366, height: 600 });
  assert.ok((await box('[data-testid="block-map"]')).height >= 200);
  assert.ok((await box('.dock')).height >= 210);
  await page.locator('.dock tfoot td').first().scrollIntoViewIfNeeded();
  assert.ok((await box('.dock')).bottom <= (await box('main.block .stage')).bottom + 1);
  assert.deepEqual(complaints, []);
  await close();
});
