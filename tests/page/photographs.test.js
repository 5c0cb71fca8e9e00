/** Photographs that are dropped as a stranger does it: what cannot be oriented is not called oriented, and what is right or level is. They are no part of the project. */

import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { FinishedBlock } from '../../pkg/node.js';
import { DATA, readJson } from '../../tools/lib/paths.mjs';
import { directionError, poseOf, rotationError } from '../../tools/score.mjs';
import { block, status } from './blocks.js';
import { done, hosted, open, part, saved, says, SKIP, upload } from './page.js';

hosted('/photographs/');

/** The reason why a test of a folder cannot run; false where it can.  @param {string[]} folders */
function without(...folders) {
  const absent = folders.map((folder) => join(DATA, folder)).find((path) => !existsSync(path));
  return absent ? `${absent} is absent` : SKIP;
}

/** @param {string} folder @param {string} name */
const photograph = (folder, name) => upload(name, readFileSync(join(DATA, folder, name)), `image/${name.endsWith('png') ? 'png' : 'jpeg'}`);

/** How a pair of files ends on the page.  @param {import('playwright-core').Page} page @param {ReturnType<typeof upload>[]} files */
async function verdictOf(page, files) {
  await part(page, 'file-input').setInputFiles(files);
  const line = await done(page);
  return { line, verdict: await part(page, 'answer').getAttribute('data-verdict') };
}

const EXACT = 'semisynth_exact_caliterra';

test('an oblique view with the camera given is oriented right, or not called oriented', { skip: without(EXACT) }, async () => {
  const truth = readJson(join(DATA, EXACT, 'truth.json'));
  const [f, , cx, cy] = truth.images[0].K;
  const { width, height } = truth.images[0];
  // The truth has pixel centres at whole numbers.
  const camera = { focal_mm: f / 1000, pixel_mm: 0.001, principal_point_mm: [(cx + 0.5 - width / 2) / 1000, (height / 2 - cy - 0.5) / 1000] };
  const { page, complaints, close } = await open();
  const given = upload('camera.json', Buffer.from(JSON.stringify(camera)), 'application/json');
  const { line, verdict } = await verdictOf(page, [photograph(EXACT, 'v1.png'), photograph(EXACT, 'v4.jpg'), given]);
  const { orientation } = JSON.parse((await saved(page, 'export-json')).toString());
  const { R, t } = truth.pairs.find((/** @type {{ a: string, b: string }} */ { a, b }) => a === 'v1.png' && b === 'v4.jpg');
  const pose = orientation && poseOf(orientation);
  const isRight = pose && rotationError(pose.rotation, R) < 1 && directionError(pose.direction, t) < 1;
  assert.ok(isRight || verdict !== 'oriented', line);
  assert.deepEqual(complaints, []);
  await close();
});

/**
 * The middle of a photograph as another program saves it: cropped to a share of both sides, with the EXIF data of the whole.
 * @param {import('playwright-core').Page} page @param {ReturnType<typeof photograph>} photo @param {number} share @returns {Promise<ReturnType<typeof photograph>>}
 */
async function cropped(page, photo, share) {
  const pixels = await page.evaluate(
    async ([base64 = '', part = '']) => {
      const image = await createImageBitmap(new Blob([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))]), { imageOrientation: 'none' });
      const [width, height] = [image.width, image.height].map((side) => Math.round(side * Number(part)));
      const canvas = new OffscreenCanvas(width ?? 0, height ?? 0);
      canvas.getContext('2d')?.drawImage(image, Math.round(((width ?? 0) - image.width) / 2), Math.round(((height ?? 0) - image.height) / 2));
      return [...new Uint8Array(await (await canvas.convertToBlob({ type: 'image/jpeg', quality: 0.95 })).arrayBuffer())];
    },
    [photo.buffer.toString('base64'), String(share)],
  );
  // The segment of the EXIF data follows the start of the image.
  const start = photo.buffer.indexOf(Buffer.from([0xff, 0xe1]));
  const exif = photo.buffer.subarray(start, start + 2 + photo.buffer.readUInt16BE(start + 2));
  return { ...photo, buffer: Buffer.concat([Buffer.from([0xff, 0xd8]), exif, Buffer.from(pixels.slice(2))]) };
}

test('photographs that were cropped by another program make a weak pair, with a caution', { skip: without('block_caliterra') }, async () => {
  const { page, complaints, close } = await open();
  const photos = ['IMG_9404.jpg', 'IMG_9405.jpg'].map((name) => photograph('block_caliterra', name));
  const whole = await verdictOf(page, photos);
  assert.equal(whole.verdict, 'oriented', whole.line);
  const parts = await Promise.all(photos.map((photo) => cropped(page, photo, 0.75)));
  await part(page, 'file-input').setInputFiles(parts);
  const line = await says(page, 'status', /^(Weak|Not oriented).*cropped/);
  assert.equal(await part(page, 'answer').getAttribute('data-verdict'), 'weak', line);
  assert.deepEqual(complaints, []);
  await close();
});

test('a photograph and what was cropped of it are called parts of one image', { skip: without('block_caliterra') }, async () => {
  const { page, complaints, close } = await open();
  const photo = photograph('block_caliterra', 'IMG_9404.jpg');
  const crop = await cropped(page, photo, 0.8);
  const { line, verdict } = await verdictOf(page, [photo, { ...crop, name: 'crop.jpg' }]);
  assert.equal(verdict, 'not_oriented', line);
  assert.match(line, /both may be parts of one image/);
  await part(page, 'answer')
    .getByRole('button', { name: /other photos/ })
    .waitFor();
  assert.deepEqual(complaints, []);
  await close();
});

test('photographs of two places are not oriented', { skip: without('block_caliterra', 'lowtexture_nir_seneca') }, async () => {
  const { page, complaints, close } = await open();
  const { line, verdict } = await verdictOf(page, [photograph('block_caliterra', 'IMG_9404.jpg'), photograph('lowtexture_nir_seneca', 'IMG_0473.jpg')]);
  assert.equal(verdict, 'not_oriented', line);
  assert.match(line, /^Not oriented/);
  assert.deepEqual(complaints, []);
  await close();
});

const LEVEL_DEG = 3;

test('a block of twelve photographs of a flight is level', { skip: without('block_caliterra') }, async () => {
  const { page, complaints, close } = await block();
  const names = readdirSync(join(DATA, 'block_caliterra')).filter((name) => name.endsWith('.jpg'));
  await part(page, 'block-files-input').setInputFiles(names.map((name) => photograph('block_caliterra', name)));
  await status(page, /Press Run/);
  await part(page, 'block-run').click();
  const line = await status(page, /^(Oriented|Weak orientation|Not oriented|The block was)/);
  assert.match(line, /^(Oriented|Weak orientation): /);
  await part(page, 'block-export-kind').selectOption('project');
  const { images } = FinishedBlock.open(await saved(page, 'block-export')).model();
  const axes = images.flatMap(({ pose }) => (pose ? [pose.rotation[2]] : []));
  assert.equal(axes.length, 12, line);
  // The photographs look down, each within some degrees: all of them together look along the vertical.
  const [x = NaN, y = NaN, z = NaN] = [0, 1, 2].map((axis) => axes.reduce((sum, row) => sum + (row[axis] ?? NaN), 0) / axes.length);
  const off = (Math.atan2(Math.hypot(x, y), z) * 180) / Math.PI;
  assert.ok(off < LEVEL_DEG, `${off}° off the vertical: ${line}`);
  assert.deepEqual(complaints, []);
  await close();
});
