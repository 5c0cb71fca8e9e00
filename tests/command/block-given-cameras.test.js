/** Cameras that are given to a block, in place of those of its files. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { runOnce } from './blocks.js';
import { file, folder, tiepoint } from './command.js';

const { block: BLOCK, half } = runOnce();

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
