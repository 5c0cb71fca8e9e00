import assert from 'node:assert/strict';
import { test } from 'node:test';
import { folder, image, json, speckle, tiepoint } from './command.js';

const at = folder();
const speckled = image(at, 'speckle.png', 64, 48, speckle);
/** One bright pixel at column 20, row 10. */
const spot = image(at, 'spot.png', 40, 30, (col, row) => (col === 20 && row === 10 ? 250 : 100));

test('the JSON has the size, the counts of each phase and the points', () => {
  const result = json('points', speckled);
  assert.deepEqual([result.width, result.height], [64, 48]);
  assert.deepEqual(Object.keys(result.counts), ['candidates', 'after_roundness', 'after_suppression']);
  const { candidates, after_roundness: round, after_suppression: left } = result.counts;
  assert.ok(candidates >= round && round >= left && left > 0, `${candidates} >= ${round} >= ${left}`);
  assert.equal(result.points.length, left);
  for (const [x, y, value] of result.points) {
    assert.ok(x % 1 === 0.5 && y % 1 === 0.5, 'points are at the centres of pixels');
    assert.ok(value >= 0 && value <= 1, 'the value of ground 2 is a roundness');
  }
});

test('a bright pixel is found at its centre by ground 1, its value the sum of eight differences', () => {
  const result = json('points', spot, '--operator', 'ground1', '--threshold', '40');
  assert.deepEqual(result.points, [[20.5, 10.5, 8 * 150]]);
});

test('every operator finds something in speckle and nothing in a flat image', () => {
  const flat = image(at, 'flat.png', 64, 48, () => 128);
  for (const operator of ['moravec', 'forstner', 'ground1', 'ground2']) {
    assert.ok(json('points', speckled, '--operator', operator).points.length > 0, operator);
    assert.deepEqual(json('points', flat, '--operator', operator).points, [], operator);
  }
});

test('points of many scales have frames, the others none', () => {
  // A disc and one twice as large, bright on dark.
  const discs = image(at, 'discs.png', 160, 80, (col, row) =>
    [
      [40, 4],
      [110, 8],
    ].some(([x = 0, r = 0]) => (col - x) ** 2 + (row - 40) ** 2 < r * r)
      ? 220
      : 60,
  );
  const { points, frames, counts } = json('points', discs, '--operator', 'multiscale');
  assert.equal(frames.length, points.length);
  assert.equal(counts.after_suppression, points.length);
  const scaleAt = (/** @type {number} */ x) =>
    frames[points.findIndex((/** @type {number[]} */ p) => Math.hypot((p[0] ?? 0) - x - 0.5, (p[1] ?? 0) - 40.5) < 2)]?.[0];
  const [small, large] = [scaleAt(40), scaleAt(110)];
  assert.ok(Math.abs(large / small - 2) < 0.2, `${small}, ${large} px`);
  assert.ok(json('points', discs, '--operator', 'multiscale', '--number', '3').points.length <= 3);
  assert.deepEqual(json('points', discs).frames, []);
});

test('a mask leaves points out', () => {
  const mask = image(at, 'mask.png', 64, 48, (_, row) => (row < 24 ? 0 : 1));
  for (const operator of ['ground2', 'multiscale']) {
    const { points } = json('points', speckled, '--operator', operator, '--mask', mask);
    assert.ok(points.length > 0 && points.every((/** @type {number[]} */ [, y]) => (y ?? 0) >= 24), operator);
  }
  assert.match(tiepoint('points', spot, '--mask', mask).stderr, /mask\.png: mask is 64 x 48 px; allowed: the image's 40 x 30 px/);
});

test('the options reach the operator', () => {
  const count = (/** @type {string[]} */ ...options) => json('points', speckled, ...options).counts;
  assert.ok(count('--threshold', '120').candidates < count('--threshold', '20').candidates);
  assert.ok(count('--roundness', '0.9').after_roundness < count('--roundness', '0.3').after_roundness);
  const all = count('--suppress', '1');
  assert.equal(all.after_suppression, all.after_roundness, 'a window of 1 suppresses nothing');
  assert.ok(count('--suppress', '9').after_suppression < count('--suppress', '3').after_suppression);
  const share = count('--fraction', '0.2').candidates / (64 * 48);
  assert.ok(Math.abs(share - 0.2) < 0.02, `the share of candidates is ${share}`);
});

test('of equal neighbours both stay, or the first', () => {
  const twins = image(at, 'twins.png', 40, 30, (col, row) => ((col === 20 || col === 22) && row === 10 ? 250 : 100));
  const find = (/** @type {string} */ ties) => json('points', twins, '--operator', 'ground1', '--threshold', '40', '--suppress', '5', '--ties', ties).points;
  assert.deepEqual(
    find('keep').map((/** @type {number[]} */ [x]) => x),
    [20.5, 22.5],
  );
  assert.deepEqual(
    find('first').map((/** @type {number[]} */ [x]) => x),
    [20.5],
  );
});

test('the table tells the same counts', () => {
  const { counts } = json('points', speckled);
  const { code, stdout, stderr } = tiepoint('points', speckled);
  assert.deepEqual([code, stderr], [0, '']);
  assert.match(stdout, new RegExp(`candidates +${counts.candidates}\\n`));
  assert.match(stdout, new RegExp(`after suppression +${counts.after_suppression}\\n`));
  assert.match(stdout, /x \[px\] +y \[px\] +value/);
});

test('help names the operator that the command takes, and options without effect beside another are told', () => {
  const help = tiepoint('points', '--help').stdout.replace(/\s+/g, ' ');
  assert.match(help, /--operator NAME [^(]*\(allowed: [^;]*; default: ground2\)/);
  const { code, stderr } = tiepoint('points', image(folder(), 'speckle.png', 96, 96, speckle), '--operator', 'multiscale', '--suppress', '5', '--cells', '4');
  assert.deepEqual([code, stderr], [0, 'tiepoint: without effect with the operator multiscale and the other options: --suppress\n']);
});
