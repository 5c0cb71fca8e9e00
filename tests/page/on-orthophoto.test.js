/** A block on an orthophoto, as a surveyor places it: dropped together, or on a finished block; what came of it, its places as control and check points, and what is kept. */

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { BlockScene, OrthophotoReference } from '../../pkg/node.js';
import { block, photos, status } from './blocks.js';
import { hosted, keptEdits, part, saved, says, SHOTS, SKIP, until, upload } from './page.js';
import { blockGround, blockPhotos } from './rendered.js';

hosted();

/** @typedef {import('playwright-core').Page} Page */

/** Large enough photos that each lies on the orthophoto. */
const FLIGHT = { strips: 2, exposures: 3, width_px: 480, height_px: 360, pixel_mm: 0.075 };
const GSD_M = 0.8;

const PLACED = /^Oriented: 6 of 6 images .*lies in the system of the orthophoto, by \d+ places that 6 of 6 images show; \d+ more check it/;

/** Files as they are given, their names set off by those of a flight.  @param {object} flight */
const groundFiles = (flight) => blockGround(flight, GSD_M).map(({ name, bytes }) => upload(name, bytes, 'image/tiff'));

/** The rows of a table of the block.  @param {Page} page @param {string} name @returns {Promise<string[][]>} */
async function rowsOf(page, name) {
  await part(page, `tab-block-${name}`).click();
  await page.waitForFunction((id) => document.querySelectorAll(`[data-testid="${id}"] tbody tr:not(.filler)`).length > 1, `block-${name}`);
  return page
    .locator(`[data-testid="block-${name}"] tbody tr:not(.filler)`)
    .evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent ?? '')));
}

const numberOf = (/** @type {string | undefined} */ cell) => Number((cell ?? '').replace('−', '-').replaceAll(/[^\d.-]/g, ''));

/** The name in the chosen row of a table of the block.  @param {Page} page @param {string} name */
const chosenRow = async (page, name) => {
  await part(page, `tab-block-${name}`).click();
  return page.locator(`[data-testid="block-${name}"] tr[aria-selected="true"] td`).first().textContent();
};

/** How many control and check points the block has.  @param {Page} page */
const surveyed = async (page) => Number(/: (\d+)/.exec((await part(page, 'block-surveyed-caption').textContent()) ?? '')?.[1]);

/** X, Y and Z of the images, as the table has them.  @param {Page} page */
const centres = async (page) => (await rowsOf(page, 'images')).map((row) => row.slice(-3).map(numberOf));

test('photographs, an orthophoto and its heights that are dropped together become a block in its system, which stays over a reload', {
  skip: SKIP,
}, async () => {
  const { page, complaints, close } = await block({ options: { viewport: { width: 1366, height: 900 } } });
  await page.locator('#block-wait').uncheck();
  await part(page, 'block-files-input').setInputFiles([
    ...blockPhotos(FLIGHT).map(({ name, bytes }) => upload(name, bytes, 'image/png')),
    ...groundFiles(FLIGHT),
  ]);
  const said = await status(page, PLACED);
  const [, control = 0, check = 0] = (/by (\d+) places .*; (\d+) more check it/.exec(said) ?? []).map(Number);
  assert.equal(await part(page, 'block-answer').getAttribute('data-verdict'), 'oriented');
  await says(page, 'block-layout', /system of the orthophoto/);
  assert.equal(await part(page, 'map-orthophoto').getAttribute('aria-pressed'), 'true');
  await page.screenshot({ path: join(SHOTS, 'block-on-orthophoto.png') });

  const scene = new BlockScene(FLIGHT);
  const known = scene.truth().images.map(({ pose }) => pose?.position ?? []);
  scene.free();
  const found = await centres(page);
  const errors = [0, 1, 2].map((axis) => known.map((place, image) => Math.abs((place[axis] ?? NaN) - (found[image]?.[axis] ?? NaN))));
  // Their standard errors are 0.8 m in X and Y and 5 m in Z, which the free focal length takes along.
  assert.ok(
    errors.every((of, axis) => Math.max(...of) < (axis < 2 ? 3 : 15)),
    `projection centres are off by ${JSON.stringify(errors)} m`,
  );

  // Its places are control and check points: one is rejected as any other.
  const rows = await rowsOf(page, 'surveyed');
  assert.ok(
    rows.every(([name = '']) => name.startsWith('orthophoto_')),
    rows.join('\n'),
  );
  assert.equal(await surveyed(page), control + check);
  await page.locator('[data-testid="block-surveyed"] tbody tr:not(.filler)').first().click();
  await part(page, 'block-reject').click();
  const points = Number(/from (\d+) points/.exec(said)?.[1]);
  // It takes no part any more, and the adjustment is another one; how many points are left is no measure, since others may come back.
  await says(page, 'block-chosen', /^orthophoto_\d+: .*; rejected by hand\.$/);
  await says(page, 'block-edit-text', /σ₀ [\d.]+ → [\d.]+ px .* check points [\d.]+ → [\d.]+ m/);
  await part(page, 'block-undo').click();
  await status(page, new RegExp(`^Oriented: 6 of 6 images from ${points} points`));

  // The orthophoto shows the block: what is chosen there is so in the tables, and opens in the images.
  await part(page, 'block-show-orthophoto').click();
  await part(page, 'ortho-plan').focus();
  await page.keyboard.press('n');
  assert.match(await says(page, 'block-chosen', /^orthophoto_\d+: /), new RegExp(`^${(await chosenRow(page, 'surveyed')) ?? ''}: `));
  await part(page, 'ortho-plan').focus();
  await page.keyboard.press('PageDown');
  const image = /^[^:]+(?=: )/.exec(await says(page, 'block-chosen', /^photo_\d+/))?.[0];
  assert.equal(await chosenRow(page, 'images'), image);
  await part(page, 'ortho-plan').focus();
  await page.keyboard.press('Escape');
  await page.waitForFunction(() => document.querySelector('[data-testid="block-chosen"]')?.textContent === '');
  const middle = await part(page, 'ortho-plan').boundingBox();
  await page.mouse.click((middle?.x ?? 0) + (middle?.width ?? 0) / 2, (middle?.y ?? 0) + (middle?.height ?? 0) / 2);
  await says(page, 'block-chosen', /^(photo_|orthophoto_)\d+/);
  await page.screenshot({ path: join(SHOTS, 'orthophoto-of-block.png') });
  await rowsOf(page, 'surveyed');
  await page.locator('[data-testid="block-surveyed"] tbody tr:not(.filler)').first().click();
  await part(page, 'ortho-plan').focus();
  await page.keyboard.press('Delete');
  await says(page, 'block-chosen', /^orthophoto_\d+: .*; rejected by hand\.$/);
  await page.keyboard.press('Control+z');
  await status(page, new RegExp(`^Oriented: 6 of 6 images from ${points} points`));
  await part(page, 'block-show-images').click();
  await says(page, 'image-point', /^orthophoto_\d+/);
  await part(page, 'block-show-map').click();

  // The project file holds it, and so does the browser.
  await part(page, 'block-export-kind').selectOption('project');
  const project = await saved(page, 'block-export');
  // The edit that was undone is kept as one that can be done again.
  await keptEdits(page, 'block/edits', 1, 0);
  await page.reload();
  const again = await status(page, /Restored from this browser/);
  assert.ok(again.startsWith(said), `${again}\n${said}`);
  await rowsOf(page, 'surveyed');
  assert.equal(await surveyed(page), control + check);
  assert.deepEqual(await centres(page), found);
  await part(page, 'block-files-input').setInputFiles([upload('town-project.tiepoint', project)]);
  await status(page, /town-project\.tiepoint was opened/);
  await rowsOf(page, 'surveyed');
  assert.equal(await surveyed(page), control + check);
  assert.match((await part(page, 'block-on-orthophoto').textContent()) ?? '', /lies in the system of the orthophoto/);
  assert.deepEqual(complaints, []);
  await close();
});

test('a finished block is placed when the user says so; an orthophoto of elsewhere leaves it as it was', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  await photos(page, FLIGHT);
  await part(page, 'block-run').click();
  const before = await status(page, /^Oriented: /);
  const own = await centres(page);
  await page.locator('[data-testid="block-images"] tbody tr:not(.filler)').first().click();
  await says(page, 'block-chosen', /^photo_/);

  await part(page, 'block-files-input').setInputFiles(groundFiles({ ...FLIGHT, seed: 9 }));
  await status(page, /^Oriented: .* Orthophoto orthophoto\.tif: .*The block can be placed on it/);
  assert.equal(await part(page, 'block-answer').getAttribute('data-verdict'), 'oriented');
  assert.deepEqual(await page.locator('[data-testid^="block-other-"]').allTextContents(), ['Place each image by itself', 'Not now']);
  // Where the block is not seen, no key edits it.
  await part(page, 'ortho-plan').focus();
  await page.keyboard.press('Delete');
  await part(page, 'block-show-map').click();
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => resolve(null)))));
  assert.ok(await part(page, 'block-undo').isHidden());
  await says(page, 'block-chosen', /^photo_/);
  await part(page, 'block-next').click();
  await status(page, /^Weak orientation: .*not in the system of the orthophoto.*0 of 6 images could be placed/);
  assert.equal(await part(page, 'block-answer').getAttribute('data-verdict'), 'weak');
  assert.deepEqual(await centres(page), own);
  assert.match((await part(page, 'block-on-orthophoto').textContent()) ?? '', /as it was without it/);
  // Each image with what was found of it.
  const found = (await part(page, 'block-on-orthophoto').locator('li').allTextContents()).join(' ');
  for (const number of [0, 5]) assert.match(found, new RegExp(`photo_0000${number}\\.png[^:]*: .*not placed`, 'iu'));
  await part(page, 'block-off-ground').click();
  const off = await status(page, /^Oriented: /);
  assert.equal(off, before);

  // That of its own ground, given in its place: cancelled, then placed.
  await part(page, 'block-files-input').setInputFiles(groundFiles(FLIGHT));
  await status(page, /The block can be placed on it/);
  await part(page, 'block-next').click();
  await status(page, /^Placing photo_0000\d\.png on the orthophoto/);
  await part(page, 'block-cancel').click();
  await status(page, /Cancelled: the block is as it was\./);
  assert.deepEqual(await centres(page), own);
  await part(page, 'block-next').click();
  await status(page, PLACED);
  assert.deepEqual(complaints, []);
  await close();
});

/** Presses where a picture shows a position: two places under the pointer say how it lies there.  @param {Page} page @param {string} host @param {string} readout @param {[number, number]} wanted */
async function pressAt(page, host, readout, wanted) {
  const box = await part(page, host).boundingBox();
  if (box === null) throw new Error(`${host} is not in sight`);
  /** @param {number} x @param {number} y @returns {Promise<number[]>} */
  const under = async (x, y) => {
    await page.mouse.move(x, y);
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => resolve(null)))));
    const text = (await part(page, readout).textContent()) ?? '';
    // Of "photo_00002.png: 240.1, 180.2 px · …" and of "X 12.30  Y −4.50" the first two numbers behind the name.
    return [
      ...text
        .replace(/^photo_\d+\.png/, '')
        .replaceAll('−', '-')
        .matchAll(/-?\d+(?:\.\d+)?/g),
    ]
      .slice(0, 2)
      .map(Number);
  };
  const [x, y] = [box.x + 0.4 * box.width, box.y + 0.4 * box.height];
  const step = 0.1 * Math.min(box.width, box.height);
  // What is measured is brought into sight meanwhile.
  const found = () =>
    until(page, `${host} stands still`, async () => {
      const [here, there] = [await under(x, y), await under(x + step, y + step)];
      const at = [0, 1].map((k) => ([x, y][k] ?? 0) + (step * ((wanted[k] ?? 0) - (here[k] ?? 0))) / ((there[k] ?? 0) - (here[k] ?? 0)));
      if (!at.every(Number.isFinite)) return null;
      const found = await under(at[0] ?? 0, at[1] ?? 0);
      return Math.hypot((found[0] ?? NaN) - wanted[0], (found[1] ?? NaN) - wanted[1]) < 1.5 ? at : null;
    });
  // A pane goes to where a point is expected, which may come between the look and the press: then it is pressed again.
  await until(page, `${host} is pressed where it stands`, async () => {
    const [column = 0, row = 0] = await found();
    await page.mouse.click(column, row);
    const after = await under(column, row);
    return Math.hypot((after[0] ?? NaN) - wanted[0], (after[1] ?? NaN) - wanted[1]) < 1.5 || !host.startsWith('pane-image') ? true : null;
  });
}

/** Places of level ground far out to four sides of the flight, each with two photos that show it and where.  @param {object} flight */
function groundPlaces(flight) {
  const scene = new BlockScene(flight);
  const files = new Map(blockGround(flight, GSD_M).map(({ name, bytes }) => [name, bytes]));
  const [picture, heights] = [files.get('orthophoto.tif'), files.get('heights.tif')];
  if (picture === undefined || heights === undefined) throw new Error('an orthophoto has heights');
  const reference = OrthophotoReference.open(picture);
  reference.set_heights(heights);
  const { images, cameras } = scene.truth();
  const [camera] = cameras;
  if (!camera) throw new Error('the flight has a camera');
  /** @param {number} index @param {number[]} place @returns {[number, number] | null} */
  const shownBy = (index, place) => {
    const pose = images[index]?.pose;
    if (!pose) return null;
    const [x = 0, y = 0, z = 0] = pose.rotation.map((line) =>
      line.reduce((sum, value, axis) => sum + value * ((place[axis] ?? 0) - (pose.position[axis] ?? 0)), 0),
    );
    const at = /** @type {[number, number]} */ ([
      camera.principal_point_px[0] - (camera.focal_px * x) / z,
      camera.principal_point_px[1] + (camera.focal_px * y) / z,
    ]);
    if (at[0] < 20 || at[1] < 40 || at[0] > camera.width_px - 20 || at[1] > camera.height_px - 20) return null;
    // There the loupe stands over the pane.
    if (at[0] > 0.45 * camera.width_px && at[1] > 0.45 * camera.height_px) return null;
    const seen = scene.surface_at(index, Float64Array.from(at));
    return Math.hypot(...place.map((value, axis) => value - (seen[axis] ?? NaN))) < 0.3 ? at : null;
  };
  // Beside roofs and walls nobody measures by eye.
  const isLevel = (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ z) => {
    const { position, standard_errors: errors } = reference.control_by_hand({ place: [x, y], number: 1 });
    return (errors?.[1] ?? NaN) < 0.9 && Math.abs(position[2] - z) < 0.3;
  };
  /** @type {{ place: [number, number], seen: { image: number, at: [number, number] }[] }[]} */
  const places = [];
  for (let of = 0; of < images.length; of++) {
    for (const column of [60, 100, 150, 200, 240, 280, 330, 380, 420]) {
      for (const row of [60, 90, 120, 150, 180, 210, 240, 270, 300]) {
        const [x = NaN, y = NaN, z = NaN] = scene.surface_at(of, Float64Array.of(column, row));
        if (Number.isNaN(x) || !isLevel(x, y, z)) continue;
        const seen = images.flatMap((_, image) => {
          const at = shownBy(image, [x, y, z]);
          return at === null ? [] : [{ image, at }];
        });
        if (seen.length >= 2) places.push({ place: /** @type {[number, number]} */ ([x, y]), seen });
      }
    }
  }
  scene.free();
  reference.free();
  const outermost = (/** @type {number} */ a, /** @type {number} */ b) =>
    places.reduce((best, one) => (a * one.place[0] + b * one.place[1] > a * best.place[0] + b * best.place[1] ? one : best));
  return [outermost(1, 1), outermost(-1, 1), outermost(1, -1)];
}

/** Waits until a picture has more than one colour.  @param {Page} page @param {string} id */
const isPainted = (page, id) =>
  page.waitForFunction((at) => {
    const canvas = /** @type {HTMLCanvasElement | null} */ (document.querySelector(`[data-testid="${at}"] canvas`));
    if (canvas === null || !canvas.checkVisibility()) return false;
    const { width, height } = canvas;
    const seen = canvas.getContext('2d')?.getImageData(width >> 2, height >> 2, width >> 2, height >> 2).data ?? [];
    return new Set(seen.filter((_, i) => i % 4 === 0)).size > 3;
  }, id);

/** Measures a place by the mouse: on the orthophoto, then in two images.  @param {Page} page @param {ReturnType<typeof groundPlaces>[number] | undefined} place @param {string} name */
async function measured(page, place, name) {
  if (place === undefined) throw new Error('no such place');
  await part(page, 'block-show-orthophoto').click();
  await part(page, 'place-add').click();
  await says(page, 'ortho-chosen', /^A new place: press it on the orthophoto/);
  await pressAt(page, 'ortho-plan', 'ortho-place', place.place);
  await says(page, 'block-edit-text', new RegExp(`^${name}: placed in 0 images`));
  // What was pressed stays in sight beside the images.
  await isPainted(page, 'place-crop-picture');
  for (const { image, at } of place.seen.slice(0, 2)) {
    for (let turn = 0; turn < 3 && (await part(page, `pane-image-${image}`).isHidden()); turn++) await part(page, 'images-other').click();
    await part(page, 'block-zoom-fit').click();
    await pressAt(page, `pane-image-${image}`, 'image-place', at);
  }
  await says(page, 'block-edit-text', new RegExp(`^${name}: placed in 2 images`));
}

test('places measured by hand bring a block into the system of the orthophoto, by mouse and by keys; they stay over a reload and a new place', {
  skip: SKIP,
}, async () => {
  // In small panes a press is off by so many px that its measurement may be refused.
  const { page, complaints, close } = await block({ options: { viewport: { width: 1600, height: 1300 } } });
  await photos(page, FLIGHT);
  await part(page, 'block-run').click();
  await status(page, /^Oriented: /);
  await part(page, 'block-files-input').setInputFiles(groundFiles(FLIGHT));
  await status(page, /The block can be placed on it/);
  // It is to lie on the orthophoto and does not yet, as one that could not be linked.
  await part(page, 'block-next').click();
  await status(page, /^Placing photo_0000\d\.png on the orthophoto/);
  await part(page, 'block-cancel').click();
  await status(page, /Cancelled: the block is as it was\./);

  const onGround = (/** @type {number} */ count) =>
    says(
      page,
      'block-on-orthophoto',
      new RegExp(`The block lies in the system of the orthophoto, by ${count} places that were measured by hand in [3-6] of 6 images`),
    );
  const places = groundPlaces(FLIGHT);
  for (const [k, place] of places.entries()) {
    const name = `orthophoto_hand_${k + 1}`;
    await measured(page, place, name);
    if (k === 0) {
      await page.screenshot({ path: join(SHOTS, 'place-by-hand.png') });
      await page.setViewportSize({ width: 360, height: 740 });
      await page.waitForTimeout(500);
      await page.screenshot({ path: join(SHOTS, 'place-by-hand-phone.png') });
      await page.setViewportSize({ width: 1600, height: 1300 });
    }
    await part(page, 'block-accept').click();
    await page.waitForFunction(
      (title) => document.querySelector('[data-testid="block-undo"]')?.getAttribute('title')?.startsWith(title),
      `Undo: measure ${name} in 2 images`,
    );
    if (k < 2) {
      await part(page, 'block-show-orthophoto').click();
      await says(page, 'ortho-chosen', new RegExp(`^${k + 1} places? by hand, ${k + 1} measured in two images or more: three whose`));
    }
  }
  await onGround(3);
  await says(page, 'block-layout', /system of the orthophoto/);
  const scene = new BlockScene(FLIGHT);
  const known = scene.truth().images.map(({ pose }) => pose?.position ?? []);
  scene.free();
  const off = (/** @type {number[][]} */ found) =>
    [0, 1, 2].map((axis) => Math.max(...known.map((at, image) => Math.abs((at[axis] ?? NaN) - (found[image]?.[axis] ?? NaN)))));
  // A press is off by up to 0.8 px of an image of 480, which tilts so small a block by a degree; the free focal length takes the height along.
  const [x = NaN, y = NaN, z = NaN] = off(await centres(page));
  assert.ok(x < 40 && y < 40 && z < 60, `projection centres are off by ${x}, ${y} and ${z} m`);
  const row = (/** @type {string[][]} */ rows, /** @type {string} */ name) => rows.find(([own]) => own === name) ?? [];
  assert.deepEqual(row(await rowsOf(page, 'surveyed'), 'orthophoto_hand_1').slice(0, 3), ['orthophoto_hand_1', 'control, by hand', '2']);

  // The fourth by keys alone: under the cross, then where the images show it.
  await part(page, 'block-show-orthophoto').click();
  await part(page, 'ortho-plan').focus();
  await page.keyboard.press('a');
  await page.screenshot({ path: join(SHOTS, 'place-by-keys.png') });
  await page.keyboard.press('Enter');
  await says(page, 'block-edit-text', /^orthophoto_hand_4: placed in 0 images/);
  for (const images of [1, 2]) {
    await page.keyboard.press('Enter');
    await says(page, 'block-edit-text', new RegExp(`^orthophoto_hand_4: placed in ${images} image`));
    await page.keyboard.press('o');
  }
  await page.screenshot({ path: join(SHOTS, 'place-in-images.png') });
  await part(page, 'block-accept').click();
  await onGround(4);
  await says(page, 'block-chosen', /^orthophoto_hand_4: 2 rays; /);
  await page.keyboard.press('Control+z');
  await onGround(3);
  await page.keyboard.press('Control+Shift+Z');
  await onGround(4);
  // Rejected and restored as any.
  await part(page, 'tab-block-surveyed').click();
  const fourth = page.locator('[data-testid="block-surveyed"] tbody tr').filter({ hasText: 'orthophoto_hand_4' }).first();
  await fourth.click();
  // The orthophoto is beside its images, and not beside those of another point.
  await part(page, 'block-show-images').click();
  await isPainted(page, 'place-crop-picture');
  await part(page, 'block-panes').focus();
  await page.keyboard.press('n');
  await part(page, 'place-crop').waitFor({ state: 'hidden' });
  await fourth.click();
  await part(page, 'block-reject').click();
  await onGround(3);
  await part(page, 'block-restore').click();
  await onGround(4);

  // They are kept, and hold beside the places that are found.
  await keptEdits(page, 'block/edits', 10, 10);
  await page.reload();
  await status(page, /Restored from this browser/);
  await onGround(4);
  // It lies there, and can be placed all the same.
  const held = await status(page, /by 4 places that were measured by hand .* Places that are found on the orthophoto can hold it, too\./);
  assert.doesNotMatch(held, /is not placed on the orthophoto/);
  assert.doesNotMatch((await part(page, 'block-results').getAttribute('class')) ?? '', /is-stale/);
  await part(page, 'block-next').click();
  await status(page, PLACED);
  await part(page, 'tab-block-surveyed').click();
  await part(page, 'block-surveyed-filter-surveyed').fill('hand');
  await page.waitForFunction(() => {
    const rows = [...document.querySelectorAll('[data-testid="block-surveyed"] tbody tr:not(.filler)')].map(({ children }) => children[1]?.textContent);
    return rows.length === 4 && rows.every((use) => use === 'control, by hand');
  });
  await part(page, 'block-surveyed-filter-surveyed').fill('');
  assert.ok((await surveyed(page)) > 24);
  const better = off(await centres(page));
  assert.ok(Math.max(better[0] ?? NaN, better[1] ?? NaN) < 3, `projection centres are off by ${JSON.stringify(better)} m`);
  await part(page, 'block-show-orthophoto').click();
  await page.screenshot({ path: join(SHOTS, 'place-beside-others.png') });

  // Without the orthophoto the places by hand do not bring the block back; redo brings one after the other.
  await part(page, 'block-off-ground').click();
  await status(page, /10 steps of places by hand were undone, since they bring the block onto the orthophoto: Redo makes them again\./);
  await part(page, 'block-on-orthophoto').waitFor({ state: 'detached' });
  assert.equal(await part(page, 'block-undo').isDisabled(), true);
  assert.match((await part(page, 'block-redo').getAttribute('title')) ?? '', /^Redo: add the place orthophoto_hand_1/);
  assert.deepEqual(complaints, []);
  await close();
});
