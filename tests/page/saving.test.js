/** Saving: what cannot be written is said beside the button, and the answer stays what it is. */

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { test } from 'node:test';
import { block, photoFolder, status } from './blocks.js';
import { done, hosted, open, part, sample, saved, says, SKIP } from './page.js';

hosted('/saving/');

/** @typedef {import('playwright-core').Page} Page */

/** Where two parts lie.  @param {Page} page @param {[string, string]} ids */
async function boxes(page, [a, b]) {
  const [first, second] = [await part(page, a).boundingBox(), await part(page, b).boundingBox()];
  assert.ok(first && second, `${a} ${b}`);
  return /** @type {const} */ ([first, second]);
}

test('a format that a block cannot be written in is refused beside the button, and its verdict stays', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block({ options: { viewport: { width: 1366, height: 768 } } });
  // Nothing says what the pixels of these measure, which the format needs.
  const folder = photoFolder(4);
  await part(page, 'block-folder-input').setInputFiles(folder);
  await status(page, /^4 images in the block/);
  await part(page, 'block-run').click();
  const verdict = await status(page, /^(Oriented|Weak orientation): /);
  const colour = await part(page, 'block-answer').getAttribute('data-verdict');
  await part(page, 'block-export-kind').selectOption('bingo');
  await part(page, 'block-export').click();
  await part(page, 'block-near').waitFor();
  assert.match((await part(page, 'block-near').textContent()) ?? '', /^BINGO was not written: /);
  assert.equal(await part(page, 'block-status').textContent(), verdict);
  assert.equal(await part(page, 'block-answer').getAttribute('data-verdict'), colour);
  const [button, said] = await boxes(page, ['block-export', 'block-near']);
  assert.ok(said.y >= button.y + button.height && said.y < button.y + button.height + 20, JSON.stringify([button, said]));
  assert.ok(said.x >= 0 && said.x + said.width <= 1366, JSON.stringify(said));
  // What can be saved takes it away.
  await part(page, 'block-export-kind').selectOption('project');
  await saved(page, 'block-export');
  assert.match(await status(page, /block-project\.tiepoint was saved\.$/), /^(Oriented|Weak orientation): /);
  assert.ok(await part(page, 'block-near').isHidden());
  rmSync(folder, { recursive: true });
  assert.deepEqual(complaints, []);
  await close();
});

test('what is saved of a pair is named, in place of a former notice, and nothing below moves', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ options: { viewport: { width: 1366, height: 768 } } });
  await sample(page);
  const before = await part(page, 'view').boundingBox();
  const verdict = await part(page, 'answer').getAttribute('data-verdict');
  for (const [id = '', name] of [
    ['export-png', 'png'],
    ['export-csv', 'csv'],
    ['export-json', 'json'],
    ['export-project', 'tiepoint'],
  ]) {
    await saved(page, id);
    await says(page, 'status', new RegExp(` [^ ]+\\.${name} was saved\\.$`));
    assert.equal(await part(page, 'answer').getAttribute('data-verdict'), verdict);
    assert.deepEqual(await part(page, 'view').boundingBox(), before, id);
  }
  await part(page, 'swap').click();
  await done(page);
  const said = /swap again/;
  assert.match((await part(page, 'status').textContent()) ?? '', said);
  await saved(page, 'export-png');
  await says(page, 'status', /\.png was saved\.$/);
  assert.doesNotMatch((await part(page, 'status').textContent()) ?? '', said);
  assert.deepEqual(complaints, []);
  await close();
});
