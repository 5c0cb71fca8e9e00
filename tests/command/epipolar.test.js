/** The command `epipolar`: what two oriented images show lies in the same row of their epipolar images. */

import assert from 'node:assert/strict';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { inflateSync } from 'node:zlib';
import { test } from 'node:test';
import { Photo } from '../../pkg/node.js';
import { file, folder, image, json, samplePair, tiepoint } from './command.js';
import { photographed } from './blocks.js';

/** Epipolar images that the command made. */
function made(/** @type {string[]} */ ...args) {
  const out = folder();
  const { code, stdout, stderr } = tiepoint('epipolar', ...args, '--out', out);
  assert.equal(code, 0, stderr);
  const photo = (/** @type {string} */ name) => Photo.decode(readFileSync(join(out, name)));
  return {
    stdout,
    left: photo('left.png'),
    right: photo('right.png'),
    anaglyph: photo('anaglyph.png'),
    parameters: JSON.parse(readFileSync(join(out, 'epipolar.json'), 'utf8')),
  };
}

/** The pixels of a PNG of red, green and blue of 8 bits, without its filters.  @param {string} path */
function colours(path) {
  const bytes = readFileSync(path);
  const [width, height] = [bytes.readUInt32BE(16), bytes.readUInt32BE(20)];
  assert.deepEqual([bytes[24], bytes[25]], [8, 2], `${path} is not in colours`);
  const packed = [];
  for (let at = 8; at < bytes.length; at += 12 + bytes.readUInt32BE(at))
    if (bytes.toString('latin1', at + 4, at + 8) === 'IDAT') packed.push(bytes.subarray(at + 8, at + 8 + bytes.readUInt32BE(at)));
  const data = inflateSync(Buffer.concat(packed));
  const stride = 3 * width;
  const pixels = new Uint8Array(stride * height);
  for (let row = 0; row < height; row += 1) {
    const filter = data[row * (stride + 1)];
    for (let k = 0; k < stride; k += 1) {
      const [left, above, corner] = [
        k < 3 ? 0 : pixels[row * stride + k - 3],
        pixels[(row - 1) * stride + k] ?? 0,
        k < 3 ? 0 : (pixels[(row - 1) * stride + k - 3] ?? 0),
      ];
      const [a = 0, b, c] = [left, row === 0 ? 0 : above, row === 0 ? 0 : corner];
      const paeth = () => {
        const [pa, pb, pc] = [Math.abs(b - c), Math.abs(a - c), Math.abs(a + b - 2 * c)];
        return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
      };
      const guess = [0, a, b, (a + b) >> 1, paeth()][filter ?? 0] ?? 0;
      pixels[row * stride + k] = (data[row * (stride + 1) + 1 + k] ?? 0) + guess;
    }
  }
  return { width, pixels };
}

/** Of windows of the left image the shift in rows at which the right one resembles them most, along their rows. */
function rowShifts(/** @type {Photo} */ left, /** @type {Photo} */ right, /** @type {number} */ reach) {
  const { width, height } = left;
  const [a, b] = [left.grey(), right.grey()];
  const half = 7;
  const shifts = [];
  for (let row = 60; row < height - 60; row += 40) {
    for (let col = reach + 60; col < width - reach - 60; col += 40) {
      let best = { difference: Infinity, down: 0 };
      for (let down = -3; down <= 3; down += 1) {
        for (let along = -reach; along <= reach; along += 1) {
          let difference = 0;
          for (let r = -half; r <= half; r += 1) {
            for (let c = -half; c <= half; c += 1)
              difference += Math.abs((a[(row + r) * width + col + c] ?? 0) - (b[(row + r + down) * width + col + c + along] ?? 0));
          }
          if (difference < best.difference) best = { difference, down };
        }
      }
      shifts.push(best.down);
    }
  }
  return shifts;
}

test('what the photos of an oriented pair show lies in the same rows, and its columns tell how far it is', () => {
  const { at, call } = samplePair();
  const out = folder();
  assert.ok([0, 3].includes(tiepoint(...call, '--out', out).code ?? 1));
  const { stdout, left, right, anaglyph, parameters } = made(join(out, 'project.tiepoint'), at);
  const { width_px: width, height_px: height, focal_px: focal, base, principal_points_px: principal, parallaxes } = parameters;
  for (const picture of [left, right, anaglyph]) assert.deepEqual([picture.width, picture.height], [width, height]);
  assert.deepEqual([parameters.left, parameters.right], ['left.png', 'right.png']);
  assert.deepEqual(parameters.system, { kind: 'photo', image: 'left.png' });
  assert.ok(parallaxes.points > 300 && parallaxes.y_rms_px < 0.5 && Math.abs(parallaxes.x_px[1]) <= 0.5, JSON.stringify(parallaxes));
  assert.match(stdout, /residual y-parallax of \d+ points: 0\.\d\d px RMS/);
  const shifts = rowShifts(left, right, Math.ceil(Math.max(...parallaxes.x_px.map(Math.abs))) + 2);
  const same = shifts.filter((down) => Math.abs(down) <= 1).length;
  assert.ok(shifts.length > 20 && same > 0.8 * shifts.length, `${same} of ${shifts.length}`);
  // The ground lies where the parallaxes have it: about as far below as the flight was high, in bases.
  const [ofLeft, ofRight] = principal;
  const farAway = (focal * base) / (parallaxes.x_px[1] - ofLeft[0] + ofRight[0]);
  assert.ok(farAway > base && farAway < 5 * base, `${farAway} ${base}`);
  assert.ok(height > 300);
});

test('epipolar images have the colours of their photos, and the anaglyph their grey values', () => {
  const { at, call } = samplePair();
  const [coloured, out] = [folder(), folder()];
  for (const side of ['left', 'right']) {
    const photo = Photo.decode(readFileSync(join(at, `${side}.png`)));
    const colours = Buffer.from([...photo.grey()].flatMap((grey) => [grey, grey, 255 - grey]));
    writeFileSync(join(coloured, `${side}.ppm`), Buffer.concat([Buffer.from(`P6\n${photo.width} ${photo.height}\n255\n`), colours]));
  }
  // The truth is of the grey photos.
  const ofColoured = call
    .slice(0, call.indexOf('--truth'))
    .map((word) => (/(?:left|right)\.png$/.test(word) ? join(coloured, basename(word).replace('.png', '.ppm')) : word));
  assert.ok([0, 3].includes(tiepoint(...ofColoured, '--out', out).code ?? 1));
  const made = folder();
  const { files, ...parameters } = json('epipolar', join(out, 'project.tiepoint'), coloured, '--out', made);
  assert.deepEqual(
    files,
    ['left.png', 'right.png', 'anaglyph.png', 'epipolar.json'].map((name) => join(made, name)),
  );
  assert.deepEqual(parameters, JSON.parse(readFileSync(join(made, 'epipolar.json'), 'utf8')));
  for (const side of ['left', 'right']) {
    const { width, pixels } = colours(join(made, `${side}.png`));
    let [shown, right] = [0, 0];
    for (let k = 0; k < pixels.length; k += 3) {
      const [red = 0, green = 0, blue = 0] = pixels.subarray(k, k + 3);
      if (red + green + blue === 0) continue;
      shown += 1;
      right += Number(red === green && Math.abs(red + blue - 255) <= 1);
    }
    assert.ok(width > 300 && shown > 100_000 && right > 0.999 * shown, `${side}: ${right} of ${shown}`);
  }
  const anaglyph = colours(join(made, 'anaglyph.png')).pixels;
  assert.ok(anaglyph.every((value, k) => k % 3 !== 2 || value === anaglyph[k - 1]));
});

test('of a block the two images with most points in common are taken, or those that are named', () => {
  const { call, photos } = photographed();
  const out = folder();
  assert.equal(tiepoint(...call, '--out', out).code, 0);
  const project = join(out, 'project.tiepoint');
  const names = readdirSync(photos);
  const found = made(project, photos);
  assert.ok(names.includes(found.parameters.left) && names.includes(found.parameters.right));
  assert.ok(found.parameters.parallaxes.y_rms_px < 1);
  // Its photos record where on the earth they were taken.
  const { origin } = JSON.parse(readFileSync(join(out, 'summary.json'), 'utf8')).orientation;
  assert.ok(Math.abs(origin.latitude_deg) > 0, JSON.stringify(origin));
  assert.deepEqual(found.parameters.system, { kind: 'tangent', origin });
  const { left, right } = found.parameters;
  const named = made(project, photos, '--left', left, '--right', right);
  assert.deepEqual(named.parameters, found.parameters);
  assert.deepEqual(named.left.grey(), found.left.grey());
});

test('what cannot be made says why', () => {
  const { at, call } = samplePair();
  const out = folder();
  tiepoint(...call, '--out', out);
  const project = join(out, 'project.tiepoint');
  const refused = (/** @type {string[]} */ ...args) => {
    const { code, stderr } = tiepoint('epipolar', ...args);
    assert.ok(code === 1 || code === 2, `${code}: ${stderr}`);
    return stderr;
  };
  assert.match(refused(project, at), /--out is missing/);
  assert.match(refused(project, at, '--out', folder(), '--left', 'left.png'), /belong together/);
  assert.match(refused(project, at, '--out', folder(), '--left', 'left.png', '--right', 'other.png'), /got other\.png; allowed: the names/);
  assert.match(refused(project, folder(), '--out', folder()), /left\.png/);
  assert.match(refused(join(at, 'left.png'), at, '--out', folder()), /the project file/);
  const others = folder();
  for (const name of ['left.png', 'right.png']) image(others, name, 50, 40, () => 9);
  assert.match(refused(project, others, '--out', folder()), /left\.png: it is another file than the left\.png of the project/);
  assert.match(refused(project, at, '--out', folder(), '--left', 'left.png', '--right', 'left.png'), /got left\.png twice/);
  const flat = folder();
  const photo = image(flat, 'flat.png', 80, 60, () => 50);
  tiepoint('match', photo, photo, '--focal-px', '600', '--out', flat);
  assert.match(refused(join(flat, 'project.tiepoint'), flat, '--out', folder()), /is not oriented/);
  assert.match(refused(file(folder(), 'none.tiepoint', 'nothing'), at, '--out', folder()), /none\.tiepoint: /);
});
