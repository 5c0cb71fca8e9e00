import assert from 'node:assert/strict';
import { test } from 'node:test';
import { json, samplePair, tiepoint } from './command.js';

const { call } = samplePair();
/** @param {string[]} options */
const run = (...options) => json(...call, ...options);
const BY_MOMENTS = ['--strategy', 'moments'];
const moments = run(...BY_MOMENTS);

test('the truth of the sample scores every strategy', () => {
  const shares = Object.fromEntries(
    ['moments', 'invariants', 'correlation', 'least-squares', 'gradient'].map((strategy) => {
      const { counts, score, orientation } = run('--strategy', strategy);
      assert.equal(score.matches, counts.matches);
      assert.equal(score.rightness.length, counts.matches);
      assert.ok(score.strict <= score.right && score.right <= score.matches);
      assert.ok(score.missed > 0 && score.right + score.missed <= counts.left.after_suppression);
      for (const name of ['omega_deg', 'phi_deg', 'kappa_deg', 'by_mm', 'bz_mm']) {
        assert.ok(Math.abs(score.errors[name]) < 5 * orientation.total_standard_errors[name], `${strategy}: ${name} ${score.errors[name]}`);
      }
      return [strategy, score.right_share];
    }),
  );
  assert.ok(shares['least-squares'] > 0.97 && shares['least-squares'] > shares.moments, JSON.stringify(shares));
});

test('every left point has one verdict with any strategy', () => {
  for (const options of [
    ['--strategy', 'correlation'],
    ['--strategy', 'least-squares'],
    ['--refine', 'least-squares'],
    ['--strategy', 'gradient'],
  ]) {
    const { counts } = run(...options);
    const refused = Object.values(counts.rejected).reduce((sum, n) => sum + Number(n), 0);
    assert.equal(counts.matches + refused, counts.left.after_suppression, options.join(' '));
  }
});

test('a refinement moves right positions between pixels and makes σ₀ smaller', () => {
  const refined = run(...BY_MOMENTS, '--refine', 'least-squares');
  assert.ok(refined.orientation.sigma0_mm < 0.5 * moments.orientation.sigma0_mm);
  assert.equal(moments.fits, null);
  assert.equal(refined.fits.length, refined.counts.matches);
  assert.ok(refined.counts.rejected.not_converged > 0);
  assert.ok(refined.matches.some((/** @type {number[]} */ m) => (m[2] ?? 0) % 0.5 !== 0));
});

test('with nothing set all matches of gradients stay, and those that least squares matching confirms are refined', () => {
  const [auto, gradient] = [run('--no-fill-in'), run('--strategy', 'gradient')];
  assert.equal(auto.counts.matches, gradient.counts.matches);
  const filled = run();
  assert.ok(filled.counts.matches > 1.4 * auto.counts.matches && filled.score.right_share > 0.98, `${filled.counts.matches}, ${filled.score.right_share}`);
  const confirmed = auto.fits.filter((/** @type {number[] | null} */ fit) => fit !== null);
  assert.ok(confirmed.length > 0.5 * auto.counts.matches && confirmed.length < auto.counts.matches);
  assert.ok(auto.orientation.sigma0_mm < 0.7 * gradient.orientation.sigma0_mm);
});

test('the limits of the strategies act', () => {
  const correlation = run('--strategy', 'correlation').counts;
  assert.ok(run('--strategy', 'correlation', '--min-correlation', '0.9').counts.matches < correlation.matches);
  assert.equal(run('--strategy', 'correlation', '--no-left-right').counts.rejected.left_right, 0);
  assert.ok(correlation.rejected.left_right > 0 && correlation.rejected.border > 0);
  const adjusted = run('--strategy', 'least-squares').counts;
  assert.ok(run('--strategy', 'least-squares', '--max-standard-error', '0.05').counts.rejected.imprecise > adjusted.rejected.imprecise);
  assert.notEqual(run('--strategy', 'least-squares', '--template', '21').counts.matches, adjusted.matches);
});

test('matching along epipolar lines needs a camera and finds more that is right', () => {
  const along = run(...BY_MOMENTS, '--epipolar');
  assert.ok(along.score.right > moments.score.right && along.score.right_share > moments.score.right_share);
  const { code, stdout, stderr } = tiepoint(...call.slice(0, 3), ...BY_MOMENTS, '--epipolar', '--base-mm', '92', '--json');
  assert.equal(code, 4);
  assert.deepEqual(JSON.parse(stdout).matches, json(...call.slice(0, 3), ...BY_MOMENTS).matches);
  assert.equal(stderr, 'tiepoint: without effect, since the camera is not known: --epipolar, --base-mm\n');
});

test('the statistics follow the options', () => {
  const { orientation } = moments;
  assert.equal(orientation.points.length, moments.counts.matches);
  assert.ok(orientation.points.every((/** @type {number[]} */ p) => p.length === 9));
  const strict = run(...BY_MOMENTS, '--alpha0', '0.05').orientation;
  assert.ok(strict.rejected.length > orientation.rejected.length);
  const detectable = (/** @type {any} */ o) =>
    o.points.map((/** @type {number[]} */ p) => p[3]).sort((/** @type {number} */ a, /** @type {number} */ b) => a - b)[100];
  assert.ok(detectable(run(...BY_MOMENTS, '--beta0', '0.95').orientation) > detectable(orientation));
  assert.equal(orientation.global_test, null);
  // A known σ₀ that is too small fails the test and rejects no more than the estimated one; a large one rejects less.
  const [small, large] = ['0.01', '0.3'].map((sigma) => run(...BY_MOMENTS, '--sigma0-mm', sigma).orientation);
  assert.deepEqual([small.global_test.passed, large.global_test.passed], [false, false]);
  assert.ok(small.global_test.statistic > small.global_test.upper && large.global_test.statistic < large.global_test.lower);
  assert.deepEqual(small.rejected, orientation.rejected);
  assert.ok(large.rejected.length < orientation.rejected.length);
  assert.notDeepEqual(run(...BY_MOMENTS, '--weighting', 'huber').orientation.by_mm, orientation.by_mm);
});

test('bad values are usage errors that name what is allowed', () => {
  const pair = call.slice(0, 3);
  for (const [options, pattern] of /** @type {const} */ ([
    [['--strategy', 'sift'], /--strategy is sift; allowed: auto, moments, invariants, correlation, least-squares, gradient/],
    [['--refine', 'yes'], /--refine is yes; allowed: none, least-squares/],
    [['--template', '12'], /--template is 12; allowed: odd whole numbers from 5 to 63/],
    [['--min-correlation', '2'], /--min-correlation is 2; allowed: -1 to 1/],
    [['--alpha0', '0'], /--alpha0 is 0; allowed/],
    [['--weighting', 'cauchy'], /--weighting is cauchy; allowed: none, huber, danish/],
    [['--truth', '/nowhere'], /nowhere/],
  ])) {
    const { code, stdout, stderr } = tiepoint(...pair, ...options);
    assert.ok(code === 2 || code === 1, stderr);
    assert.equal(stdout, '');
    assert.match(stderr, pattern);
    assert.equal(stderr.trimEnd().split('\n').length, 1);
  }
});

test("ready-made settings stand under other options, and the paper's are those of moments", () => {
  const paper = run('--preset', 'zahran-2007');
  assert.equal(paper.settings.matching.strategy, 'moments');
  assert.deepEqual([paper.settings.points.threshold, paper.settings.window.side, paper.settings.matching.search], [40, 11, 25]);
  assert.ok(paper.counts.matches > 100, JSON.stringify(paper.counts));
  const many = run('--preset', 'many-points', '--template', '15');
  assert.deepEqual([many.settings.multiscale.number, many.settings.matching.template], [20_000, 15]);
  const wide = run('--preset', 'little-in-common');
  assert.equal(wide.settings.matching.template, 21);
  const { code, stderr } = tiepoint(...call, '--preset', 'city');
  assert.equal(code, 2);
  assert.match(stderr, /--preset is city; allowed: many-points, little-in-common, zahran-2007/);
});
