import assert from 'node:assert/strict';
import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { check_heights, FinishedBlock } from '../../pkg/node.js';
import { DATA } from '../../tools/lib/paths.mjs';
import { begun, contents, killed, marksOf, photographed, records } from './blocks.js';
import { file, folder, json, tiepoint } from './command.js';

const BLOCK = photographed();
const PAIRS = 15;

/** @param {string} out @param {string[]} options */
function run(out, ...options) {
  const summary = json(...BLOCK.call, '--out', out, '--workers', '2', ...options);
  return { out, summary };
}

/** From the beginning. */
const WHOLE = run(folder(), '--export', 'colmap,bingo');

/** What another run finds of it: images and pairs, but nothing that follows from them. */
const half = () => begun(WHOLE.out);

/** @param {string[]} options */
const ran = (...options) => run(half(), ...options);

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
  const { score } = ran('--truth', BLOCK.truthFile).summary;
  assert.equal(score.oriented, 6);
  assert.ok(score.points > 30 && score.right_points > 0.85 * score.points, JSON.stringify(score));
  assert.ok(score.angle_rmse_deg < 1, JSON.stringify(score));
  // A pixel is 1.1 m on the ground.
  for (const error of score.position_rmse_m) assert.ok(error < 3, JSON.stringify(score));
  const call = (/** @type {string} */ truth) => tiepoint(...BLOCK.call, '--out', half(), '--truth', truth);
  assert.match(call(file(folder(), 'none.json', '{"relative_orientation": {}}')).stderr, /none\.json: it is no truth of a block/);
  const strange = { ...BLOCK.truth, block: { ...BLOCK.truth.block, images: [] } };
  assert.match(call(file(folder(), 'strange.json', JSON.stringify(strange))).stderr, /strange\.json: .*none of the block's images/);
});

test('each pair says why it is or is not connected', () => {
  const [header, ...lines] = readFileSync(join(WHOLE.out, 'pairs.csv'), 'utf8').trimEnd().split('\n');
  assert.equal(header, 'first,second,first_name,second_name,rule,outcome,matches,geometry,degenerate,sigma_px,common_points,chosen_points,reason');
  assert.equal(lines.length, PAIRS);
  for (const line of lines) assert.match(line, /(connected by \d+ matches|not connected: .+); all pairs are tried"?$/);
  assert.equal(lines.filter((line) => line.includes(',connected,')).length, WHOLE.summary.pairs.connected);
});

test('killed at any moment and started again, it gives the same bytes', async () => {
  const wanted = contents(WHOLE.out);
  const out = folder();
  const args = [...BLOCK.call, '--out', out, '--workers', '2', '--export', 'colmap,bingo'];
  // Ended in the midst of the images, of the pairs, and right after the last of them.
  const moments = [
    () => records(out, 'features') >= 2,
    () => records(out, 'pairs') >= 1,
    () => records(out, 'pairs') >= 8,
    () => records(out, 'pairs') >= PAIRS,
  ];
  let kills = 0;
  for (const moment of moments) kills += (await killed(args, moment)) ? 1 : 0;
  assert.ok(kills >= 3, `${kills}`);
  const before = records(out, 'pairs');
  assert.ok(before >= 8, `${before}`);
  // Ended while it wrote.
  for (const name of ['summary.json', 'work/pairs/00.record.7']) writeFileSync(join(out, `${name}.tiepoint-99999999.part`), 'half');
  const { code, stderr } = tiepoint(...args);
  assert.equal(code, 0, stderr);
  assert.match(stderr, /images: 6 \(6 from an earlier run\)/);
  assert.deepEqual(contents(out), wanted);
  assert.deepEqual(
    readdirSync(join(out, 'work', 'pairs')).filter((name) => !name.endsWith('.record')),
    [],
  );
});

test('one worker gives the bytes of two', () => {
  const out = folder();
  json(...BLOCK.call, '--out', out, '--workers', '1', '--export', 'colmap,bingo');
  assert.deepEqual(contents(out, ''), contents(WHOLE.out, ''));
});

test('a damaged record is made again', () => {
  const { out } = ran();
  const wanted = contents(out, '');
  const features = join(out, 'work', 'features');
  const pairs = join(out, 'work', 'pairs');
  const [one = '', two = '', three = ''] = readdirSync(features);
  const flipped = readFileSync(join(features, one));
  flipped[flipped.length - 7] = (flipped[flipped.length - 7] ?? 0) ^ 1;
  writeFileSync(join(features, one), flipped);
  writeFileSync(join(features, two), readFileSync(join(features, two)).subarray(0, 1000));
  writeFileSync(join(features, three), '');
  const [first = '', second = ''] = readdirSync(pairs);
  copyFileSync(join(pairs, first), join(pairs, second));
  json(...BLOCK.call, '--out', out);
  assert.deepEqual(contents(out, ''), wanted);
});

test('other settings and other images are computed again, a renamed image is not', () => {
  const { out } = ran();
  json(...BLOCK.call.slice(0, 2), '--out', out, '--features', '1100');
  assert.equal(records(out, 'features'), 12);
  json(...BLOCK.call, '--out', out, '--least-matches', '17');
  assert.equal(records(out, 'features'), 12);
  assert.equal(records(out, 'pairs'), 3 * PAIRS);
  const renamed = folder();
  for (const name of readdirSync(BLOCK.photos)) copyFileSync(join(BLOCK.photos, name), join(renamed, `new_${name}`));
  const [, ...settings] = BLOCK.call.slice(1);
  json('block', renamed, ...settings, '--out', out);
  assert.equal(records(out, 'features'), 12);
  assert.equal(records(out, 'pairs'), 3 * PAIRS);
});

test('an image that cannot be read is skipped and listed', () => {
  const mixed = folder();
  for (const name of readdirSync(BLOCK.photos)) copyFileSync(join(BLOCK.photos, name), join(mixed, name));
  const names = readdirSync(mixed);
  writeFileSync(join(mixed, 'a_text.jpg'), 'no image at all');
  const cut = readFileSync(join(mixed, names[2] ?? ''));
  writeFileSync(join(mixed, names[2] ?? ''), cut.subarray(0, 2000));
  const out = folder();
  const { code, stdout, stderr } = tiepoint('block', mixed, ...BLOCK.call.slice(2), '--out', out, '--json');
  assert.equal(code, 0, stderr);
  const summary = JSON.parse(stdout);
  assert.equal(summary.images.read, 5);
  assert.deepEqual(
    summary.images.left_out.map((/** @type {any} */ image) => image.name),
    ['a_text.jpg', names[2]],
  );
  assert.match(stderr, /a_text\.jpg is skipped: /);
  assert.match(stderr, new RegExp(`${names[2]} is skipped: the image cannot be read`));
  const alone = tiepoint('block', join(mixed, 'a_text.jpg'), join(mixed, names[0] ?? ''), '--out', folder());
  assert.equal(alone.code, 1);
  assert.match(alone.stderr, /images of the block: got 1 that could be read, of 2 \(a_text\.jpg: /);
});

test('files of kinds that are not decoded are named beside the images of a folder, each reason once', () => {
  const mixed = folder();
  const heic = Buffer.concat([Buffer.from([0, 0, 0, 24]), Buffer.from('ftypheic\0\0\0\0mif1heic'), Buffer.alloc(100)]);
  for (let i = 1; i <= 7; i++) writeFileSync(join(mixed, `IMG_${i}.HEIC`), heic);
  writeFileSync(join(mixed, 'map.ecw'), 'e');
  writeFileSync(join(mixed, 'notes.txt'), 'heic');
  const none = tiepoint('block', mixed, '--out', folder());
  assert.equal(none.code, 1);
  assert.match(
    none.stderr,
    /there is no image in this folder \(JPEG, .*\); 7 files are skipped \(IMG_1\.HEIC, .*IMG_5\.HEIC and 2 more\): HEIC pictures are not read: export them as JPEG .*; map\.ecw is skipped: ECW pictures/,
  );
  const alone = tiepoint('points', join(mixed, 'IMG_1.HEIC'));
  assert.deepEqual([alone.code, /IMG_1\.HEIC: HEIC pictures are not read: export them as JPEG/.test(alone.stderr)], [1, true], alone.stderr);
  for (const name of readdirSync(BLOCK.photos)) copyFileSync(join(BLOCK.photos, name), join(mixed, name));
  const { code, stderr } = tiepoint(...BLOCK.call.with(1, mixed), '--out', folder());
  assert.equal(code, 0, stderr);
  const notes = stderr.split('\n').filter((line) => line.includes('skipped'));
  assert.deepEqual(
    notes.map((line) => line.slice(0, line.indexOf(' pictures'))),
    ['tiepoint: 7 files are skipped (IMG_1.HEIC, IMG_2.HEIC, IMG_3.HEIC, IMG_4.HEIC, IMG_5.HEIC and 2 more): HEIC', 'tiepoint: map.ecw is skipped: ECW'],
  );
});

test('copies of an image are left out of a block and named', () => {
  const twins = folder();
  const [name = '', other = ''] = readdirSync(BLOCK.photos);
  for (const copy of ['img_10.png', 'img_9.png', 'IMG.png', 'img_9b.png']) copyFileSync(join(BLOCK.photos, name), join(twins, copy));
  copyFileSync(join(BLOCK.photos, other), join(twins, 'other.png'));
  const out = folder();
  const { stdout, stderr } = tiepoint('block', twins, ...BLOCK.call.slice(2), '--out', out, '--json');
  const summary = JSON.parse(stdout);
  const copies = ['img_9.png', 'img_9b.png', 'img_10.png'];
  assert.equal(stderr, `tiepoint: 3 files are skipped (${copies.join(', ')}): image of the block: got the same file as IMG.png; allowed: each image once\n`);
  assert.equal(summary.images.read, 2);
  assert.deepEqual(
    summary.images.left_out.map((/** @type {{name: string}} */ image) => image.name),
    copies,
  );
  assert.equal(records(out, 'features'), 2);
  const rows = readFileSync(join(out, 'images.csv'), 'utf8').trimEnd().split('\n').slice(1);
  assert.deepEqual(
    rows.map((row) => row.split(',')[1]),
    ['IMG.png', 'other.png'],
  );
});

test('cameras of a file take the place of those of EXIF', () => {
  const at = folder();
  const cameras = file(
    at,
    'cameras.json',
    JSON.stringify({
      cameras: [
        { images: 'PHOTO_0000[0]*', focal_px: 1 },
        { images: 'photo_0000?.png', focal_px: 700, radial: [0.01, 0, 0], fixed: true },
      ],
    }),
  );
  const { code, stdout, stderr } = tiepoint(...BLOCK.call, '--out', half(), '--cameras', cameras, '--json');
  assert.equal(code, 0, stderr);
  const summary = JSON.parse(stdout);
  const text = 'the camera of PHOTO_0000[0]* fits the name of no image';
  assert.deepEqual(summary.remarks, [{ kind: 'unused_camera', images: 'PHOTO_0000[0]*', text }]);
  assert.match(stderr, /^tiepoint: the camera of PHOTO_0000\[0\]\* fits the name of no image\n$/);
  assert.equal(summary.cameras.length, 1);
  assert.equal(summary.cameras[0].focal_px, 700);
  assert.deepEqual(summary.orientation.cameras[0].radial, [0.01, 0, 0]);
  assert.equal(summary.orientation.cameras[0].focal_px, 700);
  const refused = tiepoint(...BLOCK.call, '--out', at, '--cameras', file(at, 'wrong.json', '{"cameras": [{"focal_px": -3}]}'));
  assert.equal(refused.code, 1);
  assert.match(refused.stderr, /wrong\.json: .*focal length of a camera: got -3/);
  const strange = tiepoint(...BLOCK.call, '--out', half(), '--cameras', file(at, 'strange.json', '{"cameras": [{"images": "DJI_*.jpg", "focal_px": 700}]}'));
  assert.deepEqual([strange.code, strange.stdout], [1, '']);
  assert.match(
    strange.stderr,
    /^tiepoint: the cameras: got DJI_\*\.jpg, which fit no image; allowed: patterns that fit names as photo_00000\.png, photo_00001\.png\n$/,
  );
  const short = tiepoint(...BLOCK.call, '--out', half(), '--cameras', file(at, 'short.json', '{"cameras": [{"focal_px": 11.7}]}'));
  assert.match(
    short.stderr,
    /the focal length of \*, 480 x 360 px is 11\.7 px, 0\.024 of the longer side of the image, where 0\.3 to 20 are usual: is it in mm\?/,
  );
  assert.ok(short.code === 3 || short.code === 4, `${short.code}`);
});

test('a block of a camera that its files contradict, or whose principal point is far off, is weak, and says so first', () => {
  for (const [camera, told] of /** @type {const} */ ([
    [
      { focal_px: 1416 },
      /^Weak orientation: .* A camera is hardly the right one \(the focal length of .* is given as 1416 px, where the files of these images say 708\.3 px: /,
    ],
    [
      { focal_px: 708, principal_point_px: [600, 180] },
      /^Weak orientation: .* A camera is hardly the right one \(the principal point of .* lies 0\.75 times the longer side /,
    ],
  ])) {
    const cameras = file(folder(), 'other.json', JSON.stringify({ cameras: [camera] }));
    const { code, stdout } = tiepoint(...BLOCK.call, '--out', half(), '--cameras', cameras, '--json');
    const { verdict } = JSON.parse(stdout);
    assert.deepEqual([code, verdict.kind], [3, 'weak'], verdict.text);
    assert.match(verdict.text, told);
  }
});

test('surveyed points place the block', () => {
  // Marks follow from the truth: ground points on roofs are not known, but any place in space that the photos face does.
  const { images, cameras } = BLOCK.truth.block;
  const at = folder();
  const [camera] = cameras;
  const [low, high] = [0, 1]
    .map((axis) => images.map((/** @type {any} */ image) => image.pose.position[axis]))
    .map((list) => [Math.min(...list), Math.max(...list)]);
  const places = [
    [low?.[0], high?.[0], 0],
    [low?.[1], high?.[1], 10],
    [low?.[0], high?.[1], 20],
    [low?.[1], high?.[0], 5],
  ];
  const points = places.map(([x = 0, y = 0, z = 0], i) => ({ name: `P${i}`, at: [x, y, z] }));
  const marks = marksOf(BLOCK.truth.block, points);
  // Straight down, a focal length and a height stand for each other: the camera is known here.
  const known = ['--cameras', file(at, 'cameras.json', JSON.stringify({ cameras: [{ focal_px: camera.focal_px, fixed: true }] }))];
  const control = file(at, 'control.csv', points.map(({ name, at: place }) => [name, ...place].join()).join('\n'));
  const out = half();
  const measured = file(at, 'marks.csv', `image,point,x,y\n${marks.join('\n')}\n`);
  const { stdout, stderr } = tiepoint(...BLOCK.call, '--out', out, '--workers', '2', ...known, '--control', control, '--marks', measured, '--json');
  assert.equal(JSON.parse(stdout).orientation.models[0].datum, 'control', stderr);
  assert.match(stderr, /the GNSS positions of 6 images take no part: the coordinate reference system of the control points is not named; name it/);
  const block = FinishedBlock.open(readFileSync(join(out, 'project.tiepoint'))).model();
  block.images.forEach((/** @type {any} */ image, /** @type {number} */ i) => {
    const error = Math.hypot(...image.pose.position.map((/** @type {number} */ v, /** @type {number} */ k) => v - images[i].pose.position[k]));
    assert.ok(error < 4, `image ${i}: ${error} m`);
  });
  assert.match(tiepoint(...BLOCK.call, '--out', at, '--control', control).stderr, /--control needs --marks beside it/);
  const strange = file(at, 'strange.csv', `absent.png,P0,1,1\nphoto_00000.png,P9,10,10\n${marks.join('\n')}\n`);
  const told = tiepoint(...BLOCK.call, '--out', half(), ...known, '--control', control, '--marks', strange).stderr;
  assert.match(told, /the image measurements name images that are none of the block: absent\.png/);
  assert.match(told, /image measurements of these points take no part, since the table of control points does not have them: P9/);
  const other = file(at, 'other.csv', marks.join('\n').replaceAll('photo_', 'flight_'));
  assert.match(
    tiepoint(...BLOCK.call, '--out', at, '--control', control, '--marks', other).stderr,
    /ground control points: got 0 of 4 measured in two images or more; the block does not have the images flight_00000\.png/,
  );
  const stranger = file(at, 'stranger.csv', 'photo_00000.png,P9,10,10\n');
  assert.match(
    tiepoint(...BLOCK.call, '--out', at, '--control', control, '--marks', stranger).stderr,
    /image measurements: got the point P9; allowed: points of the table of control points/,
  );
  // Beside GNSS positions the block is placed without them: that is no reason to say nothing.
  const beside = file(at, 'beside.csv', `name,longitude,latitude,height\nP0,8.0001,50.0001,100\nP1,8.001,50.001,100\n`);
  const ofTwo = file(
    at,
    'of-two.csv',
    marks
      .filter((row) => /,P[01],/.test(row))
      .join('\n')
      .replaceAll('photo_', 'flight_'),
  );
  const lost = tiepoint(...BLOCK.call, '--out', half(), '--crs', 'EPSG:4326', '--geoid-m', '0', '--control', beside, '--marks', ofTwo, '--json');
  assert.equal(lost.code, 3, lost.stderr);
  assert.match(
    JSON.parse(lost.stdout).verdict.text,
    /No image measurement of the 2 GCPs is in an image of the block\. The table of measurements names flight_00000\.png/,
  );
  const outside = (/** @type {string} */ place) => {
    const seen = [`photo_00000.png,P0,${place}`, ...marks.filter((mark) => !mark.startsWith('photo_00000.png,P0,'))];
    return tiepoint(...BLOCK.call, '--out', half(), ...known, '--control', control, '--marks', file(at, 'outside.csv', seen.join('\n'))).stderr;
  };
  assert.match(outside('-500,9'), /got \(-500, 9\) for P0 in photo_00000\.png, outside any image/);
  assert.match(outside('500,99999'), /got \(500, 99999\) for P0 in photo_00000\.png, outside the image; allowed: positions within its/);
  const uses = points.map(({ name, at: place }, i) => [name, ...place, i === 3 ? 'check' : 'control'].join());
  const checked = ran(
    '--gps',
    'ignore',
    ...known,
    '--control',
    file(at, 'uses.csv', `name,x,y,z,use\n${uses.join('\n')}\n`),
    '--marks',
    file(at, 'marks.csv', marks.join('\n')),
  );
  const { checks } = checked.summary.orientation.models[0];
  assert.ok(checks.points === 1 && checks.ratio < 4 && checks.rmse_m.every((/** @type {number} */ rmse) => rmse < 4), JSON.stringify(checks));
  const table = readFileSync(join(checked.out, 'surveyed.csv'), 'utf8').trimEnd().split('\n');
  assert.deepEqual(
    table.slice(1).map((row) => row.split(',').slice(0, 2).join(' ')),
    ['P0 control', 'P1 control', 'P2 control', 'P3 check'],
  );
  const feet = file(at, 'feet.csv', points.map(({ name, at: place }) => [name, ...place.map((v) => v * 3.28084)].join()).join('\n'));
  const inFeet = tiepoint(...BLOCK.call, '--out', half(), ...known, '--control', feet, '--marks', file(at, 'marks.csv', marks.join('\n')), '--json');
  const { warnings } = JSON.parse(inFeet.stdout).orientation.models[0];
  assert.ok(
    warnings.some((/** @type {{ text: string }} */ { text }) =>
      /The GCPs make the block 3\.\d times as large as the GNSS positions: are they in feet\?/.test(text),
    ),
    JSON.stringify(warnings),
  );
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

const STRIP = join(DATA, 'block_caliterra');

/** The angle in degrees between the vertical and the mean direction of the camera axes in a table of images, whose angles are ω, φ and κ. */
function meanTiltDeg(/** @type {string} */ csv) {
  const [head = '', ...rows] = csv.trim().split('\n');
  const columns = ['omega_deg', 'phi_deg'].map((name) => head.split(',').indexOf(name));
  assert.ok(!columns.includes(-1), head);
  let [x, y, z] = [0, 0, 0];
  for (const row of rows) {
    const cells = columns.map((column) => row.split(',')[column] ?? '');
    // Images that are not oriented have no angles.
    if (cells.includes('')) continue;
    const [omega = 0, phi = 0] = cells.map((cell) => (Number(cell) * Math.PI) / 180);
    x += Math.sin(phi);
    y -= Math.sin(omega) * Math.cos(phi);
    z += Math.cos(omega) * Math.cos(phi);
  }
  return (Math.atan2(Math.hypot(x, y), z) * 180) / Math.PI;
}

test('the mean tilt is that of the mean axis', () => {
  assert.ok(Math.abs(meanTiltDeg('name,omega_deg,phi_deg\na,10,0\nb,-10,0\n')) < 1e-9);
  assert.ok(Math.abs(meanTiltDeg('name,omega_deg,phi_deg\na,39,0\nb,39,0\nc,,\n') - 39) < 1e-9);
  assert.ok(Math.abs(meanTiltDeg('name,omega_deg,phi_deg\na,0,-5\n') - 5) < 1e-9);
});

test('nadir images whose recorded positions do not settle their rotation are level to 3°', { skip: existsSync(STRIP) ? false : `${STRIP} is absent` }, () => {
  const photos = readdirSync(STRIP)
    .filter((name) => name.endsWith('.jpg'))
    .sort()
    .map((name) => join(STRIP, name));
  assert.equal(photos.length, 12);
  const out = folder();
  const { orientation } = json('block', ...photos, '--out', out, '--workers', '2');
  assert.equal(orientation.oriented, 12, JSON.stringify(orientation));
  const tilt = meanTiltDeg(readFileSync(join(out, 'images.csv'), 'utf8'));
  assert.ok(tilt < 3, `${tilt}°`);
});

test('one strip is oriented where its poor recorded positions do not settle', { skip: existsSync(STRIP) ? false : `${STRIP} is absent` }, () => {
  const photos = readdirSync(STRIP)
    .filter((name) => name.endsWith('.jpg'))
    .sort()
    .slice(0, 6)
    .map((name) => join(STRIP, name));
  const out = folder();
  const { orientation } = json('block', ...photos, '--out', out, '--workers', '2');
  assert.equal(orientation.oriented, 6, JSON.stringify(orientation));
  const [model] = orientation.models;
  assert.ok(model.sigma0_px < 0.5, JSON.stringify(model));
  // Its views level it.
  assert.ok(model.in_system && model.warnings.some((/** @type {{ kind: string }} */ { kind }) => kind === 'levelled'), JSON.stringify(model));
  const tilt = meanTiltDeg(readFileSync(join(out, 'images.csv'), 'utf8'));
  assert.ok(tilt < 3, `${tilt}°`);
});

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
  const [first] = FinishedBlock.open(readFileSync(project)).model().images;
  const out = join(folder(), 'covariances.csv');
  const { code, stderr } = tiepoint('covariances', project, '--of', `${first?.name},point:0`, '--out', out);
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
  assert.ok(readFileSync(out, 'utf8').split('\n').length > 50);
  const refused = tiepoint('covariances', project, '--of', 'nobody.jpg', '--out', out);
  assert.ok(refused.code === 1 && /nobody\.jpg/.test(refused.stderr), refused.stderr);
  assert.match(tiepoint('covariances', project, '--out', out).stderr, /--of is missing/);
});

test('maps of the accuracy that is to be expected are written, and say what the standard errors of tie points say', () => {
  const project = join(WHOLE.out, 'project.tiepoint');
  const out = folder();
  const { code, stdout, stderr } = tiepoint('accuracy', project, '--out', out);
  assert.equal(code, 0, stderr);
  assert.match(stdout, /^standard error in height: \S+ in the median, \S+ at 95 % of the cells$/m);
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
  assert.match(refused('[{"kind": "reject_points", "points": [{"tie_point": 4000000}]}]'), /tie point 4000000/);
  assert.match(refused('[{"kind": "reject_images", "images": [9]}]'), /index 9/);
  assert.match(refused('[{"kind": "reject_pairs", "pairs": [[3, 3]]}]'), /pair of images: got \[3, 3\]/);
  assert.match(refused('[{"kind": "paint"}]'), /paint/);
  assert.match(refused('{"kind": "reject_images"}'), /no list of edits/);
  assert.match(refused('[{'), /no JSON/);
  // A list without its brackets is no project either.
  assert.match(refused('{"kind": "reject_images"}, {"kind": "reject_points"}'), /edits\.json: it is no JSON \(.*position 25/);
  assert.match(tiepoint('edit', project).stderr, /--out is missing/);
});
