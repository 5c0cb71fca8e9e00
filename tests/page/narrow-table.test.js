/** A table that is opened on a narrow screen leaves the picture in sight, whose images and links its rows are about. */

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { block, photoFolder, status } from './blocks.js';
import { hosted, open, part, SHOTS, SKIP } from './page.js';

hosted();

test('at 390 px the orthophoto is in sight over the table of its images, wherever that is scrolled', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ fresh: true, options: { viewport: { width: 390, height: 844 } } });
  await part(page, 'mode-block').click();
  await part(page, 'block-place-first').click();
  await status(page, /^4 of 4 images placed/);
  await part(page, 'block-table').click();
  const rows = page.locator('.dock .panel:not([hidden]) tbody tr:not(.filler)');
  await rows.first().waitFor();
  const picture = page.locator('.ortho-view .view').first();
  for (const to of [0, 10_000]) {
    await page.evaluate((y) => scrollTo(0, y), to);
    const [seen, table] = await Promise.all([picture.boundingBox(), page.locator('.dock').boundingBox()]);
    assert.ok(seen !== null && table !== null);
    assert.ok(seen.y >= 0 && seen.height >= 250 && seen.y + seen.height <= table.y, `${to}: ${JSON.stringify({ seen, table })}`);
    const isFree = await picture.evaluate((view) => {
      const { left, top, width, height } = view.getBoundingClientRect();
      return [0.1, 0.5, 0.9].every((share) => view.contains(document.elementFromPoint(left + width / 2, top + share * height)));
    });
    assert.ok(isFree, `scrolled to ${to} something covers the picture`);
  }
  const last = await rows.last().boundingBox();
  assert.ok(last !== null && last.y + last.height <= 844, JSON.stringify(last));
  await page.screenshot({ path: join(SHOTS, 'narrow-table.png') });
  // Of the two that save here each says what.
  await page.keyboard.press('Control+k');
  await part(page, 'search-text').fill('save');
  const saving = await part(page, 'search-list').locator('li:has(> span:first-child:text-is("Save")) > small').allTextContents();
  assert.deepEqual([saving.length >= 2, new Set(saving).size, saving.includes('Export of the placed images')], [true, saving.length, true], saving.join('; '));
  assert.deepEqual(complaints, []);
  await close();
});

test('at 390 px what can be done with a row that is chosen lies over the foot of the picture, and takes presses', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block({ fresh: true, options: { viewport: { width: 390, height: 844 } } });
  const folder = photoFolder(3);
  await part(page, 'menu').click();
  await part(page, 'block-folder-input').setInputFiles(folder);
  await status(page, /^(?:Oriented|Weak orientation)/);
  rmSync(folder, { recursive: true });
  await part(page, 'block-table').click();
  const rows = page.locator('.dock .panel:not([hidden]) tbody tr:not(.filler)');
  await rows.first().click();
  const buttons = page.locator('.edit-bar button:enabled:visible');
  await buttons.first().waitFor();
  for (const to of [0, 10_000]) {
    await page.evaluate((y) => scrollTo(0, y), to);
    const isOver = await buttons.first().evaluate((button) => {
      const { left, top, width, height } = button.getBoundingClientRect();
      return button.contains(document.elementFromPoint(left + width / 2, top + height / 2));
    });
    assert.ok(isOver, `scrolled to ${to} something covers what can be done`);
  }
  // What the keyboard comes to is not behind the picture.
  await rows.first().focus();
  await page.evaluate(() => scrollTo(0, 10_000));
  for (let i = 0; i < 30; i++) {
    await page.keyboard.press('Shift+Tab');
    const behind = await page.evaluate(() => {
      const [own, picture] = [document.activeElement, document.querySelector('main.block .views')];
      const { left, top, width, height } = own?.getBoundingClientRect() ?? new DOMRect();
      const seen = document.elementFromPoint(left + width / 2, top + height / 2);
      return own !== null && picture?.contains(own) === false && picture.contains(seen) ? own.outerHTML : null;
    });
    assert.equal(behind, null, `${i}`);
  }
  assert.deepEqual(complaints, []);
  await close();
});
