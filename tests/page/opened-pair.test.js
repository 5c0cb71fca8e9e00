/** A pair that is opened from a block, with what the block knows of its camera. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BlockScene, FinishedBlock, grey_png, photo_camera } from '../../pkg/node.js';
import { done, hosted, open, part, saved, SKIP, upload } from './page.js';

hosted();

const FLIGHT = { strips: 2, exposures: 3, width_px: 480, height_px: 360, pixel_mm: 0.15 };
const FOCAL_MM = 85;
/** In the direction from object to image, without unit. */
const K1 = -0.02;
/** Six standard errors from the truth, which is 0. */
const WRONG_K1 = -0.06;
const CAMERA = { images: '*.png', focal_px: FOCAL_MM / FLIGHT.pixel_mm, principal_point_px: [242, 180], radial: [K1, 0, 0], pixel_mm: FLIGHT.pixel_mm };

/** Runs a block of photos of one camera and opens its first pair.  @param {import('playwright-core').Page} page @param {object} camera */
async function openedPair(page, camera) {
  await part(page, 'mode-block').click();
  const scene = new BlockScene(FLIGHT);
  const photos = Array.from({ length: FLIGHT.strips * FLIGHT.exposures }, (_, index) => {
    const { width, height, grey } = scene.photo(index);
    return upload(`photo_${index}.png`, grey_png(width, height, grey), 'image/png');
  });
  scene.free();
  await part(page, 'block-files-input').setInputFiles(photos);
  await part(page, 'block-cameras-input').setInputFiles([upload('cameras.json', Buffer.from(JSON.stringify({ cameras: [camera] })), 'application/json')]);
  await part(page, 'block-run').click();
  await page.waitForFunction(() =>
    /^(Oriented|Weak orientation|Not oriented|The block was)/.test(document.querySelector('[data-testid="block-status"]')?.textContent ?? ''),
  );
  await part(page, 'block-export-kind').selectOption('project');
  const block = FinishedBlock.open(await saved(page, 'block-export')).model();
  await part(page, 'block-show-matrix').click();
  await part(page, 'block-matrix').focus();
  await page.keyboard.press('ArrowRight');
  await part(page, 'block-open-pair').click();
  await done(page);
  await part(page, 'tab-camera').click();
  const value = async (/** @type {string} */ id) => Number(await part(page, id).inputValue());
  const [focal, x0, y0, k1, k2, k3] = await Promise.all(['camera-focal', 'camera-x0', 'camera-y0', 'camera-k1', 'camera-k2', 'camera-k3'].map(value));
  return { block, shown: { focal, x0, y0, k1, k2, k3 } };
}

test('a pair of a block has its focal length, principal point and distortion', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  const {
    shown: { focal = 0, x0 = 0, y0 = 0, k1 = 0 },
  } = await openedPair(page, { ...CAMERA, fixed: true });
  assert.ok(Math.abs(focal - FOCAL_MM) < 1e-6);
  assert.ok(Math.abs(x0 - 2 * FLIGHT.pixel_mm) < 1e-6 && Math.abs(y0) < 1e-9);
  // A correction of what was measured has the other sign; its first term is that of the other direction but for higher ones.
  assert.ok(Math.abs(k1 * FOCAL_MM ** 2 + K1) < 0.05 * Math.abs(K1), `k1 is ${k1}`);
  assert.deepEqual(complaints, []);
  await close();
});

test('a pair of a block that was adjusted has its calibrated camera, not that of the file', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  const { block, shown } = await openedPair(page, { ...CAMERA, radial: [WRONG_K1, 0, 0] });
  const [camera] = block.cameras;
  assert.ok(camera && block.images.every(({ pose }) => pose), 'the block is not oriented');
  const {
    focal_mm,
    principal_point_mm: [x0, y0],
    radial_distortion: [k1, k2, k3],
  } = /** @type {Required<import('../../pkg/node.js').CameraMm>} */ (photo_camera(camera));
  assert.deepEqual(shown, { focal: focal_mm, x0, y0, k1, k2, k3 });
  // The photos were taken without distortion: what the file says of it is wrong, and the block finds that.
  assert.ok(Math.abs(camera.radial?.[0] ?? NaN) < 0.5 * Math.abs(WRONG_K1), `k1 is ${camera.radial}`);
  assert.deepEqual(complaints, []);
  await close();
});
