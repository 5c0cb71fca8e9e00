/** The ground sample distances that the page shows of a block. Without a browser. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pageModules } from './www.js';

const {
  ground: { gsdOf, medianGsd },
  frame: { gsdText },
} = await pageModules(['block/state/ground', 'block/view/map/frame']);

/** @param {{ origin?: object, control?: boolean }} how a block knows its scale */
const blockOf = ({ origin, control = false }) => ({
  view: { layout: { kind: 'oriented' }, surveyed: control ? [{ role: 'control' }] : [] },
  ground: { gsd: Float64Array.of(0.04, 0.05, NaN, 0.042), origin: origin ?? null },
});

test('a block in metres has the median of its images, and each oriented image its own', () => {
  for (const known of [{ origin: {} }, { control: true }]) {
    const { view, ground } = blockOf(known);
    assert.equal(medianGsd(view, ground), 0.042);
    assert.deepEqual(
      [0, 1, 2, 3].map((image) => gsdOf(view, ground, image)),
      [0.04, 0.05, null, 0.042],
    );
  }
  assert.deepEqual([0.042, 0.0061, 1.25, 0.66].map(gsdText), ['GSD 4.2 cm', 'GSD 6.1 mm', 'GSD 1.3 m', 'GSD 66 cm']);
});

test('a block in units of its own has none', () => {
  const { view, ground } = blockOf({});
  assert.deepEqual([medianGsd(view, ground), gsdOf(view, ground, 0), medianGsd(view, null)], [null, null, null]);
});
