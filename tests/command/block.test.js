/** A block of photographs from the call to its files: matched by the pairs that were chosen, oriented, written. */

import assert from 'node:assert/strict';
import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { contents, PAIRS, runOnce } from './blocks.js';
import { file, folder, tiepoint } from './command.js';

const { block: BLOCK, whole: WHOLE, half, ran } = runOnce('--export', 'colmap,bingo');

test('a block is matched, oriented and written', () => {
  const { out, summary } = WHOLE;
  assert.equal(summary.images.read, 6);
  assert.equal(summary.cameras.length, 1);
  assert.ok(Math.abs(summary.cameras[0].focal_px - 85 / 0.12) < 1e-3, `${summary.cameras[0].focal_px}`);
  assert.equal(summary.pairs.tried, PAIRS);
  assert.equal(summary.orientation.oriented, 6, JSON.stringify(summary.orientation));
  const [model] = summary.orientation.models;
  assert.ok(model.in_system && model.sigma0_px < 1, JSON.stringify(model));
  for (const name of [
    'project.tiepoint',
    'images.csv',
    'pairs.csv',
    'points.csv',
    'rays.csv',
    'orientation.json',
    'report.html',
    'summary.json',
    'colmap/sparse/images.txt',
    'bingo/bingo.dat',
  ]) {
    assert.ok(contents(out).has(name), name);
  }
  assert.deepEqual(JSON.parse(readFileSync(join(out, 'summary.json'), 'utf8')), summary);
  assert.equal(summary.verdict.kind, 'oriented', JSON.stringify(summary.verdict));
});

test('the report is in the language that is asked for, and all other files are English', () => {
  const out = folder();
  const call = ['edit', join(WHOLE.out, 'project.tiepoint'), '--out', out, '--language', 'ar'];
  assert.equal(tiepoint(...call).code, 0);
  const [arabic, whole] = [contents(out), contents(WHOLE.out)];
  assert.match(String(arabic.get('report.html')), /<html lang="ar" dir="rtl">/u);
  assert.match(String(whole.get('report.html')), /<html lang="en">/u);
  for (const name of ['images.csv', 'points.csv', 'pairs.csv', 'rays.csv', 'project.tiepoint']) assert.deepEqual(arabic.get(name), whole.get(name), name);
});

test('orientations and points are right by the truth', () => {
  const { score } = ran('--truth', dirname(BLOCK.truthFile)).summary;
  assert.equal(score.oriented, 6);
  assert.ok(score.points > 30 && score.right_points > 0.85 * score.points, JSON.stringify(score));
  assert.ok(score.angle_rmse_deg < 1, JSON.stringify(score));
  // A pixel is 1.1 m on the ground.
  for (const error of score.position_rmse_m) assert.ok(error < 3, JSON.stringify(score));
  const call = (/** @type {string} */ truth) => tiepoint(...BLOCK.call, '--out', half(), '--truth', truth);
  assert.match(call(file(folder(), 'none.json', '{"relative_orientation": {}}')).stderr, /none\.json: it is no truth of a block/);
  const strange = { ...BLOCK.truth, block: { ...BLOCK.truth.block, images: [] } };
  assert.match(call(file(folder(), 'strange.json', JSON.stringify(strange))).stderr, /strange\.json: .*none of the block's images/);
  assert.match(call(BLOCK.photos).stderr, /truth\.json: there is no such file/);
});

test('options without effect beside the others are told, and a coordinate system that is none is a bad call', () => {
  const call = (/** @type {string[]} */ ...more) => tiepoint(...BLOCK.call, '--out', half(), '--json', ...more);
  const { code, stderr } = call('--pairs', 'all', '--near', '3', '--geoid-m', '5', '--least-matches', '16');
  assert.deepEqual([code, stderr], [0, 'tiepoint: without effect with the other options: --near, --geoid-m\n']);
  for (const [crs, why] of /** @type {const} */ ([
    ['EPSG:99999', 'a code that is unknown here'],
    ['no system', 'which cannot be read'],
  ])) {
    const refused = call('--crs', crs);
    assert.deepEqual([refused.code, refused.stdout], [2, ''], refused.stderr);
    assert.ok(refused.stderr.startsWith(`tiepoint: --crs: coordinate reference system: got ${crs}, ${why}`), refused.stderr);
  }
});

test('each pair says why it is or is not connected', () => {
  const [header, ...lines] = readFileSync(join(WHOLE.out, 'pairs.csv'), 'utf8').trimEnd().split('\n');
  assert.equal(header, 'first,second,first_name,second_name,rule,outcome,matches,geometry,degenerate,sigma_px,common_points,chosen_points,reason');
  assert.equal(lines.length, PAIRS);
  for (const line of lines) assert.match(line, /(connected by \d+ matches|not connected: .+); all pairs are tried"?$/);
  assert.equal(lines.filter((line) => line.includes(',connected,')).length, WHOLE.summary.pairs.connected);
});

test('each rule of pairs chooses its own', () => {
  const tried = (/** @type {string[]} */ ...options) => ran(...options).summary.pairs.tried;
  assert.equal(tried('--pairs', 'sequence', '--sequence', '1'), 5);
  assert.equal(tried('--pairs', 'near', '--near', '5'), PAIRS);
  assert.ok(tried('--pairs', 'near', '--near', '2') < PAIRS);
  const { out, summary } = ran('--pairs', 'alike', '--alike', '2');
  assert.ok(summary.pairs.tried < PAIRS && summary.pairs.connected >= 5, JSON.stringify(summary.pairs));
  assert.match(readFileSync(join(out, 'pairs.csv'), 'utf8'), /chosen because the images are similar/);
  assert.match(tiepoint(...BLOCK.call, '--out', out, '--pairs', 'alike', '--alike', '3').stderr, /similarity of images: 5 \(5 from an earlier run\)/);
  assert.equal(tried('--pairs', 'near', '--gps', 'ignore', '--sequence', '1'), 5);
});

test('a format that the block cannot be written in is told, the rest is written', () => {
  const out = half();
  const { code, stderr } = tiepoint(...BLOCK.call, '--out', out, '--gps', 'ignore', '--export', 'geojson,csv');
  assert.equal(code, 1);
  assert.match(stderr, /not exported: geojson \(.+\); all other files were written/);
  assert.ok(contents(out).has('csv/points.csv') && contents(out).has('summary.json'));
});

test('calls that cannot be run are refused by name', () => {
  const out = ['--out', folder()];
  const twins = folder();
  const [name = ''] = readdirSync(BLOCK.photos);
  mkdirSync(join(twins, 'empty'));
  copyFileSync(join(BLOCK.photos, name), join(twins, name));
  for (const [args, code, pattern] of /** @type {[string[], number, RegExp][]} */ ([
    [BLOCK.call, 2, /--out is missing/],
    [['block', ...out], 2, /FOLDER or IMAGE is missing/],
    [[...BLOCK.call, ...out, '--pairs', 'some'], 2, /--pairs is some; allowed: all, near, sequence, alike/],
    [[...BLOCK.call, ...out, '--per-image', '0'], 2, /--per-image is 0; allowed: whole numbers from 1 to 10000/],
    [[...BLOCK.call, ...out, '--workers', '1.5'], 2, /--workers is 1\.5; allowed: whole numbers from 1 to 256/],
    [[...BLOCK.call, ...out, '--export', 'colmap,maya'], 2, /--export has maya; allowed, with commas between: colmap, micmac/],
    [[...BLOCK.call, ...out, '--gps', 'maybe'], 2, /--gps is maybe; allowed: use, ignore/],
    [[...BLOCK.call, ...out, '--pear-image', '3'], 2, /did you mean --per-image\?/],
    [['block', BLOCK.photos, join(twins, name), ...out], 2, /have the same name/],
    [['block', join(twins, 'empty'), ...out], 1, /there is no image in this folder/],
    [['block', join(twins, 'none.jpg'), join(twins, name), '--out', join(twins, 'out')], 1, /none\.jpg: there is no such file or folder/],
    [[...BLOCK.call, '--out', join(BLOCK.photos, name)], 1, /cannot write to the folder/],
  ])) {
    const ended = tiepoint(...args);
    assert.equal(ended.code, code, `${args}: ${ended.stderr}`);
    // Behind the lines of the stages that were done.
    assert.match(ended.stderr.trimEnd().split('\n').at(-1) ?? '', pattern);
  }
  assert.ok(!existsSync(join(twins, 'out')));
});
