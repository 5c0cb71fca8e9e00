/** What the page says where a strategy that compares windows does not suit the photos, and what is given in place of a camera. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grey_png, Photo } from '../../pkg/node.js';
import { again, CAMERA, choose, done, hosted, open, part, pngs, says, SKIP, upload } from './page.js';

hosted();

test('photos that are turned are told by how much, and a pair without matches asks for no camera', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  const [left, right] = pngs();
  assert.ok(left && right);
  const photo = Photo.decode(right.buffer);
  const { width, height } = photo;
  const turned = upload('right.png', grey_png(width, height, photo.grey().toReversed()), 'image/png');
  await part(page, 'file-input').setInputFiles([left, turned]);
  await done(page);
  await choose(page, 'matching.strategy', 'moments');
  assert.match(await says(page, 'status', /turned in its plane/), /turned in its plane by -?1(79|80)°: this strategy compares windows/);
  assert.equal(await part(page, 'next').textContent(), 'Use “auto”');
  await page.locator('input[data-key="matching.max_measure"]').fill('0');
  await again(page);
  assert.match(await says(page, 'status', /no match was found/), /Not oriented: no match was found, and an orientation takes at least 5/);
  assert.deepEqual(complaints, []);
  await close();
});

test('the cameras of a block are named where the camera of a pair is wanted', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await part(page, 'file-input').setInputFiles([...pngs(), CAMERA]);
  await done(page);
  const cameras = JSON.stringify({ cameras: [{ images: 'a*', focal_px: 1500 }, { focal_px: 900 }] });
  await part(page, 'file-input').setInputFiles([upload('cameras.json', Buffer.from(cameras), 'application/json')]);
  await says(page, 'status', /cameras\.json .*2 cameras of a block, by the names of their images/);
  assert.deepEqual(complaints, []);
  await close();
});
