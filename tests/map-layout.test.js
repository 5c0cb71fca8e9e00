/** Where the map draws images: those that are oriented at their places, the others beside them. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pageModules } from './www.js';

const { layout } = await pageModules(['block/engine/layout']);

/** @param {number} a @param {number} b */
const connected = (a, b) => ({ images: [a, b], shared: 0, outcome: { kind: 'connected', matches: 100 } });

/** @param {readonly (readonly number[] | null)[]} centres @param {readonly object[]} [connections] @returns {[number, number][]} */
function placesOf(centres, connections = []) {
  const { kind, places } = layout.layoutOf(
    centres,
    centres.map(() => null),
    connections,
  );
  assert.equal(kind, 'oriented');
  return centres.map((_, i) => [places[2 * i], places[2 * i + 1]]);
}

/** @param {[number, number][]} places */
function leastDistance(places) {
  const between = places.flatMap(([x, y], i) => places.slice(0, i).map(([u, v]) => Math.hypot(x - u, y - v)));
  return Math.min(...between);
}

test('an image that is connected with nothing covers none of a strip, whichever way it runs', () => {
  for (const [dx = 0, dy = 0] of [
    [0, 100],
    [100, 0],
    [70, 70],
  ]) {
    const strip = Array.from({ length: 5 }, (_, i) => [i * dx, i * dy, 300]);
    const places = placesOf([...strip, ...Array.from({ length: 6 }, () => null)]);
    assert.deepEqual(
      places.slice(0, 5),
      strip.map(([x, y]) => [x, y]),
    );
    // Outside of what is known, at its lower left, and apart from each other.
    for (const [x, y] of places.slice(5)) assert.ok(x < 0 && y <= 0, `${x} ${y}`);
    assert.ok(leastDistance(places) > 50, String(leastDistance(places)));
  }
});

test('an image without a place stands among those it is connected with, and on none of them', () => {
  const strip = Array.from({ length: 5 }, (_, i) => [0, i * 100, 300]);
  const centres = [...strip, null, null, null, null];
  const places = placesOf(centres, [connected(5, 0), connected(6, 0), connected(7, 1), connected(7, 3), connected(8, 3), connected(8, 4)]);
  assert.ok(leastDistance(places) > 20, String(leastDistance(places)));
  const [x = NaN, y = NaN] = places[8] ?? [];
  assert.deepEqual([x, y], [0, 350]);
});

test('a block of one oriented image has the others beside it', () => {
  assert.ok(leastDistance(placesOf([[5, 7, 9], null, null])) > 0.5);
});
