/** A match of a pair and a link to an orthophoto that are being measured by hand outlive a reload, other pairs and New: they are measured on where they were left. */

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { block, photos, status } from './blocks.js';
import { done, enabled, hosted, open, pair, part, partsKept, partsNamed, says, SHOTS, SKIP, until } from './page.js';

hosted('/measured-on-beside/');

/** @typedef {import('playwright-core').Page} Page */

/** Presses a place of an image of the pair, by shares of its pane.  @param {Page} page @param {'left' | 'right'} side */
async function press(page, side, across = 0.6, down = 0.55) {
  const box = await part(page, `pane-${side}`).boundingBox();
  assert.ok(box !== null);
  await page.mouse.click(box.x + across * box.width, box.y + down * box.height);
}

/** What is kept of what is measured.  @param {Page} page @param {string} name @param {(value: any) => boolean} is */
const kept = (page, name, is) => until(page, `${name} is kept`, async () => (is((await partsKept(page, name)).get(name) ?? null) ? true : null));

/** Where the points of the match are, as the bar above the pictures says it.  @param {Page} page @param {RegExp} pattern */
const drafted = async (page, pattern) => /left [^.]*\.\d+, [^ ]+ · right [^ ]+ [^ ]+/.exec(await says(page, 'draft-text', pattern))?.[0] ?? '';

/** The placed point is where it was; the other one is expected within a fraction of a px of where it was, as what it is expected by is computed anew.  @param {string} shown @param {string} before */
function samePlaces(shown, before) {
  const [now, then] = [shown, before].map((text) => [...text.matchAll(/\d+\.\d+/g)].map(Number));
  assert.ok(now?.length === 4 && then?.length === 4, `${shown}; before ${before}`);
  assert.deepEqual(now.slice(0, 2), then.slice(0, 2));
  for (const k of [2, 3]) assert.ok(Math.abs((now[k] ?? NaN) - (then[k] ?? NaN)) < 0.3, `${shown}; before ${before}`);
}

test('a match that is being measured, new or moved, is measured on after a reload and after New', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  await part(page, 'tool-measure').click();
  await press(page, 'left');
  const places = await drafted(page, /The right point is predicted: /);
  await kept(page, 'pair/draft', (draft) => draft?.places.left !== null && draft?.places.right === null);
  await page.reload();
  await says(page, 'status', /Restored from this browser/);
  await done(page);
  samePlaces(await drafted(page, /The right point is predicted: /), places);
  assert.equal(await part(page, 'tool-measure').getAttribute('aria-pressed'), 'true');

  await part(page, 'projects').click();
  await part(page, 'project-new').click();
  await until(page, 'the pair is gone', async () => (await part(page, 'draft').isHidden()) || null);
  await part(page, 'projects').click();
  await page.locator('[data-testid="project"]:not([aria-current]) .link').first().click();
  samePlaces(await drafted(page, /The right point is predicted: /), places);
  await done(page);
  await page.screenshot({ path: join(SHOTS, 'measured-on-pair.png') });
  await press(page, 'right');
  await says(page, 'draft-text', /Place the right point/);
  await page.keyboard.press('Enter');
  await says(page, 'undo', /^Undo: add 1 match$/);
  await until(page, 'no match is kept', async () => ((await partsNamed(page, 'pair/draft')) === 0 ? true : null));
  await page.keyboard.press('Escape');

  // The same of one that is moved.
  await part(page, 'tab-matches').click();
  await part(page, 'statistics-row').nth(1).click();
  await enabled(page, 'move');
  await part(page, 'move').click();
  const before = await drafted(page, /right/);
  await page.keyboard.press('Shift+ArrowRight');
  await until(page, 'it is moved', async () => ((await drafted(page, /right/)) !== before ? true : null));
  const moved = await drafted(page, /right/);
  // Shown to two digits, it is kept as it is.
  await kept(page, 'pair/draft', (draft) => draft !== null && moved.includes(` right ${draft.places.right[0].toFixed(2)}, `));
  await page.reload();
  await says(page, 'status', /Restored from this browser/);
  await done(page);
  assert.equal(await drafted(page, /Moved match/), moved);
  await part(page, 'view').focus();
  await page.keyboard.press('Enter');
  await says(page, 'undo', /^Undo: move 1 match$/);
  assert.deepEqual(complaints, []);
  await close();
});

test('a match of a pair of a block waits there while the block and other pairs are looked at, and through a reload', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  const go = (/** @type {number} */ first) =>
    page.evaluate(
      (to) => {
        window.location.hash = to;
      },
      `#view=pair&image=photo_0000${first}.png&image=photo_0000${first + 1}.png`,
    );
  await photos(page);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  await go(0);
  await says(page, 'name-left', /photo_00000/);
  await done(page);
  await part(page, 'tool-measure').click();
  await press(page, 'left', 0.5, 0.5);
  const places = await drafted(page, /right/);
  await part(page, 'back-to-block').click();
  await go(3);
  await says(page, 'name-left', /photo_00003/);
  await done(page);
  assert.doesNotMatch((await part(page, 'draft-text').textContent()) ?? '', /left \d/);
  await until(page, 'it is kept', async () => ((await partsNamed(page, 'pair/shelf')) === 1 ? true : null));
  await page.reload();
  await says(page, 'of-block', /^photo_00003\.png – photo_00004\.png: connected/);
  await go(0);
  await says(page, 'name-left', /photo_00000/);
  await done(page);
  samePlaces(await drafted(page, /right/), places);
  await press(page, 'right', 0.5, 0.5);
  await says(page, 'draft-text', /Place the right point/);
  await page.keyboard.press('Enter');
  await says(page, 'undo', /^Undo: add 1 match$/);
  assert.deepEqual(complaints, []);
  await close();
});

test('a link to an orthophoto that is being measured is measured on after a reload and after New, its other end expected', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  /** The pixels of the marks on the orthophoto. */
  const marks = () =>
    page.evaluate(() => /** @type {HTMLCanvasElement} */ (document.querySelector('[data-testid="ortho-plan"] [data-testid="layer-marks"]')).toDataURL());
  await part(page, 'block-place-first').click();
  await says(page, 'block-status', /^4 of 4 images placed\./);
  await page.locator('[data-testid="block-placed"] tbody tr:not(.filler)').nth(2).click();
  await says(page, 'ortho-chosen', /^photo_00002\.png: Placed by/);
  await part(page, 'ortho-image').focus();
  await page.keyboard.press('a');
  await says(page, 'ortho-chosen', /^A new link: press/);
  await part(page, 'ortho-image').click();
  await says(page, 'ortho-chosen', /^Press the point on the orthophoto\.$/);
  await kept(page, 'block/link', (link) => link !== null && link.at !== null && link.place === null);
  const { image, at } = (await partsKept(page, 'block/link')).get('block/link');
  await page.reload();
  await says(page, 'ortho-chosen', /^Press the point on the orthophoto\.$/);
  await page.screenshot({ path: join(SHOTS, 'measured-on-link.png') });
  assert.equal(await part(page, 'link-add').getAttribute('aria-pressed'), 'true');
  assert.deepEqual((await partsKept(page, 'block/link')).get('block/link'), { image, at, place: null });

  await part(page, 'projects').click();
  await part(page, 'project-new').click();
  await until(page, 'the orthophoto is gone', async () => (await part(page, 'ortho-chosen').isHidden()) || null);
  await part(page, 'projects').click();
  await page.locator('[data-testid="project"]:not([aria-current]) .link').first().click();
  await says(page, 'ortho-chosen', /^Press the point on the orthophoto\.$/);
  const before = await marks();
  await part(page, 'ortho-plan').click();
  await says(page, 'ortho-chosen', /Enter/);
  assert.notEqual(await marks(), before);
  await page.keyboard.press('Enter');
  await says(page, 'ortho-chosen', /^Link [^,]+, measured by hand, (used|rejected as a gross error): /);
  await until(page, 'no link is kept', async () => ((await partsNamed(page, 'block/link')) === 0 ? true : null));
  assert.deepEqual(complaints, []);
  await close();
});
