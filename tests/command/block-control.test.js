/** Control and check points of a block, from tables that fit it and from those that do not. */

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { FinishedBlock } from '../../pkg/node.js';
import { marksOf, runOnce } from './blocks.js';
import { file, folder, tiepoint } from './command.js';

const { block: BLOCK, half, ran } = runOnce();

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
