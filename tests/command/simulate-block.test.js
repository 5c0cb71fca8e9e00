import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { Photo, read_exif } from '../../pkg/node.js';
import { contents, SMALL } from './blocks.js';
import { folder, json, tiepoint } from './command.js';

const TINY = [...SMALL.slice(4, -2), '--strips', '2', '--exposures', '2'];

/** @param {string[]} options */
function made(...options) {
  const at = folder();
  return { at, ...json('simulate', '--block', '--out', at, ...TINY, ...options) };
}

test('a block is photographed with camera and recorded position', () => {
  const { at, photos } = made('--receiver-m', '0');
  assert.equal(photos.length, 4);
  const truth = JSON.parse(readFileSync(join(at, 'truth.json'), 'utf8')).block;
  assert.deepEqual(
    readdirSync(join(at, 'photos')),
    truth.images.map((/** @type {any} */ image) => image.name),
  );
  const bytes = readFileSync(photos[3]);
  const photo = Photo.decode(bytes);
  assert.deepEqual([photo.width, photo.height], [480, 360]);
  const exif = read_exif(bytes, 480, 360);
  assert.ok(exif.camera && Math.abs(exif.camera.focal_mm - 85) < 1e-4 && Math.abs((exif.camera.pixel_mm ?? 0) - 0.12) < 1e-6, JSON.stringify(exif));
  assert.equal(exif.orientation, 1);
  const [, , z] = truth.images[3].pose.position;
  assert.ok(exif.position && Math.abs((exif.position.height_m ?? 0) - z - truth.origin.height_m) < 0.5, JSON.stringify(exif.position));
  assert.ok(Math.abs(exif.position.longitude_deg - 8) < 0.02 && Math.abs(exif.position.latitude_deg - 50) < 0.02);
});

test('one worker makes the photos of two, another seed others', () => {
  const [one, two, other] = [made('--workers', '1'), made('--workers', '2'), made('--seed', '9')];
  assert.deepEqual(contents(one.at), contents(two.at));
  assert.notDeepEqual(readFileSync(one.photos[0]), readFileSync(other.photos[0]));
});

test('flights that cannot be photographed are refused by name', () => {
  for (const [options, pattern] of /** @type {[string[], RegExp][]} */ ([
    [['--relief-m', '200'], /--relief-m is 200; allowed: 0 to 80/],
    [['--strips', '900'], /--flying-height-m is 800; allowed: up to \d+ m/],
    [['--strips', '0'], /--strips is 0; allowed: whole numbers from 1 to 1000/],
    [['--view', 'up'], /--view is up; allowed: nadir, oblique, two-heights/],
    [['--focal-mm', '100'], /tiepoint simulate --block has no option --focal-mm/],
  ])) {
    const { code, stderr } = tiepoint('simulate', '--block', '--out', folder(), ...options);
    assert.equal(code, 2, stderr);
    assert.match(stderr, pattern);
    assert.doesNotMatch(stderr, /block_flight\./);
  }
  assert.match(tiepoint('simulate', '--block').stderr, /--out is missing/);
  assert.match(tiepoint('simulate', '--block', '--help').stdout, /--flying-height-m/);
});
