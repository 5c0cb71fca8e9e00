/** The programs of the document for JavaScript run as they stand there, and its codes of errors are those of the crate. */

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { after } from 'node:test';
import { fileURLToPath } from 'node:url';
import { grey_png, match_pair, Photo, simulate } from '../../pkg/node.js';
import { photographed } from '../command/blocks.js';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const DOCUMENT = readFileSync(join(ROOT, 'docs/javascript.md'), 'utf8');

/** Programs by the file names that their first lines say. */
const programs = new Map([...DOCUMENT.matchAll(/^```js\n\/\/ (\S+\.js)\n([\s\S]*?)^```$/gm)].map(([, name = '', code = '']) => [name, code]));

const home = mkdtempSync(join(tmpdir(), 'tiepoint-documents-'));
after(() => rmSync(home, { recursive: true, force: true }));
writeFileSync(join(home, 'package.json'), '{ "private": true, "type": "module" }');
mkdirSync(join(home, 'node_modules'));
symlinkSync(join(ROOT, 'pkg'), join(home, 'node_modules/tiepoint'), 'junction');
for (const [name, code] of programs) writeFileSync(join(home, name), code);

const pair = simulate({});
for (const side of /** @type {const} */ (['left', 'right'])) {
  const { width, height, grey } = pair[side];
  writeFileSync(join(home, `${side}.jpg`), grey_png(width, height, grey));
}

const marksOf = (/** @type {typeof pair.left_fiducials} */ marks) =>
  ['col,row,x_mm,y_mm', ...marks.map(({ col, row, x_mm, y_mm }) => [col, row, x_mm, y_mm].join(','))].join('\n');
writeFileSync(join(home, 'camera.json'), JSON.stringify(pair.camera));
writeFileSync(join(home, 'left-fiducials.csv'), marksOf(pair.left_fiducials));
writeFileSync(join(home, 'right-fiducials.csv'), marksOf(pair.right_fiducials));

/** What a program writes.  @param {string} name */
function written(name) {
  const { status, stdout, stderr } = spawnSync(process.execPath, [name], { cwd: home, encoding: 'utf8' });
  assert.equal(status, 0, stderr);
  assert.equal(stderr, '');
  return stdout;
}

test('every block of JavaScript in the document is a program of this test', () => {
  assert.equal(DOCUMENT.match(/^```js$/gm)?.length, programs.size);
  assert.deepEqual([...programs.keys()], ['pair.js', 'camera.js', 'points.js', 'orientation.js', 'block-worker.js', 'block.js', 'placing.js', 'project.js']);
});

test('a pair is matched and oriented, and its verdict said in two languages', () => {
  const said = written('pair.js');
  assert.match(said, /matches: \d{3,}/);
  assert.match(said, /\p{Script=Arabic}/u);
});

test('a pair on film is oriented by its camera and its fiducial marks', () => {
  assert.deepEqual(
    [pair.left_origin, pair.right_origin],
    [
      [413, 107],
      [48, 114],
    ],
  );
  const said = written('camera.js');
  const [, omega, error] = /^omega (-?[\d.]+) ± ([\d.]+) deg$/m.exec(said) ?? [];
  assert.ok(Math.abs(Number(omega) - pair.truth.omega_deg) < 0.05, said);
  const [left, right] = [pair.left, pair.right].map(({ width, height, grey }) => Photo.from_grey(width, height, grey));
  assert.ok(left && right);
  const scans = [
    { fiducials: pair.left_fiducials, origin: pair.left_origin },
    { fiducials: pair.right_fiducials, origin: pair.right_origin },
  ];
  const { orientation } = match_pair(left, right, { camera: pair.camera, left: scans[0], right: scans[1] }, {});
  // What the scatter of the matches alone says would be too small.
  assert.equal(Number(error), orientation?.total_standard_errors?.omega_deg);
  assert.ok(Number(error) > 1.5 * (orientation?.standard_errors?.omega_deg ?? NaN) && Number(error) < 0.05, said);
});

test('points keep away from the mask, and features are matched', () => {
  const said = written('points.js');
  const rows = [...said.matchAll(/y ([\d.]+) px/g)].map(([, y]) => Number(y));
  assert.equal(rows.length, 3);
  assert.ok(rows.every((y) => y < pair.left.height / 2));
  assert.ok(Number(/(\d+) matches, [a-z]+/.exec(said)?.[1]) > 50, said);
});

test('measurements of a simulated pair give its truth', () => {
  const said = written('orientation.js');
  for (const angle of /** @type {const} */ (['omega_deg', 'phi_deg', 'kappa_deg'])) {
    const found = Number(new RegExp(`${angle}: (-?[\\d.]+)`).exec(said)?.[1]);
    assert.ok(Math.abs(found - pair.truth[angle]) < 0.05, `${angle}: ${found}`);
  }
});

test('a block is run by threads that the document has, and an image that cannot be read is skipped and listed', () => {
  const { photos } = photographed();
  mkdirSync(join(home, 'photos'));
  for (const name of readdirSync(photos).slice(0, 3)) writeFileSync(join(home, 'photos', name), readFileSync(join(photos, name)));
  writeFileSync(join(home, 'photos/broken.png'), new Uint8Array([1, 2, 3]));
  const first = written('block.js');
  assert.match(first, /^broken\.png: .*this kind of file is not supported/m);
  const project = readFileSync(join(home, 'project.tiepoint'));
  // The second time its records are there.
  assert.equal(written('block.js'), first);
  assert.deepEqual(readFileSync(join(home, 'project.tiepoint')), project);
});

test('an image is placed on an orthophoto, with the standard errors of its position', () => {
  assert.match(written('placing.js'), /points of the orthophoto\nPlaced by .*\[.*\] \[.*\]/s);
});

test('a pair is written as a project and opened again', () => {
  assert.match(written('project.js'), /pair.*'left\.jpg', 'right\.jpg'/s);
});

test('the document and the types have every code of an error', () => {
  const of = (/** @type {string} */ text, /** @type {RegExp} */ pattern) => [...text.matchAll(pattern)].map(([, code]) => code).sort();
  const [, match = ''] = /pub fn code\(&self\)[\s\S]*?match self \{([\s\S]*?)\n {8}\}/.exec(readFileSync(join(ROOT, 'src/error/mod.rs'), 'utf8')) ?? [];
  const codes = of(match, /=> "([a-z-]+)"/g);
  assert.ok(codes.length > 10);
  const [, union = ''] = /export type ErrorCode =([^;]*);/.exec(readFileSync(join(ROOT, 'src/wasm/about.rs'), 'utf8')) ?? [];
  assert.deepEqual(of(union, /"([a-z-]+)"/g), codes);
  assert.deepEqual(of(DOCUMENT, /^\| `([a-z-]+)` \|/gm), codes);
});
