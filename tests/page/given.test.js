/** Files that a block is given beside its images: what is wrong with them is told at once, and costs no block that is there. */

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { test } from 'node:test';
import { read_exif } from '../../pkg/node.js';
import { block, drop, FLIGHT, photoFolder, photos, status } from './blocks.js';
import { flatGeoid } from './georeferenced.js';
import { hosted, part, partsNamed, SKIP, until, upload } from './page.js';
import { blockPhotos } from './rendered.js';

hosted('/given/');

const POINTS = 'a,0,0,0\nb,100,0,0\nc,0,100,0\n';

/** Marks of three points in images.  @param {string[]} images @param {string[]} [points] */
const marksIn = (images, points = ['a', 'b', 'c']) =>
  images.flatMap((image) => points.map((point, i) => `${image},${point},${100 + 90 * i},${80 + 70 * i}`)).join('\n');

/** Waits until a part of the page says something: files are read in a worker.  @param {import('playwright-core').Page} page @param {string} id @param {RegExp} pattern */
const says = (page, id, pattern) =>
  page.waitForFunction(
    ([name, source]) => new RegExp(source ?? '').test(document.querySelector(`[data-testid="${name}"]`)?.textContent ?? ''),
    [id, pattern.source],
  );

/** @param {import('playwright-core').Page} page @param {string} given @param {string} name @param {string} content */
const give = (page, given, name, content) => part(page, `block-${given}-input`).setInputFiles(upload(name, new TextEncoder().encode(content)));

test('control points without marks wait for them; marks without control points are refused beside their field and on Run', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  const folder = photoFolder(2);
  await part(page, 'block-folder-input').setInputFiles(folder);
  await status(page, /^2 images/);
  await give(page, 'control', 'points.csv', POINTS);
  await status(page, /^Ground control points from points\.csv\. The control points take no part yet: none is measured in two images or more, 3 are needed/);
  await says(page, 'block-control-problem', /take no part yet/);
  await part(page, 'block-control-remove').click();
  await says(page, 'block-control-problem', /^$/);
  await give(page, 'marks', 'marks.csv', marksIn(['photo_0.png', 'photo_1.png']));
  await says(page, 'block-marks-problem', /^Image measurements need their ground control points/);
  await part(page, 'block-run').click();
  await status(page, /^Not run: Image measurements need their ground control points/);
  assert.equal(await part(page, 'block-status').getAttribute('data-kind'), 'problem');
  await give(page, 'control', 'points.csv', POINTS);
  await status(page, /^Ground control points from points\.csv\.$/);
  await says(page, 'block-marks-problem', /^$/);
  rmSync(folder, { recursive: true });
  assert.deepEqual(complaints, []);
  await close();
});

test('files are read when they are given, and told by name', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  await give(page, 'cameras', 'cameras.json', '{"cameras": [{"images": "*", "focal_pix": 500}]}');
  await status(page, /^cameras\.json: .*focal_pix.* The block cannot be run with it\.$/);
  await says(page, 'block-cameras-problem', /^cameras\.json: .*focal_pix/);
  await give(page, 'cameras', 'cameras.json', '{"cameras": [{"images": "*", "focal_px": 500}]}');
  await status(page, /^Cameras from cameras\.json\.$/);
  await says(page, 'block-cameras-problem', /^$/);
  await give(page, 'control', 'points.csv', 'a,0,0\n');
  await status(page, /^points\.csv: /);
  await give(page, 'control', 'points.csv', POINTS);
  await give(page, 'marks', 'marks.csv', marksIn(['left.png', 'right.png'], ['a', 'b', 'stranger']));
  await status(page, /^marks\.csv: image measurements: got the point stranger; allowed: points of the table of control points\./);
  assert.deepEqual(complaints, []);
  await close();
});

test('a coordinate system that cannot be read is told at its field, and no table is to blame for it', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  const folder = photoFolder(2);
  await part(page, 'block-folder-input').setInputFiles(folder);
  await status(page, /^2 images/);
  await give(page, 'control', 'points.csv', POINTS);
  await give(page, 'marks', 'marks.csv', marksIn(['photo_0.png', 'photo_1.png']));
  const field = page.locator('input[data-key="placing.crs"]').first();
  const problem = page.locator('[id="p-placing-crs-problem"]').first();
  for (const [typed, told] of /** @type {const} */ ([
    ['UTM 32N', /it cannot be read\. Allowed: an EPSG code \(EPSG:25832\), PROJ text \(\+proj=utm \+zone=32\) or WKT/],
    ['EPSG:99999', /got EPSG:99999, a code that is unknown here/],
  ])) {
    await field.fill(typed);
    await field.blur();
    await until(page, `${typed} is refused`, async () => told.test((await problem.textContent()) ?? ''));
    assert.equal(await field.getAttribute('aria-invalid'), 'true');
    await says(page, 'block-marks-problem', /^$/);
    await part(page, 'block-run').click();
    await status(page, /^Not run: “Coordinate system”: /);
    assert.equal(await part(page, 'block-next').textContent(), 'Open “Coordinate system”');
  }
  await field.fill('EPSG:25832');
  await field.blur();
  await until(page, 'it is read', async () => (await problem.textContent()) === '');
  rmSync(folder, { recursive: true });
  assert.deepEqual(complaints, []);
  await close();
});

test('cameras that are of no image are told: all of them at once, one beside others with the block', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  const folder = photoFolder(2);
  await part(page, 'block-folder-input').setInputFiles(folder);
  await status(page, /^2 images/);
  await give(page, 'cameras', 'cameras.json', '{"cameras": [{"images": "DJI_*", "focal_px": 500}]}');
  await status(page, /^cameras\.json: the cameras: got DJI_\*, which fit no image.* The block cannot be run with it\.$/);
  await give(page, 'cameras', 'cameras.json', '{"cameras": [{"images": "DJI_*", "focal_px": 500}, {"images": "photo_*", "focal_px": 600}]}');
  await status(page, /^Cameras from cameras\.json\.$/);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation|No image)/);
  assert.match((await part(page, 'block-remarks').textContent()) ?? '', /the camera of DJI_\* fits the name of no image/);
  rmSync(folder, { recursive: true });
  assert.deepEqual(complaints, []);
  await close();
});

test('a run that fails leaves the finished block on the page', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  const folder = photoFolder(2);
  await part(page, 'block-folder-input').setInputFiles(folder);
  await drop(page, ['broken.jpg']);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): .*\. 2 images/);
  const points = await part(page, 'block-points-count').textContent();
  // The third image has a name, and cannot be read: only the run knows.
  await give(page, 'control', 'points.csv', POINTS);
  await give(page, 'marks', 'marks.csv', marksIn(['photo_0.png', 'broken.jpg']));
  await part(page, 'block-run').click();
  const line = await status(page, /^(Oriented|Weak orientation|Not run|The block was not finished)/);
  assert.match(line, /^The block was not finished: .*ground control points.* The screen shows the former block\.$/);
  assert.equal(await part(page, 'block-points-count').textContent(), points);
  assert.match((await part(page, 'block-results').getAttribute('class')) ?? '', /is-stale/);
  assert.ok(await part(page, 'block-export').isEnabled());
  for (const given of ['control', 'marks']) await part(page, `block-${given}-remove`).click();
  assert.match(await status(page, /^(Oriented|Weak orientation): /), /^(Oriented|Weak orientation): .*\. 2 images/);
  rmSync(folder, { recursive: true });
  assert.deepEqual(complaints, []);
  await close();
});

test('heights of a block count from the geoid of a file, which the browser keeps', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  await photos(page);
  await part(page, 'block-geoid-input').setInputFiles(upload('flat.gtx', flatGeoid()));
  await status(page, /flat\.gtx without a coordinate system.* The block cannot be run with it\.$/);
  await says(page, 'block-geoid-problem', /flat\.gtx without a coordinate system/);
  await part(page, 'tab-block-settings').click();
  await page.locator('input[data-key="placing.crs"]').first().fill('EPSG:32632');
  await page.locator('input[data-key="placing.crs"]').first().blur();
  await says(page, 'block-geoid-problem', /^$/);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation)/);
  assert.match(
    (await part(page, 'block-remarks').textContent()) ?? '',
    /heights count from the geoid of flat\.gtx, which lies 47\.00 to 47\.00 m above the ellipsoid/,
  );
  await until(page, 'the block is kept', async () => (await partsNamed(page, 'block/shown')) > 0);
  await page.reload();
  await says(page, 'block-geoid-name', /^flat\.gtx$/);
  await says(page, 'block-remarks', /the geoid of flat\.gtx/);
  // What is no geoid is refused by the run, which leaves the finished block.
  await part(page, 'block-geoid-remove').click();
  await says(page, 'block-geoid-name', /^None\. The geoid to which/);
  await part(page, 'block-geoid-input').setInputFiles(upload('cut.gtx', flatGeoid().slice(0, 100)));
  await part(page, 'block-run').click();
  await status(page, /^The block was not finished: .*cut\.gtx, which is not a geoid file that can be read/);
  assert.deepEqual(complaints, []);
  await close();
});

test('a table of GNSS positions is known among files, georeferences photos that record none and is kept', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  const rows = blockPhotos(FLIGHT).flatMap(({ name, bytes }) => {
    const { position } = read_exif(bytes, FLIGHT.width_px, FLIGHT.height_px);
    return position ? [[`photo_${Number(name.replace(/\D/gu, ''))}`, position.latitude_deg, position.longitude_deg, position.height_m].join(',')] : [];
  });
  assert.equal(rows.length, 6);
  const folder = photoFolder(6);
  await part(page, 'block-folder-input').setInputFiles(folder);
  await status(page, /^6 images/);
  const table = ['Label,Latitude,Longitude,Altitude,Yaw', ...rows.map((row) => `${row},1`)].join('\n');
  await part(page, 'block-files-input').setInputFiles(upload('flight.csv', Buffer.from(`\ufeff${table}`, 'utf16le')));
  await status(page, /^GNSS positions of images from flight\.csv\.$/);
  await says(page, 'block-positions-name', /^flight\.csv$/);
  await part(page, 'tab-block-settings').click();
  await page.locator('input[data-key="placing.crs"]').first().fill('EPSG:32632');
  await page.locator('input[data-key="placing.crs"]').first().blur();
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation)/);
  const remarks = (await part(page, 'block-remarks').textContent()) ?? '';
  assert.match(remarks, /surveyed\.csv are in .*UTM zone 32N/);
  assert.match(remarks, /columns of the table of image positions are not understood and not read: Yaw/);
  await until(page, 'the block is kept', async () => (await partsNamed(page, 'block/shown')) > 0);
  await page.reload();
  await says(page, 'block-positions-name', /^flight\.csv$/);
  await says(page, 'block-remarks', /UTM zone 32N/);
  assert.doesNotMatch((await part(page, 'block-results').getAttribute('class')) ?? '', /is-stale/);
  // Coordinates of a plane wait for their system.
  await give(page, 'positions', 'plane.csv', `image,easting,northing\n${rows[0]?.split(',')[0]},500000,5500000\n`);
  await status(page, /^6 images\. Images or settings have changed: press Run\. GNSS positions of images from plane\.csv\.$/);
  await says(page, 'block-positions-problem', /^$/);
  await page.locator('input[data-key="placing.crs"]').first().fill('');
  await page.locator('input[data-key="placing.crs"]').first().blur();
  await says(page, 'block-positions-problem', /plane\.csv: .*without a coordinate system.* \(Settings: “Coordinate system”\)$/);
  // The answer opens the field that is missing.
  await part(page, 'tab-block-orthophoto').click();
  await part(page, 'block-run').click();
  await status(page, /^Not run: .*\(Settings: “Coordinate system”\)/);
  await part(page, 'block-next').click();
  assert.equal(await page.evaluate(() => document.activeElement?.getAttribute('data-key')), 'placing.crs');
  assert.match((await part(page, 'block-results').getAttribute('class')) ?? '', /is-stale/);
  await part(page, 'block-positions-remove').click();
  await says(page, 'block-positions-name', /^None\. GNSS positions of images/);
  rmSync(folder, { recursive: true });
  assert.deepEqual(complaints, []);
  await close();
});
