/** A pair that is opened from a block, with what the block knows of its camera. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BlockScene } from '../../pkg/node.js';
import { greyPng } from '../../pkg/command/png.js';
import { done, hosted, open, part, SKIP, upload } from './page.js';

hosted();

const FLIGHT = { strips: 1, exposures: 3, width_px: 480, height_px: 360, pixel_mm: 0.15 };
const FOCAL_MM = 85;
/** In the direction from object to image, without unit. */
const K1 = -0.02;

test('a pair of a block has its focal length, principal point and distortion', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await part(page, 'mode-block').click();
  const scene = new BlockScene(FLIGHT);
  const photos = [0, 1, 2].map((index) => {
    const { width, height, grey } = scene.photo(index);
    return upload(`photo_${index}.png`, greyPng(width, height, grey), 'image/png');
  });
  scene.free();
  await part(page, 'block-files-input').setInputFiles(photos);
  const camera = { images: '*.png', focal_px: FOCAL_MM / FLIGHT.pixel_mm, principal_point_px: [242, 180], radial: [K1, 0, 0], pixel_mm: FLIGHT.pixel_mm, fixed: true };
  await part(page, 'block-cameras-input').setInputFiles([upload('cameras.json', Buffer.from(JSON.stringify({ cameras: [camera] })), 'application/json')]);
  await part(page, 'block-run').click();
  await page.waitForFunction(() => /^(Done|The block was)/.test(document.querySelector('[data-testid="block-status"]')?.textContent ?? ''), undefined, { timeout: 60_000 });
  await part(page, 'block-show-matrix').click();
  await part(page, 'block-matrix').focus();
  await page.keyboard.press('ArrowRight');
  await part(page, 'block-open-pair').click();
  await done(page);
  await part(page, 'tab-camera').click();
  const value = async (/** @type {string} */ id) => Number(await part(page, id).inputValue());
  assert.ok(Math.abs(await value('camera-focal') - FOCAL_MM) < 1e-6);
  assert.ok(Math.abs(await value('camera-x0') - 2 * FLIGHT.pixel_mm) < 1e-6 && Math.abs(await value('camera-y0')) < 1e-9);
  // A correction of what was measured has the other sign; its first term is that of the other direction but for higher ones.
  assert.ok(Math.abs(await value('camera-k1') * FOCAL_MM ** 2 + K1) < 0.05 * Math.abs(K1), `k1 is ${await value('camera-k1')}`);
  assert.deepEqual(complaints, []);
  await close();
});
