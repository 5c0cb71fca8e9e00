/** A third photo that is given to a pair: what it is for is asked before anything changes. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { FLIGHT, status } from './blocks.js';
import { done, transferOf, hosted, open, part, says, SKIP, upload } from './page.js';
import { blockPhotos } from './rendered.js';

hosted();

const photos = () =>
  blockPhotos(FLIGHT)
    .slice(0, 3)
    .map(({ name, bytes }) => upload(name, Buffer.from(bytes), 'image/png'));

/** @param {import('playwright-core').Page} page @param {'left' | 'right'} side */
const nameOf = (page, side) => part(page, `name-${side}`).textContent();

/** A page with two of the photos; gives the third.  @param {import('playwright-core').BrowserContextOptions} [options] */
async function two(options = {}) {
  const opened = await open({ fresh: true, options });
  const [left, right, third] = photos();
  assert.ok(left && right && third);
  await part(opened.page, 'file-input').setInputFiles([left, right]);
  await done(opened.page);
  return { ...opened, left, third };
}

/** Drops a photo on the right pane.  @param {import('playwright-core').Page} page @param {ReturnType<typeof upload>} photo */
async function drop(page, photo) {
  const [transfer, box] = [await transferOf(page, [photo]), await part(page, 'pane-right').boundingBox()];
  assert.ok(box);
  const at = { clientX: box.x + box.width / 2, clientY: box.y + box.height / 2 };
  for (const type of ['dragenter', 'dragover', 'drop']) await part(page, 'view').dispatchEvent(type, { dataTransfer: transfer, ...at });
}

test('a third photo that is dropped on a pair replaces none before that is asked, and the three open as a block', { skip: SKIP }, async () => {
  const { page, complaints, close, left, third } = await two();
  const verdict = await part(page, 'answer').getAttribute('data-verdict');
  await drop(page, third);
  await says(page, 'status', /^photo_00002\.png is a third image: open all three as a block, or replace the right image with it\?$/);
  assert.deepEqual(
    [await nameOf(page, 'left'), await nameOf(page, 'right')].map((name) => /photo_0000\d/.exec(name ?? '')?.[0]),
    ['photo_00000', 'photo_00001'],
  );
  await part(page, 'other-2').click();
  await done(page);
  assert.equal(await part(page, 'answer').getAttribute('data-verdict'), verdict);
  // The photo that is there is no third one; what cannot be read is said as ever.
  await part(page, 'file-input').setInputFiles([left]);
  await done(page);
  assert.equal(await part(page, 'other-2').count(), 0);
  // Nor is the one of the other pane, whatever it is called now.
  await drop(page, { ...left, name: 'copy.png' });
  await says(page, 'status', /copy\.png is the left image already\. Nothing was changed\.$/);
  assert.match((await nameOf(page, 'right')) ?? '', /photo_00001/);
  await part(page, 'file-input').setInputFiles([upload('bad.png', Buffer.from('no image'), 'image/png')]);
  await says(page, 'status', /bad\.png cannot be opened: .* The open images are kept\.$/);

  await drop(page, third);
  await says(page, 'status', /is a third image/);
  await part(page, 'next').click();
  await status(page, /^(Oriented|Weak orientation): 3 of 3 images/);
  await part(page, 'mode-pair').click();
  assert.match((await nameOf(page, 'right')) ?? '', /photo_00001/);
  assert.doesNotMatch((await part(page, 'status').textContent()) ?? '', /third/);
  assert.deepEqual(complaints, []);
  await close();
});

test('a third photo replaces the one whose pane it was dropped on, where that is answered', { skip: SKIP }, async () => {
  const { page, complaints, close, third } = await two();
  await drop(page, third);
  await says(page, 'status', /replace the right image with it\?$/);
  await part(page, 'other-1').click();
  await says(page, 'name-right', /photo_00002/);
  assert.match((await nameOf(page, 'left')) ?? '', /photo_00000/);
  await done(page);
  assert.deepEqual(complaints, []);
  await close();
});
