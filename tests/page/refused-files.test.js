/** Files that the page does not read: named by their kind, with what to do, each reason once. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { block, status } from './blocks.js';
import { done, hosted, open, part, pngs, says, SKIP, transferOf, upload } from './page.js';

hosted();

const HEIC = Buffer.concat([Buffer.from([0, 0, 0, 24]), Buffer.from('ftypheic\0\0\0\0mif1heic'), Buffer.alloc(100)]);

/** @param {string} name */
const heic = (name) => upload(name, HEIC);

/** @param {import('playwright-core').Page} page @param {ReturnType<typeof upload>[]} files */
async function drop(page, files) {
  const transfer = await transferOf(page, files);
  for (const type of ['dragover', 'drop']) await page.locator('body').dispatchEvent(type, { dataTransfer: transfer });
}

const REASON =
  'HEIC pictures are not read: export them as JPEG \\(on an iPhone, for new ones: Settings, Camera, Formats, Most Compatible\\); allowed: JPEG, .*WebP\\.';

test('pictures of kinds that are not read are named for a pair, and what is dropped with them is opened', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ fresh: true });
  await says(page, 'status', /^Ready/);
  await drop(page, [heic('IMG_1.HEIC'), heic('IMG_2.jpg')]);
  await says(page, 'status', new RegExp(`^2 files cannot be opened \\(IMG_1\\.HEIC, IMG_2\\.jpg\\): ${REASON}$`));
  assert.equal(await part(page, 'answer').getAttribute('data-kind'), 'problem');
  await drop(page, [heic('IMG_1.HEIC')]);
  await says(page, 'status', new RegExp(`^IMG_1\\.HEIC cannot be opened: ${REASON}$`));
  // The same reason of files that are read to the end.
  await drop(page, [upload('a.png', Buffer.from('no image'), 'image/png'), upload('b.png', Buffer.from('no image'), 'image/png')]);
  await says(page, 'status', /^2 files cannot be opened \(a\.png, b\.png\): [^(]*not supported; allowed: .*WebP\.$/);
  await drop(page, [...pngs(), heic('IMG_1.HEIC'), upload('ground.ecw', Buffer.from('e'))]);
  await says(page, 'status', /IMG_1\.HEIC cannot be opened: HEIC.*ground\.ecw cannot be opened: ECW pictures are not read: save them as GeoTIFF/);
  await done(page);
  assert.match((await part(page, 'name-right').textContent()) ?? '', /right/);
  assert.deepEqual(complaints, []);
  await close();
});

test('pictures of kinds that are not read are named for a block, the first of them, and are no files that nobody understands', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  const many = Array.from({ length: 7 }, (_, i) => heic(`IMG_${i}.HEIC`));
  const files = /^7 files cannot be opened \(IMG_0\.HEIC, IMG_1\.HEIC, IMG_2\.HEIC, IMG_3\.HEIC, IMG_4\.HEIC and 2 more\): HEIC pictures are not read/;
  await drop(page, many);
  await status(page, files);
  assert.equal(await part(page, 'block-status').getAttribute('data-kind'), 'problem');
  await drop(page, [...pngs(), ...many, upload('notes.md', Buffer.from('notes'))]);
  assert.match(await status(page, /in the block/), /^2 images in the block\. 1 file skipped: not an image by name\. .*7 files cannot be opened/);
  // Beside an orthophoto that is given, and where that is refused.
  await part(page, 'block-orthophoto-input').setInputFiles([heic('ground.heic')]);
  await status(page, /^ground\.heic cannot be opened: HEIC/);
  await part(page, 'block-orthophoto-input').setInputFiles([heic('ground.heic'), upload('plain.png', Buffer.from('no image'))]);
  await status(page, /plain\.png.*ground\.heic cannot be opened: HEIC/);
  assert.deepEqual(complaints, []);
  await close();
});

test('files that are not read are named in Arabic', { skip: SKIP }, async () => {
  const { page, close } = await open({ fresh: true, options: { locale: 'ar' } });
  await part(page, 'view').waitFor();
  await drop(page, [heic('IMG_1.HEIC'), heic('IMG_2.HEIC')]);
  await says(page, 'status', /لا يمكن فتح ملفين .*IMG_1\.HEIC.*صور HEIC لا تُقرأ.*الأكثر توافقًا/);
  await close();
});
