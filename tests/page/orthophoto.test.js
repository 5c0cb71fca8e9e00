/** Photographs on an orthophoto, as a surveyor places them: the sample, its results in table, orthophoto and image, what is kept and saved; and what is refused. */

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { BlockScene, grey_png, system_coordinates } from '../../pkg/node.js';
import { block, FLIGHT, photos, status } from './blocks.js';
import { georeferenced, inDegrees } from './georeferenced.js';
import { hosted, part, saved, says, SHOTS, SKIP, upload } from './page.js';
import { blockGround, blockPhotos } from './rendered.js';

hosted();

/** @typedef {import('playwright-core').Page} Page */

/** Waits until a canvas shows more than one colour.  @param {Page} page @param {string} host @param {string} layer */
const isPainted = (page, host, layer) =>
  page.waitForFunction(
    ([id, name]) => {
      const canvas = document.querySelector(`[data-testid="${id}"] [data-testid="layer-${name}"]`);
      if (!(canvas instanceof HTMLCanvasElement) || canvas.width < 10) return false;
      const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d')).getImageData(0, 0, canvas.width, canvas.height);
      const seen = new Set();
      for (let i = 0; i < data.length && seen.size < 40; i += 4 * 97) if ((data[i + 3] ?? 0) > 0) seen.add(data[i]);
      return seen.size >= 40;
    },
    [host, layer],
  );

/** Waits until at least a tenth of what a canvas shows is in colours: more than lines and points are.  @param {Page} page @param {string} host @param {string} layer */
const isColoured = (page, host, layer) =>
  page.waitForFunction(
    ([id, name]) => {
      const canvas = document.querySelector(`[data-testid="${id}"] [data-testid="layer-${name}"]`);
      if (!(canvas instanceof HTMLCanvasElement) || canvas.width < 10) return false;
      const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d')).getImageData(0, 0, canvas.width, canvas.height);
      let [shown, coloured] = [0, 0];
      for (let i = 0; i < data.length; i += 4 * 7) {
        if ((data[i + 3] ?? 0) < 255) continue;
        shown += 1;
        coloured += Number(Math.abs((data[i] ?? 0) - (data[i + 1] ?? 0)) > 20);
      }
      return coloured > shown / 10;
    },
    [host, layer],
  );

/** Waits until the browser has parts of the project; `block`: with an orthophoto in it.  @param {Page} page @param {string[]} names */
const isKept = (page, ...names) =>
  page.waitForFunction(async (wanted) => {
    if ((await indexedDB.databases()).length === 0) return false;
    const database = await new Promise((resolve, reject) => {
      const opening = indexedDB.open('tiepoint');
      opening.onsuccess = () => resolve(opening.result);
      opening.onerror = () => reject(opening.error);
    });
    const rows = await new Promise((resolve) => {
      const asked = database.transaction('parts').objectStore('parts').getAll();
      asked.onsuccess = () => resolve(asked.result);
    });
    database.close();
    return wanted.every((name) =>
      rows.some((/** @type {{ part: string, value: any }} */ { part: own, value }) =>
        name.endsWith('/') ? own.startsWith(name) : own === name && (name !== 'block' || value.placing.orthophoto !== null),
      ),
    );
  }, names);

/** A place of an image, to 5 px.  @param {string} text */
const rounded = (text) => [...text.matchAll(/[\d.]+/gu)].map(([figure]) => Math.round(Number(figure) / 5));

test('the sample is placed by one press; image, link and table go together, are kept over a reload, and are saved', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  await part(page, 'block-place-first').click();
  await says(page, 'block-status', /^4 of 4 images placed\./);
  assert.equal(await part(page, 'block-answer').getAttribute('data-verdict'), 'oriented');
  await isPainted(page, 'ortho-plan', 'picture');
  await page.screenshot({ path: join(SHOTS, 'orthophoto-placed.png') });

  assert.equal((await says(page, 'block-placed-images', /photo_00003\.png: Placed by/)).match(/: Placed by [\d\s]+ points/g)?.length, 4);
  // An image of the table opens beside the orthophoto; a link of the table is said, and the next one by a key.
  await page.locator('[data-testid="block-placed"] tbody tr:not(.filler)').nth(2).click();
  await says(page, 'ortho-chosen', /^photo_00002\.png: Placed by [\d\s]+ points/);
  await isPainted(page, 'ortho-image', 'picture');
  const picture = () => page.evaluate(() => /** @type {HTMLCanvasElement} */ (document.querySelector('[data-testid="ortho-plan"] canvas')).toDataURL());
  const before = await picture();
  await part(page, 'ortho-over').click();
  await page.waitForFunction(
    (was) => /** @type {HTMLCanvasElement} */ (document.querySelector('[data-testid="ortho-plan"] canvas')).toDataURL() !== was,
    before,
  );
  await part(page, 'ortho-over').click();
  await part(page, 'tab-block-links').click();
  await page.locator('[data-testid="block-links"] tbody tr:not(.filler)').nth(4).click();
  const [, all = ''] = /^Link 5 of ([^,]+), /.exec(await says(page, 'ortho-chosen', /^Link 5 of /)) ?? [];
  await part(page, 'ortho-image').focus();
  await page.keyboard.press('n');
  await says(page, 'ortho-chosen', /^Link 6 of /);
  await page.waitForFunction(() => document.querySelector('[data-testid="block-links"] tr[aria-selected="true"] td')?.textContent === '6');

  // Links near the border leave an image whole that is shown so, however small its pane gets: what lies in the middle is its middle.
  const inMiddle = async () => {
    await page.mouse.move(0, 0);
    await says(page, 'ortho-at', /^$/);
    await part(page, 'ortho-image').hover();
    return says(page, 'ortho-at', /row/);
  };
  const seen = await inMiddle();
  await page.setViewportSize({ width: 1100, height: 620 });
  const resized = await inMiddle();
  await part(page, 'ortho-image').focus();
  await page.keyboard.press('0');
  const fitted = rounded(await inMiddle());
  assert.deepEqual([seen, resized].map(rounded), [fitted, fitted]);
  await page.setViewportSize({ width: 1280, height: 800 });

  // By hand: a link is left out and used again, and a new one is measured in both pictures.
  const filter = part(page, 'block-links-filter-link-use');
  await filter.fill('used');
  await page.waitForFunction(() => !/rejected|check/.test(document.querySelector('[data-testid="block-links"] tbody')?.textContent ?? ''));
  await page.locator('[data-testid="block-links"] tbody tr:not(.filler)').first().click();
  await says(page, 'ortho-chosen', /^Link \S+ of [^,]+, used: /);
  await part(page, 'ortho-image').focus();
  await page.keyboard.press('Delete');
  await says(page, 'ortho-chosen', /^Link \S+ of [^,]+, rejected by hand: /);
  await part(page, 'link-undo').click();
  await says(page, 'ortho-chosen', /^Link \S+ of [^,]+, used: /);
  await filter.fill('');
  await part(page, 'ortho-image').focus();
  await page.keyboard.press('a');
  await says(page, 'ortho-chosen', /^A new link: press/);
  await part(page, 'ortho-image').click();
  await says(page, 'ortho-chosen', /^Press the point on the orthophoto\.$/);
  await part(page, 'ortho-plan').click();
  await part(page, 'link-accept').click();
  const more = await says(page, 'block-links-caption', new RegExp(`: (?!${all}$)`));
  assert.equal(Number(more.replaceAll(/\D/g, '')), Number(all.replaceAll(/\D/g, '')) + 1);
  await says(page, 'ortho-chosen', /^Link [^,]+, measured by hand, (used|rejected as a gross error): /);
  await part(page, 'link-undo').click();
  await says(page, 'block-links-caption', new RegExp(`: ${all}$`));
  // A press on the middle of the orthophoto without an image: an image whose ground it is.
  await part(page, 'ortho-image').focus();
  await page.keyboard.press('Escape');
  await page.keyboard.press('Escape');
  await says(page, 'ortho-chosen', /^Press a footprint/);
  await part(page, 'ortho-plan').click();
  await says(page, 'ortho-chosen', /^photo_0000\d\.png: /);

  // Its keys are in the list of all keys, once.
  await part(page, 'ortho-plan').focus();
  await page.keyboard.press('?');
  assert.equal((await part(page, 'keys-dialog').textContent())?.match(/rejects the chosen link/g)?.length, 1);
  await part(page, 'keys-close').click();

  // Where it was moved to, it looks in a window of another size too.
  const middle = async () => {
    const box = await part(page, 'ortho-plan').boundingBox();
    assert.ok(box);
    await page.mouse.move(box.x + 1, box.y + 1);
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    return (await says(page, 'ortho-place', /^X/)).match(/[\d.−-]+/g)?.map((value) => Number(value.replace('−', '-'))) ?? [];
  };
  await part(page, 'close-block-settings').click();
  await part(page, 'ortho-plan').focus();
  for (const key of ['+', '+', '+', 'ArrowRight', 'ArrowDown']) await page.keyboard.press(key);
  const looked = await middle();
  await page.setViewportSize({ width: 800, height: 1000 });
  const then = await middle();
  assert.ok(looked.length === 2 && looked.every((value, i) => Math.abs(value - (then[i] ?? NaN)) < 1), `${looked} and ${then}`);
  // On a phone all its tools are in sight, or in a menu that is.
  await page.setViewportSize({ width: 360, height: 740 });
  const inSight = async (/** @type {string} */ id) => {
    const box = await part(page, id).boundingBox();
    assert.ok(box && box.x >= 0 && box.x + box.width <= 360, `${id}: ${JSON.stringify(box)}`);
  };
  for (const id of ['block-show-map', 'block-show-orthophoto', 'block-table', 'ortho-menu']) await inSight(id);
  await part(page, 'ortho-menu').click();
  for (const id of ['ortho-near', 'ortho-residuals', 'placed-export-kind', 'placed-export']) await inSight(id);
  await page.screenshot({ path: join(SHOTS, 'orthophoto-phone.png') });
  await page.setViewportSize({ width: 1280, height: 800 });

  const placed = (await saved(page, 'placed-export')).toString();
  assert.equal(placed.trim().split('\n').length, 5);
  assert.match(placed, /^photo_00002\.png,/m);
  await part(page, 'placed-export-kind').selectOption('rectified');
  const rectified = await saved(page, 'placed-export');
  assert.ok(rectified.length > 10_000 && rectified.subarray(0, 2).toString() === 'II', `${rectified.length} bytes`);

  // A rough place by a press; what was placed is of earlier settings then.
  await part(page, 'ortho-near').click();
  await says(page, 'ortho-chosen', /^Press the orthophoto where/);
  await part(page, 'ortho-plan').click();
  await says(page, 'block-status', /Settings, heights or cameras have changed/);
  await part(page, 'ortho-everywhere').click();
  await page.waitForFunction(() => !/have changed/.test(document.querySelector('[data-testid="block-status"]')?.textContent ?? ''));

  // All of it is there after a reload: the picture is read again, nothing is placed again.
  await isKept(page, 'block/placed/');
  await page.reload();
  assert.equal(await part(page, 'ortho-welcome').isVisible(), false);
  await says(page, 'block-status', /^4 of 4 images placed\./);
  await isPainted(page, 'ortho-plan', 'picture');
  await part(page, 'tab-block-placed').click();
  await page.locator('[data-testid="block-placed"] tbody tr:not(.filler)').nth(2).click();
  await part(page, 'tab-block-links').click();
  await says(page, 'block-links-caption', new RegExp(`: ${all}$`));
  assert.deepEqual(complaints, []);
  await close();
});

test('what is no orthophoto and what are no heights of it is said, and what is there stays', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  const scene = new BlockScene({ strips: 1, exposures: 2, width_px: 240, height_px: 180, pixel_mm: 0.3 });
  const { picture, heights } = scene.orthophoto(2);
  const photo = scene.photo_file(0);
  scene.free();
  const png = grey_png(40, 30, new Uint8Array(1200).fill(90));
  const give = async (/** @type {string} */ field, /** @type {ReturnType<typeof upload>[]} */ ...files) => {
    await page.waitForFunction(() => !(/** @type {HTMLButtonElement} */ (document.querySelector('[data-testid="block-orthophoto"]')).disabled));
    await part(page, `${field}-input`).setInputFiles(files);
  };
  await part(page, 'tab-block-orthophoto').click();
  await give('block-orthophoto', upload('plain.png', png, 'image/png'));
  await status(page, /^plain\.png cannot be used as an orthophoto: .*does not say where it lies/);
  await give('block-orthophoto', upload('cut.tif', picture.slice(0, picture.length / 2)));
  await status(page, /^cut\.tif cannot be used as an orthophoto: /);
  await give('block-files', upload('alone.tfw', new TextEncoder().encode('1\n0\n0\n-1\n0\n0\n')));
  await status(page, /^alone\.tfw says where a picture of the same name lies: give both together\.$/);
  const grid = (/** @type {number} */ east) =>
    upload('grid.asc', new TextEncoder().encode(`ncols 2\nnrows 2\nxllcorner ${east}\nyllcorner -4000\ncellsize 8000\n5 5\n5 5\n`));
  await give('block-files', grid(-4000));
  await status(page, /^grid\.asc holds heights: give their orthophoto first, or both together\.$/);

  // A TIFF that says where it lies is an orthophoto wherever it is given; photographs wait for Run.
  // A grid that may be a geoid is put aside, and the rest is taken.
  await give('block-files', upload('town.tif', picture), upload('degrees.tif', inDegrees(heights)), upload('photo.png', photo, 'image/png'));
  await status(
    page,
    /^Orthophoto town\.tif: \d+ × \d+ px of 2 m\. 1 image in the block\. Press Place\. degrees\.tif is a grid of numbers [^*]*, and put aside\. [^*]* under Geoid in the settings;[^*]*$/,
  );
  await give('block-heights', grid(4e6));
  const elsewhere = await status(page, /^(grid\.asc cannot be used as heights|Heights from grid\.asc)/);
  if (elsewhere.startsWith('Heights')) {
    await part(page, 'block-run').click();
    await status(page, /^Nothing was placed: .*height model: got none under the orthophoto/);
  }
  await give('block-heights', upload('text.asc', new TextEncoder().encode('no grid at all')));
  await status(page, /^text\.asc cannot be used as heights: /);
  await part(page, 'block-level').fill('12');
  await part(page, 'block-level').blur();
  await status(page, /^The ground is level at 12\.00 m\./);
  // The field that holds what is not allowed is what is opened, not one with the same label.
  const number = page.locator('input[data-key="placing.points"]');
  await number.fill('-1');
  await number.blur();
  await status(page, /^Number of points: this value is not allowed/);
  await part(page, 'tab-block-settings').click();
  await part(page, 'block-next').click();
  assert.equal(await page.evaluate(() => document.activeElement?.getAttribute('data-key')), 'placing.points');
  await number.fill('5000');
  await number.blur();
  await status(page, /^1 image can be placed/);
  await part(page, 'block-orthophoto-remove').click();
  await says(page, 'block-orthophoto-name', /^None\./);

  // Over the view of pairs an orthophoto with a photograph goes where it is of use; the photograph is there already.
  await part(page, 'mode-pair').click();
  const transfer = await page.evaluateHandle(
    (given) => {
      const data = new DataTransfer();
      for (const [name, bytes] of given) data.items.add(new File([Uint8Array.from(bytes)], name));
      return data;
    },
    /** @type {[string, number[]][]} */ ([
      ['town.tif', [...picture]],
      ['photo.png', [...photo]],
    ]),
  );
  for (const type of ['dragenter', 'dragover', 'drop']) await page.locator('body').dispatchEvent(type, { dataTransfer: transfer });
  await status(page, /^Orthophoto town\.tif: .* 1 image skipped: their names are in the block already\. Press Place\.$/);
  assert.equal(await part(page, 'mode-block').getAttribute('aria-pressed'), 'true');
  // So does one that is chosen there.
  await part(page, 'mode-pair').click();
  await part(page, 'file-input').setInputFiles([upload('city.tif', picture), upload('other.png', photo, 'image/png')]);
  await status(page, /^Orthophoto city\.tif: .* 2 images in the block\./);
  assert.equal(await part(page, 'mode-block').getAttribute('aria-pressed'), 'true');
  // Several of them are photographs.
  await give('block-files', upload('east.tif', picture), upload('west.tif', picture));
  await status(page, /^2 images that say where they lie are taken as photographs: .* 4 images in the block\./);
  assert.deepEqual(complaints, []);
  await close();
});

test('the orthomosaic of a block is laid under its map, saved, and there after a reload', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  await photos(page);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  assert.ok(await part(page, 'map-orthophoto').isHidden());
  await part(page, 'map-mosaic').click();
  await says(page, 'block-status', /The orthomosaic lies under the map\. Orthophoto orthomosaic\.tif: /);
  const under = () => page.waitForFunction(() => document.querySelector('[data-testid="map-orthophoto"]')?.getAttribute('aria-pressed') === 'true');
  await under();
  assert.ok(await part(page, 'map-orthophoto').isVisible());
  assert.ok(await part(page, 'map-mosaic').isHidden());
  await isPainted(page, 'block-map', 'map');
  await page.screenshot({ path: join(SHOTS, 'block-map-orthomosaic.png') });
  await part(page, 'block-export-kind').selectOption('mosaic');
  const mosaic = await saved(page, 'block-export');
  assert.ok(mosaic.length > 10_000 && mosaic.subarray(0, 2).toString() === 'II', `${mosaic.length} bytes`);
  await status(page, / orthomosaic\.tif was saved\. Note: the mosaic's coordinates are metres east and north of latitude \d/);
  // Of one image that is chosen it is that image on the ground.
  await part(page, 'block-export-kind').selectOption('chosen');
  assert.ok(await part(page, 'block-export').isDisabled());
  await part(page, 'tab-block-images').click();
  await page.locator('[data-testid="block-images"] tbody tr:not(.filler)').nth(1).click();
  const rectified = await saved(page, 'block-export');
  assert.ok(rectified.length > 1_000 && rectified.length < mosaic.length, `${rectified.length} of ${mosaic.length} bytes`);
  await status(page, / photo_\d+-rectified\.tif was saved\. Note: the mosaic's coordinates /);
  await isKept(page, 'block/shown', 'block');
  await page.reload();
  await status(page, /^(Oriented|Weak orientation): .*Restored from this browser/);
  await part(page, 'map-orthophoto').waitFor();
  await under();
  assert.deepEqual(complaints, []);
  await close();
});

const numbers = (/** @type {string} */ text) =>
  (
    text
      .replaceAll('\u202f', '')
      .replaceAll('−', '-')
      .match(/-?\d+(\.\d+)?/g) ?? []
  ).map(Number);

/** From the system of the block to that of the orthophoto, by three places under the pointer.  @param {Page} page @param {string} crs */
async function bySystem(page, crs) {
  const box = await part(page, 'block-map').boundingBox();
  assert.ok(box);
  const at = [];
  for (const [x, y] of [
    [0.2, 0.3],
    [0.8, 0.3],
    [0.2, 0.8],
  ]) {
    await page.mouse.move(box.x + (x ?? 0) * box.width, box.y + (y ?? 0) * box.height);
    const [own = '', there = ''] = (await says(page, 'map-place', new RegExp(`${crs} `))).split(`${crs} `);
    at.push([...numbers(own), ...numbers(there)]);
  }
  const [[x0 = 0, y0 = 0, u0 = 0, v0 = 0] = [], [x1 = 0, y1 = 0, u1 = 0, v1 = 0] = [], [x2 = 0, y2 = 0, u2 = 0, v2 = 0] = []] = at;
  const determinant = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0);
  return (/** @type {number} */ x, /** @type {number} */ y) => {
    const [p, q] = [((x - x0) * (y2 - y0) - (x2 - x0) * (y - y0)) / determinant, ((x1 - x0) * (y - y0) - (x - x0) * (y1 - y0)) / determinant];
    return [u0 + p * (u1 - u0) + q * (u2 - u0), v0 + p * (v1 - v0) + q * (v2 - v0)];
  };
}

test('images that record positions elsewhere than the orthophoto are doubted before anything is matched, with the zone that fits', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  const scene = new BlockScene(FLIGHT);
  const { origin } = scene.truth();
  scene.free();
  assert.ok(origin);
  const picture = blockGround(FLIGHT, 1).find(({ name }) => name === 'orthophoto.tif')?.bytes ?? new Uint8Array();
  const { png, world } = georeferenced(picture, 32632, origin, 0);
  const text = (/** @type {string} */ value) => new TextEncoder().encode(value);
  const open = (/** @type {string} */ name, /** @type {string} */ system) =>
    part(page, 'block-orthophoto-input').setInputFiles([
      upload(`${name}.png`, png, 'image/png'),
      upload(`${name}.pgw`, text(world)),
      upload(`${name}.prj`, text(system)),
    ]);
  await photos(page);
  await part(page, 'tab-block-orthophoto').click();
  await open('wrong', 'EPSG:32633');
  await says(page, 'block-answer', /No GNSS position of the \d+ images lies within 500 m of the orthophoto: as EPSG:32633 has it, .* In zone 32 of UTM/i);
  await open('right', 'EPSG:32632');
  await says(page, 'block-orthophoto-name', /^Orthophoto right\.png/);
  const isSure = () => page.waitForFunction(() => !/GNSS position/.test(document.querySelector('[data-testid="block-answer"]')?.textContent ?? ''));
  await isSure();
  // Positions of a table stand in place of those that the files record.
  const { longitude_deg: longitude, latitude_deg: latitude } = origin;
  const rows = blockPhotos(FLIGHT).map(({ name }) => `${name},${longitude + 1},${latitude}\n`);
  await part(page, 'block-positions-input').setInputFiles(upload('flight.csv', text(`image,lon,lat\n${rows.join('')}`)));
  await says(page, 'block-answer', /[Nn]o GNSS position of the 6 images lies within 500 m of the orthophoto/);
  await part(page, 'tab-block-settings').click();
  await part(page, 'block-positions-remove').click();
  await isSure();
  // Those of a plane lie where the coordinate system has them.
  const [east, north] = system_coordinates('EPSG:32632', new Float64Array([longitude, latitude, 0])) ?? [];
  const plane = blockPhotos(FLIGHT).map(({ name }) => `${name},${east},${north}\n`);
  await part(page, 'block-positions-input').setInputFiles(upload('plane.csv', text(`image,easting,northing\n${plane.join('')}`)));
  await says(page, 'block-positions-name', /^plane\.csv/);
  await isSure();
  const crs = page.locator('input[data-key="placing.crs"]').first();
  await crs.fill('EPSG:32633');
  await crs.blur();
  await says(page, 'block-answer', /[Nn]o GNSS position of the 6 images lies within 500 m of the orthophoto/);
  await crs.fill('');
  await crs.blur();
  await isSure();
  assert.deepEqual(complaints, []);
  await close();
});

test('an orthophoto in UTM lies under a block with GNSS positions, with a code or in the system that is chosen: centres are at their true pixels', {
  skip: SKIP,
}, async () => {
  const { page, complaints, close } = await block();
  const scene = new BlockScene(FLIGHT);
  const { images, origin } = scene.truth();
  const [, , ground = 0] = scene.surface_at(1, Float64Array.of(240, 180));
  scene.free();
  assert.ok(origin);
  const picture = blockGround(FLIGHT, 1).find(({ name }) => name === 'orthophoto.tif')?.bytes ?? new Uint8Array();
  const made = georeferenced(picture, 32632, origin, ground);
  const [a, b, x0, d, e, y0] = made.affine;
  /** The pixels of the projection centres of the block, by the table and what the map says, beside the true ones. */
  const centresAreTrue = async (isInSystem = false) => {
    const toSystem = isInSystem ? (/** @type {number} */ x, /** @type {number} */ y) => [x, y] : await bySystem(page, 'EPSG:32632');
    await part(page, 'tab-block-images').click();
    const rows = await page
      .locator('[data-testid="block-images"] tbody tr:not(.filler)')
      .evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent ?? '')));
    assert.equal(rows.length, images.length);
    for (const row of rows) {
      const [x = NaN, y = NaN] = row.slice(-3, -1).map((cell) => numbers(cell)[0] ?? NaN);
      const [u = NaN, v = NaN] = toSystem(x, y);
      const at = [((u - x0) * e - (v - y0) * b) / (a * e - b * d), ((v - y0) * a - (u - x0) * d) / (a * e - b * d)];
      const [tx = NaN, ty = NaN] = images.find(({ name }) => `${name}.png` === row[0])?.pose?.position ?? [];
      const { origin: corner, by_column: column, by_row: line } = made.georeference;
      const known = [(tx - corner[0]) / column[0], (ty - corner[1]) / line[1]];
      // GNSS positions are wrong by some metres: so is the block.
      const off = Math.hypot((at[0] ?? NaN) - (known[0] ?? NaN), (at[1] ?? NaN) - (known[1] ?? NaN));
      assert.ok(off < 4, `${row[0]}: ${at} for ${known}`);
    }
  };
  await photos(page);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  await part(page, 'tab-block-orthophoto').click();
  await part(page, 'block-orthophoto-input').setInputFiles([upload('utm.tif', made.tif)]);
  await says(page, 'block-orthophoto-name', /^Orthophoto utm\.tif/);
  // Images that are placed on it lie over ground as high as that of the block.
  const [level = NaN] = numbers(
    /: (.*) m\.$/.exec(await says(page, 'block-heights-name', /Its height is the median of the tie points of the block/))?.[1] ?? '',
  );
  assert.ok(Math.abs(level - origin.height_m - ground) < 40, `level ground at ${level} m`);
  await page.screenshot({ path: join(SHOTS, 'level-of-block.png') });
  await part(page, 'block-show-map').click();
  await says(page, 'block-layout', /Orthophoto laid under by the positions of both on the earth \(EPSG:32632\)/);
  assert.equal(await part(page, 'map-orthophoto').getAttribute('aria-pressed'), 'true');
  await isPainted(page, 'block-map', 'map');
  await page.screenshot({ path: join(SHOTS, 'block-map-utm.png') });
  await isColoured(page, 'block-map', 'map');
  await centresAreTrue();

  // Of elsewhere it is said why nothing lies there.
  await part(page, 'tab-block-orthophoto').click();
  await part(page, 'block-orthophoto-input').setInputFiles([upload('zone.tif', georeferenced(picture, 32633, { ...origin, longitude_deg: 15 }, ground).tif)]);
  await says(page, 'block-orthophoto-name', /^Orthophoto zone\.tif/);
  await says(page, 'block-heights-name', /^(?!.*median)None: the ground is level/);
  await part(page, 'block-show-map').click();
  await says(page, 'block-layout', /The orthophoto lies elsewhere than the block \(EPSG:32633\)/);
  assert.ok(await part(page, 'map-orthophoto').isHidden());

  // A picture with a world file says no system: it is taken in that which is chosen for the block.
  await part(page, 'block-orthophoto-input').setInputFiles([
    upload('world.png', made.png, 'image/png'),
    upload('world.pgw', new TextEncoder().encode(made.world)),
  ]);
  await says(page, 'block-orthophoto-name', /^Orthophoto world\.png/);
  await says(page, 'block-layout', /The orthophoto is in another system/);
  await part(page, 'tab-block-settings').click();
  await page.locator('input[data-key="placing.crs"]').first().fill('EPSG:32632');
  await page.locator('input[data-key="placing.crs"]').first().blur();
  await part(page, 'block-run').click();
  await says(page, 'block-layout', /\(WGS 84 \/ UTM zone 32N\).*Orthophoto laid under by the positions of both on the earth \(EPSG:32632\)/);
  // The table has the coordinates of the system that was chosen, with its code in the heads, and so has the map.
  await centresAreTrue(true);
  assert.match((await page.locator('[data-testid="block-images"] thead tr').first().textContent()) ?? '', /X EPSG:32632 m.*Y EPSG:32632 m.*Z EPSG:32632 m/);
  await part(page, 'block-map').hover();
  await says(page, 'map-place', /^X 4\d{5}\.\d\d +Y 55\d{5}\.\d\d m +EPSG:32632$/);
  assert.deepEqual(complaints, []);
  await close();
});

test('the camera and the marks of scanned film are taken with what is wrong with them', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  const text = (/** @type {string} */ name, /** @type {string} */ content) => upload(name, new TextEncoder().encode(content));
  const give = (/** @type {string} */ field, /** @type {ReturnType<typeof upload>[]} */ ...files) => part(page, `${field}-input`).setInputFiles(files);
  await part(page, 'tab-block-orthophoto').click();
  await says(page, 'block-film-camera-name', /^No film camera\. .*"focal_mm"/);
  await give('block-film-camera', text('film.json', '{"principal_point_mm": [0, 0]}'));
  await status(page, /^film\.json cannot be used: .*focal_mm/);
  await give('block-film-marks', text('scan.csv', 'col,row\n1,2\n'));
  await status(page, /^scan\.csv cannot be used: .*x_mm/);
  await give('block-film-marks', text('scan.csv', 'col,row,x_mm,y_mm\n4,4,-5,3.4375\n36,4,5,3.4375\n36,26,5,-3.4375\n4,26,-5,-3.4375\n'));
  await says(page, 'block-film-problem', /^No image has the name of scan\.csv: fiducial marks are named as the image of their scan\.$/);
  await give('block-files', upload('scan.png', grey_png(40, 30, new Uint8Array(1200).fill(90)), 'image/png'));
  await says(page, 'block-film-problem', /need the film camera/);
  await give('block-film-camera', text('film.json', '{"focal_mm": 152}'));
  await says(page, 'block-film-problem', /^$/);
  assert.deepEqual(
    [await part(page, 'block-film-camera-name').textContent(), await part(page, 'block-film-marks-names').textContent()],
    ['film.json', 'scan.csv'],
  );
  await part(page, 'block-film-frames').click();
  await status(page, /^1 scan was resampled to an image of one camera, which counts as calibrated\./);
  await says(page, 'block-film-marks-names', /^No fiducial marks\./);
  assert.ok(await part(page, 'block-film-frames').isDisabled());
  // With a mask and a camera.
  await part(page, 'tab-block-settings').click();
  await says(page, 'block-masks-name', /^scan-film\.png$/);
  await says(page, 'block-cameras-name', /^camera of the film$/);
  await says(page, 'block-cameras-problem', /^$/);
  assert.deepEqual(complaints, []);
  await close();
});
