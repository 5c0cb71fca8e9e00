import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { describeOrientation } from '../../pkg/command/orient.js';
import { orient_relative, parse_observations } from '../../pkg/node.js';
import { file, folder, json, speckle, tiepoint } from './command.js';

const at = folder();
const FOCAL = 153.38;
const BASE = 92;
const TRUTH = { omega_deg: 0.9, phi_deg: -0.4, kappa_deg: 1.2, by_mm: -2.1, bz_mm: 0.7 };
const NAMES = /** @type {const} */ (['omega_deg', 'phi_deg', 'kappa_deg', 'by_mm', 'bz_mm']);

/** M = M3(kappa) M2(phi) M1(omega), by its product.  @returns {number[][]} */
function rotation() {
  const [o, p, k] = [TRUTH.omega_deg, TRUTH.phi_deg, TRUTH.kappa_deg].map((deg) => (deg * Math.PI) / 180);
  const [so = 0, co = 0, sp = 0, cp = 0, sk = 0, ck = 0] = [o, p, k].flatMap((a = 0) => [Math.sin(a), Math.cos(a)]);
  const product = (/** @type {number[][]} */ a, /** @type {number[][]} */ b) =>
    a.map((row) => [0, 1, 2].map((c) => row.reduce((s, v, i) => s + v * (b[i]?.[c] ?? 0), 0)));
  const m1 = [
    [1, 0, 0],
    [0, co, so],
    [0, -so, co],
  ];
  const m2 = [
    [cp, 0, -sp],
    [0, 1, 0],
    [sp, 0, cp],
  ];
  const m3 = [
    [ck, sk, 0],
    [-sk, ck, 0],
    [0, 0, 1],
  ];
  return product(m3, product(m2, m1));
}

/** Photo coordinates of `count` points on relief; `noise(i)` is added to the right y.  @param {number} count @param {(i: number) => number} noise */
function observations(count, noise = () => 0) {
  const m = rotation();
  const lines = Array.from({ length: count }, (_, i) => {
    const [u, v, w] = [0, 1, 2].map((k) => speckle(i, k) / 255);
    const depth = FOCAL * (0.9 + 0.2 * (w ?? 0));
    const [xl, yl] = [100 * (u ?? 0) - 10, 180 * (v ?? 0) - 90];
    const point = [(xl * depth) / FOCAL - BASE, (yl * depth) / FOCAL - TRUTH.by_mm, -depth - TRUTH.bz_mm];
    const [px = 0, py = 0, pz = 1] = m.map((row) => row.reduce((s, r, k) => s + r * (point[k] ?? 0), 0));
    return [xl, yl, (-FOCAL * px) / pz, (-FOCAL * py) / pz + noise(i)].join(',');
  });
  return ['x_left_mm,y_left_mm,x_right_mm,y_right_mm', ...lines].join('\n');
}

const CALL = ['--focal-mm', String(FOCAL), '--base-mm', String(BASE)];

test('exact observations give the orientation back', () => {
  for (const options of [[], ['--method', 'determinant'], ['--no-robust'], ['--method', 'determinant', '--no-robust']]) {
    const result = json('orient', file(at, 'exact.csv', observations(40)), ...CALL, ...options);
    for (const name of NAMES) assert.ok(Math.abs(result[name] - TRUTH[name]) < 1e-7, `${name} ${result[name]} with ${options.join(' ')}`);
    assert.equal(result.degrees_of_freedom, 35);
    assert.deepEqual(result.rejected, []);
  }
});

test('a base that is not given is the median x-parallax, as in JavaScript, and none of 0 is taken', () => {
  const table = file(at, 'exact.csv', observations(40));
  const lines = readFileSync(table, 'utf8').split('\n').slice(1);
  const parallaxes = lines.map((line) => line.split(',').map(Number)).map(([xl = 0, , xr = 0]) => xl - xr);
  const sorted = parallaxes.toSorted((a, b) => a - b);
  const found = json('orient', table, '--focal-mm', String(FOCAL));
  assert.ok(Math.abs(found.base_mm - ((sorted[19] ?? 0) + (sorted[20] ?? 0)) / 2) < 1e-9, `${found.base_mm}`);
  const scale = found.base_mm / BASE;
  for (const name of NAMES) assert.ok(Math.abs(found[name] - TRUTH[name] * (name.endsWith('mm') ? scale : 1)) < 1e-7, `${name} ${found[name]}`);
  const { focal_mm, base_mm } = orient_relative(parse_observations(readFileSync(table, 'utf8')), FOCAL, {});
  assert.deepEqual([found.focal_mm, found.base_mm], [focal_mm, base_mm]);
  const refused = tiepoint('orient', table, '--focal-mm', String(FOCAL), '--base-mm', '0');
  assert.equal(refused.code, 2);
  assert.match(refused.stderr, /--base-mm is 0; allowed: -1000000 to 1000000, but not 0\n$/);
  const help = tiepoint('orient', '--help').stdout.replace(/\s+/g, ' ');
  assert.match(help, /--base-mm MM The length b of the base at photo scale, not 0,/);
  assert.match(help, /--focal-mm is required\./);
});

test('turned axes are named where angles are', () => {
  const found = json('orient', file(at, 'turned.csv', observations(40)), ...CALL);
  const text = (/** @type {number} */ turn) => describeOrientation({ ...found, turn_deg: turn }, null).join('\n');
  assert.match(text(90), /\naxes turned by 90°: x points up in the left image\n/);
  assert.doesNotMatch(text(0), /turned/);
});

test('the JSON has precision, correlations and residuals', () => {
  const result = json(
    'orient',
    file(
      at,
      'noisy.csv',
      observations(40, (i) => (speckle(i, 9) / 255 - 0.5) * 0.02),
    ),
    ...CALL,
  );
  assert.ok(result.sigma0_mm > 0.001 && result.sigma0_mm < 0.02, `sigma0 ${result.sigma0_mm}`);
  assert.deepEqual(Object.keys(result.standard_errors), [...NAMES]);
  for (const name of NAMES) assert.ok(result.standard_errors[name] > 0 && Math.abs(result[name] - TRUTH[name]) < 5 * result.standard_errors[name], name);
  assert.deepEqual(
    result.correlations.map((/** @type {number[]} */ row) => row.length),
    [5, 5, 5, 5, 5],
  );
  for (let i = 0; i < 5; i++) assert.ok(Math.abs(result.correlations[i][i] - 1) < 1e-9);
  assert.deepEqual(
    result.residuals_mm.map((/** @type {number[]} */ row) => row.length),
    Array(40).fill(4),
  );
  assert.ok(result.iterations >= 1);
});

test('gross errors are rejected by their indices; plain least squares keeps them', () => {
  const path = file(
    at,
    'blunders.csv',
    observations(60, (i) => (i % 10 === 3 ? 4 + i / 10 : (speckle(i, 9) / 255 - 0.5) * 0.01)),
  );
  const robust = json('orient', path, ...CALL);
  assert.deepEqual(
    robust.rejected.filter((/** @type {number} */ i) => i % 10 === 3),
    [3, 13, 23, 33, 43, 53],
  );
  assert.ok(Math.abs(robust.kappa_deg - TRUTH.kappa_deg) < 0.02);
  const plain = tiepoint('orient', path, ...CALL, '--no-robust', '--json');
  assert.ok([0, 3, 4].includes(plain.code ?? 1), plain.stderr);
  assert.deepEqual(JSON.parse(plain.stdout).rejected ?? [], []);
});

test('too few observations and points on a line are not oriented, with the reason', () => {
  const few = tiepoint('orient', file(at, 'few.csv', observations(4)), ...CALL);
  assert.deepEqual([few.code, few.stderr], [4, '']);
  assert.match(few.stdout, /^Not oriented: .*4 given; at least 5/);
  const { verdict, ...rest } = json('orient', file(at, 'few.csv', observations(4)), ...CALL);
  assert.deepEqual([verdict.kind, verdict.no_orientation.error.got, rest], ['not_oriented', 4, {}]);
  const line = ['x_left_mm,y_left_mm,x_right_mm,y_right_mm', ...Array.from({ length: 20 }, (_, i) => `${i},0,${i - BASE},0`)].join('\n');
  const degenerate = tiepoint('orient', file(at, 'line.csv', line), ...CALL);
  assert.equal(degenerate.code, 4, degenerate.stderr);
  assert.match(degenerate.stdout, /^Not oriented: [^\n]+\n$/);
});

test('what the crate refuses has the name of its option', () => {
  const { code, stderr } = tiepoint('orient', file(at, 'small.csv', observations(20)), '--focal-mm', '0.00001', '--base-mm', '92');
  assert.deepEqual([code, stderr], [2, 'tiepoint: --focal-mm is 0.00001; allowed: 0.001 to 100000\n']);
});

test('the verdict stands first, in the JSON and as the exit code', () => {
  const noisy = (/** @type {number} */ count) =>
    file(
      at,
      `noisy-${count}.csv`,
      observations(count, (i) => (speckle(i, 9) / 255 - 0.5) * 0.02),
    );
  const { code, stdout } = tiepoint('orient', noisy(40), ...CALL);
  assert.match(stdout, /^Oriented from 40 points, σ0 \d+(\.\d+)? µm; the right photo is turned in its plane \(κ\) by 1\.\d+°/);
  const { verdict } = json('orient', noisy(40), ...CALL);
  assert.deepEqual([code, verdict.kind, verdict.sigma0_px], [0, 'oriented', null]);
  assert.ok(stdout.startsWith(`${verdict.text}\n`));
  const weak = json('orient', noisy(6), ...CALL, '--no-robust');
  assert.equal(weak.verdict.kind, 'weak');
  assert.ok(weak.warnings.some((/** @type {{ kind: string }} */ { kind }) => kind === 'unchecked'));
  assert.equal(tiepoint('orient', noisy(6), ...CALL, '--no-robust').code, 3);
});

test('a base of an absurd length is doubted, one at photo scale and a minus are not', () => {
  const from = file(at, 'exact.csv', observations(40));
  const doubt = (/** @type {string} */ base) =>
    json('orient', from, '--focal-mm', String(FOCAL), '--base-mm', base).warnings.filter(
      (/** @type {{ kind: string }} */ { kind }) => kind === 'doubtful_base',
    );
  assert.deepEqual([doubt(String(BASE)), doubt('-92'), doubt('9.2')], [[], [], []]);
  const [found] = doubt('100000');
  assert.ok(Math.abs(found.times / (100000 / BASE) - 1) < 0.1, JSON.stringify(found));
  assert.match(found.text, /^The given base of 100000 mm is 1\d00 times as long as that at photo scale/);
  const [positive, negative] = ['92', '-92'].map((base) => json('orient', from, '--focal-mm', String(FOCAL), '--base-mm', base));
  assert.deepEqual(negative, positive);
});

test('the table shows values with their standard errors', () => {
  const { code, stdout } = tiepoint('orient', file(at, 'exact.csv', observations(40)), ...CALL);
  assert.equal(code, 0);
  assert.match(stdout, /kappa \[deg\] +1\.2000 +0\.0000/);
  assert.match(stdout, /35 degrees of freedom/);
});

test('object points are written with their standard errors', () => {
  const from = file(
    at,
    'noisy-points.csv',
    observations(40, (i) => 0.01 * (speckle(i, 7) / 255 - 0.5)),
  );
  const rowsOf = (/** @type {string[]} */ ...more) => {
    const out = join(folder(), 'points.csv');
    assert.equal(tiepoint('orient', from, ...CALL, '--points', out, ...more).code, 0);
    const [names = '', ...lines] = readFileSync(out, 'utf8').trimEnd().split('\n');
    assert.equal(names, 'point,x,y,z,sigma_x,sigma_y,sigma_z,use');
    assert.equal(lines.length, 40);
    return lines.map((line) => line.split(','));
  };
  const [unit, metres] = [rowsOf(), rowsOf('--base-length', '500')];
  for (const [k, row] of unit.entries()) {
    assert.equal(row[0], String(k));
    for (let c = 1; c < 7; c++) assert.ok(Math.abs(500 * Number(row[c]) - Number(metres[k]?.[c])) < 1e-6 * Math.abs(Number(metres[k]?.[c])), row.join());
    assert.ok(Number(row[3]) < 0 && Number(row[6]) > 0 && row[7] === 'used', row.join());
  }
  assert.equal(tiepoint('orient', from, ...CALL, '--base-length', '500').code, 2);
  assert.equal(tiepoint('orient', from, ...CALL, '--points', join(folder(), 'p.csv'), '--base-length', '0').code, 2);
});

test('observations of which most are grossly wrong are weak by their σ0, not by the base that it hides', () => {
  let weak = 0;
  for (let set = 0; set < 4; set++) {
    const from = file(
      at,
      'wild.csv',
      observations(20, (i) => (i < 12 ? 6 * (speckle(i, 20 + set) / 255 - 0.5) : 0.01 * (speckle(i, 7) / 255 - 0.5))),
    );
    const { code, stdout } = tiepoint('orient', from, ...CALL, '--json');
    const { verdict, sigma0_mm: sigma0 } = JSON.parse(stdout);
    if (!(sigma0 > FOCAL / 300)) continue;
    weak += 1;
    assert.deepEqual([code, verdict.kind, verdict.warning.kind], [3, 'weak', 'coarse']);
    assert.match(verdict.text, /σ0 is \d+ µm, where measuring reaches 510 µm at this focal length/);
  }
  assert.ok(weak > 0, 'no set has a σ0 so large');
});

test('copies of observations do not count in the verdict', () => {
  const once = observations(20, (i) => 0.01 * (speckle(i, 7) / 255 - 0.5));
  const five = [once, ...Array.from({ length: 4 }, () => once.split('\n').slice(1).join('\n'))].join('\n');
  const { verdict, points } = json('orient', file(at, 'copies.csv', five), ...CALL);
  assert.deepEqual([verdict.kind, verdict.points, points.length], ['oriented', 20, 100]);
  assert.match(verdict.text, /Oriented from 20 points/);
});
