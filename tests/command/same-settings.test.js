/** The same settings give the same matches from the package, the command, the stages that the page calls and, by the golden files, from Rust and the page itself. */

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import {
  estimate_offset,
  interior,
  match_pair,
  match_photos,
  matches_csv,
  nearest_piece,
  parse_camera,
  parse_fiducials,
  Photo,
  resolved,
} from '../../pkg/node.js';
import { folder, json, samplePair } from './command.js';

const { at, call } = samplePair();
const golden = (/** @type {string} */ name) =>
  readFileSync(new URL(`../golden/${name}`, import.meta.url), 'utf8')
    .trimEnd()
    .split('\n')
    .slice(0, -1)
    .join('\n');

/** @param {string} file */
const bytes = (file) => readFileSync(join(at, file));
/** @param {string} file */
const text = (file) => readFileSync(join(at, file), 'utf8');
/** @param {string} option */
const given = (option) => call[call.indexOf(option) + 1] ?? '';
const [left, right] = [Photo.decode(bytes('left.png')), Photo.decode(bytes('right.png'))];
const camera = parse_camera(text('camera.json'));
const side = (/** @type {'left' | 'right'} */ name) => ({
  fiducials: parse_fiducials(text(`${name}-fiducials.csv`)),
  origin: /** @type {[number, number]} */ (given(`--${name}-origin`).split(',').map(Number)),
});
const input = { camera, left: side('left'), right: side('right') };
const orientation = { base_mm: Number(given('--base-mm')) };

/** As the page does it: stage by stage, each with the settings as they were given.  @param {any} settings */
function byStages(settings) {
  const described = [left, right].map((photo) => photo.describe_points(settings));
  const [ofLeft, ofRight] = described;
  assert.ok(ofLeft && ofRight);
  const gradient = resolved(settings).matching.strategy === 'gradient';
  const offset = gradient ? null : estimate_offset(left.reduced(1024), right.reduced(1024));
  const interiors = {
    focal_mm: camera.focal_mm,
    left: interior(camera, { width: left.width, height: left.height, ...input.left }),
    right: interior(camera, { width: right.width, height: right.height, ...input.right }),
  };
  const [a, b] = [ofLeft.gradients ?? new Uint8Array(), ofRight.gradients ?? new Uint8Array()];
  const half = Math.floor(a.length / 256);
  const pieces = gradient ? [nearest_piece(a, 0, half, b), nearest_piece(a, half, a.length / 128, b)] : undefined;
  return match_photos(left, right, ofLeft, ofRight, offset, interiors, settings, pieces);
}

for (const [name, file, settings, options] of /** @type {const} */ ([
  ['gradients', 'sample-gradient.csv', { matching: { strategy: 'gradient' } }, ['--strategy', 'gradient']],
  ['the default', 'sample.csv', {}, []],
  ['moments', 'sample-moments.csv', { points: { fraction: 0.148 }, matching: { strategy: 'moments' } }, ['--fraction', '0.148', '--strategy', 'moments']],
  [
    'least squares',
    'sample-least-squares.csv',
    { points: { fraction: 0.148 }, matching: { strategy: 'least-squares' } },
    ['--fraction', '0.148', '--strategy', 'least-squares'],
  ],
])) {
  test(`the same settings give the same result from every entry: ${name}`, () => {
    const wanted = golden(file);
    const all = { ...settings, orientation };
    const { match, orientation: found } = match_pair(left, right, input, all);
    assert.equal(matches_csv(match.matches, found?.rejected).trimEnd(), wanted, 'package');
    assert.equal(matches_csv(byStages(all).matches, found?.rejected).trimEnd(), wanted, 'stages');
    const out = folder();
    json(...call, ...options, '--out', out);
    assert.equal(readFileSync(join(out, 'matches.csv'), 'utf8').trimEnd(), wanted, 'command');
  });
}
