/** What is said of a block that was computed: one set of numbers in all files, every model by itself, and an exit code for none. */

import assert from 'node:assert/strict';
import { copyFileSync, existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { FinishedBlock, grey_png, Photo, read_exif } from '../../pkg/node.js';
import { photographed, runOnce } from './blocks.js';
import { file, folder, image, json, speckle, tiepoint } from './command.js';

const {
  block: BLOCK,
  whole: { out: WHOLE, summary: SUMMARY },
  half,
} = runOnce();

/** @param {string} out @param {string} name @returns {Record<string, string>[]} */
function rows(out, name) {
  const [header = '', ...lines] = readFileSync(join(out, name), 'utf8').trimEnd().split('\n');
  return lines.map((line) => Object.fromEntries(header.split(',').map((column, i) => [column, line.split(',')[i] ?? ''])));
}

/** A folder of the block's photos, some of them with another recorded position.  @param {Record<string, Partial<import('../../pkg/node.js').ExifPosition>>} changes by name */
function recorded(changes) {
  const at = folder();
  for (const name of readdirSync(BLOCK.photos)) {
    const change = changes[name];
    if (!change) {
      copyFileSync(join(BLOCK.photos, name), join(at, name));
      continue;
    }
    const bytes = readFileSync(join(BLOCK.photos, name));
    const photo = Photo.decode(bytes);
    const exif = read_exif(bytes, photo.width, photo.height);
    assert.ok(exif.camera && exif.position);
    file(at, name, grey_png(photo.width, photo.height, photo.grey(), { ...exif, position: { ...exif.position, ...change } }));
  }
  return at;
}

test('all files and the text give the same numbers of points and rays', () => {
  const out = WHOLE;
  const { selection, orientation } = SUMMARY;
  const [images, points, rays] = ['images', 'points', 'rays'].map((name) => rows(out, `${name}.csv`));
  assert.ok(images && points && rays);
  assert.deepEqual([points.length, rays.length], [orientation.points, orientation.rays]);
  assert.deepEqual([points.length, rays.length], [selection.points, selection.rays]);
  for (const row of images) assert.equal(Number(row.rays), rays.filter((ray) => ray.image === row.image).length, row.name);
  assert.equal(selection.least_rays_of_an_image, Math.min(...images.map((row) => Number(row.rays))));
  const { stdout, stderr } = tiepoint(...BLOCK.call, '--out', out);
  const labels = stdout
    .split('\n')
    .map((line) => line.split('  ')[0])
    .filter((label) => label !== '');
  assert.deepEqual(labels, [...new Set(labels)]);
  assert.match(stdout, new RegExp(`^points chosen +${points.length}\nobservations of points chosen +${rays.length}$`, 'm'));
  // Steps are not told as points.
  assert.match(stderr, /^tie points in/m);
  assert.match(stderr, /^orientation in/m);
});

test('every model is told by itself, with its images', () => {
  const other = photographed('--seed', '9');
  const mixed = folder();
  for (const name of readdirSync(BLOCK.photos)) copyFileSync(join(BLOCK.photos, name), join(mixed, name));
  const others = readdirSync(other.photos)
    .sort()
    .slice(0, 3)
    .map((name) => `other_${name}`);
  for (const name of others) copyFileSync(join(other.photos, name.replace('other_', '')), join(mixed, name));
  const out = half();
  const call = ['block', mixed, ...BLOCK.call.slice(2), '--out', out];
  const { orientation } = json(...call);
  assert.deepEqual(
    orientation.models.map((/** @type {any} */ { images, names }) => [images, names]),
    [
      [6, readdirSync(BLOCK.photos)],
      [3, others],
    ],
  );
  assert.deepEqual(
    rows(out, 'images.csv').map(({ model }) => model),
    [...'222111111'],
  );
  const { stdout } = tiepoint(...call);
  assert.match(stdout, /^images oriented +6 of 9\nmodels +2$/m);
  assert.match(stdout, /^model 1: photo_00000\.png, .* and 1 more; sigma0 0\.\d+ px$/m);
  assert.match(stdout, /^model 2, in orientation\.json alone: other_photo_00000\.png, other_photo_00001\.png, other_photo_00002\.png; sigma0 0\.\d+ px$/m);
  const first = stdout.split('\nmodel 2')[0] ?? '';
  for (const { text } of orientation.models[1].warnings)
    assert.ok(
      stdout.includes(`  warning: ${text}`) &&
        (orientation.models[0].warnings.some((/** @type {{ text: string }} */ other) => other.text === text) || !first.includes(text)),
      text,
    );
});

test('positions that do not fit are not in the RMS of those that do', () => {
  const {
    orientation: {
      models: [model],
    },
  } = json('block', recorded({ 'photo_00004.png': { height_m: 5000 } }), ...BLOCK.call.slice(2), '--out', half());
  assert.ok(
    model.warnings.some((/** @type {{ text: string }} */ { text }) => text.includes('photo_00004.png (')),
    JSON.stringify(model.warnings),
  );
  for (const error of model.position_rmse_m) assert.ok(error < 20, JSON.stringify(model));
});

test('images of which no two are connected make no block', () => {
  const at = folder();
  for (let i = 0; i < 3; i++) image(at, `${i}.png`, 240, 180, (col, row) => speckle(col + 1000 * i, row));
  const out = folder();
  const { code, stdout, stderr } = tiepoint('block', at, '--out', out, '--features', '300');
  assert.equal(code, 4);
  assert.doesNotMatch(stderr, /tiepoint:/);
  assert.match(stdout, /^Not oriented: no two of the images could be connected\.$/m);
  assert.match(stdout, /^images oriented +0 of 3$/m);
  assert.doesNotMatch(stdout, /tie points\./);
  for (const { reason } of rows(out, 'pairs.csv')) assert.match(reason ?? '', /^"?not connected: .*(on one geometry|candidate matches are there)/);
  assert.ok(existsSync(join(out, 'pairs.csv')) && FinishedBlock.open(readFileSync(join(out, 'project.tiepoint'))).model().images.length === 3);
});

test('recorded positions that cannot be are told', () => {
  const changed = recorded({ 'photo_00001.png': { latitude_deg: 123 }, 'photo_00005.png': { latitude_deg: 0, longitude_deg: 0, height_m: 0 } });
  const call = ['block', changed, ...BLOCK.call.slice(2)];
  const said = 'impossible GNSS positions and heights are ignored: photo_00001.png (latitude 123), photo_00005.png (longitude 0, latitude 0)';
  const { code, stdout, stderr } = tiepoint(...call, '--out', half(), '--json');
  const { remarks } = JSON.parse(stdout);
  assert.deepEqual([code, remarks.map((/** @type {{ text: string }} */ { text }) => text), stderr], [0, [said], `tiepoint: ${said}\n`]);
  assert.deepEqual(remarks[0].images[0], { name: 'photo_00001.png', value: 'latitude 123' });
  assert.deepEqual(json(...call, '--out', half(), '--gps', 'ignore').remarks, []);
});
