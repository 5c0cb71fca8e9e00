/** Images of a block side by side, as the page's own code lays them out and finds their places: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(
    page,
    await pageModules(['shared/state/neighbours', 'block/state/panes', 'block/state/observed', 'block/view/images/grid', 'block/view/images/observations']),
  );
});

/** A view of images of these names.  @param {string[]} names */
const viewOf = (...names) => ({ images: names.map((name) => ({ name })) });

test('no more than nine images are shown, each once; what stays looks where it looked, by its name in another view', () => {
  const { NO_PANES, reducePanes, shownImages, panesInOtherView } = page.panes;
  const view = viewOf('a', 'b', 'c', 'd', 'e');
  assert.deepEqual(shownImages(NO_PANES, view), [0, 1, 2, 3]);
  let panes = reducePanes(NO_PANES, { type: 'showImages', images: [5, 1, 1, 2, 3, 4, 0, 6, 7, 8, 9] });
  assert.deepEqual(panes.images, [5, 1, 2, 3, 4, 0, 6, 7, 8]);
  assert.equal(panes.active, 5);
  const looks = { x: 1, y: 2, scale: 3 };
  panes = reducePanes(panes, {
    type: 'moveViews',
    views: new Map([
      [1, looks],
      [9, looks],
    ]),
  });
  panes = reducePanes(panes, { type: 'showImages', images: [1, 4] });
  assert.deepEqual([...panes.views], [[1, looks]]);
  assert.equal(panes.active, 1);
  const other = panesInOtherView(panes, view, viewOf('e', 'x', 'b'));
  assert.deepEqual([other.images, [...other.views], other.active], [[2, 0], [[2, looks]], 2]);
  assert.deepEqual(panesInOtherView(panes, null, view).images, []);
});

test('panes are as large as they can be, touch no other, and lie one below the other on a narrow page', () => {
  const { columnsOf, gridOf } = page.grid;
  assert.equal(columnsOf(9, 1366, 768, 4 / 3, false), 3);
  assert.equal(columnsOf(2, 1366, 768, 4 / 3, false), 2);
  assert.equal(columnsOf(2, 600, 1200, 4 / 3, false), 1);
  assert.equal(columnsOf(9, 360, 1980, 4 / 3, true), 1);
  for (let count = 1; count <= 9; count++) {
    const columns = columnsOf(count, 1000, 700, 1.5, false);
    const rects = gridOf(count, columns, 1000, 700);
    assert.equal(rects.length, count);
    for (const [i, a] of rects.entries()) {
      assert.ok(a.left >= 0 && a.top >= 0 && a.left + a.width <= 1000 && a.top + a.height <= 700, JSON.stringify(a));
      for (const b of rects.slice(i + 1)) assert.ok(b.left >= a.left + a.width || b.top >= a.top + a.height || b.left + b.width <= a.left, `${count}`);
    }
  }
});

/** Points on a raster in one image, moved and turned in the other; on the ground a slope. */
function twoImages() {
  const rows = Array.from({ length: 100 }, (_, i) => [50 + 100 * (i % 10), 50 + 100 * Math.floor(i / 10)]);
  const points = Uint32Array.from(rows, (_, i) => i);
  const of = (/** @type {(x: number, y: number) => number[]} */ place) => ({
    points,
    places: Float64Array.from(rows.flatMap(([x = 0, y = 0]) => place(x, y))),
    residuals: new Float64Array(200),
    parts: new Uint8Array(100),
  });
  const turned = (/** @type {number} */ x, /** @type {number} */ y) => [900 - 1.1 * y, 20 + 1.1 * x];
  const positions = Float64Array.from(rows.flatMap(([x = 0, y = 0]) => [500_000 + 0.1 * x, 4_000_000 - 0.1 * y, 100 + 0.01 * x]));
  return { left: of((x, y) => [x, y]), right: of(turned), turned, positions };
}

test('the points around a place say where it lies in another image and on the ground', () => {
  const { inOtherImage, groundAt, placeOfPoint } = page.observed;
  const { left, right, turned, positions } = twoImages();
  const [x = 0, y = 0] = inOtherImage(left, right, [333, 444]);
  const [u = 0, v = 0] = turned(333, 444);
  assert.ok(Math.hypot(x - u, y - v) < 1e-6, `${x} ${y}`);
  const ground = groundAt(left, { positions }, 333, 444);
  assert.deepEqual(
    ground.map((/** @type {number} */ value) => Number(value.toFixed(4))),
    [500_033.3, 3_999_955.6, 103.33],
  );
  assert.deepEqual(placeOfPoint(left, 11), [150, 150]);
  assert.equal(placeOfPoint(left, 100), null);
  // A point that was rejected in either image says nothing.
  right.places[2 * 44] = 5000;
  right.parts[44] = 1;
  const other = twoImages();
  const again = inOtherImage(left, { ...other.right, places: right.places, parts: right.parts }, [450, 450]);
  assert.ok(Math.hypot(again[0] - turned(450, 450)[0], again[1] - turned(450, 450)[1]) < 1e-6, again.join());
});

test('two lines say where they cross, unless they are hardly two', () => {
  const { crossing } = page.neighbours;
  const bent = Float64Array.of(0, 0, 100, 0, 200, 100);
  assert.deepEqual(crossing(bent, Float64Array.of(150, -50, 150, 200)), [150, 50]);
  assert.equal(crossing(bent, Float64Array.of(150, 60, 150, 200)), null);
  assert.equal(crossing(bent, Float64Array.of(0, 2, 100, -2)), null);
  assert.equal(crossing(bent, new Float64Array()), null);
});

test('photo coordinates are in mm from the principal point, y up', () => {
  const camera = { calibrated: { principal_point_px: [500, 400], pixel_mm: 0.002 }, given: null };
  assert.deepEqual(page.observed.photoMm(camera, [600, 300]), [0.2, 0.2]);
  assert.equal(page.observed.photoMm({ calibrated: { principal_point_px: [500, 400], pixel_mm: null }, given: null }, [1, 1]), null);
});

test('the bar of residuals stands for a round length and has room in its pane', () => {
  for (const scale of [0.03, 1, 7, 200, 64_000]) {
    const { px, length } = page.observations.barOf(scale);
    assert.ok(length <= 70 && length > 27, `${scale}: ${length}`);
    assert.match(px.toExponential(), /^[125]e/);
  }
});
