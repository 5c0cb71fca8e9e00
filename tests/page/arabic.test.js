/** The page in Arabic: chosen or by the browser, from right to left, whole, and with nothing mirrored that must not be. */

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { english, texts } from './arabic.js';
import { looker } from './axe.js';
import { FLIGHT, photos } from './blocks.js';
import { CAMERA, done, enabled, hosted, open, part, pngs, saved, says, SHOTS, SKIP, upload } from './page.js';
import { blockPhotos } from './rendered.js';

hosted();

/** @typedef {import('playwright-core').Page} Page */

const ARABIC = { options: { locale: 'ar-EG' } };

/** @param {Page} page */
const document_ = (page) => page.evaluate(() => ({ lang: document.documentElement.lang, dir: document.documentElement.dir, title: document.title }));

test('the language is that of the browser until one is chosen, and the choice is kept', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ ...ARABIC, fresh: true });
  await page.waitForFunction(() => document.title.startsWith('\u200f'));
  assert.deepEqual(await document_(page), { lang: 'ar', dir: 'rtl', title: '\u200fTiepoint: مطابقة الصور وتوجيهها النسبي' });
  await enabled(page, 'sample-first');
  await Promise.all([page.waitForEvent('load'), part(page, 'language').click()]);
  await says(page, 'language', /^العربية$/u);
  assert.deepEqual(await document_(page), { lang: 'en', dir: 'ltr', title: 'Tiepoint: image matching and relative orientation' });
  await page.reload();
  await says(page, 'language', /^العربية$/u);
  assert.equal((await document_(page)).lang, 'en');
  await enabled(page, 'sample-first');
  await Promise.all([page.waitForEvent('load'), part(page, 'language').click()]);
  await says(page, 'language', /^English$/u);
  assert.equal((await document_(page)).dir, 'rtl');
  assert.deepEqual(complaints, []);
  await close();
});

test('a pair is matched and oriented in Arabic, and files stay English', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open(ARABIC);
  const found = new Map();
  const look = looker(page, found);
  /** @type {string[]} */
  const left = [];
  const read = async (/** @type {string} */ where) => left.push(...english(await texts(page)).map((text) => `${where}: ${text}`));
  await enabled(page, 'sample-first');
  await read('start');
  await look('start in Arabic');
  await part(page, 'file-input').setInputFiles([...pngs(), CAMERA]);
  assert.match(await done(page), /^(?:وُجّه الزوج|توجيه ضعيف)/u);
  await read('pair');
  await look('a pair in Arabic');
  // The left image stays on the left, and its panel of settings goes to the right.
  const [first, second] = await Promise.all(['pane-left', 'pane-right'].map((id) => part(page, id).boundingBox()));
  assert.ok((first?.x ?? 0) < (second?.x ?? 0));
  const settings = await page.locator('.side.of-settings').first().boundingBox();
  assert.ok((settings?.x ?? 0) > (second?.x ?? 0));
  // Charts run from left to right: the least value stands below the left end of the bars, and signs before their numbers.
  await part(page, 'histogram-residuals').waitFor();
  for (const figure of await page.locator('.histograms figure').all()) {
    const [least, median, most] = await figure.locator('.scale span').evaluateAll((all) => all.map((one) => one.getBoundingClientRect().x));
    assert.ok(least !== undefined && median !== undefined && most !== undefined && least < median && median < most, `${least}, ${median}, ${most}`);
  }
  const signs = await page.locator('[data-testid="correlations"] .matrix-value').evaluateAll((all) =>
    all.flatMap((one) => {
      const text = /** @type {SVGTextElement} */ (/** @type {unknown} */ (one));
      return text.textContent?.startsWith('−') === true ? [text.getStartPositionOfChar(0).x < text.getStartPositionOfChar(1).x] : [];
    }),
  );
  assert.ok(signs.length > 2 && !signs.includes(false), signs.join());
  await part(page, 'tab-matches').click();
  await read('matches');
  await part(page, 'tab-point').click();
  await part(page, 'view').focus();
  await page.keyboard.press('n');
  await page.waitForFunction(() => document.querySelector('[data-testid="point-verdict"]') !== null);
  await read('point');
  await page.keyboard.press('Control+k');
  await read('search');
  await look('the search in Arabic', 'dialog[open]');
  await page.keyboard.press('Escape');
  const json = JSON.parse((await saved(page, 'export-json')).toString());
  assert.match(json.verdict.text, /^(?:Oriented|Weak)/u);
  for (const width of [360, 768, 1366, 1920]) {
    await page.setViewportSize({ width, height: 800 });
    await page.screenshot({ path: join(SHOTS, `arabic-${String(width)}.png`) });
  }
  assert.deepEqual([...new Set(left)], []);
  assert.deepEqual([...found.values()], []);
  assert.deepEqual(complaints, []);
  await close();
});

test('a block runs in Arabic', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open(ARABIC);
  await part(page, 'mode-block').click();
  await enabled(page, 'block-simulate');
  const left = english(await texts(page)).map((text) => `start: ${text}`);
  await part(page, 'tab-block-orthophoto').click();
  left.push(...english(await texts(page)).map((text) => `orthophoto: ${text}`));
  await photos(page, undefined, /اضغط «تشغيل»/u);
  await part(page, 'block-run').click();
  await page.waitForFunction(() => /^(?:done|partial|problem)$/u.test(document.querySelector('[data-testid="block-status"]')?.getAttribute('data-kind') ?? ''));
  // The status comes before the map: the texts are whole once that is described.
  await says(page, 'block-map-words', /تقع الصور ضمن/u);
  left.push(...english(await texts(page)).map((text) => `run: ${text}`));
  for (const view of ['matrix', 'images', 'plots']) {
    await part(page, `block-show-${view}`).click();
    left.push(...english(await texts(page)).map((text) => `${view}: ${text}`));
  }
  const found = new Map();
  await looker(page, found)('a block in Arabic');
  await part(page, 'close-block-settings').click();
  await page.setViewportSize({ width: 360, height: 740 });
  for (const view of ['map', 'images', 'matrix', 'plots', 'orthophoto']) {
    await part(page, `block-show-${view}`).click();
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth), view);
  }
  assert.deepEqual([...new Set(left)], []);
  assert.deepEqual([...found.values()], []);
  assert.deepEqual(complaints, []);
  await close();
});

test('what is typed is refused in Arabic, with its range', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open(ARABIC);
  await enabled(page, 'sample');
  await part(page, 'tab-camera').click();
  for (const [id, typed, said] of /** @type {const} */ ([
    ['camera-focal', '-5', /أكبر من \u2068?0\u2069? وحتى \u2068?100000/u],
    ['camera-x0', '1e6', /عددان\u2069? من \u2068?-10000/u],
  ])) {
    await part(page, id).fill(typed);
    await part(page, id).press('Enter');
    const text = (await part(page, `${id}-problem`).textContent()) ?? '';
    assert.match(text, said);
    assert.deepEqual(english([text]), []);
  }
  assert.deepEqual(complaints, []);
  await close();
});

test('names that begin with a number, and what opens an image, are read as they are written', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ options: { ...ARABIC.options, viewport: { width: 1366, height: 768 } } });
  /** Whether the letters of a text stand where they do from left to right.  @param {import('playwright-core').Locator} place @param {string} text */
  const runs = (place, text) =>
    place.evaluate((element, wanted) => {
      const walker = document.createTreeWalker(element, NodeFilter.SHOW_TEXT);
      for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
        const from = node.textContent?.indexOf(wanted) ?? -1;
        if (from < 0) continue;
        const at = [...wanted].map((_, i) => {
          const range = document.createRange();
          range.setStart(node, from + i);
          range.setEnd(node, from + i + 1);
          return range.getBoundingClientRect().left;
        });
        return at.every((left, i) => i === 0 || left > (at[i - 1] ?? NaN));
      }
      return null;
    }, text);
  const [first, second] = pngs();
  assert.ok(first && second);
  await part(page, 'file-input').setInputFiles([{ ...first, name: '0001.png' }]);
  await says(page, 'name-left', /0001\.png/);
  assert.equal(await runs(part(page, 'name-left'), '0001.png'), true);
  // Its words run from right to left, and what follows them stands at their left.
  const ends = await part(page, 'open-right').evaluate((press) => {
    const node = press.firstChild;
    const range = document.createRange();
    const leftOf = (/** @type {number} */ at) => {
      range.setStart(/** @type {Node} */ (node), at);
      range.setEnd(/** @type {Node} */ (node), at + 1);
      return range.getBoundingClientRect().left;
    };
    return [getComputedStyle(press).direction, leftOf(0) > leftOf((node?.textContent?.length ?? 1) - 1)];
  });
  assert.deepEqual(ends, ['rtl', true]);
  await part(page, 'file-input').setInputFiles([{ ...second, name: '0002.png' }]);
  await done(page);
  await part(page, 'mode-block').click();
  await enabled(page, 'block-simulate');
  const numbered = blockPhotos(FLIGHT).slice(0, 3);
  await part(page, 'block-files-input').setInputFiles(numbered.map(({ bytes }, i) => upload(`000${i}.png`, bytes, 'image/png')));
  await enabled(page, 'block-run');
  await part(page, 'block-run').click();
  await page.waitForFunction(() => document.querySelector('[data-testid="block-answer"]')?.getAttribute('data-verdict'));
  await part(page, 'tab-block-pairs').click();
  await page.locator('[data-testid="block-pairs"] tbody tr:not(.filler)').first().click();
  assert.equal(await runs(part(page, 'block-chosen'), '0000.png – 0001.png'), true);
  assert.deepEqual(complaints, []);
  await close();
});
