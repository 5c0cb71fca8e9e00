/** Fiducial marks of scanned film, measured in the view of pairs and used in the block. */

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { file, folder } from '../command/command.js';
import { ASKEW, inScan, MARKS_MM, PRINCIPAL_POINT_MM, scanOf, SIZE } from '../command/scans.js';
import { block, status } from './blocks.js';
import { hosted, part, partsKept, says, SHOTS, SKIP, until, upload } from './page.js';
import { blockPhotos } from './rendered.js';

hosted();

const FLIGHT = { strips: 1, exposures: 3, width_px: 480, height_px: 360, pixel_mm: 0.075 };
/** The corners of the film. */
const MARKS = MARKS_MM.slice(0, 4);
const LYING = [ASKEW, { ...ASKEW, turn: -0.05 }, { ...ASKEW, turn: 0.06, middle: /** @type {const} */ ([281.2, 240.4]) }];

/** The scans of the flight as files. */
function scans() {
  const at = folder();
  return blockPhotos(FLIGHT).map(({ name, bytes }, k) => {
    const { scan } = scanOf(at, `film_${k}`, file(at, name, bytes), LYING[k] ?? ASKEW);
    return upload(`film_${k}.png`, readFileSync(scan), 'image/png');
  });
}

/** @typedef {import('playwright-core').Page} Page */

/**
 * Presses the mark in hand where a scan has it: two presses beside it tell how large the picture is.
 * @param {Page} page @param {'left' | 'right'} side @param {readonly [number, number]} wanted px of the scan
 */
async function press(page, side, [col, row]) {
  const at = async (/** @type {number} */ x, /** @type {number} */ y) => {
    const before = await part(page, 'mark-text').textContent();
    // What is said above the pictures moves them.
    const box = await part(page, `pane-${side}`).boundingBox();
    assert.ok(box);
    await page.mouse.click(box.x + box.width / 2 + x, box.y + box.height / 2 + y);
    await page.waitForFunction((text) => document.querySelector('[data-testid="mark-text"]')?.textContent !== text, before);
    const [, c = '', r = ''] = /lies at ([\d.]+), ([\d.]+)/.exec(await says(page, 'mark-text', /lies at/)) ?? [];
    return /** @type {const} */ ([Number(c), Number(r)]);
  };
  const first = await at(3, 3);
  // Away from the border.
  const [right, down] = [col < SIZE[0] / 2 ? 30 : -30, row < SIZE[1] / 2 ? 30 : -30];
  const second = await at(3 + right, 3 + down);
  const scale = (second[0] - first[0]) / right;
  const [c, r] = await at(3 + (col - first[0]) / scale, 3 + (row - first[1]) / scale);
  assert.ok(Math.hypot(c - col, r - row) < 3, `${[c, r]} in place of ${[col, row]}`);
}

/** Presses marks of a scan one after the other, from the one in hand on.  @param {Page} page @param {'left' | 'right'} side @param {number} scan @param {readonly number[]} marks */
async function measure(page, side, scan, marks) {
  for (const index of marks) {
    // Where two tell where the next one is, it comes into view by itself.
    const expected = scan > 0 && index > 1 ? '.*near the dashed ring' : '';
    await says(page, 'mark-text', new RegExp(`[Mm]ark ${index + 1}${expected}`));
    await press(page, side, inScan(MARKS[index] ?? [0, 0], LYING[scan] ?? ASKEW));
    await page.keyboard.press('n');
  }
}

test('marks of scans are measured two by two, used in the block, and frames are made by them', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  const camera = upload('film.json', Buffer.from(JSON.stringify({ focal_mm: 40, principal_point_mm: PRINCIPAL_POINT_MM })), 'application/json');
  await part(page, 'block-files-input').setInputFiles([...scans(), camera]);
  await status(page, /^Film camera from film\.json\. 3 images in the block\. Press Measure marks under Scanned film/);
  await part(page, 'tab-block-orthophoto').click();
  await says(page, 'block-film-counted', /^Marks of 0 of 3 scans\.$/);
  await page.screenshot({ path: join(SHOTS, 'film-marks-settings.png') });
  await part(page, 'block-film-measure').click();

  // Nothing is known of the first scan: marks are pressed, and their photo coordinates typed once.
  await says(page, 'mark-text', /^New mark 1/);
  await says(page, 'of-scans', /^Marks of 0 of 3 scans\.$/);
  await says(page, 'name-left', /^film_0\.png/);
  await says(page, 'name-right', /^film_1\.png/);
  await measure(page, 'left', 0, [0, 1, 2, 3]);
  await says(page, 'of-scans', /film_0\.png: 4 marks have no x and y in mm; type them under Camera/);
  assert.ok(await part(page, 'marks-to-block').isHidden());
  // They stay with their scan while others are shown.
  await part(page, 'next-scans').click();
  await says(page, 'name-left', /^film_2\.png/);
  await part(page, 'next-scans').click();
  await says(page, 'name-left', /^film_0\.png/);
  await says(page, 'of-scans', /film_0\.png: 4 marks have no x and y in mm/);
  assert.doesNotMatch((await part(page, 'status').textContent()) ?? '', /Projects/);
  await part(page, 'tab-camera').click();
  for (const [index, [x, y]] of MARKS.entries()) {
    const fields = page.locator('[data-testid="fiducials-left"] tbody tr').nth(index).locator('input');
    await fields.nth(2).fill(String(x));
    await fields.nth(3).fill(String(y));
    await fields.nth(3).press('Tab');
    if (index === 1) await says(page, 'of-scans', /2 marks have no x and y.* film_0\.png: fiducial marks: 2 given; at least 3 are needed\.$/);
  }
  await says(page, 'of-scans', /^Marks of 0 of 3 scans\.$/);
  // The other scan has them from this one.
  await part(page, 'scan-marks-1').click();
  await says(page, 'mark-text', /^Mark 1 \(−17\.200/);
  await measure(page, 'right', 1, [0, 1, 2, 3]);
  await page.screenshot({ path: join(SHOTS, 'film-marks.png') });
  await part(page, 'marks-to-block').click();
  await says(page, 'of-scans', /^Marks of 2 of 3 scans\.$/);
  assert.ok(await part(page, 'marks-to-block').isHidden());

  // The last one, alone. What is measured, and what the block has, is there again after a reload.
  await part(page, 'next-scans').click();
  await says(page, 'name-left', /^film_2\.png/);
  await says(page, 'mark-text', /^Mark 1 \(−17\.200/);
  assert.ok(await part(page, 'scan-marks-1').isHidden());
  assert.ok(await part(page, 'next-scans').isHidden());
  await measure(page, 'left', 2, [0, 1]);
  await until(page, 'both marks are kept', async () => {
    const fiducials = (await partsKept(page, 'pair')).get('pair')?.typed.photos.left.fiducials ?? [];
    // Where it was pressed last, not on the way there.
    return Math.abs((fiducials[1]?.col ?? NaN) - inScan(MARKS[1] ?? [0, 0], LYING[2] ?? ASKEW)[0]) < 3;
  });
  await page.reload();
  await says(page, 'of-scans', /^Marks of 2 of 3 scans\. film_2\.png: fiducial marks: 2 given; at least 3 are needed\.$/);
  await part(page, 'scan-marks-0').click();
  await measure(page, 'left', 2, [2, 3]);
  await part(page, 'marks-to-block').click();
  await says(page, 'of-scans', /^Marks of 3 of 3 scans\.$/);
  // Scans are gone through again, with their marks; nothing was left under Projects.
  await part(page, 'next-scans').click();
  await says(page, 'name-left', /^film_0\.png/);
  await page.waitForFunction(() => document.querySelectorAll('[data-testid="fiducials-left"] tbody tr').length === 4);
  await page.screenshot({ path: join(SHOTS, 'film-marks-again.png') });
  assert.doesNotMatch((await part(page, 'status').textContent()) ?? '', /Projects/);

  await part(page, 'scans-to-block').click();
  await status(page, /Fiducial marks of scans from film_2\.csv\. Press Make images of one camera/);
  await says(page, 'block-film-marks-names', /^film_0\.csv, film_1\.csv, film_2\.csv$/);
  await part(page, 'block-film-frames').click();
  await status(page, /^3 scans were resampled to images of one camera, which the block calibrates within/);

  // It is a step with a name, which is undone where it was done, after a reload too, and done again.
  const undo = part(page, 'block-film-undo');
  await says(page, 'block-film-undo', /^Undo: make images of one camera of 3 scans$/);
  await until(page, 'the step is kept', async () => (await partsKept(page, 'block')).get('block/marks')?.done === 1);
  await page.reload();
  await part(page, 'tab-block-orthophoto').click();
  await undo.click();
  await says(page, 'block-film-marks-names', /^film_0\.csv, film_1\.csv, film_2\.csv$/);
  await page.waitForFunction(() => document.activeElement?.getAttribute('data-testid') === 'block-film-frames');
  assert.ok(await undo.isHidden());
  await page.keyboard.press('Control+Shift+Z');
  await says(page, 'block-film-undo', /^Undo: make images of one camera of 3 scans$/);
  await says(page, 'block-film-marks-names', /^No fiducial marks/);
  await page.keyboard.press('Control+z');
  await says(page, 'block-film-marks-names', /^film_0\.csv/);
  await part(page, 'block-film-frames').click();
  await status(page, /^3 scans were resampled to images of one camera/);
  assert.deepEqual(complaints, []);
  await close();
});

test('marks that are begun are there after a reload, and a press on Next scans right after it counts', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  await part(page, 'block-files-input').setInputFiles(scans());
  await status(page, /^3 images in the block\./);
  await part(page, 'tab-block-orthophoto').click();
  await part(page, 'block-film-measure').click();
  await says(page, 'name-left', /^film_0\.png/);
  await measure(page, 'left', 0, [0, 1]);
  const kept = () =>
    until(page, 'both marks are kept', async () => {
      const fiducials = (await partsKept(page, 'pair')).get('pair')?.typed.photos.left.fiducials ?? [];
      return fiducials.length === 2 && Math.abs(fiducials[1].col - inScan(MARKS[1] ?? [0, 0], LYING[0] ?? ASKEW)[0]) < 3;
    });
  await kept();
  // As soon as there is something to press, however slow the start is.
  const client = await page.context().newCDPSession(page);
  await client.send('Emulation.setCPUThrottlingRate', { rate: 4 });
  await page.addInitScript(() => {
    const pressed = new MutationObserver(() => {
      const press = document.querySelector('[data-testid="next-scans"]');
      if (!(press instanceof HTMLButtonElement) || press.disabled || !press.checkVisibility() || sessionStorage.getItem('pressed') !== 'wanted') return;
      sessionStorage.setItem('pressed', 'yes');
      press.click();
    });
    pressed.observe(document, { subtree: true, childList: true, attributes: true });
  });
  await page.evaluate(() => sessionStorage.setItem('pressed', 'wanted'));
  await page.reload();
  await says(page, 'name-left', /^film_2\.png/);
  // Begun marks stay with their scan: over a reload while another one is shown, too.
  await until(page, 'the other scan is kept', async () => {
    const [pair, own] = [await partsKept(page, 'pair'), await partsKept(page, 'block')];
    return pair.get('pair')?.images.left.name === 'film_2.png' && own.get('block')?.placing.film.begun.length > 0;
  });
  await page.evaluate(() => sessionStorage.setItem('pressed', 'wanted'));
  await page.reload();
  await says(page, 'name-left', /^film_0\.png/);
  await page.waitForFunction(() => document.querySelectorAll('[data-testid="fiducials-left"] tbody tr').length === 2);
  await client.send('Emulation.setCPUThrottlingRate', { rate: 1 });
  assert.deepEqual(complaints, []);
  await close();
});
