import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { describe } from '../../pkg/command/match.js';
import { match_pair, Photo } from '../../pkg/node.js';
import { cameraWanted } from '../../pkg/pair/camera-wanted.js';
import { file, folder, image, json, samplePair, speckle, tiepoint } from './command.js';

const { at, call } = samplePair();
const truth = JSON.parse(readFileSync(join(at, 'truth.json'), 'utf8')).relative_orientation;
const result = json(...call);

test('the JSON has the counts, the matches and the orientation', () => {
  assert.deepEqual(Object.keys(result.counts.left), ['candidates', 'after_roundness', 'after_suppression']);
  assert.deepEqual(Object.keys(result.counts.right), Object.keys(result.counts.left));
  const { rejected } = result.counts;
  for (const rule of ['threshold', 'ambiguous', 'many_to_one', 'parallax']) assert.ok(Number.isInteger(rejected[rule]), rule);
  const refusals = Object.values(rejected).reduce((sum, n) => sum + Number(n), 0);
  assert.equal(result.counts.matches + refusals, result.counts.left.after_suppression, 'every left point is matched or rejected by one rule');
  assert.equal(result.matches.length, result.counts.matches);
  assert.deepEqual([...new Set(result.matches.map((/** @type {number[]} */ m) => m.length))], [5]);
  assert.ok(
    result.matches.every((/** @type {number[]} */ m) => (m[4] ?? NaN) < 3),
    'every measure is below the threshold',
  );
});

test('the orientation of the sample is the true one within its precision', () => {
  const o = result.orientation;
  assert.deepEqual(
    o.correlations.map((/** @type {number[]} */ row) => row.length),
    [5, 5, 5, 5, 5],
  );
  assert.equal(o.residuals_mm.length, result.counts.matches);
  for (const [name, limit] of Object.entries({ omega_deg: 0.05, phi_deg: 0.05, kappa_deg: 0.05, by_mm: 0.1, bz_mm: 0.15 })) {
    assert.ok(Math.abs(o[name] - truth[name]) < limit, `${name} is ${o[name]}, truth ${truth[name]}`);
    assert.ok(o.standard_errors[name] > 0);
  }
  assert.equal(result.no_orientation, null);
});

test('the same call prints the same bytes, and the files hold the same', () => {
  const out = join(at, 'out');
  const [first, second] = [tiepoint(...call, '--json', '--out', out), tiepoint(...call, '--json')];
  assert.equal(first.stdout, second.stdout);
  assert.equal(readFileSync(join(out, 'result.json'), 'utf8'), first.stdout);
  const lines = readFileSync(join(out, 'matches.csv'), 'utf8').trim().split('\n');
  assert.equal(lines.length, result.counts.matches + 1);
  assert.deepEqual(lines[1]?.split(',').slice(0, 5).map(Number), result.matches[0]);
  const states = lines.map((line) => line.split(',')[5]);
  assert.equal(states.shift(), 'state');
  assert.deepEqual(
    states.flatMap((state, index) => (state === 'rejected' ? [index] : [])),
    result.orientation.rejected,
  );
  assert.ok(result.orientation.rejected.length > 0 && new Set(states).size === 2, 'all others are used');
  assert.equal(readFileSync(join(out, 'left-points.csv'), 'utf8').trim().split('\n').length, result.counts.left.after_suppression + 1);
});

for (const [name, ...options] of [
  ['sample.csv'],
  ['sample-moments.csv', '--strategy', 'moments', '--fraction', '0.148'],
  ['sample-least-squares.csv', '--strategy', 'least-squares', '--fraction', '0.148'],
  ['sample-correlation.csv', '--strategy', 'correlation', '--refine', 'least-squares', '--epipolar', '--fraction', '0.148'],
  ['sample-gradient.csv', '--strategy', 'gradient'],
]) {
  test(`Node finds exactly the matches of ${name} that the native build finds`, () => {
    // The golden file ends with a line of the orientation.
    const golden = readFileSync(new URL(`../golden/${name}`, import.meta.url), 'utf8')
      .trimEnd()
      .split('\n');
    const { orientation: o } = json(...call, ...options, '--out', join(at, 'identity'));
    assert.equal([o.omega_deg, o.phi_deg, o.kappa_deg, o.by_mm, o.bz_mm].join(), golden.pop());
    assert.deepEqual(
      readFileSync(join(at, 'identity', 'matches.csv'), 'utf8')
        .trimEnd()
        .split('\n'),
      golden,
    );
  });
}

test('a verdict stands first: in words, in the JSON and as the exit code', () => {
  const { code, stdout, stderr } = tiepoint(...call);
  assert.deepEqual([code, result.verdict.kind, stderr], [0, 'oriented', '']);
  assert.match(
    stdout,
    /^Oriented from \d+ points, σ0 0\.\d+ px; the right photo is turned in its plane \(κ\) by 0\.\d+° ± 0\.\d+°, (φ|the direction of the base) is known to ± \d\.\d+° \(95 %\)\.\n/,
  );
  assert.ok(stdout.startsWith(result.verdict.text));
  const corner = image(folder(), 'corner.png', 450, 700, (col, row) => (col > 150 && col < 300 && row > 280 && row < 430 ? 255 : 0));
  const weak = tiepoint(...call, '--mask-left', corner, '--json');
  assert.deepEqual([weak.code, JSON.parse(weak.stdout).verdict.kind], [3, 'weak']);
});

test('an option that has no effect beside the others is told', () => {
  const { code, stderr } = tiepoint(...call, '--window', '7', '--epipolar');
  assert.equal(code, 0);
  assert.match(stderr, /without effect with the strategy gradient and the other options: --window, --epipolar/);
});

test('the options reach the matching', () => {
  const moments = [...call, '--strategy', 'moments'];
  const matches = (/** @type {string[]} */ ...options) => json(...moments, ...options).counts;
  const plain = matches();
  assert.ok(matches('--max-measure', '0.5').matches < plain.matches);
  assert.ok(matches('--ambiguity', '0.5').rejected.ambiguous > plain.rejected.ambiguous);
  assert.notEqual(matches('--denominator', 'floor').matches, plain.matches);
  assert.notEqual(json(...call, '--strategy', 'invariants').counts.matches, plain.matches);
  assert.notEqual(matches('--window', '7').matches, plain.matches);
  assert.notEqual(matches('--search', '9').matches, plain.matches);
  assert.ok(matches('--operator', 'forstner').matches > 0);
  const far = json(...moments, '--offset', '4000,0');
  assert.deepEqual([far.counts.matches, far.orientation], [0, null]);
  assert.equal(far.counts.rejected.no_candidate + far.counts.rejected.no_descriptor, far.counts.left.after_suppression);
});

test('the base scales by and bz only', () => {
  const base = call.indexOf('--base-mm') + 1;
  const doubled = json(...call.map((word, i) => (i === base ? String(2 * Number(word)) : word))).orientation;
  assert.ok(Math.abs(doubled.by_mm - 2 * result.orientation.by_mm) < 1e-6);
  assert.ok(Math.abs(doubled.kappa_deg - result.orientation.kappa_deg) < 1e-9);
});

test('without a focal length the matches stand and the orientation is null with the reason', () => {
  const [left = '', right = ''] = call.slice(1, 3);
  const bare = json('match', left, right, '--strategy', 'moments');
  assert.equal(bare.counts.matches, json(...call, '--strategy', 'moments').counts.matches);
  assert.equal(bare.orientation, null);
  assert.match(bare.no_orientation.text, /focal/i);
  assert.deepEqual([bare.verdict.kind, bare.verdict.text], ['not_oriented', `Not oriented: ${bare.no_orientation.text}.`]);
  const { code, stdout } = tiepoint('match', left, right, '--strategy', 'moments');
  assert.equal(code, 4);
  assert.match(stdout, /^Not oriented: .*focal/);
});

test('of scans with a camera and nothing that tells the size of their pixels, marks are asked for and not the camera', () => {
  const [left = '', right = ''] = call.slice(1, 3);
  const hinted = (/** @type {string[]} */ ...options) => tiepoint('match', left, right, '--strategy', 'moments', ...options).stdout;
  const camera = file(at, 'of-film.json', JSON.stringify({ focal_mm: 153 }));
  assert.match(hinted('--camera', camera), /^hint: give the fiducial marks of scans with --left-fiducials and --right-fiducials, or pixel_mm in the camera$/m);
  assert.match(hinted(), /^hint: give the camera with --camera FILE/m);
});

test('a principal point that is far from the middle of the image is the reason why nothing fits, and no pure rotation', () => {
  const [left = '', right = ''] = call.slice(1, 3);
  const camera = (/** @type {number[]} */ at_mm) => JSON.stringify({ focal_mm: 0.6, pixel_mm: 0.001, principal_point_mm: at_mm });
  const far = tiepoint('match', left, right, '--camera', file(at, 'far.json', camera([0.5, 0.1])));
  assert.equal(far.code, 4, far.stdout);
  assert.match(
    far.stdout,
    /^Not oriented: nothing fits the principal point, which lies 0\.\d+ times the longer side of the left image from its middle, where up to 0\.5 times is usual/,
  );
});

test('a focal length in px stands for a camera of pixels of 0.001 mm', () => {
  const [left = '', right = ''] = call.slice(1, 3);
  const camera = file(at, 'px.json', JSON.stringify({ focal_mm: 0.6, pixel_mm: 0.001 }));
  const [by, named] = [
    json('match', left, right, '--strategy', 'moments', '--focal-px', '600'),
    json('match', left, right, '--strategy', 'moments', '--camera', camera),
  ];
  assert.ok(by.orientation !== null && by.pixel_mm === 0.001 && by.interior.focal_mm === 0.6);
  assert.deepEqual(by, named);
  for (const [options, pattern] of /** @type {const} */ ([
    [['--focal-px', '0.5'], /--focal-px is 0\.5; allowed: 1 to 10000000/],
    [['--focal-px', '0'], /--focal-px is 0; allowed: 1 to 10000000/],
    [['--focal-px', '600', '--camera', camera], /--camera and --focal-px both give a focal length/],
  ])) {
    const { code, stderr } = tiepoint('match', left, right, ...options);
    assert.equal(code, 2);
    assert.match(stderr, pattern);
  }
});

test('gradients tell the geometry of the two views, with a camera and without', () => {
  const known = json(...call, '--strategy', 'gradient');
  assert.deepEqual([known.geometry.model.kind, known.no_geometry, known.offset_px], ['calibrated', null, null]);
  assert.ok(known.geometry.sigma_px < known.geometry.threshold_px && known.geometry.threshold_px < 2);
  assert.equal(known.settings.points.operator, 'multiscale');
  assert.match(tiepoint(...call, '--strategy', 'gradient').stdout, /geometry of the two views: orientation of calibrated cameras, standard error 0\.\d+ px/);
  assert.equal(json(...call, '--strategy', 'moments').geometry, null);
  const flat = image(folder(), 'flat.png', 80, 60, () => 50);
  const none = json('match', flat, flat, '--strategy', 'gradient');
  assert.deepEqual([none.counts.matches, none.geometry], [0, null]);
  assert.equal(typeof none.no_geometry.text, 'string');
});

/** Files that name no camera. */
const NO_CAMERAS = { names: ['left.png', 'right.png'], cameras: [null, null] };

test('where one of two files names a camera the hint gives its focal length for the other, which is named', () => {
  const [left, right] = call.slice(1, 3).map((path) => Photo.decode(readFileSync(path)));
  assert.ok(left && right);
  const output = match_pair(left, right, {}, {});
  assert.deepEqual([output.verdict.kind, cameraWanted(output.verdict)], ['not_oriented', 'given']);
  const camera = { make: null, model: null, focal_mm: 4, pixel_mm: 0.004 };
  const hint = (/** @type {readonly (object | null)[]} */ cameras) =>
    describe(output, null, {}, /** @type {Parameters<typeof describe>[3]} */ ({ ...NO_CAMERAS, cameras }))[1];
  assert.equal(hint([camera, null]), 'hint: right.png names no camera; if it is that of left.png, give --focal-px 1000.0, or the camera with --camera FILE');
  assert.match(hint([null, camera]) ?? '', /^hint: left\.png names no camera; if it is that of right\.png/);
  for (const cameras of [
    [null, null],
    [camera, camera],
  ])
    assert.match(hint(cameras) ?? '', /^hint: give the camera with --camera FILE, or its focal length alone/);
});

test('cameras whose focal length the matches gave are not called calibrated', () => {
  const [left, right] = call.slice(1, 3).map((path) => Photo.decode(readFileSync(path)));
  assert.ok(left && right);
  const output = match_pair(left, right, {}, {});
  const { geometry } = output.match;
  assert.ok(geometry);
  const model = { ...geometry.model, kind: 'calibrated' };
  const line = (/** @type {object | null} */ focal) => {
    const told = /** @type {typeof output} */ ({ ...output, match: { ...output.match, geometry: { ...geometry, model, focal } } });
    return describe(told, null, {}, NO_CAMERAS).find((text) => text.startsWith('geometry of the two views: '));
  };
  assert.match(line(null) ?? '', /: orientation of calibrated cameras, standard error/);
  assert.match(line({ focal_px: 600, standard_error_px: 5 }) ?? '', /: cameras with the focal length estimated from the matches, standard error/);
});

test('photos that hardly match are told so, whether a camera is given or not', () => {
  const [left = '', right = ''] = call.slice(1, 3);
  for (const pair of [call, ['match', left, right]]) {
    const { verdict } = json(...pair, '--strategy', 'moments', '--offset', '4000,0');
    assert.deepEqual(verdict.no_orientation, { kind: 'too_few_matches', matches: 0, needed: 5 });
    assert.match(verdict.text, /^Not oriented: no match was found, and an orientation takes at least 5/);
  }
});

test('where windows do not match it is told what the photos differ by, in words and figures', () => {
  const right = Photo.decode(readFileSync(call[2] ?? ''));
  const [width, height, grey] = [right.width, right.height, right.grey()];
  const back = image(at, 'upside-down.png', width, height, (col, row) => grey[(height - 1 - row) * width + width - 1 - col] ?? 0);
  const turned = json('match', call[1] ?? '', back, '--strategy', 'moments', '--focal-px', '600');
  assert.notEqual(turned.verdict.kind, 'oriented');
  assert.equal(turned.hint.kind, 'turned');
  assert.ok(Math.abs(Math.abs(turned.hint.turn_deg) - 180) < 1 && Math.abs(turned.hint.scale - 1) < 0.05, JSON.stringify(turned.hint));
  assert.match(turned.hint.text, /turned in its plane by -?1(79|80)°.*Use the strategy “auto”/);
  const found = json(...call, '--strategy', 'moments').offset_px;
  const displaced = json(...call, '--strategy', 'moments', '--offset', '4000,0');
  assert.deepEqual([displaced.hint.kind, displaced.hint.expected_dx_px, displaced.hint.most_px], ['displaced', 4000, 12.5]);
  assert.ok(Math.hypot(displaced.hint.dx_px - found[0], displaced.hint.dy_px - found[1]) < 10, JSON.stringify([displaced.hint, found]));
  const told = tiepoint(...call, '--strategy', 'moments', '--offset', '4000,0').stdout;
  assert.ok(told.includes(`\nhint: ${displaced.hint.text}\n`), told);
  assert.equal(result.hint, null);
});

test('the outcome of gradients is the same for any number of workers, oriented or not', () => {
  const [left = '', right = ''] = call.slice(1, 3);
  const flat = image(folder(), 'flat.png', 80, 60, () => 50);
  const half = image(at, 'half-mask.png', 450, 700, (col) => (col < 225 ? 0 : 255));
  for (const pair of [
    [...call, '--mask-left', half],
    ['match', left, right],
    ['match', left, right, '--focal-px', '600', '--offset', '5,5'],
    ['match', flat, flat],
  ]) {
    const outcomes = ['1', '2', '3'].map((workers) => tiepoint(...pair, '--strategy', 'gradient', '--workers', workers, '--json'));
    assert.equal(new Set(outcomes.map(({ code }) => code)).size, 1, outcomes[1]?.stderr);
    assert.ok([0, 3, 4].includes(outcomes[0]?.code ?? 1), outcomes[0]?.stderr);
    assert.equal(new Set(outcomes.map(({ stdout }) => stdout)).size, 1, pair.join(' '));
  }
  const { code, stderr } = tiepoint(...call, '--strategy', 'gradient', '--workers', '2', '--number', '1000', '--threshold-px', '1e9');
  assert.equal(code, 2);
  assert.match(stderr, /--threshold-px is 1e9; allowed/);
});

test('what lies at the same place of both frames is left out, and kept where that is wanted', () => {
  const [left = '', right = ''] = call.slice(1, 3);
  const [border, shift] = [30, 60];
  // Both pictures within the same border, one shifted in it.
  const framed = (/** @type {string} */ path, /** @type {string} */ name, /** @type {number} */ from) => {
    const photo = Photo.decode(readFileSync(path));
    const [width, height, whole] = [photo.width - shift, photo.height, photo.width];
    const grey = photo.grey();
    photo.free();
    const isBorder = (/** @type {number} */ col, /** @type {number} */ row) => Math.min(col, row, width - 1 - col, height - 1 - row) < border;
    return image(at, name, width, height, (col, row) => (isBorder(col, row) ? speckle(col >> 2, row >> 2) : (grey[row * whole + col + from] ?? 0)));
  };
  const scans = ['match', framed(left, 'framed-left.png', 0), framed(right, 'framed-right.png', shift), '--strategy', 'gradient'];
  const [without, kept] = [json(...scans), json(...scans, '--keep-frame')];
  assert.deepEqual([without.settings.matching.without_frame, kept.settings.matching.without_frame], [true, false]);
  const atSamePlace = (/** @type {{ matches: number[][] }} */ { matches }) =>
    matches.filter(([xl = 0, yl = 0, xr = 0, yr = 0]) => Math.hypot(xl - xr, yl - yr) < 2).length;
  assert.ok(without.counts.rejected.frame > 500 && without.counts.matches > 500, JSON.stringify(without.counts));
  assert.equal(atSamePlace(without), 0);
  assert.equal(kept.counts.rejected.frame, 0);
  assert.ok(atSamePlace(kept) > 500, 'the border matches by itself, and outvotes the pictures');
});

test('a report shows what its masks leave out', () => {
  const half = image(at, 'half-report.png', 450, 700, (col) => (col < 225 ? 0 : 255));
  const { file: page, verdict } = json('report', ...call.slice(1), '--mask-left', half, '--fraction', '0.02', '--out', join(at, 'report'));
  assert.deepEqual(verdict, json(...call, '--mask-left', half).verdict);
  const html = readFileSync(page, 'utf8');
  assert.match(html, /A mask leaves out 50\.0 % of the left image\./);
  assert.equal(html.match(/class="left-out"/g)?.length, 1);
  const small = image(at, 'small-report.png', 45, 70, () => 255);
  const { code, stderr } = tiepoint('report', ...call.slice(1), '--mask-right', small, '--out', join(at, 'report'));
  assert.equal(code, 1);
  assert.match(stderr, /small-report\.png: mask is 45 x 70 px; allowed: the image's 450 x 700 px/);
});

test('masks leave points out of their image, and have its size', () => {
  const half = image(at, 'half.png', 450, 700, (col) => (col < 225 ? 0 : 255));
  for (const strategy of ['moments', 'gradient']) {
    const out = join(at, `masked-${strategy}`);
    const { counts } = json(...call, '--strategy', strategy, '--mask-left', half, '--out', out);
    const columns = (/** @type {string} */ name) =>
      readFileSync(join(out, name), 'utf8')
        .trim()
        .split('\n')
        .slice(1)
        .map((line) => Number(line.split(',')[0]));
    assert.ok(counts.left.after_suppression > 500 && columns('left-points.csv').every((x) => x >= 225), strategy);
    assert.ok(
      columns('right-points.csv').some((x) => x < 225),
      strategy,
    );
    assert.ok(counts.matches > 200, strategy);
  }
  const small = image(at, 'small.png', 45, 70, () => 255);
  const { code, stderr } = tiepoint(...call, '--mask-right', small);
  assert.equal(code, 1);
  assert.match(stderr, /small\.png: mask is 45 x 70 px; allowed: the image's 450 x 700 px/);
});

test('images without overlap, identical images and flat images end well', () => {
  const other = folder();
  const flat = image(other, 'flat.png', 80, 60, () => 50);
  const a = image(other, 'a.png', 80, 60, speckle);
  const b = image(other, 'b.png', 80, 60, (col, row) => speckle(col + 1000, row));
  assert.equal(json('match', flat, flat).counts.matches, 0);
  for (const strategy of ['moments', 'gradient']) {
    const same = json('match', a, a, '--strategy', strategy);
    assert.ok(same.matches.length > 0 && same.matches.every((/** @type {number[]} */ [xl, yl, xr, yr]) => xl === xr && yl === yr));
  }
  assert.equal(json('match', a, b, '--offset', '0,0', '--strategy', 'moments').orientation, null);
  assert.deepEqual([json('match', a, b).verdict.kind, json('match', a, a, '--focal-px', '80').verdict.kind], ['not_oriented', 'not_oriented']);
});

test('the table shows both images, every rule and the orientation', () => {
  const { code, stdout, stderr } = tiepoint(...call);
  assert.deepEqual([code, stderr], [0, '']);
  assert.match(stdout, new RegExp(`^candidates +${result.counts.left.candidates} +${result.counts.right.candidates}$`, 'm'));
  assert.match(stdout, new RegExp(`^rejected: Many to one +${result.counts.rejected.many_to_one}$`, 'm'));
  assert.match(stdout, /sigma0 [\d.]+ mm = [\d.]+ px/);
});
