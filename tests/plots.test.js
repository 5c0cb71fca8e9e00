/** The plots of a block: their values, what is chosen in them, and their axes, without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(page, await pageModules(['block/state/plots', 'block/view/plot/axes']));
});

/** Three images of which one is not oriented; four points of which the last was rejected. */
const VIEW = {
  images: [
    { name: 'a', rmsePx: 0.2, position: [0, 0, 100] },
    { name: 'b', rmsePx: null, position: null },
    { name: 'c', rmsePx: 0.4, position: [3, 4, 100] },
  ],
  points: {
    count: 4,
    taking: 3,
    rays: Uint16Array.of(2, 3, 2, 5),
    positions: Float64Array.of(0, 0, 0, 10, 90, 0, 5, 50, 0, 1, 1, 1),
    errors: Float64Array.of(3, 4, 9, 0, 1, 2, NaN, NaN, NaN, NaN, NaN, NaN),
  },
  surveyed: [
    { name: 'G1', role: 'check', point: 2, isUsed: true, difference_m: [3, 4, -2] },
    { name: 'G2', role: 'control', point: 3, isUsed: false, difference_m: [NaN, NaN, NaN] },
  ],
};

const OBSERVED = {
  images: Uint32Array.of(0, 2, 0, 2),
  points: Uint32Array.of(0, 0, 1, 1),
  residuals: Float64Array.of(1, 0, 0, -2, NaN, NaN, 0.5, 0.5),
  parts: Uint8Array.of(0, 0, 0, 2),
};

const FACTS = {
  observations: () => OBSERVED,
  ground: () => ({ gnss: Float64Array.of(0, 0, 101, 0, 0, 0, NaN, NaN, NaN) }),
};

const values = (/** @type {string} */ name) => {
  const { x, y } = page.plots.plotOf(name, VIEW, FACTS);
  return [x.names ?? [...x.values], [...y.values]];
};

test('plots show what is known, and choose what their values are about', () => {
  assert.deepEqual(values('images'), [
    ['a', 'c'],
    [0.2, 0.4],
  ]);
  assert.deepEqual(values('gnss'), [['a'], [1]]);
  assert.deepEqual(values('rays'), [
    ['2', '3'],
    [2, 1],
  ]);
  // Along the longer side of the block; points without a standard error, and rejected ones, are left out.
  assert.deepEqual(values('sigma-plan'), [
    [0, 90],
    [5, 1],
  ]);
  assert.deepEqual(values('sigma-height')[1], [9, 2]);
  assert.deepEqual(values('surveyed-plan'), [['G1 (check)'], [5]]);
  assert.deepEqual(values('surveyed-height')[1], [-2]);
  assert.deepEqual(values('residuals'), [
    [1, 0],
    [0, -2],
  ]);
  assert.equal(page.plots.plotOf('residuals', VIEW, { ...FACTS, observations: () => null }), null);

  const { plotOf } = page.plots;
  const images = plotOf('images', VIEW, FACTS);
  assert.deepEqual(images.choice(1), { kind: 'image', image: 2 });
  assert.equal(images.together([0, 1]), null);
  assert.deepEqual([0, 1].map(images.chosen({ kind: 'pair', images: [1, 2] })), [false, true]);
  const rays = plotOf('rays', VIEW, FACTS);
  assert.deepEqual(rays.choice(0), { kind: 'points', points: Uint32Array.of(0, 2) });
  assert.deepEqual([0, 1].map(rays.chosen({ kind: 'point', point: 1 })), [false, true]);
  const residuals = plotOf('residuals', VIEW, FACTS);
  assert.deepEqual(residuals.choice(1), { kind: 'observation', point: 0, image: 2 });
  assert.deepEqual([0, 1].map(residuals.chosen({ kind: 'observation', point: 0, image: 2 })), [false, true]);
  assert.deepEqual([0, 1].map(residuals.chosen(null)), [false, false]);
  assert.deepEqual(plotOf('sigma-plan', VIEW, FACTS).together([0, 1]), { kind: 'points', points: Uint32Array.of(0, 1) });
});

test('axes end beside their values, bars stand on zero, and ticks are round', () => {
  const { decimalsOf, endsOf, ticksBetween } = page.axes;
  assert.deepEqual(ticksBetween([0.13, 0.91], 4), [0.2, 0.4, 0.6, 0.8]);
  assert.deepEqual(ticksBetween([-2.2, 2.2], 5), [-2, -1, 0, 1, 2]);
  assert.equal(decimalsOf([0.2, 0.4]), 1);
  assert.equal(decimalsOf([0, 50]), 0);
  assert.deepEqual(ticksBetween([1, 1], 5), []);
  const { x, y } = endsOf(page.plots.plotOf('images', VIEW, FACTS), 400, 300);
  assert.deepEqual([x, y[0]], [[-0.5, 1.5], 0]);
  assert.ok(y[1] > 0.4 && y[1] < 0.45);
  // Residuals have one scale in both directions, about zero.
  const square = endsOf(page.plots.plotOf('residuals', VIEW, FACTS), 464, 300);
  assert.ok(Math.abs(square.x[0] + square.x[1]) < 1e-12 && Math.abs(square.y[0] + square.y[1]) < 1e-12);
  assert.ok(Math.abs((square.x[1] - square.x[0]) / (464 - 80) - (square.y[1] - square.y[0]) / (300 - 54)) < 1e-12);
});
