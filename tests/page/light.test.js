/** Brightness and contrast of pictures: what is seen of them changes, what is drawn over them and what is computed from them does not. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grey_png } from '../../pkg/node.js';
import { block, photos, status } from './blocks.js';
import { coloured } from './colours.js';
import { done, hosted, open, pair, part, partsNamed, pngs, saved, SKIP, SMALL, until, upload } from './page.js';

hosted('/light/');

/** @typedef {import('playwright-core').Page} Page */

/** The mean red, green and blue of a picture, and how many of its pixels have the colour of matches.  @param {Page} page @param {Buffer} png */
const colours = (page, png) =>
  page.evaluate(
    async (given) => {
      const bitmap = await createImageBitmap(new Blob([new Uint8Array(given)]));
      const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
      if (context === null) throw new Error('no canvas');
      context.drawImage(bitmap, 0, 0);
      const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
      const sums = [0, 0, 0];
      let matches = 0;
      for (let i = 0; i < data.length; i += 4) {
        const [r = 0, g = 0, b = 0] = data.subarray(i, i + 3);
        for (const [band, value] of [r, g, b].entries()) sums[band] = (sums[band] ?? 0) + value;
        if (r < 60 && g > 170 && b > 100 && b < 170) matches += 1;
      }
      return { mean: sums.map((sum) => (4 * sum) / data.length), matches };
    },
    [...png],
  );

/** What is seen of the middle of a view's left part.  @param {Page} page */
async function seen(page, view = 'view') {
  const box = (await part(page, view).boundingBox()) ?? assert.fail(view);
  // Beside the pointer nothing is enlarged.
  const clip = { x: box.x + box.width * 0.2, y: box.y + box.height * 0.4, width: box.width * 0.1, height: box.height * 0.2 };
  return colours(page, await page.screenshot({ clip }));
}

/** What a layer of the view holds.  @param {Page} page @param {string} layer */
const held = (page, layer) => part(page, layer).evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL());

/** What a button that unfolds the sliders is called, and whether it has a mark.  @param {Page} page @param {string} id */
const marked = (page, id) =>
  page
    .locator(`button[data-testid="${id}"]`)
    .evaluate((press) => [press.getAttribute('aria-label'), getComputedStyle(press, '::before').borderTopStyle === 'solid']);

/** @param {Page} page */
const unfold = (page) => page.locator('button[data-testid="view-light"]').click();

test('brightness and contrast change how a pair is seen, and nothing else; they are kept, and taken back', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  const middle = SMALL.width_px / 2;
  const half = Uint8Array.from({ length: SMALL.width_px * SMALL.height_px }, (_, i) => (i % SMALL.width_px < middle ? 0 : 255));
  await part(page, 'file-input').setInputFiles([upload('left-mask.png', grey_png(SMALL.width_px, SMALL.height_px, half), 'image/png')]);
  await page.waitForFunction(() => /masks 50/.test(document.querySelector('[data-testid="status"]')?.textContent ?? ''));
  await done(page);
  const computed = async () => {
    const { points, matches, score } = JSON.parse((await saved(page, 'export-json')).toString());
    return JSON.stringify({ points, matches, score });
  };
  const [results, picture, mask, marks] = [await computed(), ...(await Promise.all(['pictures', 'masks', 'marks'].map((name) => held(page, `layer-${name}`))))];
  const before = await seen(page);

  await unfold(page);
  assert.ok(await part(page, 'view-light-reset').isDisabled());
  assert.deepEqual(await marked(page, 'view-light'), ['Brightness and contrast', false]);
  await part(page, 'view-brightness').fill('-0.6');
  await page.keyboard.press('Escape');
  assert.deepEqual(await marked(page, 'view-light'), ['Brightness and contrast: brightness 52 %, contrast 100 %', true]);
  const dark = await seen(page);
  assert.ok((dark.mean[0] ?? 0) < 0.9 * (before.mean[0] ?? 0), `${dark.mean} of ${before.mean}`);
  assert.deepEqual(await Promise.all(['pictures', 'masks', 'marks'].map((name) => held(page, `layer-${name}`))), [picture, mask, marks]);
  assert.deepEqual(
    await page.evaluate(() =>
      ['masks', 'marks', 'overlay', 'glass'].map(
        (name) => getComputedStyle(document.querySelector(`[data-testid="view"] [data-testid="layer-${name}"]`) ?? document.body).filter,
      ),
    ),
    ['none', 'none', 'none', 'none'],
  );
  assert.equal(await computed(), results);
  // The picture that is saved is the one on the screen.
  const own = await colours(page, await saved(page, 'export-png'));

  await until(page, 'the pair is kept', async () => (await partsNamed(page, 'pair/result')) === 1);
  await page.reload();
  await done(page);
  await page.waitForFunction(() => document.querySelector('[data-testid="view"]')?.getAttribute('style')?.includes('brightness(0.5'));
  assert.equal(await part(page, 'view-brightness').inputValue(), '-0.6');
  await unfold(page);
  await part(page, 'view-contrast').fill('-0.8');
  await part(page, 'view-contrast').dblclick({ position: { x: 2, y: 4 } });
  assert.equal(await part(page, 'view-contrast').inputValue(), '0');
  await part(page, 'view-light-reset').click();
  assert.equal(await part(page, 'view-brightness').inputValue(), '0');
  assert.deepEqual(await marked(page, 'view-light'), ['Brightness and contrast', false]);
  const after = await seen(page);
  assert.ok(Math.abs((after.mean[0] ?? 0) - (before.mean[0] ?? 0)) < 1, `${after.mean} of ${before.mean}`);
  const plain = await colours(page, await saved(page, 'export-png'));
  assert.ok((own.mean[0] ?? 0) < (plain.mean[0] ?? 0), 'of the saved picture');
  assert.ok(own.matches > 50 && Math.abs(own.matches - plain.matches) < 0.2 * plain.matches, `${own.matches} and ${plain.matches}`);
  assert.deepEqual(complaints, []);
  await close();
});

test('a picture in colour keeps its hue in another light, in the loupe too', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await part(page, 'file-input').setInputFiles(await coloured(page, pngs()));
  await done(page);
  await part(page, 'layer-points').click();
  await part(page, 'magnifier').click();
  const box = (await part(page, 'view').boundingBox()) ?? assert.fail('view');
  await page.mouse.move(box.x + box.width * 0.15, box.y + box.height * 0.35);
  const loupe = () => seen(page);
  const before = await loupe();
  await part(page, 'view-brightness').evaluate((input) => {
    /** @type {HTMLInputElement} */ (input).value = '-0.5';
    input.dispatchEvent(new Event('input', { bubbles: true }));
  });
  const dark = await loupe();
  const share = 3 ** -0.5;
  for (const band of [0, 1, 2]) assert.ok(Math.abs((dark.mean[band] ?? 0) / (before.mean[band] ?? 0) - share) < 0.12, `${dark.mean} of ${before.mean}`);
  assert.ok((dark.mean[0] ?? 0) > 1.2 * (dark.mean[2] ?? 0));
  assert.deepEqual(complaints, []);
  await close();
});

test('the images of a block have the same sliders, which show the light that holds', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  await photos(page);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation)/);
  await part(page, 'block-show-images').click();
  await page.locator('[data-testid^="pane-image-"]').first().waitFor();
  await part(page, 'images-points').click();
  const before = await seen(page, 'block-panes');
  await part(page, 'images-menu').click();
  await part(page, 'images-brightness').fill('-0.6');
  await page.keyboard.press('Escape');
  assert.deepEqual(await marked(page, 'images-menu'), ['View: brightness 52 %, contrast 100 %', true]);
  const dark = await seen(page, 'block-panes');
  assert.ok((dark.mean[0] ?? 0) < 0.75 * (before.mean[0] ?? 0), `${dark.mean} of ${before.mean}`);
  await part(page, 'images-menu').click();
  assert.equal(await part(page, 'images-brightness').getAttribute('aria-valuetext'), '52 %');
  await part(page, 'images-light-reset').click();
  assert.equal(await part(page, 'images-brightness').inputValue(), '0');
  assert.deepEqual(complaints, []);
  await close();
});
