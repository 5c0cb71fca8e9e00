/** Tools in hand, looked at with axe: areas of masks, fiducial marks, and a point of a block that is measured. */

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { test } from 'node:test';
import { looker } from './axe.js';
import { block, photoFolder, status } from './blocks.js';
import { CAMERA, done, hosted, open, part, pngs, says, SKIP, upload } from './page.js';

hosted('/accessibility-tools/');

const MARKS = upload(
  'left-fiducials.csv',
  Buffer.from('col,row,x_mm,y_mm\n20,30,-29.2,43.2\n250,30,29.2,43.2\n250,370,29.2,-43.2\n20,370,-29.2,-43.2\n'),
  'text/csv',
);

test('axe finds nothing while areas of a mask are drawn and fiducial marks are measured', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ fresh: true });
  /** @type {Map<string, string>} */
  const found = new Map();
  const look = looker(page, found);
  await part(page, 'file-input').setInputFiles([...pngs(), CAMERA, MARKS]);
  await done(page);
  await part(page, 'tool-mask').click();
  await says(page, 'mask-text', /^Draw round an area/);
  await look('a mask is begun');
  const box = await part(page, 'pane-left').boundingBox();
  assert.ok(box);
  const at = (/** @type {number} */ x, /** @type {number} */ y) => /** @type {const} */ ([box.x + x * box.width, box.y + y * box.height]);
  await page.mouse.move(...at(0.4, 0.4));
  await page.mouse.down();
  for (const corner of /** @type {[number, number][]} */ ([
    [0.6, 0.4],
    [0.6, 0.6],
    [0.4, 0.6],
  ]))
    await page.mouse.move(...at(...corner), { steps: 8 });
  await page.mouse.up();
  await says(page, 'mask-text', /^An area of \d+ corners: mask it/);
  await look('an area of a mask');
  await page.keyboard.press('Escape');
  await page.keyboard.press('Escape');
  await part(page, 'settings').click();
  await part(page, 'tab-camera').click();
  await part(page, 'measure-fiducials-left').click();
  await says(page, 'mark-text', /^New mark 5/);
  await look('a new fiducial mark');
  await page.keyboard.press('p');
  await says(page, 'mark-text', /^Mark 4 \(.*\) lies at/);
  await look('a fiducial mark that is measured');
  assert.deepEqual([...found.values()], []);
  assert.deepEqual(complaints, []);
  await close();
});

test('axe finds nothing while points of a block are measured', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block({ fresh: true });
  /** @type {Map<string, string>} */
  const found = new Map();
  const look = looker(page, found);
  const folder = photoFolder(3);
  await part(page, 'block-folder-input').setInputFiles(folder);
  await status(page, /^(Oriented|Weak orientation): /);
  rmSync(folder, { recursive: true });
  await part(page, 'block-show-images').click();
  await part(page, 'block-panes').focus();
  await page.keyboard.press('n');
  await says(page, 'image-point', / rays/);
  await page.keyboard.press('e');
  await says(page, 'block-edit-text', /placed in 0 images/);
  await look('a point of a block is measured');
  await part(page, 'block-panes').focus();
  await page.keyboard.press('Escape');
  await page.keyboard.press('a');
  await page.keyboard.press('Enter');
  await says(page, 'block-edit-text', /placed in 1 image/);
  await look('a new point of a block is placed');
  assert.deepEqual([...found.values()], []);
  assert.deepEqual(complaints, []);
  await close();
});
