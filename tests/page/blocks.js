/** The page's part for blocks, as its tests open and fill it. */

import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { BlockScene } from '../../pkg/node.js';
import { enabled, open, part, upload } from './page.js';
import { barePhotos, blockPhotos } from './rendered.js';

/** Small photos: six of them are rendered and matched in a few seconds. */
export const FLIGHT = { strips: 2, exposures: 3, width_px: 480, height_px: 360, pixel_mm: 0.15 };

/** @typedef {import('playwright-core').Page} Page */

/** @param {Page} page @param {RegExp} pattern @returns {Promise<string>} the status line once it is so */
export async function status(page, pattern) {
  await page.waitForFunction(
    ([source]) => new RegExp(source ?? '').test(document.querySelector('[data-testid="block-status"]')?.textContent ?? ''),
    [pattern.source],
  );
  return (await part(page, 'block-status').textContent()) ?? '';
}

/** A page that shows its part for blocks.  @param {Parameters<typeof open>[0]} [how] */
export async function block(how) {
  const opened = await open(how);
  await part(opened.page, 'mode-block').click();
  await enabled(opened.page, 'block-simulate');
  return opened;
}

/** Photographs the flight in the page.  @param {Page} page */
export async function photograph(page, flight = FLIGHT) {
  await part(page, 'tab-block-flight').click();
  for (const [field, value] of Object.entries(flight)) await page.locator(`input[data-key="block_flight.${field}"]`).first().fill(String(value));
  await part(page, 'block-photograph').click();
  await status(page, /Press Run/);
}

/** Gives the photos of the flight as files, and waits until they can be run. Nothing knows their truth.  @param {Page} page @param {RegExp} ready what is said then */
export async function photos(page, flight = FLIGHT, ready = /Press Run/) {
  await part(page, 'block-files-input').setInputFiles(blockPhotos(flight).map(({ name, bytes }) => upload(name, bytes, 'image/png')));
  await status(page, ready);
}

/** Waits until undo would take back this.  @param {Page} page @param {RegExp} pattern */
export const undoIs = (page, pattern) =>
  page.waitForFunction(
    ([source]) => {
      const adjusting = document.querySelector('[data-testid="block-edit-text"]')?.textContent === 'Adjusting the block …';
      return !adjusting && new RegExp(source ?? '', 'u').test(document.querySelector('[data-testid="block-undo"]')?.getAttribute('title') ?? '');
    },
    [pattern.source],
  );

/** Goes on to a tie point that the first image shows away from its edges: what surrounds it can be matched.  @param {Page} page */
export async function inside(page) {
  const pane = await part(page, 'pane-image-0').boundingBox();
  if (!pane) throw new Error('the first image is not shown');
  for (let k = 1; k < 80; k += 1) {
    await page.keyboard.press('n');
    // Its place is in the middle of the pane, and is told of where the pointer is.
    await page.mouse.move(pane.x + pane.width / 2 + (k % 2), pane.y + pane.height / 2);
    const place = /^photo_0+\.png: (\d+)\S*, (\d+)\S* px/.exec((await part(page, 'image-place').textContent()) ?? '');
    const [column = 0, row = 0] = place?.slice(1).map(Number) ?? [];
    if (column > 60 && column < FLIGHT.width_px - 60 && row > 30 && row < FLIGHT.height_px / 2 - 30) return;
  }
  throw new Error('no tie point is away from the edges of the first image');
}

/** A folder with photos of the flight and what is no image.  @param {number} count */
export function photoFolder(count) {
  const folder = mkdtempSync(join(tmpdir(), 'tiepoint-photos-'));
  for (const { name, bytes } of barePhotos(FLIGHT, count)) writeFileSync(join(folder, name), bytes);
  writeFileSync(join(folder, 'truth.json'), '{}');
  return folder;
}

/** How far apart two places of one surface may be, in m. */
const SAME_SURFACE_M = 0.5;

/**
 * A folder with all photos of the flight, and the tables of surveyed points on its ground: the second is a check point, the first is marked in two photos alone.
 * @returns {{ folder: string, points: string, marks: string, first: { image: string, column: number, row: number }[] }} first: where all photos show that
 */
export function surveyedFolder() {
  const folder = mkdtempSync(join(tmpdir(), 'tiepoint-surveyed-'));
  const scene = new BlockScene(FLIGHT);
  const { images, cameras } = scene.truth();
  const [camera] = cameras;
  if (!camera) throw new Error('the flight has a camera');
  for (const { name, bytes } of blockPhotos(FLIGHT)) writeFileSync(join(folder, name), bytes);
  const { width_px: width, height_px: height } = FLIGHT;
  /** @param {number} index @param {number[]} place @returns {[number, number] | null} where a photo shows a place, if nothing hides it */
  const shownBy = (index, place) => {
    const pose = images[index]?.pose;
    if (!pose) return null;
    const [x = 0, y = 0, z = 0] = pose.rotation.map((line) =>
      line.reduce((sum, value, axis) => sum + value * ((place[axis] ?? 0) - (pose.position[axis] ?? 0)), 0),
    );
    const [column, row] = [camera.principal_point_px[0] - (camera.focal_px * x) / z, camera.principal_point_px[1] + (camera.focal_px * y) / z];
    if (z > 0 || column < 5 || row < 5 || column > width - 5 || row > height - 5) return null;
    const seen = scene.surface_at(index, Float64Array.of(column, row));
    return Math.hypot(...place.map((value, axis) => value - (seen[axis] ?? NaN))) < SAME_SURFACE_M ? [column, row] : null;
  };
  const wanted = [0.25, 0.5, 0.75].flatMap((x) => [0.25, 0.5, 0.75].map((y) => [x * width, y * height]));
  const found = [1, 4].flatMap((image) =>
    wanted.map(([x = 0, y = 0]) => {
      const place = [...scene.surface_at(image, Float64Array.of(x, y))];
      const at = images.map((_, index) => shownBy(index, place));
      return {
        place,
        marks: at.flatMap((seen, index) => (seen === null ? [] : [{ image: `${images[index]?.name ?? ''}.png`, column: seen[0], row: seen[1] }])),
      };
    }),
  );
  scene.free();
  const used = found.filter(({ place, marks }) => marks.length >= 3 && place.every(Number.isFinite)).sort((a, b) => b.marks.length - a.marks.length);
  const points = used.map(({ place }, i) => `G${i},${place.map((value) => value.toFixed(4)).join()},${i === 1 ? 'check' : 'control'}`);
  const marks = used.flatMap(({ marks: all }, i) =>
    (i === 0 ? all.slice(0, 2) : all).map(({ image, column, row }) => `${image},G${i},${column.toFixed(3)},${row.toFixed(3)}`),
  );
  return { folder, points: `name,x,y,z,use\n${points.join('\n')}\n`, marks: `${marks.join('\n')}\n`, first: used[0]?.marks ?? [] };
}

/** Drops files of these names that hold no image.  @param {Page} page @param {string[]} names */
export async function drop(page, names) {
  const transfer = await page.evaluateHandle((given) => {
    const data = new DataTransfer();
    for (const name of given) data.items.add(new File(['no image'], name));
    return data;
  }, names);
  for (const type of ['dragenter', 'dragover', 'drop']) await part(page, 'block-map').dispatchEvent(type, { dataTransfer: transfer });
}
