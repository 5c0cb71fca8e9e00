/** Pictures on a canvas, as the page's own code moves them: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(page, await pageModules(['shared/view/transform', 'shared/view/panes', 'pair/view/geometry']));
});

test('a canvas of another size shows the same in its middle, and all that was seen', () => {
  const { resized, toPosition } = page.transform;
  const t = { scale: 2, x: -120, y: 35 };
  const from = { width: 800, height: 600 };
  for (const to of [
    { width: 400, height: 600 },
    { width: 1600, height: 900 },
    { width: 360, height: 200 },
  ]) {
    const other = resized(t, from, to);
    assert.deepEqual(toPosition(other, to.width / 2, to.height / 2), toPosition(t, from.width / 2, from.height / 2));
    for (const [x, y] of [
      [0, 0],
      [800, 600],
    ]) {
      const [px, py] = toPosition(t, x, y);
      assert.ok(other.scale * px + other.x > -1e-9 && other.scale * px + other.x < to.width + 1e-9, JSON.stringify(to));
      assert.ok(other.scale * py + other.y > -1e-9 && other.scale * py + other.y < to.height + 1e-9, JSON.stringify(to));
    }
  }
  assert.deepEqual(resized(t, from, from), t);
});

test('a pane that was moved shows all that was seen in another size, and is as it was in its own', () => {
  const { inPane } = page.panes;
  const view = { x: 300, y: 200, scale: 2 };
  const pane = (/** @type {number} */ width, /** @type {number} */ height) => ({ left: 0, top: 0, width, height });
  assert.equal(inPane(view, pane(400, 300)), view);
  assert.deepEqual(inPane(view, pane(200, 300)), { x: 300, y: 200, scale: 1 });
  assert.deepEqual(inPane(view, pane(800, 450)), { x: 300, y: 200, scale: 3 });
  assert.deepEqual(inPane(view, pane(0, 0)), view);
  assert.deepEqual(inPane(view, pane(400, 300)), view);
});

test('a pair lies side by side or one above the other, whichever shows its images clearly larger', () => {
  const { isBeside, panesOf } = page.geometry;
  // On a phone high photographs stand side by side, wide ones one above the other.
  assert.equal(isBeside(360, 430, 450 / 700), true);
  assert.equal(isBeside(360, 430, 4 / 3), false);
  assert.equal(isBeside(1366, 540, 4 / 3), true);
  assert.equal(isBeside(1366, 540, null), true);
  assert.equal(isBeside(360, 430, null), false);
  const opened = { value: { info: { width: 450, height: 700 } } };
  const { left, right } = panesOf({ results: { openLeft: opened, openRight: opened } }, 360, 430);
  assert.deepEqual([left.height, right.height, right.left + right.width], [430, 430, 360]);
});
