/** Images of a block side by side, as a person looks at them. */

import assert from 'node:assert/strict';
import { readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { block, photoFolder, status, undoIs } from './blocks.js';
import { done, hosted, part, saved, says, SHOTS, SKIP } from './page.js';

hosted('/images/');

/** @typedef {import('playwright-core').Page} Page */

const panes = (/** @type {Page} */ page) => page.locator('[data-testid^="pane-image-"]');

/** Waits until so many panes are shown.  @param {Page} page @param {number} least @param {number} most */
const shown = (page, least, most) =>
  page.waitForFunction(
    ([from = 0, to = 0]) => {
      const { length } = document.querySelectorAll('[data-testid^="pane-image-"]');
      return length >= from && length <= to;
    },
    [least, most],
  );

/** Waits until a loupe is drawn in each pane, or in none.  @param {Page} page @param {boolean} wanted */
const loupes = (page, wanted) =>
  page.waitForFunction((is) => {
    const canvas = /** @type {HTMLCanvasElement | null} */ (document.querySelector('[data-testid="block-panes"] [data-testid="layer-lenses"]'));
    const context = canvas?.getContext('2d');
    if (canvas == null || context == null) return false;
    const box = canvas.getBoundingClientRect();
    return [...document.querySelectorAll('[data-testid^="pane-image-"]')].every((pane) => {
      const { left, top, width, height } = pane.getBoundingClientRect();
      const { data } = context.getImageData(left - box.left, top - box.top, width, height);
      return data.some((value, at) => at % 4 === 3 && value > 0) === is;
    });
  }, wanted);

test('images open at a tie point in all that show it, with loupe, coordinates and the way to the pair', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block({ options: { viewport: { width: 1366, height: 768 } } });
  const folder = photoFolder(6);
  await part(page, 'block-folder-input').setInputFiles(folder);
  await status(page, /6 images in the block/);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  // Tables that are opened after the run have its rows.
  await part(page, 'block-table').click();
  await says(page, 'block-images-caption', /^Images: 6$/);
  await part(page, 'block-table').click();
  await part(page, 'block-show-images').click();
  await shown(page, 4, 4);
  assert.ok(await part(page, 'images-pair').isHidden());

  // The next point of the first image opens in every image that shows it.
  await part(page, 'block-panes').focus();
  await page.keyboard.press('n');
  const line = await says(page, 'image-point', /^Tie point .* rays/);
  const rays = Number(/(\d+) rays/.exec(line)?.[1]) + Number(/(\d+) rejected/.exec(line)?.[1] ?? 0);
  await shown(page, rays, rays);
  assert.match(line, /^Tie point \d+ · X Y Z .* · RMSE \d+\.\d\d px/);
  // In panes of half the stage, what is said of the point stands under the name, and neither is cut.
  const cut = await page.evaluate(() =>
    [...document.querySelectorAll('[data-testid^="pane-image-"] :is(.pane-name, .pane-figures)')]
      .filter(({ scrollWidth, clientWidth, scrollHeight, clientHeight }) => scrollWidth > clientWidth || scrollHeight > clientHeight + 1)
      .map(({ textContent }) => textContent),
  );
  assert.deepEqual(cut, []);
  await page.screenshot({ path: join(SHOTS, 'images-point.png') });
  await page.keyboard.press('Escape');
  assert.equal(await says(page, 'image-point', /^$/), '');
  // A press on it in the middle of its pane chooses it again.
  const frame = await panes(page).first().boundingBox();
  assert.ok(frame);
  const middle = /** @type {const} */ ([frame.x + frame.width / 2, frame.y + frame.height / 2]);
  await page.mouse.click(...middle);
  assert.equal(await says(page, 'image-point', /^Tie point .* rays/), line);
  assert.match(await says(page, 'image-place', / px/), /^photo_\d\.png: \d+\.\d, \d+\.\d px · ground about X Y Z( [−\d][\d .]*){3}/);

  // The loupe is in more images than the one under the pointer.
  await page.mouse.move(middle[0] + 20, middle[1] + 10);
  await loupes(page, false);
  await page.keyboard.press('m');
  await loupes(page, true);
  await page.screenshot({ path: join(SHOTS, 'images-loupe.png') });
  await page.keyboard.press('m');

  // What is chosen here is chosen in the other views; images chosen there are shown here.
  await part(page, 'block-show-map').click();
  assert.match((await part(page, 'block-chosen').textContent()) ?? '', /^photo_\d\.png, point \d+: \d+ rays/);
  await part(page, 'block-map').focus();
  await page.keyboard.press('n');
  await page.keyboard.press('c');
  const chosen = (await part(page, 'block-chosen').textContent()) ?? '';
  await part(page, 'block-show-images').click();
  await shown(page, 2, 2);
  assert.ok(await part(page, 'images-pair').isVisible());
  const names = await panes(page).locator('.pane-name').allTextContents();
  assert.ok(
    names.every((name) => chosen.includes(name)),
    `${names.join()} of ${chosen}`,
  );
  await page.locator('[data-testid^="close-image-"]').first().click();
  await shown(page, 1, 1);
  await part(page, 'images-menu').click();
  await part(page, 'images-add').selectOption({ index: 6 });
  await page.keyboard.press('Escape');
  await shown(page, 2, 2);
  await part(page, 'images-pair').click();
  assert.match(await done(page), /matches/);
  await part(page, 'back-to-block').click();
  await shown(page, 2, 2);

  // A project does not hold its images: they are asked for, and need no run.
  await part(page, 'block-export-kind').selectOption('project');
  const project = await saved(page, 'block-export');
  await part(page, 'block-clear').click();
  await part(page, 'block-files-input').setInputFiles([{ name: 'block.tiepoint', mimeType: 'application/octet-stream', buffer: project }]);
  await status(page, /was opened/);
  await shown(page, 4, 4);
  assert.match((await panes(page).first().textContent()) ?? '', /photo_0\.png.*The file of this image is not open/);
  // In either theme it is read as any text on the ground of its pane.
  for (const colorScheme of /** @type {const} */ (['dark', 'light'])) {
    await page.emulateMedia({ colorScheme });
    const [said, text] = await page.evaluate(() => [document.querySelector('.pane-absent p'), document.body].map((one) => one && getComputedStyle(one).color));
    assert.equal(said, text, colorScheme);
  }
  const photos = Array.from({ length: 6 }, (_, i) => `photo_${i}.png`).map((name) => ({
    name,
    mimeType: 'image/png',
    buffer: readFileSync(join(folder, name)),
  }));
  await part(page, 'block-files-input').setInputFiles(photos);
  await status(page, /All images of the block are there\.$/);
  await page.waitForFunction(() => document.querySelector('[data-testid^="pane-image-"] .pane-absent p') === null);
  rmSync(folder, { recursive: true });
  assert.deepEqual(complaints, []);
  await close();
});

test('a tie point that was chosen before the images were first shown opens at the scale of their panes', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block({ options: { viewport: { width: 1366, height: 768 } } });
  const folder = photoFolder(3);
  await part(page, 'block-folder-input').setInputFiles(folder);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  await part(page, 'tab-block-points').click();
  await page.locator('[data-testid="block-points"] tbody tr:not(.filler)').first().click();
  await part(page, 'block-show-images').click();
  await says(page, 'image-point', /^Tie point .* rays/);
  const frame = await panes(page).first().boundingBox();
  assert.ok(frame);
  const [x, y] = [frame.x + frame.width / 2, frame.y + frame.height / 2];
  /** Column of the image under the pointer. */
  const columnAt = async (/** @type {number} */ at) => {
    await page.mouse.move(at, y);
    return Number(/: (\d+\.\d), /.exec(await says(page, 'image-place', / px/))?.[1]);
  };
  const scale = 100 / ((await columnAt(x + 50)) - (await columnAt(x - 50)));
  // It fills its pane, or is as large as it is.
  const fills = Math.max(1, frame.width / 480, frame.height / 360);
  assert.ok(Math.abs(scale / fills - 1) < 0.05, `${scale} and not ${fills}`);
  // What is begun by a button goes on by the keys of the images.
  await part(page, 'block-match').click();
  await status(page, /Matched in [23] of [23] images\. Enter accepts\./);
  await page.keyboard.press('Escape');
  await says(page, 'block-edit-text', /^$/);
  // In the active image alone it is matched by another one that has it, from wherever it was moved.
  const shown = await panes(page).locator('.pane-name span').allTextContents();
  await page.keyboard.press('e');
  await page.keyboard.press('o');
  await page.keyboard.press('Shift+ArrowRight');
  await page.keyboard.press('Shift+F');
  await status(page, new RegExp(`Matched in ${shown[1]} by ${shown[0]}\\. Enter accepts\\.$`));
  await says(page, 'block-edit-text', /: placed in 1 image\b/);
  await page.keyboard.press('Escape');
  await says(page, 'block-edit-text', /^$/);
  await part(page, 'block-match-alone').click();
  await status(page, /Matched in photo_\d+\.png by photo_\d+\.png\. Enter accepts\.$/);
  await page.keyboard.press('Enter');
  await undoIs(page, /^Undo: match 1 observation in photo_\d+\.png/);
  await page.keyboard.press('Control+z');
  await undoIs(page, /^(?!Undo: match)/);
  // In low panes, as many images have, nothing lies over the point in the middle.
  for (const height of [124, 64]) {
    await page.evaluate((px) => {
      const rule = `.image-panes { flex: none !important; height: ${px}px !important; min-height: 0 !important; }`;
      document.styleSheets[0]?.insertRule(rule, document.styleSheets[0].cssRules.length);
    }, height);
    await page.waitForFunction((px) => document.querySelector('[data-testid^="pane-image-"]')?.getBoundingClientRect().height === px, height);
    for (const pane of await panes(page).all()) {
      const [whole, head] = await Promise.all([pane, pane.locator('.pane-head')].map((one) => one.boundingBox()));
      assert.ok(whole && head);
      assert.ok(head.y + head.height < whole.y + whole.height / 2 - 7, `the head ends ${head.y + head.height - whole.y} px below the top of ${whole.height}`);
      assert.ok(await pane.locator('.pane-name span').evaluate(({ scrollWidth, clientWidth }) => scrollWidth <= clientWidth));
    }
  }
  rmSync(folder, { recursive: true });
  assert.deepEqual(complaints, []);
  await close();
});

test('on a phone the images stand one below the other', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block({ fresh: true, options: { viewport: { width: 390, height: 844 }, colorScheme: 'dark' } });
  const folder = photoFolder(3);
  await part(page, 'menu').click();
  await part(page, 'block-folder-input').setInputFiles(folder);
  await status(page, /^(Oriented|Weak orientation|Not oriented|No image)/);
  await part(page, 'block-show-images').click();
  await shown(page, 3, 3);
  const boxes = await Promise.all((await panes(page).all()).map((pane) => pane.boundingBox()));
  for (const [i, box] of boxes.entries()) {
    const above = boxes[i - 1];
    assert.ok(box && box.width > 300 && box.height > 150, JSON.stringify(box));
    assert.ok(!above || above.y + above.height <= box.y, JSON.stringify([above, box]));
  }
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth));
  // What the marks mean takes no room from the pictures: it is in the menu.
  assert.ok(await part(page, 'image-legend').isHidden());
  await part(page, 'images-menu').click();
  assert.ok(await part(page, 'images-menu-legend').isVisible());
  await page.keyboard.press('Escape');
  await page.screenshot({ path: join(SHOTS, 'images-phone.png') });
  rmSync(folder, { recursive: true });
  assert.deepEqual(complaints, []);
  await close();
});
