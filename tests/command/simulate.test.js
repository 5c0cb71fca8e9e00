import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { test } from 'node:test';
import { programWords } from '../../pkg/command/program.js';
import { folder, json, PROGRAM, tiepoint } from './command.js';

const SMALL = ['--width-px', '200', '--height-px', '220'];
const OTHER = ['--width-px', '200', '--height-px', '210'];

/** @param {string[]} options */
const made = (...options) => madeOf(SMALL, ...options);

/** @param {string[]} size @param {string[]} options */
function madeOf(size, ...options) {
  const at = folder();
  const { files, match } = json('simulate', '--out', at, ...size, ...options);
  return { at, files, match: match.slice(1) };
}

test('a flight is written with everything that the match command needs', () => {
  const { files, match } = made();
  assert.deepEqual(Object.keys(files), ['left', 'right', 'left_fiducials', 'right_fiducials', 'camera', 'truth', 'map', 'visible']);
  assert.equal(readFileSync(files.map).length, 200 * 220 * 8);
  const result = json(...match);
  assert.ok(result.score.right_share > 0.8, `${result.score.right_share}`);
  assert.ok(result.orientation.total_standard_errors.kappa_deg > result.orientation.standard_errors.kappa_deg);
});

test('the same options give the same bytes, another seed another pair', () => {
  const [one, two, other] = [made('--seed', '5'), made('--seed', '5'), made('--seed', '6')];
  for (const key of Object.keys(one.files)) assert.deepEqual(readFileSync(one.files[key]), readFileSync(two.files[key]), key);
  assert.notDeepEqual(readFileSync(one.files.left), readFileSync(other.files.left));
});

test('presets and parameters reach the flight', () => {
  const { at } = made('--preset', 'hard', '--omega-deg', '1.5');
  const truth = JSON.parse(readFileSync(join(at, 'truth.json'), 'utf8'));
  assert.equal(truth.relative_orientation.omega_deg, 1.5);
  assert.equal(truth.flight.omega_deg, 1.5);
  assert.ok(truth.flight.noise_grey >= 6 && truth.flight.relief_m >= 20 && truth.flight.highest_building_m >= 28);
});

test('a flight that cannot be flown is refused by name', () => {
  for (const [options, pattern] of /** @type {const} */ ([
    [['--relief-m', '400'], /relief/],
    [['--noise-grey', 'much'], /--noise-grey is much; allowed: a number/],
    [['--preset', 'easy'], /--preset is easy; allowed: sample, paper, hard, lively/],
    [['--width-px', '4000'], /overlap|columns|width/i],
    [['--base-mm', '200', '--width-px', '450'], /--width-px is 450; allowed: 16 to 118$/],
  ])) {
    const { code, stderr } = tiepoint(
      'simulate',
      '--out',
      folder(),
      ...SMALL.filter((_, i) => !options.some((option) => option === '--width-px') || i > 1),
      ...options,
    );
    assert.ok(code === 1 || code === 2, stderr);
    assert.match(stderr.trimEnd(), pattern);
    assert.doesNotMatch(stderr, /flight\./);
  }
  assert.match(tiepoint('simulate').stderr, /--out is missing/);
});

test('a truth that does not fit, or is damaged, is refused by name', () => {
  const { at, match } = made();
  const other = madeOf(OTHER);
  const place = match.indexOf('--truth') + 1;
  const against = (/** @type {string} */ truth) =>
    tiepoint(...match.map((/** @type {string} */ word, /** @type {number} */ i) => (i === place ? truth : word)));
  assert.match(against(join(other.at, 'truth.json')).stderr, /200 x 210 px; the left image has 200 x 220/);
  writeFileSync(join(at, 'map_row_col.f32'), 'short');
  assert.match(against(at).stderr, /map_row_col\.f32: it has 5 bytes; allowed: 352000/);
  writeFileSync(join(at, 'truth.json'), '{}');
  assert.match(against(at).stderr, /relative_orientation\.omega_deg is missing/);
});

test('a truth is taken for its own pair alone, in its own order', () => {
  const { at, files, match } = made();
  const truth = ['--truth', at];
  assert.match(tiepoint('match', files.right, files.left, ...truth).stderr, /the truth is of this pair in the other order/);
  const other = made('--seed', '7');
  const refused = tiepoint('report', files.left, other.files.right, ...truth, '--out', at);
  assert.equal(refused.code, 1);
  assert.match(
    refused.stderr,
    /the truth is of another pair: the grey values of the right image have the SHA-256 digest [0-9a-f]{12}…; allowed: [0-9a-f]{12}…/,
  );
  // A truth without digests is taken by its size.
  const path = join(at, 'truth.json');
  const json_ = JSON.parse(readFileSync(path, 'utf8'));
  delete json_.left.grey_sha256;
  delete json_.right;
  writeFileSync(path, JSON.stringify(json_));
  assert.ok(json(...match).score.right_share > 0.8);
  writeFileSync(path, JSON.stringify({ ...json_, left: { grey_sha256: 'none' } }));
  assert.match(tiepoint(...match).stderr, /left\.grey_sha256 must be 64 hexadecimal digits/);
});

test('true errors of by and bz are at the scale of the base that was used', () => {
  const { match } = made();
  const place = match.indexOf('--base-mm') + 1;
  const [own, double] = [1, 2].map((factor) =>
    json(...match.map((/** @type {string} */ word, /** @type {number} */ i) => (i === place ? String(factor * Number(word)) : word))),
  );
  for (const [name, scale] of /** @type {const} */ ([
    ['omega_deg', 1],
    ['kappa_deg', 1],
    ['by_mm', 2],
    ['bz_mm', 2],
  ])) {
    assert.ok(Math.abs(double.score.errors[name] - scale * own.score.errors[name]) < 1e-6, `${name}: ${own.score.errors[name]}, ${double.score.errors[name]}`);
  }
});

test('a flight without a base names no base to match with', () => {
  const { match } = made('--base-mm', '0', '--by-mm', '0', '--bz-mm', '0');
  assert.ok(!match.includes('--base-mm'));
  const { code, stderr } = tiepoint('match', ...match.slice(1));
  assert.equal(code, 4, stderr);
});

test('the report of a flight is one file that holds everything', () => {
  const { at, match } = made();
  const out = join(at, 'report');
  const { file } = json('report', ...match.slice(1), '--out', out);
  const page = readFileSync(file, 'utf8');
  for (const part of ['left.png', 'Table 1.', 'Table 2.', 'Table 3.', 'true errors', 'Reliability', 'data:image/png;base64,'])
    assert.ok(page.includes(part), part);
  assert.ok(!/(?:src|href)="(?!data:|#)/.test(page));
  json('report', ...match.slice(1), '--out', out);
  assert.equal(readFileSync(file, 'utf8'), page);
  assert.match(tiepoint('report', ...match.slice(1)).stderr, /--out is missing/);
});

test('a report says in a pipe how far it is', () => {
  const { at, match } = made();
  const call = ['report', ...match.slice(1), '--out', join(at, 'report')];
  const { code, stdout, stderr } = tiepoint(...call);
  const matched = tiepoint(...match);
  assert.equal(code, matched.code);
  assert.equal(stdout.split('\n')[0], matched.stdout.split('\n')[0]);
  const lines = stderr.trimEnd().split('\n');
  assert.equal(lines.length, 7);
  for (const step of ['this run', 'moments', 'gradients'])
    assert.ok(
      lines.some((line) => new RegExp(`^matching: ${step} in [\\d.]+ s$`).test(line)),
      step,
    );
  assert.equal(tiepoint(...call, '--json').stderr, '');
});

test('a report is in the language that is asked for', () => {
  const { at, match } = made();
  /** @param {string[]} more */
  const page = (...more) => readFileSync(json('report', ...match.slice(1), '--out', join(at, 'report'), ...more).file, 'utf8');
  const [plain, arabic] = [page(), page('--language', 'ar')];
  assert.match(plain, /<html lang="en">.*<title>Tiepoint report: left\.png, right\.png<\/title>/su);
  assert.match(arabic, /<html lang="ar" dir="rtl">.*<title>[^<]*تقرير Tiepoint[^<]*<\/title>/su);
  assert.equal(page('--language', 'en'), plain);
  const { code, stderr } = tiepoint('report', ...match.slice(1), '--out', join(at, 'report'), '--language', 'de');
  assert.equal(code, 2);
  assert.match(stderr, /--language is de; allowed: en, ar/);
});

test('the next command is told as this one was called', () => {
  const next =
    tiepoint('simulate', '--out', folder(), ...SMALL)
      .stdout.trimEnd()
      .split('\n')
      .at(-1) ?? '';
  assert.ok(next.startsWith('node ') && next.includes('tiepoint.js match '), next);
  const [, program = '', ...words] = next.split(' ');
  assert.equal(resolve(program), PROGRAM);
  // So small photos have few matches.
  assert.equal(tiepoint(...words).code, 3);
  const called = (/** @type {string} */ path) => programWords(path, '/home/me').join(' ');
  assert.equal(called('/home/me/tiepoint/pkg/bin/tiepoint.js'), 'node tiepoint/pkg/bin/tiepoint.js');
  assert.equal(called('/opt/tiepoint/pkg/bin/tiepoint.js'), 'node /opt/tiepoint/pkg/bin/tiepoint.js');
  assert.equal(called('/home/me/node_modules/.bin/tiepoint'), 'npx tiepoint');
  assert.equal(called('/usr/local/bin/tiepoint'), 'tiepoint');
});
