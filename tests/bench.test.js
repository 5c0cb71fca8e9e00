/** What the bench reads and scores by itself. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { match_pair, Photo, score_matches, simulate } from '../pkg/node.js';
import { calibratedInput } from '../tools/bench/calibrated.mjs';
import { parsed } from '../tools/bench/rivals/aliked.mjs';
import { acknowledged, countKinds, wrongWith } from '../tools/bench/crash-states.mjs';
import { flight } from '../tools/bench/verdict/flights.mjs';
import { seenShare } from '../tools/bench/verdict/seen.mjs';
import { exchanged, inputOf, reduced, turned } from '../tools/bench/verdict/views.mjs';

/** Matches of a small flight as it was simulated, flat with stride 5. */
function matched() {
  const pair = flight('sample', 901, {});
  const [left, right] = [pair.left, pair.right].map(({ picture: { width, height, grey } }) => Photo.from_grey(width, height, grey));
  if (!left || !right) throw new Error('a pair has two images');
  const { match } = match_pair(left, right, inputOf(pair), { matching: { strategy: 'moments' } });
  left.free();
  right.free();
  return { pair, matches: match.matches };
}

/** The matches at other places, and with a wrong one for every fifth.  @param {Float64Array} matches @param {(row: number[]) => number[]} to */
const moved = (matches, to) =>
  Float64Array.from(Array.from({ length: matches.length / 5 }, (_, k) => [...to([...matches.subarray(5 * k, 5 * k + 4)]), 0]).flat());

test('matches of a simulated pair are as right as the crate says, turned, reduced and exchanged too', () => {
  const { pair, matches } = matched();
  const { width, height } = pair.left.picture;
  const made = simulate({ seed: 901, width_px: 400, height_px: 560 });
  const { right } = score_matches(matches, new Float64Array(), made.right_position, width, height, width, height);
  const expected = right / (matches.length / 5);
  assert.ok(matches.length > 1000 && expected > 0.8 && expected < 1, `${matches.length} ${expected}`);
  assert.equal(seenShare(pair)(matches), expected);
  const upside = { ...pair, right: turned(pair.right, 180) };
  const about = (/** @type {number} */ share) => assert.ok(Math.abs(share - expected) < 0.005, `${share} ${expected}`);
  about(seenShare(upside)(moved(matches, ([xl = 0, yl = 0, xr = 0, yr = 0]) => [xl, yl, width - xr, height - yr])));
  assert.ok(seenShare(upside)(matches) < 0.1);
  about(seenShare(exchanged(pair))(moved(matches, ([xl = 0, yl = 0, xr = 0, yr = 0]) => [xr, yr, xl, yl])));
  const half = { ...pair, left: reduced(pair.left, 2), right: reduced(pair.right, 2) };
  assert.ok(seenShare(half)(moved(matches, (row) => row.map((value) => value / 2))) >= expected);
});

test('cameras of one kind need no marks; other principal points and pixels that are not square are told by the corners', () => {
  const size = { width: 100, height: 80 };
  const camera = { f: 90, cx: 51, cy: 39, k1: 0, k2: 0 };
  assert.deepEqual(Object.keys(calibratedInput([camera, { ...camera, fy: 90 }], [size, size])), ['camera']);
  const { left, right } = calibratedInput([camera, { ...camera, fy: 60, cx: 41 }], [size, size]);
  assert.deepEqual(left?.fiducials?.[2], { col: 100, row: 80, x_mm: (49 * 0.09) / 90, y_mm: (-41 * 0.09) / 90 });
  assert.deepEqual(right?.fiducials?.[2], { col: 100, row: 80, x_mm: (59 * 0.09) / 90, y_mm: (-41 * 0.09) / 60 });
});

test('the record of the learned rival is read, with and without a pose', () => {
  const text = `# By hand.
homography_graf              graf1.png        graf3.png        matches    251 right    242 share 0.964 rot - dir - features 15.477
stereo_rectified_motorcycle  motorcycle_left. motorcycle_right matches   1775 right   1774 share 0.999 rot 0.343 dir 1.360 features 11.964`;
  assert.deepEqual(parsed(text), [
    { case: 'homography_graf', a: 'graf1.png', b: 'graf3.png', matches: 251, right: 242, share: 0.964 },
    {
      case: 'stereo_rectified_motorcycle',
      a: 'motorcycle_left.',
      b: 'motorcycle_right',
      matches: 1775,
      right: 1774,
      share: 0.999,
      rotation_error_deg: 0.343,
      direction_error_deg: 1.36,
    },
  ]);
});

test('after a crash the state that was kept is there, or one since; an edit that is lost, undone, or another is found out', () => {
  const state = (/** @type {string[]} */ names, held = names.length, masked = false) => ({ names, held, masked });
  const seen = [state([]), state(['reject 1 match']), state(['reject 1 match'], 0), state(['add 1 match'])].map((one, i) => ({
    state: one,
    key: JSON.stringify(one),
    at: 600 * i,
    kept: i === 1 ? '[1]' : null,
  }));
  assert.deepEqual(
    [700, 1700, 2900].map((at) => acknowledged(seen, at)),
    [1, 1, 3],
  );
  assert.equal(wrongWith(seen, 1, state(['reject 1 match']), '[1]'), '');
  assert.match(wrongWith(seen, 1, state(['reject 1 match']), '[2]'), /other edits/);
  assert.equal(wrongWith(seen, 3, state(['add 1 match']), '[3]'), '');
  for (const lost of [state([]), state(['reject 1 match']), state(['reject 1 match'], 0)])
    assert.notEqual(wrongWith(seen, 3, lost, '[1]'), '', lost.names.join());
  // What was under way when it crashed may be there.
  assert.equal(wrongWith(seen, 3, state(['add 1 match', 'move 1 match']), '[3,4]'), '');
  assert.equal(wrongWith(seen, 3, state(['add 1 match'], 0), '[3]'), '');
  assert.notEqual(wrongWith(seen, 3, state(['reject 1 match', 'add 1 match']), '[1,3]'), '');
  const counts = new Map();
  countKinds(seen, counts);
  assert.deepEqual(
    [...counts],
    [
      ['reject', 1],
      ['undo', 1],
      ['add', 1],
    ],
  );
});
