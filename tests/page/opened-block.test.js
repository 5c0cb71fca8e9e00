/** The project file of a block that is opened elsewhere: what it holds is what the settings show and the next run takes; what it does not hold is said before that. */

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { test } from 'node:test';
import { block, FLIGHT, photos, status, surveyedFolder } from './blocks.js';
import { hosted, part, partsNamed, saved, says, SKIP, until, upload } from './page.js';
import { flatGeoid, pointsInSystem } from './georeferenced.js';
import { blockGround } from './rendered.js';

hosted('/opened-block/');

const CRS = 'EPSG:32632';
/** Of the flat geoid. */
const GEOID_M = 47;

/** @param {string} text */
const bytesOf = (text) => new TextEncoder().encode(text);

/** @param {import('playwright-core').Page} page @param {string} given @param {string} name @param {Uint8Array} content */
const give = (page, given, name, content) => part(page, `block-${given}-input`).setInputFiles(upload(name, content));

/** The rows of control and check points.  @param {import('playwright-core').Page} page */
async function surveyed(page) {
  await part(page, 'tab-block-surveyed').click();
  await says(page, 'block-surveyed', /G2/u);
  return page.locator('[data-testid="block-surveyed"] tbody tr:not(.filler)').allTextContents();
}

/** What *Project file* saves.  @param {import('playwright-core').Page} page */
async function savedProject(page) {
  await part(page, 'block-export-kind').selectOption('project');
  return saved(page, 'block-export');
}

test('an opened project file has its control points, measurements, system, geoid, cameras and settings, and a new run takes them', {
  skip: SKIP,
}, async () => {
  const { folder, points, marks } = surveyedFolder();
  rmSync(folder, { recursive: true });
  const first = await block();
  await photos(first.page);
  const field = (/** @type {import('playwright-core').Page} */ page, /** @type {string} */ key) => page.locator(`input[data-key="${key}"]`).first();
  await field(first.page, 'placing.crs').fill(CRS);
  await field(first.page, 'placing.mark_sigma_px').fill('0.7');
  await field(first.page, 'placing.mark_sigma_px').blur();
  await give(first.page, 'geoid', 'flat.gtx', flatGeoid());
  await give(first.page, 'control', 'points.csv', bytesOf(pointsInSystem(points, FLIGHT, CRS, GEOID_M)));
  await give(first.page, 'marks', 'marks.csv', bytesOf(marks));
  await give(first.page, 'cameras', 'cameras.json', bytesOf('{"cameras": [{"images": "*", "focal_px": 566.7}]}'));
  await part(first.page, 'block-run').click();
  const before = (await status(first.page, /^(Oriented|Weak orientation): /)).replace(/\d+(?:\.\d+)? s\b/u, '');
  const rows = await surveyed(first.page);
  // The surveyor's own coordinates stand before those of the block.
  assert.match(rows.find((row) => row.startsWith('G2')) ?? '', /^G2control5428.?483\.1985.?539.?105\.775/u);
  const project = await savedProject(first.page);
  assert.deepEqual(first.complaints, []);
  await first.close();

  const { page, complaints, close } = await block();
  await part(page, 'block-files-input').setInputFiles(upload('survey.tiepoint', project));
  await status(page, /survey\.tiepoint was opened/);
  for (const given of ['control', 'marks', 'cameras']) await says(page, `block-${given}-name`, /^survey\.tiepoint$/);
  await says(page, 'block-geoid-name', /^flat\.gtx$/);
  assert.equal(await field(page, 'placing.crs').inputValue(), CRS);
  assert.equal(await field(page, 'placing.mark_sigma_px').inputValue(), '0.7');
  assert.deepEqual(await surveyed(page), rows);
  await photos(page, FLIGHT, /All images of the block are there/);
  // What is changed is of the next run; after a reload, too, nothing else is.
  await field(page, 'placing.mark_sigma_px').fill('0.8');
  await status(page, /Images or settings have changed: press Run\./);
  await field(page, 'placing.mark_sigma_px').fill('0.7');
  await status(page, /^(Oriented|Weak orientation): /);
  await until(page, 'the block is kept', async () => (await partsNamed(page, 'block/shown')) > 0);
  await page.waitForTimeout(1500);
  await page.reload();
  await status(page, /^(Oriented|Weak orientation): .*Restored from this browser/);
  await part(page, 'block-run').click();
  await page.waitForFunction(() => document.querySelector('[data-testid="block-status"]')?.getAttribute('data-kind') === 'busy');
  const after = (await status(page, /^(Oriented|Weak orientation): /)).replace(/\d+(?:\.\d+)? s\b/u, '');
  assert.equal(after, before);
  assert.deepEqual(await surveyed(page), rows);
  assert.match((await part(page, 'block-remarks').textContent()) ?? '', /heights count from the geoid of flat\.gtx/);
  // Control points georeference it: an orthophoto is no next step, and can be one.
  const [, picture] = blockGround(FLIGHT, 1);
  assert.ok(picture);
  await part(page, 'block-files-input').setInputFiles(upload('ground.tif', picture.bytes, 'image/tiff'));
  await status(page, /The block lies where its control points place it\./);
  assert.equal(await part(page, 'block-next').textContent(), 'Save the project');
  assert.equal(await part(page, 'block-other-1').textContent(), 'Place the block on the orthophoto');
  assert.deepEqual(complaints, []);
  await close();
});

test('masks that an opened project file names and does not hold are asked for before a run', { skip: SKIP }, async () => {
  const first = await block();
  await photos(first.page);
  const mask = Buffer.concat([Buffer.from(`P5\n${FLIGHT.width_px} ${FLIGHT.height_px}\n255\n`), Buffer.alloc(FLIGHT.width_px * FLIGHT.height_px, 255)]);
  await give(first.page, 'masks', 'photo_00001.pgm', mask);
  await says(first.page, 'block-masks-problem', /^$/);
  await part(first.page, 'block-run').click();
  await status(first.page, /^(Oriented|Weak orientation): /);
  const project = await savedProject(first.page);
  await first.close();

  const { page, complaints, close } = await block();
  await part(page, 'block-files-input').setInputFiles(upload('masked.tiepoint', project));
  await status(page, /A new run needs a file that the project file does not hold: give it again under Files in the settings, or remove it there\./);
  await says(page, 'block-masks-name', /^photo_00001\.pgm$/);
  await says(page, 'block-masks-problem', /^the mask photo_00001\.pgm is not in the project file/);
  await photos(page, FLIGHT, /All images of the block are there/);
  await part(page, 'block-run').click();
  await status(page, /Not run: [Tt]he mask photo_00001\.pgm is not in the project file: give it again, or remove it to run the block without\./);
  await give(page, 'masks', 'photo_00001.pgm', mask);
  await says(page, 'block-masks-problem', /^$/);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  assert.deepEqual(complaints, []);
  await close();
});

test('a project file takes the place of a block, and of what waits to be run: neither its images nor its settings are those of the other one', {
  skip: SKIP,
}, async () => {
  const { page, complaints, close } = await block();
  const crs = page.locator('input[data-key="placing.crs"]').first();
  await photos(page);
  await crs.fill(CRS);
  await crs.blur();
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  const project = await savedProject(page);
  // The images of the block that was shown have the names of those of the file, and stay with it.
  await part(page, 'block-files-input').setInputFiles(upload('survey.tiepoint', project));
  await status(page, /survey\.tiepoint was opened.* The former block stays under Projects\./);
  assert.equal(await crs.inputValue(), CRS);
  assert.ok(await part(page, 'block-run').isDisabled());
  await photos(page, FLIGHT, /All images of the block are there/);
  // Without its block the settings of a file are those of nothing.
  await part(page, 'block-clear').click();
  await status(page, /stays under Projects\./);
  assert.equal(await crs.inputValue(), '');
  // Images and settings that wait are kept where they are replaced.
  await photos(page);
  await crs.fill('EPSG:25832');
  await crs.blur();
  await part(page, 'block-files-input').setInputFiles(upload('survey.tiepoint', project));
  await status(page, /survey\.tiepoint was opened.* The former block stays under Projects\./);
  assert.equal(await crs.inputValue(), CRS);
  await part(page, 'projects').click();
  await page.locator('[data-testid="project"]:not([aria-current]) .link').first().click();
  await page.waitForFunction(() => /** @type {HTMLInputElement | null} */ (document.querySelector('input[data-key="placing.crs"]'))?.value === 'EPSG:25832');
  assert.deepEqual(complaints, []);
  await close();
});
