/** At 390 px nothing is cut so that it says something else, or hides what it is of. */

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { block, FLIGHT, status, surveyedFolder } from './blocks.js';
import { pointsInSystem } from './georeferenced.js';
import { hosted, open, part, sample, SHOTS, SKIP, until, upload } from './page.js';

hosted('/phone/');

const PHONE = { fresh: true, options: { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true } };

/** @typedef {import('playwright-core').Page} Page */

/** @param {Page} page @param {string} selector */
const boxes = (page, selector) =>
  page.locator(selector).evaluateAll((all) =>
    all.map((one) => {
      const { left, top, right, bottom } = one.getBoundingClientRect();
      return { left, top, right, bottom };
    }),
  );

/** The figures of the answer stand with their captions over the buttons.  @param {Page} page @param {string} answer */
async function figuresAreWhole(page, answer) {
  const [buttons] = await boxes(page, `[data-testid="${answer}"] .answer-actions`);
  const figures = await boxes(page, `[data-testid="${answer}"] .figures :is(dt, dd)`);
  assert.ok(buttons && figures.length >= 4, `${figures.length} figures and captions`);
  const [card] = await boxes(page, `[data-testid="${answer}"]`);
  for (const { top, bottom } of figures) assert.ok(card && top >= card.top && bottom <= buttons.top + 1, JSON.stringify({ top, bottom, buttons, card }));
}

test('figures of a block have their captions, the legend of the map is whole, and no tab lies under the button that closes', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block(PHONE);
  /** What the map writes, with the place where it ends. */
  await page.evaluate(() => {
    const drawn = /** @type {Map<string, number>} */ (new Map());
    Object.assign(window, { drawn });
    const { fillText } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.fillText = function (text, x, y, most) {
      drawn.set(text, x + this.measureText(text).width);
      if (most === undefined) fillText.call(this, text, x, y);
      else fillText.call(this, text, x, y, most);
    };
  });
  const { folder, points, marks } = surveyedFolder();
  await part(page, 'block-wait').evaluate((box) => /** @type {HTMLInputElement} */ (box).click());
  await part(page, 'block-folder-input').setInputFiles(folder);
  // With it GNSS positions take part beside the control points: the legend names both.
  await page
    .locator('input[data-key="placing.crs"]')
    .first()
    .evaluate((field) => {
      /** @type {HTMLInputElement} */ (field).value = 'EPSG:32632';
      field.dispatchEvent(new Event('change'));
    });
  const table = pointsInSystem(points, FLIGHT, 'EPSG:32632', 0);
  await part(page, 'block-control-input').setInputFiles(upload('points.csv', new TextEncoder().encode(table)));
  await part(page, 'block-marks-input').setInputFiles(upload('marks.csv', new TextEncoder().encode(marks)));
  await part(page, 'block-run').click();
  await status(page, /^(?:Oriented|Weak orientation)/);
  await figuresAreWhole(page, 'block-answer');
  // Whatever is said beside the verdict.
  await part(page, 'block-files-input').setInputFiles(join(folder, 'photo_00000.png'));
  await status(page, /their names are in the block already/);
  await figuresAreWhole(page, 'block-answer');
  const ends = await until(page, 'the legend is drawn', () =>
    page.evaluate(() => {
      const { drawn } = /** @type {{ drawn: Map<string, number> }} */ (/** @type {unknown} */ (window));
      const own = [...drawn].filter(([text]) => /minus surveyed|minus adjusted/iu.test(text));
      return own.length === 0 ? null : own;
    }),
  );
  assert.ok(
    ends.some(([text]) => /GNSS minus adjusted/u.test(text)),
    ends.join(),
  );
  for (const [text, end] of ends) assert.ok(end <= 390, `${text} ends at ${end} px`);
  await part(page, 'block-table').click();
  const closing = await boxes(page, '.dock .close');
  const tabs = await boxes(page, '.dock [role="tab"]:not([hidden])');
  assert.ok(closing[0] && tabs.length >= 5, `${tabs.length} tabs`);
  for (const tab of tabs) {
    assert.ok(tab.right <= 390, JSON.stringify(tab));
    assert.ok(tab.right <= closing[0].left || tab.top >= closing[0].bottom, JSON.stringify([tab, closing[0]]));
  }
  await page.screenshot({ path: join(SHOTS, 'phone-block.png') });
  rmSync(folder, { recursive: true });
  assert.deepEqual(complaints, []);
  await close();
});

test('the reason why a point is rejected is read whole', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open(PHONE);
  await sample(page);
  await figuresAreWhole(page, 'answer');
  await part(page, 'layer-unmatched').click();
  let seen = 0;
  for (const [x, y] of /** @type {const} */ ([
    [60, 300],
    [120, 380],
    [150, 250],
    [80, 420],
  ])) {
    await page.touchscreen.tap(x, y);
    await page.waitForTimeout(400);
    const cut = await page.evaluate(() => {
      const text = document.getElementById('announce')?.closest('.caption');
      return text == null || !/Rejected/u.test(text.textContent ?? '') ? null : text.scrollHeight - text.clientHeight;
    });
    if (cut === null) continue;
    seen += 1;
    assert.ok(cut <= 1, `${cut} px are hidden`);
  }
  assert.ok(seen > 0, 'a rejected point was pressed');
  await page.screenshot({ path: join(SHOTS, 'phone-rejected.png') });
  assert.deepEqual(complaints, []);
  await close();
});
