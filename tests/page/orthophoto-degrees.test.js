/** An orthophoto in degrees: it lies under the map of a block where one of its UTM zone lies, is there after a reload, and nothing is placed on it. */

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { BlockScene } from '../../pkg/node.js';
import { block, FLIGHT, photos, status } from './blocks.js';
import { georeferenced } from './georeferenced.js';
import { hosted, part, rowsKept, says, SHOTS, SKIP, until, upload } from './page.js';
import { blockGround } from './rendered.js';

hosted();

/** @typedef {import('playwright-core').Page} Page */

/** The colours of the map, all of it three channels a pixel, once they stay as they are.  @param {Page} page */
async function shown(page) {
  const colours = () =>
    page.evaluate(() => {
      const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector('[data-testid="block-map"] [data-testid="layer-map"]'));
      const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d')).getImageData(0, 0, canvas.width, canvas.height);
      return { width: canvas.width, data: [...data].filter((_, i) => i % 4 < 3) };
    });
  let now = await colours();
  for (;;) {
    await page.waitForTimeout(300);
    const next = await colours();
    const isBlue = next.data.filter((blue, i) => i % 3 === 2 && Math.abs(blue - (next.data[i - 2] ?? 0)) > 20).length > next.data.length / 60;
    if (isBlue && next.data.every((value, i) => value === now.data[i])) return next;
    now = next;
  }
}

/** How far two pictures of the map differ in the mean, the second one shifted by so many px.  @param {{ width: number, data: number[] }} one @param {number[]} other @param {number} right @param {number} down */
function difference({ width, data }, other, right, down) {
  const height = data.length / 3 / width;
  let [sum, count] = [0, 0];
  for (let y = 10; y < height - 10; y += 1)
    for (let x = 10; x < width - 10; x += 1)
      for (let k = 0; k < 3; k += 1) {
        sum += Math.abs((data[3 * (y * width + x) + k] ?? 0) - (other[3 * ((y + down) * width + x + right) + k] ?? 0));
        count += 1;
      }
  return sum / count;
}

test('an orthophoto in degrees lies under the map as that in UTM does; it is kept, and nothing is placed on it', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  const scene = new BlockScene(FLIGHT);
  const { origin } = scene.truth();
  const [, , ground = 0] = scene.surface_at(1, Float64Array.of(240, 180));
  scene.free();
  assert.ok(origin);
  const picture = blockGround(FLIGHT, 1).find(({ name }) => name === 'orthophoto.tif')?.bytes ?? new Uint8Array();
  const [utm, degrees] = [georeferenced(picture, 32632, origin, ground), georeferenced(picture, 4326, origin, ground)];
  await photos(page);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  const give = async (/** @type {ReturnType<typeof upload>[]} */ ...files) => {
    await part(page, 'block-orthophoto-input').setInputFiles(files);
    await says(page, 'block-orthophoto-name', new RegExp(`^Orthophoto ${files[0]?.name.replace('.', '\\.')}`));
    await part(page, 'block-show-map').click();
  };
  await part(page, 'tab-block-orthophoto').click();
  await give(upload('utm.tif', utm.tif));
  await says(page, 'block-layout', /by the positions of both on the earth \(EPSG:32632\)\./);
  await part(page, 'map-points').selectOption('none');
  for (const own of ['map-connections', 'map-footprints', 'map-offsets'])
    if ((await part(page, own).getAttribute('aria-pressed')) === 'true') await part(page, own).click();
  const expected = await shown(page);
  await give(upload('degrees.tif', degrees.tif));
  await status(
    page,
    / px of 1 m\. It is in degrees \(EPSG:4326\): it lies under the map, and is shown by itself in EPSG:32632\. Images are placed on one in a projected system alone/,
  );
  await says(page, 'block-layout', /by the positions of both on the earth \(EPSG:4326\)\./);
  for (const own of ['map-connections', 'map-footprints', 'map-offsets'])
    if ((await part(page, own).getAttribute('aria-pressed')) === 'true') await part(page, own).click();
  const tags = await shown(page);
  await page.screenshot({ path: join(SHOTS, 'block-map-degrees.png') });
  const isThere = (/** @type {{ width: number, data: number[] }} */ now) => {
    const by = (/** @type {number} */ right, /** @type {number} */ down) => difference(expected, now.data, right, down);
    const near = by(0, 0);
    for (const [right, down] of /** @type {const} */ ([
      [2, 0],
      [-2, 0],
      [0, 2],
      [0, -2],
    ]))
      assert.ok(near < 0.6 * by(right, down), `${near} as it is, ${by(right, down)} shifted by ${right}, ${down}`);
  };
  isThere(tags);
  // Coordinates under the pointer are those of both systems.
  await part(page, 'block-map').hover();
  await says(page, 'map-place', /^E .* EPSG:4326 \d+\.\d{7} \d+\.\d{7}$/);
  // It is looked at alone.
  assert.deepEqual([await part(page, 'orthophoto-purpose').inputValue(), await part(page, 'orthophoto-purpose').isDisabled()], ['map', true]);
  await part(page, 'block-show-orthophoto').click();
  assert.ok(await part(page, 'place-add').isHidden());
  await page.screenshot({ path: join(SHOTS, 'orthophoto-degrees.png') });

  // A picture with a world file says it in numbers alone; it is there after a reload.
  await give(upload('world.png', degrees.png, 'image/png'), upload('world.pgw', new TextEncoder().encode(degrees.world)));
  await says(page, 'block-layout', /by the positions of both on the earth \(EPSG:4326\)\./);
  await until(page, 'it is kept', async () => JSON.stringify(await rowsKept(page, 'block')).includes('world.png'));
  await page.reload();
  await says(page, 'block-layout', /by the positions of both on the earth \(EPSG:4326\)\./);
  await says(page, 'block-orthophoto-name', /^Orthophoto world\.png.*It is in degrees/);
  assert.deepEqual(complaints, []);
  await close();
});
