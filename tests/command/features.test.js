import assert from 'node:assert/strict';
import { test } from 'node:test';
import { gradient_candidates, join_nearest, match_descriptors, match_features, match_photos, nearest_piece, Photo, simulate } from '../../pkg/node.js';

const sample = simulate({});
const photos = /** @type {const} */ (['left', 'right']).map((side) => Photo.from_grey(sample[side].width, sample[side].height, sample[side].grey));
const found = photos.map((photo) => photo.features({ multiscale: { number: 2000 } }));
const [left, right] = /** @type {[typeof found[0], typeof found[0]]} */ (/** @type {unknown} */ (found));

/** @param {typeof left} features */
const positions = ({ points }) => Float64Array.from({ length: (points.length / 5) * 2 }, (_, i) => points[5 * (i >> 1) + (i & 1)] ?? NaN);

test('the pieces of nearest neighbours, joined, are those of the whole', () => {
  const whole = match_descriptors(left.descriptors, right.descriptors, {});
  assert.ok(whole.indices.length > 1000);
  const count = left.descriptors.length / 128;
  for (const ends of [[count], [1, 700, 701, count]]) {
    const pieces = ends.map((end, i) => nearest_piece(left.descriptors, ends[i - 1] ?? 0, end, right.descriptors));
    assert.deepEqual(join_nearest(pieces, {}), whole);
  }
  assert.throws(
    () => join_nearest([nearest_piece(left.descriptors, 5, 9, right.descriptors), nearest_piece(left.descriptors, 10, 12, right.descriptors)], {}),
    { name: 'TiepointError', code: 'invalid-input' },
  );
});

test('matching photos takes pieces of nearest neighbours and finds the same', () => {
  const settings = /** @type {const} */ ({ points: { operator: 'multiscale' }, multiscale: { number: 1500 }, matching: { strategy: 'gradient' } });
  const [one, two] = photos;
  assert.ok(one && two);
  const [a, b] = [one, two].map((photo) => photo.describe_points(settings));
  assert.ok(a && b);
  const whole = match_photos(one, two, a, b, null, null, settings);
  assert.ok(whole.counts.matches > 300);
  const count = a.gradients.length / 128;
  const piece = (/** @type {number} */ first, /** @type {number} */ end) => nearest_piece(a.gradients, first, end, b.gradients);
  assert.deepEqual(match_photos(one, two, a, b, null, null, settings, [piece(0, 400), piece(400, 401), piece(401, count)]), whole);
  assert.deepEqual(match_photos(one, two, a, b, null, null, settings, []), whole, 'where none are given they are found');
  for (const pieces of [[piece(0, 400)], [piece(5, count)], [piece(0, 400), piece(401, count)]]) {
    assert.throws(() => match_photos(one, two, a, b, null, null, settings, pieces), { name: 'TiepointError', code: 'invalid-input' });
  }
});

test('features of two images are matched, verified and completed', () => {
  const result = match_features(positions(left), left.descriptors, positions(right), right.descriptors, {});
  assert.equal(result.no_geometry, null);
  assert.ok(result.geometry && result.geometry.sigma_px < 0.5 * result.geometry.threshold_px && result.geometry.threshold_px < 2);
  assert.ok(result.indices.length > 0.5 * match_descriptors(left.descriptors, right.descriptors, {}).indices.length);
  const none = match_features(
    positions(left),
    left.descriptors,
    positions(right),
    right.descriptors.map((byte) => byte ^ 85),
    {},
  );
  assert.equal(none.geometry, null);
  assert.match(none.no_geometry?.kind ?? '', /chance|too_few_matches/);
  assert.equal(none.indices.length, 0);
});

test('what does not fit is refused by name', () => {
  const refused = { name: 'TiepointError', code: 'invalid-input' };
  assert.throws(() => match_features(positions(left).subarray(2), left.descriptors, positions(right), right.descriptors, {}), refused);
  assert.throws(() => match_features(positions(left), left.descriptors.subarray(1), positions(right), right.descriptors, {}), refused);
  assert.throws(() => match_features(positions(left), left.descriptors, positions(right), right.descriptors, { nearest: { ratio: 2 } }), {
    code: 'invalid-option',
    message: /nearest\.ratio is 2/,
  });
  const [one, two] = photos;
  assert.ok(one && two);
  assert.throws(
    () =>
      match_photos(one, two, { points: new Float64Array([5, 5, 1]) }, { points: new Float64Array([5, 5, 1]) }, null, null, {
        matching: { strategy: 'gradient' },
      }),
    { ...refused, message: /descriptors: got 0 bytes of gradients for 1 points/ },
  );
  assert.throws(() => one.detect({ points: { operator: 'multiscale' } }, new Uint8Array(7)), refused);
});

test('candidates come in the order of their distance', () => {
  const [one] = photos;
  assert.ok(one);
  const described = one.describe_points({ points: { operator: 'multiscale' }, multiscale: { number: 500 }, matching: { strategy: 'gradient' } });
  assert.equal(described.frames.length, (described.points.length / 3) * 2);
  assert.equal(described.gradients.length, (described.points.length / 3) * 128);
  const ranking = gradient_candidates(7, described.gradients, described.gradients, 5);
  assert.deepEqual([...ranking.subarray(0, 2)], [7, 0]);
  assert.equal(ranking.length, 10);
  assert.ok([3, 5, 7, 9].every((i) => (ranking[i] ?? NaN) >= (ranking[i - 2] ?? NaN)));
  assert.throws(() => gradient_candidates(500, described.gradients, described.gradients, 5), { code: 'invalid-input' });
});
