/** The page's part for blocks, as its tests open and fill it. */

import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { BlockScene, grey_png } from '../../pkg/node.js';
import { open, part } from './page.js';

/** Small photos: six of them are rendered and matched in a few seconds. */
export const FLIGHT = { strips: 2, exposures: 3, width_px: 480, height_px: 360, pixel_mm: 0.15 };

/** @typedef {import('playwright-core').Page} Page */

/** @param {Page} page @param {RegExp} pattern @returns {Promise<string>} the status line once it is so */
export async function status(page, pattern) {
  await page.waitForFunction(
    ([source]) => new RegExp(source ?? '').test(document.querySelector('[data-testid="block-status"]')?.textContent ?? ''),
    [pattern.source],
    { timeout: 40_000 },
  );
  return (await part(page, 'block-status').textContent()) ?? '';
}

/** A page that shows its part for blocks.  @param {Parameters<typeof open>[0]} [how] */
export async function block(how) {
  const opened = await open(how);
  await part(opened.page, 'mode-block').click();
  await opened.page.waitForFunction(() => document.querySelector('[data-testid="block-simulate"]')?.hasAttribute('disabled') === false);
  return opened;
}

/** Photographs the flight in the page.  @param {Page} page */
export async function photograph(page, flight = FLIGHT) {
  await part(page, 'tab-block-flight').click();
  for (const [field, value] of Object.entries(flight)) await page.locator(`input[data-key="block_flight.${field}"]`).first().fill(String(value));
  await part(page, 'block-photograph').click();
  await status(page, /Press Run/);
}

/** A folder with photos of the flight and what is no image.  @param {number} count */
export function photoFolder(count) {
  const folder = mkdtempSync(join(tmpdir(), 'tiepoint-photos-'));
  const scene = new BlockScene(FLIGHT);
  for (let index = 0; index < count; index++) {
    const { width, height, grey } = scene.photo(index);
    writeFileSync(join(folder, `photo_${index}.png`), grey_png(width, height, grey));
  }
  scene.free();
  writeFileSync(join(folder, 'truth.json'), '{}');
  return folder;
}

/** Drops files of these names that hold no image.  @param {Page} page @param {string[]} names */
export async function drop(page, names) {
  const transfer = await page.evaluateHandle((given) => {
    const data = new DataTransfer();
    for (const name of given) data.items.add(new File(['no image'], name));
    return data;
  }, names);
  for (const type of ['dragenter', 'dragover', 'drop']) await part(page, 'block-picture').dispatchEvent(type, { dataTransfer: transfer });
}
