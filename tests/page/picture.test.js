/** The picture of the pair: its keys, and what lies over it. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { done, hosted, open, pair, part, SKIP } from './page.js';

hosted();

test('keys work in the picture once a button has opened a pair, and after a press on its bar, but not in fields', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await page.waitForFunction(() => document.querySelector('[data-testid="sample"]:enabled') !== null);
  await part(page, 'sample').focus();
  await page.keyboard.press('Enter');
  await done(page);
  const pressed = () => part(page, 'magnifier').getAttribute('aria-pressed');
  await page.keyboard.press('m');
  assert.equal(await pressed(), 'true');
  await part(page, 'linked').click();
  await page.keyboard.press('m');
  assert.equal(await pressed(), 'false');
  await part(page, 'layer-lines').focus();
  await page.keyboard.press('m');
  assert.equal(await pressed(), 'false');
  assert.match((await page.locator('#keys').textContent()) ?? '', /arrows pan .* N P points/);
  assert.deepEqual(complaints, []);
  await close();
});

for (const [name, width, height] of /** @type {const} */ ([
  ['narrow', 420, 800],
  ['wide', 1440, 900],
  ['low', 1280, 420],
])) {
  test(`the bars with the names of the images cover none of them on a ${name} screen`, { skip: SKIP }, async () => {
    const { page, complaints, close } = await open({ fresh: true, options: { viewport: { width, height } } });
    await pair(page);
    for (const side of ['left', 'right']) {
      const covered = await page.evaluate((of) => {
        const bar = document.querySelector(`[data-testid="pane-${of}"] .pane-head`);
        const canvas = /** @type {HTMLCanvasElement | null} */ (document.querySelector('[data-testid="layer-pictures"]'));
        if (bar === null || canvas === null) throw new Error('the view is not there');
        const [box, all] = [bar.getBoundingClientRect(), canvas.getBoundingClientRect()];
        const data =
          canvas.getContext('2d')?.getImageData(box.left - all.left, box.top - all.top, Math.min(box.width, all.right - box.left), box.height).data ?? [];
        return Array.from(data).filter((value, i) => i % 4 === 3 && value > 0).length;
      }, side);
      assert.equal(covered, 0, side);
    }
    assert.deepEqual(complaints, []);
    await close();
  });
}
