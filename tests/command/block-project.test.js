/** What the project of a block is good for: it is opened, edited, and says how well things are known. */

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { test } from 'node:test';
import { check_heights, FinishedBlock } from '../../pkg/node.js';
import { contents, PAIRS, runOnce } from './blocks.js';
import { file, folder, json, tiepoint } from './command.js';

const { whole: WHOLE, ran } = runOnce();

test('a damaged project is refused plainly', () => {
  const path = join(WHOLE.out, 'project.tiepoint');
  const bytes = readFileSync(path);
  const opened = FinishedBlock.open(bytes);
  const [block, { pairs: connections }] = [opened.model(), opened.overview()];
  assert.equal(block.images.length, 6);
  assert.equal(connections.length, PAIRS);
  const refused = (/** @type {Uint8Array} */ damaged) => {
    assert.throws(
      () => FinishedBlock.open(damaged),
      (/** @type {any} */ error) => error.name === 'TiepointError' && error.code === 'unreadable-file' && /project file/.test(error.message),
    );
  };
  refused(bytes.subarray(0, bytes.length - 100));
  const flipped = Buffer.from(bytes);
  flipped[bytes.length - 50] = (flipped[bytes.length - 50] ?? 0) ^ 4;
  refused(flipped);
  refused(Buffer.from('{}'));
});

test('covariances of images and points of a project are written as a table', () => {
  const project = join(WHOLE.out, 'project.tiepoint');
  const block = FinishedBlock.open(readFileSync(project));
  const [first] = block.model().images;
  const [number = 0] = block.overview().points.numbers;
  // As points.csv and rays.csv have it.
  for (const name of ['points.csv', 'rays.csv'])
    assert.match(readFileSync(join(WHOLE.out, name), 'utf8').split('\n')[1] ?? '', new RegExp(`^${number},`), name);
  assert.deepEqual(block.point_number(block.point_ids()[0] ?? { manual: 0 }), number);
  block.free();
  const out = join(folder(), 'covariances.csv');
  const { code, stderr } = tiepoint('covariances', project, '--of', `${first?.name},point:${number}`, '--out', out);
  assert.equal(code, 0, stderr);
  const [head = [], ...rows] = readFileSync(out, 'utf8')
    .trim()
    .split('\n')
    .map((line) => line.split(','));
  assert.equal(head[5], `${first?.name} omega [deg]`);
  assert.equal(rows.length, 9);
  const sigmas = readFileSync(join(WHOLE.out, 'images.csv'), 'utf8')
    .split('\n')
    .slice(0, 2)
    .map((line) => line.split(','));
  const sigma = Number(sigmas[1]?.[sigmas[0]?.indexOf('sigma_x') ?? -1]);
  assert.ok(Math.abs(Number(rows[3]?.[4]) / sigma - 1) < 1e-5, `${rows[3]} ${sigma}`);
  for (const [k, row] of rows.entries()) assert.ok(Math.abs(Number(row[5 + k]) / Number(row[4]) ** 2 - 1) < 1e-9);
  const whole = tiepoint('covariances', project, '--of', 'all', '--out', out);
  assert.equal(whole.code, 0, whole.stderr);
  const lines = readFileSync(out, 'utf8').trimEnd().split('\n');
  assert.ok(lines.length > 50);
  assert.deepEqual(json('covariances', project, '--of', 'all', '--out', out), { file: out, unknowns: lines.length - 1 });
  const refused = tiepoint('covariances', project, '--of', 'nobody.jpg', '--out', out);
  assert.ok(refused.code === 1 && /nobody\.jpg/.test(refused.stderr), refused.stderr);
  assert.match(tiepoint('covariances', project, '--out', out).stderr, /--of is missing/);
});

test('maps of the accuracy that is to be expected are written, and say what the standard errors of tie points say', () => {
  const project = join(WHOLE.out, 'project.tiepoint');
  const out = folder();
  const { code, stdout, stderr } = tiepoint('accuracy', project, '--out', out);
  assert.equal(code, 0, stderr);
  assert.match(stdout, /^\d+ cells of \S+ m that two or more images show/m);
  assert.match(stdout, /^standard error in height: \S+ m in the median, \S+ m at 95 % of the cells$/m);
  const { files, unit, height, cells: number } = json('accuracy', project, '--out', out);
  assert.deepEqual(
    files.map((/** @type {string} */ path) => basename(path)),
    ['plan.tif', 'height.tif', 'images.tif', 'accuracy.csv'],
  );
  assert.ok(unit === 'm' && stdout.includes(`${number} cells`) && stdout.includes(`height: ${height[0].toPrecision(3)} m in`), `${unit} ${height}`);
  // A block without positions has no scale.
  const free = json('accuracy', join(ran('--gps', 'ignore').out, 'project.tiepoint'), '--out', folder());
  assert.equal(free.unit, null);
  const table = (/** @type {string} */ file) => {
    const [head = [], ...rows] = readFileSync(file, 'utf8')
      .trim()
      .split('\n')
      .map((line) => line.split(','));
    return rows.map((row) => Object.fromEntries(head.map((name, k) => [name, row[k] === '' ? NaN : Number(row[k])])));
  };
  const middle = (/** @type {number[]} */ values) => values.sort((a, b) => a - b)[values.length >> 1] ?? NaN;
  const cells = table(join(out, 'accuracy.csv'));
  const seen = cells.filter(({ images = 0 }) => images >= 3);
  const points = table(join(WHOLE.out, 'points.csv')).filter(({ sigma_z = NaN }) => sigma_z > 0);
  assert.ok(cells.length > 500 && seen.length > 100 && points.length > 50, `${cells.length} ${seen.length} ${points.length}`);
  // Tie points are not seen in every image that shows them: what is expected is no worse, and not by much.
  const ratio = middle(seen.map(({ height_error = NaN }) => height_error)) / middle(points.map(({ sigma_z = NaN }) => sigma_z));
  assert.ok(ratio > 0.4 && ratio < 1.2, `${ratio}`);
  for (const name of ['plan.tif', 'height.tif', 'images.tif']) assert.doesNotThrow(() => check_heights(readFileSync(join(out, name)), undefined), name);
  const coarse = tiepoint('accuracy', project, '--out', out, '--cell', '1e9');
  assert.ok(coarse.code === 1 && /side of a cell of the map: got 1000000000/.test(coarse.stderr), coarse.stderr);
  assert.match(tiepoint('accuracy', project).stderr, /--out is missing/);
  assert.match(tiepoint('accuracy', project, '--out', out, '--point-sigma-px', '0').stderr, /--point-sigma-px is 0; allowed: 0\.000000001 to 1000/);
});

test('edits by hand are applied to a project, and undone to the byte', () => {
  const project = join(WHOLE.out, 'project.tiepoint');
  const found = FinishedBlock.open(readFileSync(project));
  const [point] = found.point_ids();
  const [first, second] = found.point(0).observations;
  assert.ok(point && first && second);
  // Of the pairs of the other images the one with fewest matches.
  const rows = readFileSync(join(WHOLE.out, 'pairs.csv'), 'utf8').split('\n');
  const connected = rows.map((line) => line.split(',')).filter((cells) => cells[5] === 'connected' && !cells.slice(0, 2).includes('5'));
  const [[a = '', b = ''] = []] = connected.sort((one, other) => Number(one[6]) - Number(other[6]));
  const edits = [
    { kind: 'reject_observations', observations: [{ point, image: first.image }] },
    { kind: 'measure', point, image: second.image, x_px: second.x_px + 0.2, y_px: second.y_px },
    { kind: 'reject_images', images: [5] },
    { kind: 'reject_pairs', pairs: [[Number(b), Number(a)]] },
  ];
  const [at, out] = [folder(), folder()];
  const edited = json('edit', project, '--edits', file(at, 'edits.json', JSON.stringify(edits)), '--out', out, '--export', 'colmap');
  assert.equal(edited.edits, 4);
  assert.equal(edited.orientation.oriented, 5);
  assert.deepEqual(JSON.parse(readFileSync(join(out, 'summary.json'), 'utf8')), edited);
  assert.ok(contents(out).has('colmap/sparse/images.txt'));
  const [head = ''] = readFileSync(join(out, 'rays.csv'), 'utf8').split('\n');
  assert.match(head, /,by_hand$/);
  const kept = FinishedBlock.open(readFileSync(join(out, 'project.tiepoint')));
  assert.deepEqual(kept.edits(), [edits[0], { ...edits[1], by: 'hand' }, edits[2], edits[3]]);
  const marked = readFileSync(join(out, 'pairs.csv'), 'utf8').split('\n');
  assert.match(marked[0] ?? '', /,reason,rejected_by_hand$/);
  assert.deepEqual(
    marked.filter((line) => /,1$/.test(line)).map((line) => line.split(',').slice(0, 2)),
    [[a, b]],
  );
  // Without --edits those of the project stay, [] undoes them.
  assert.equal(json('edit', join(out, 'project.tiepoint'), '--out', folder()).edits, 4);
  const undone = folder();
  assert.equal(json('edit', join(out, 'project.tiepoint'), '--edits', file(at, 'none.json', '[]'), '--out', undone).edits, 0);
  for (const name of ['project.tiepoint', 'points.csv', 'orientation.json']) {
    assert.equal(readFileSync(join(undone, name), 'utf8'), readFileSync(join(WHOLE.out, name), 'utf8'), name);
  }
});

test('edits that cannot be are refused by name', () => {
  const project = join(WHOLE.out, 'project.tiepoint');
  const at = folder();
  const refused = (/** @type {string} */ text) => {
    const { code, stderr } = tiepoint('edit', project, '--edits', file(at, 'edits.json', text), '--out', folder());
    assert.ok(code !== 0 && stderr.includes('edits.json'), stderr);
    return stderr;
  };
  // Texts name it by its number, which counts from 1.
  assert.match(refused('[{"kind": "reject_points", "points": [{"tie_point": 4000000}]}]'), /tie point 4000001/);
  assert.match(refused('[{"kind": "reject_images", "images": [9]}]'), /index 9/);
  assert.match(refused('[{"kind": "reject_pairs", "pairs": [[3, 3]]}]'), /pair of images: got \[3, 3\]/);
  assert.match(refused('[{"kind": "paint"}]'), /paint/);
  assert.match(refused('{"kind": "reject_images"}'), /no list of edits/);
  assert.match(refused('[{'), /no JSON/);
  // A list without its brackets is no project either.
  assert.match(refused('{"kind": "reject_images"}, {"kind": "reject_points"}'), /edits\.json: it is no JSON \(.*position 25/);
  assert.match(tiepoint('edit', project).stderr, /--out is missing/);
});
