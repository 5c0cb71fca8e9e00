/** Tiles of an orthophoto on a canvas. Without a browser: the canvas tells where pictures are drawn. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {any} */
let tiles;

before(async () => {
  ({ tiles } = await pageModules(['block/view/orthophoto/tiles']));
});

/** Draws a picture of 512 x 256 px, two tiles, and gives from where to where each lies on the canvas, in device px.  @param {object | null} cells @param {number} ratio */
async function drawn(cells, ratio) {
  /** @type {[number, number][]} */
  const across = [];
  let by = [1, 0];
  const nothing = () => undefined;
  const context = {
    save: nothing,
    restore: nothing,
    transform: (/** @type {number} */ a, /** @type {number} */ _b, /** @type {number} */ _c, /** @type {number} */ _d, /** @type {number} */ e) =>
      (by = [a, e]),
    drawImage: (/** @type {any[]} */ ...given) => {
      const [a = 1, e = 0] = by;
      across.push([(a * given[5] + e) * ratio, (a * (given[5] + given[7]) + e) * ratio]);
    },
  };
  const bitmap = { width: 256, height: 256, close: nothing };
  const made = new tiles.OrthophotoTiles(async () => bitmap, nothing);
  const given = { raster: {}, info: { width: 512, height: 256 } };
  const lies = { whole: { a: 1, b: 0, c: 0, d: -1, e: 0, f: 0 }, cells };
  const paint = () => made.paint(context, given, lies, { scale: 1, x: 0, y: 0 }, [512, 256, ratio]);
  paint();
  await new Promise((done) => setTimeout(done, 20));
  across.length = 0;
  paint();
  return across.sort(([a], [b]) => a - b);
}

test('tiles of cells share a pixel of the screen along their borders; others are drawn as they are', async () => {
  const corners = [
    [0, 0],
    [512, 0],
    [0, -256],
    [512, -256],
  ];
  for (const ratio of [1, 2]) {
    const [first, second] = await drawn({ number: 1, corners, margin: 1 }, ratio);
    assert.ok(first && second);
    assert.ok(Math.abs(first[1] - second[0] - 1) < 1e-6, `${first} ${second}`);
    const [left, right] = await drawn(null, ratio);
    assert.equal(left?.[1], right?.[0]);
  }
});
