/** Cancel while the images of a pair are read: their files stay, and Run takes them up. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grey_png } from '../../pkg/node.js';
import { done, hosted, open, part, pngs, says, SKIP, upload } from './page.js';

hosted();

const HEIC = Buffer.concat([Buffer.from([0, 0, 0, 24]), Buffer.from('ftypheic\0\0\0\0mif1heic'), Buffer.alloc(100)]);

/** An image of noise, larger than the others. */
function large() {
  const [width, height] = [1600, 1200];
  const grey = new Uint8Array(width * height);
  for (let i = 0, seed = 1; i < grey.length; i++) {
    seed = (Math.imul(seed, 1_664_525) + 1_013_904_223) >>> 0;
    grey[i] = seed >>> 24;
  }
  return Buffer.from(grey_png(width, height, grey));
}

/**
 * Gives files, and presses Cancel as soon as the status begins so: a press from here may come after all is read.
 * @param {import('playwright-core').Page} page @param {string} start of the status @param {ReturnType<typeof upload>[]} files
 */
async function cancelled(page, start, files) {
  await page.evaluate((begins) => {
    const [status, cancel] = ['status', 'cancel'].map((id) => /** @type {HTMLElement} */ (document.querySelector(`[data-testid="${id}"]`)));
    const watching = new MutationObserver(() => {
      if (!status?.textContent.startsWith(begins)) return;
      watching.disconnect();
      cancel?.click();
    });
    if (status) watching.observe(status, { childList: true, characterData: true, subtree: true });
  }, start);
  await part(page, 'file-input').setInputFiles(files);
}

test('images whose reading was cancelled stay, and Run opens them', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ fresh: true });
  await says(page, 'status', /^Ready/);
  const [small] = pngs();
  const bytes = large();
  assert.ok(small);
  await cancelled(page, 'Reading a_large.png and b_small.png', [upload('a_large.png', bytes, 'image/png'), { ...small, name: 'b_small.png' }]);
  await says(page, 'status', /^Cancelled\. The images stay: press Run to open them\.$/);
  assert.deepEqual(
    await Promise.all(['left', 'right'].map(async (side) => /(?:a_large|b_small)/.exec((await part(page, `name-${side}`).textContent()) ?? '')?.[0])),
    ['a_large', 'b_small'],
  );
  await part(page, 'run').click();
  await done(page);
  assert.match((await part(page, 'name-left').textContent()) ?? '', /1600 × 1200|1\s?600/);
  // Images that would take the place of others change nothing.
  await cancelled(page, 'Reading c_large.png', [upload('c_large.png', bytes, 'image/png'), { ...small, name: 'd_small.png' }]);
  await says(page, 'status', /Cancelled\. Nothing was changed\./);
  assert.match((await part(page, 'name-left').textContent()) ?? '', /a_large/);
  // Images that took the place of others are not said to be kept.
  const marks = upload(
    'left_fiducials.csv',
    Buffer.from('col,row,x_mm,y_mm\n20,30,-29.2,43.2\n250,30,29.2,43.2\n250,370,29.2,-43.2\n20,370,-29.2,-43.2\n'),
    'text/csv',
  );
  await part(page, 'file-input').setInputFiles([...pngs(), upload('e.heic', HEIC)]);
  const refused = await says(page, 'status', /e\.heic cannot be opened/);
  assert.doesNotMatch(refused, /are kept/);
  await done(page);
  assert.deepEqual(complaints, []);
  await close();
  const another = await open({ fresh: true });
  await says(another.page, 'status', /^Ready/);
  const given = [upload('a_large.png', bytes, 'image/png'), { ...small, name: 'b_small.png' }, marks];
  await cancelled(another.page, 'Reading a_large.png and b_small.png', given);
  await says(another.page, 'status', /^Cancelled\. The images stay: press Run to open them\..*left_fiducials\.csv was not read: give it again\./);
  await another.page.waitForTimeout(500);
  assert.ok(await part(another.page, 'run').isVisible());
  assert.match((await part(another.page, 'status').textContent()) ?? '', /^Cancelled/);
  await another.close();
});
