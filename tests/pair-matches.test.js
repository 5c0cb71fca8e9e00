/** What a block makes of matches that were rejected or measured by hand in one of its pairs: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(page, await pageModules(['block/state/edits', 'block/state/pair-matches']));
});

/** @typedef {{ source: object, at: number[], parts?: [number, number] }} Point where images 3 and 1 show a point, and whether it takes part there */

/**
 * What a block of these points makes of the matches of its images 3 (left) and 1 (right).
 * @param {Point[]} points @param {{ rejected?: number[][], used?: number[][], measured?: { at: number[], of: number[] | null, had?: number[][] }[] }} matches
 */
function made(points, { rejected = [], used = [], measured = [] }) {
  const view = { points: { sources: Float64Array.from(points, ({ source }) => page.edits.codeOfSource(source)) } };
  const order = points.map((_, index) => index);
  const shownBy = (/** @type {number} */ side) => {
    // The images list their points in different orders.
    const rows = side === 0 ? order : [...order].reverse();
    return {
      points: Uint32Array.from(rows),
      places: Float64Array.from(rows.flatMap((index) => points[index]?.at.slice(2 * side, 2 * side + 2) ?? [])),
      parts: Uint8Array.from(rows, (index) => points[index]?.parts?.[side] ?? 0),
    };
  };
  const placed = measured.map((one) => ({ had: [one.at], ...one }));
  const given = { rejected, used: Float64Array.from(used.flatMap((place) => [...place, 0.3])), measured: placed };
  return page.pair_matches.forBlock(view, 3, 1, shownBy(0), shownBy(1), given);
}

const A = { source: { tie_point: 40 }, at: [100, 50, 70, 52] };
const B = { source: { tie_point: 7 }, at: [200.2, 80.9, 170, 81] };

test('of a tie point that a rejected match joined both observations are rejected, in one edit', () => {
  const { rejection, matches, without, addition } = made([A, B], { rejected: [A.at, [199.9, 80.7, 170.4, 81.2], [300, 10, 270, 11]] });
  assert.deepEqual(rejection, [
    {
      kind: 'reject_observations',
      observations: [
        { point: { tie_point: 40 }, image: 3 },
        { point: { tie_point: 40 }, image: 1 },
        { point: { tie_point: 7 }, image: 3 },
        { point: { tie_point: 7 }, image: 1 },
      ],
    },
  ]);
  assert.deepEqual([matches, without, addition], [2, 1, []]);
});

test('a match is that of a tie point where both of its ends lie at its observations', () => {
  const other = { source: { tie_point: 8 }, at: [100, 50.5, 400, 300] };
  for (const place of [
    [100, 50, 75, 52],
    [103, 50, 70, 52],
    // One end at one point, the other end at another one.
    [200.2, 80.9, 400, 300],
  ]) {
    const { rejection, matches, without } = made([A, B, other], { rejected: [place] });
    assert.deepEqual([rejection, matches, without], [[], 0, 1]);
  }
  const { rejection } = made([A, B, other], { rejected: [[101.2, 50, 70, 51]] });
  assert.deepEqual(
    rejection[0].observations.map((/** @type {any} */ { point }) => point),
    [{ tie_point: 40 }, { tie_point: 40 }],
  );
});

test('the nearest match is that of a tie point: one that stays keeps it, two that are rejected reject it once', () => {
  const near = [100.4, 50, 70.4, 52];
  const kept = made([A], { rejected: [[100.9, 50, 70, 52]], used: [near] });
  assert.deepEqual([kept.rejection, kept.matches, kept.without], [[], 0, 1]);
  const gone = made([A], { rejected: [near], used: [[100.9, 50, 70, 52]] });
  assert.deepEqual([gone.rejection[0].observations.length, gone.matches], [2, 1]);
  const both = made([A], { rejected: [near, A.at] });
  assert.deepEqual([both.rejection[0].observations.length, both.matches, both.without], [2, 2, 0]);
});

test('what the block does not use is not rejected again, and control points are no tie points', () => {
  const control = { source: { ground_control: 0 }, at: B.at };
  for (const parts of /** @type {[number, number][]} */ ([
    [0, 1],
    [2, 2],
  ])) {
    const { rejection, matches, without } = made([{ ...A, parts }, control], { rejected: [A.at, B.at] });
    assert.deepEqual([rejection, matches, without], [[], 0, 1]);
  }
});

test('measured matches become tie points by hand, moved ones move their tie point, each once', () => {
  const at = [20, 30, 5, 31];
  const moved = { at: [203, 80, 172, 81], of: B.at };
  const { addition, measured, rejection } = made([A, B], { measured: [{ at, of: null }, moved, { at: [60, 60, 40, 61], of: [61, 64, 40, 62] }] });
  const point = { tie_point: 7 };
  assert.deepEqual(addition, [
    {
      kind: 'add_point',
      observations: [
        { image: 3, x_px: 20, y_px: 30 },
        { image: 1, x_px: 5, y_px: 31 },
      ],
    },
    { kind: 'measure', point, image: 3, x_px: 203, y_px: 80 },
    { kind: 'measure', point, image: 1, x_px: 172, y_px: 81 },
    {
      kind: 'add_point',
      observations: [
        { image: 3, x_px: 60, y_px: 60 },
        { image: 1, x_px: 40, y_px: 61 },
      ],
    },
  ]);
  assert.deepEqual([measured, rejection], [3, []]);
  // However little one was moved; where only one end was, it alone.
  const little = { at: [200.2, 80.9, 170.3, 81], of: B.at };
  assert.deepEqual(made([A, B], { measured: [little] }).addition, [{ kind: 'measure', point, image: 1, x_px: 170.3, y_px: 81 }]);
  // In the block they are there, whatever was done to them since.
  const there = [A, { ...B, at: moved.at }, { source: { manual: 0 }, at, parts: /** @type {[number, number]} */ ([2, 2]) }];
  const again = made(there, { measured: [{ at, of: null }, moved] });
  assert.deepEqual([again.addition, again.measured], [[], 0]);
});

test('a match that was moved after the block took it moves its tie point, however far, and is no second one', () => {
  const point = { manual: 0 };
  const [first, taken] = [
    [20, 30, 5, 31],
    [20, 30, 6, 31],
  ];
  const own = { source: point, at: taken };
  const moveTo = (/** @type {number[]} */ at, points = [A, own], had = [first, taken, at]) => made(points, { measured: [{ at, of: null, had }] }).addition;
  for (const x of [6.8, 66]) {
    const right = [{ kind: 'measure', point, image: 1, x_px: x, y_px: 31 }];
    assert.deepEqual(moveTo([20, 30, x, 31]), right);
    // The step that held its place is gone: the left place names it.
    assert.deepEqual(moveTo([20, 30, x, 31], [A, own], [first, [20, 30, x, 31]]), right);
    // As a gross error it is mended by this; what was rejected by hand is left alone.
    assert.deepEqual(moveTo([20, 30, x, 31], [A, { ...own, parts: [1, 1] }]), right);
    assert.ok(moveTo([20, 30, x, 31], [A, { ...own, parts: [2, 2] }]).every(({ kind }) => kind === 'add_point'));
  }
  assert.deepEqual(
    moveTo([50, 60, 6, 31]).map(({ kind, image }) => [kind, image]),
    [['measure', 3]],
  );
  // One that was found, moved and taken, and moved again.
  const [once, twice] = [
    [200.2, 80.9, 190, 81],
    [200.2, 80.9, 175, 81],
  ];
  const again = made([A, { ...B, at: once }], { measured: [{ at: twice, of: B.at, had: [once, twice] }] });
  assert.deepEqual(again.addition, [{ kind: 'measure', point: B.source, image: 1, x_px: 175, y_px: 81 }]);
  // The point of one match is not that of another one at its place.
  const two = [
    { at: taken, of: null },
    { at: [20, 30, 40, 31], of: null },
  ];
  assert.deepEqual(
    made([A, own], { measured: two }).addition.map((/** @type {any} */ { kind }) => kind),
    ['add_point'],
  );
});
