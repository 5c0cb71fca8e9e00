/** Points that take no part after edits by hand, as the page shows them beside those of the block: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(page, await pageModules(['block/engine/rejected', 'block/state/address', 'block/state/edits', 'block/state/words']));
});

/** The tie points of the block as it was found, each in images 0 and 1. */
const TIE_POINTS = [4, 9, 12];

/** A block of these tie points.  @param {readonly number[]} points */
const blockOf = (points) => ({
  point_ids: () => points.map((point) => ({ tie_point: point })),
  overview: () => ({ points: columnsOf(points) }),
  point_number: (/** @type {object} */ source) => Object.values(source)[0] + ('manual' in source ? 2001 : 1),
  // Rays meet, but from row 8.
  meeting_place: (/** @type {{ image: number, x_px: number, y_px: number }[]} */ [first, ...others]) =>
    first === undefined || others.length === 0 || first.y_px === 8 ? undefined : Float64Array.of(first.x_px, first.y_px, others.length),
  image_points: (/** @type {number} */ image) => ({
    points: Uint32Array.from(points.keys()),
    places: Float64Array.from(points.flatMap((point) => [point, 100 + image])),
  }),
  point: (/** @type {number} */ index) => ({
    id: { tie_point: points[index] },
    name: null,
    position: [index, 0, 0],
    confidence: 0.9,
    observations: [0, 1].map((image) => ({ image, x_px: points[index], y_px: 100 + image, by_hand: false, part: 'accepted' })),
  }),
});

/** @param {readonly number[]} points */
const columnsOf = (points) => ({
  numbers: Uint32Array.from(points, (point) => point + 1),
  rays: new Uint16Array(points.length).fill(2),
  rmsePx: new Float64Array(points.length),
  positions: new Float64Array(3 * points.length),
  errors: new Float64Array(3 * points.length),
  confidence: new Float64Array(points.length).fill(0.9),
});

/** What is shown of the block that is left with these points.  @param {readonly number[]} points @param {readonly object[]} edits */
function shown(points, edits) {
  const { Found, Rejected } = page.rejected;
  const sources = Float64Array.from(points, (point) => page.edits.codeOfSource({ tie_point: point }));
  const left = {
    points: { ...columnsOf(points), count: points.length, taking: points.length, lost: new Set(), sources },
    surveyed: [],
    origin: null,
    images: [],
  };
  const rejected = new Rejected(new Found(blockOf(TIE_POINTS), [], 0), edits, points.length, sources);
  return { rejected, view: rejected.inView(left) };
}

test('points keep their numbers, and addresses find them, whatever is rejected', () => {
  const all = shown(TIE_POINTS, []).view;
  const { view } = shown([4, 12], [{ kind: 'reject_points', points: [{ tie_point: 9 }] }]);
  assert.deepEqual([...all.points.numbers], [5, 10, 13]);
  assert.deepEqual([...view.points.numbers], [5, 13, 10]);
  assert.deepEqual([[...view.points.lost], view.points.taking], [[], 2]);
  for (const [point, number] of [5, 13, 10].entries()) {
    const address = page.address.addressOf({ shown: { view }, onStage: 'map', selection: { chosen: { kind: 'point', point } } });
    assert.equal(address, `view=map&point=${number}`);
    assert.deepEqual(page.address.asked(address, view).choice, { kind: 'point', point });
  }
});

test('a point that a measurement leaves without rays that meet stays in sight, where it was measured', () => {
  const edits = [{ kind: 'measure', point: { tie_point: 9 }, image: 1, x_px: 400, y_px: 300, by: 'hand' }];
  const { rejected, view } = shown([4, 12], edits);
  assert.deepEqual([view.points.count, [...view.points.lost], view.points.numbers[2]], [3, [2], 10]);
  assert.match(page.words.describe({ view, given: [] }, { kind: 'point', point: 2 }), /^point 10: 2 rays; .*; rejected: too few rays that meet\.$/u);
  const { observations, position } = rejected.detail(2);
  const seen = observations.map(({ image, x_px, y_px, by_hand, part }) => [image, x_px, y_px, by_hand, part]);
  assert.deepEqual(seen, [
    [0, 9, 100, false, 'lost_point'],
    [1, 400, 300, true, 'lost_point'],
  ]);
  assert.deepEqual(position, [1, 0, 0]);
  const none = { points: new Uint32Array(), places: new Float64Array(), parts: new Uint8Array() };
  const of = { ...none, residuals: new Float64Array(), redundancy: new Float64Array(), w: new Float64Array(), detectable: new Float64Array() };
  const inImage = rejected.inImage(of, 1);
  assert.deepEqual([[...inImage.points], [...inImage.places], [...inImage.parts]], [[2], [400, 300], [1]]);
  // What becomes of surveyed points is said elsewhere.
  assert.equal(shown(TIE_POINTS, [{ ...edits[0], point: { ground_control: 0 } }]).view.points.count, 3);
  // One that is rejected as well is not lost, but rejected by hand.
  const both = shown([4, 12], [...edits, { kind: 'reject_points', points: [{ tie_point: 9 }] }]);
  assert.deepEqual([both.view.points.lost.size, both.rejected.detail(2).observations[0].part], [0, 'rejected_by_hand']);
});

test('points that edits leave without two rays stay in sight, whatever the edit is about', () => {
  const { rejected, view } = shown([12], [{ kind: 'reject_images', images: [1] }]);
  assert.deepEqual(
    [[...view.points.numbers], [...view.points.lost]],
    [
      [13, 5, 10],
      [1, 2],
    ],
  );
  assert.deepEqual(
    rejected.detail(1).observations.map((/** @type {{ part: string }} */ { part }) => part),
    ['lost_point', 'lost_point'],
  );
});

test('a point that was measured in images alone, and does not meet, is shown where it was measured', () => {
  const observations = [0, 1].map((image) => ({ image, x_px: 7, y_px: 8 + image, by: 'hand' }));
  const { rejected, view } = shown(TIE_POINTS, [{ kind: 'add_point', observations }]);
  assert.deepEqual([[...view.points.lost], view.points.numbers[3], view.points.rays[3]], [[3], 2001, 2]);
  assert.ok(Number.isNaN(view.points.positions[9]));
  const places = rejected.detail(3).observations.map(({ image, x_px, y_px }) => [image, x_px, y_px]);
  assert.deepEqual(places, [
    [0, 7, 8],
    [1, 7, 9],
  ]);
  assert.equal(rejected.detail(0), null);
});

test('a point that was added by hand and rejected lies where its measurements meet', () => {
  const observations = [0, 1, 3].map((image) => ({ image, x_px: 70 + image, y_px: 90, by: 'hand' }));
  const { rejected, view } = shown(TIE_POINTS, [
    { kind: 'add_point', observations },
    { kind: 'reject_points', points: [{ manual: 0 }] },
  ]);
  assert.deepEqual([view.points.count, view.points.lost.size, [...view.points.positions.slice(9)]], [4, 0, [70, 90, 2]]);
  assert.deepEqual(rejected.detail(3).position, [70, 90, 2]);
});
