/** Wheel, drag, pinch and keys move every picture of the page in the same way. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { block, photos, status } from './blocks.js';
import { hosted, open, pair, part, SKIP, until } from './page.js';

hosted();

/** @typedef {import('playwright-core').Page} Page */

/** What a canvas shows, once it is drawn.  @param {Page} page @param {string} layer @returns {Promise<string>} */
const look = (page, layer) =>
  part(page, layer).evaluate(async (canvas) => {
    await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    return /** @type {HTMLCanvasElement} */ (canvas).toDataURL();
  });

/** Two fingers that part.  @param {Page} page @param {number} x @param {number} y */
async function spread(page, x, y) {
  const session = await page.context().newCDPSession(page);
  const at = (/** @type {number} */ d) => [
    { x: x - d, y, id: 1 },
    { x: x + d, y, id: 2 },
  ];
  await session.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: at(20) });
  for (const d of [30, 45, 60]) await session.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: at(d) });
  await session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
}

/** Each gesture changes the picture, and the key 0 shows all of it again.  @param {Page} page @param {string} host @param {string} layer @param {string | null} arrow a key that moves an enlarged picture */
async function moves(page, host, layer, arrow) {
  const box = await part(page, host).boundingBox();
  assert.ok(box);
  const [x, y] = [box.x + 0.3 * box.width, box.y + 0.4 * box.height];
  await part(page, host).focus();
  await page.keyboard.press('0');
  await page.mouse.move(1, 1);
  const whole = await look(page, layer);
  /** @type {[string, () => Promise<void>][]} */
  const gestures = [
    [
      'wheel',
      async () => {
        await page.mouse.move(x, y);
        await page.mouse.wheel(0, -600);
      },
    ],
    [
      'drag',
      async () => {
        await page.mouse.down();
        await page.mouse.move(x - 60, y - 40, { steps: 4 });
        await page.mouse.up();
      },
    ],
    ['plus', () => page.keyboard.press('+')],
    ...(arrow === null ? [] : [/** @type {[string, () => Promise<void>]} */ ([arrow, () => page.keyboard.press(arrow)])]),
    ['pinch', () => spread(page, x, y)],
  ];
  let before = whole;
  for (const [name, act] of gestures) {
    await act();
    // A wheel is not answered at once.
    const last = before;
    before = await until(page, `${name} changes ${host}`, async () => {
      const after = await look(page, layer);
      return after !== last && after;
    });
  }
  await page.keyboard.press('0');
  await page.mouse.move(1, 1);
  await until(page, `0 shows all of ${host}`, async () => (await look(page, layer)) === whole);
}

test('the images of a pair are moved by wheel, drag, keys and two fingers', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ options: { hasTouch: true } });
  await pair(page);
  await moves(page, 'view', 'layer-pictures', 'ArrowRight');
  assert.deepEqual(complaints, []);
  await close();
});

test('the picture and the matrix of a block are moved in the same way', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block({ options: { hasTouch: true } });
  await photos(page);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation|Not oriented|The block was)/);
  await moves(page, 'block-map', 'layer-map', 'ArrowRight');
  await part(page, 'block-show-matrix').click();
  // Its arrows go from cell to cell.
  await moves(page, 'block-matrix', 'layer-matrix', null);
  assert.deepEqual(complaints, []);
  await close();
});
