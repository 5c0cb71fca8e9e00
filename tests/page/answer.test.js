/** What a stranger sees: an invitation, the answer beside the pictures, settings only where they are asked for. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { block, FLIGHT, status } from './blocks.js';
import { coloured, shareOfOrange } from './colours.js';
import { choose, done, enabled, hosted, number, open, pair, part, pngs, sample, says, SKIP, until, upload } from './page.js';
import { barePhotos, blockPhotos } from './rendered.js';

hosted('/answer/');

/** @typedef {import('playwright-core').Page} Page */

/**
 * Starts to add up how far parts of the page move that nobody pressed, as web vitals do: the most of those that follow each other within a second, for
 * five seconds. It runs in the page.
 */
function watchShifts() {
  const most = /** @type {{ shifts?: number }} */ (/** @type {unknown} */ (window));
  most.shifts = 0;
  let [sum, begun, last] = [0, -Infinity, -Infinity];
  new PerformanceObserver((list) => {
    for (const { hadRecentInput, value, startTime } of /** @type {{ hadRecentInput: boolean, value: number, startTime: number }[]} */ (
      /** @type {unknown} */ (list.getEntries())
    )) {
      if (hadRecentInput) continue;
      if (startTime - last > 1000 || startTime - begun > 5000) [sum, begun] = [0, startTime];
      [sum, last] = [sum + value, startTime];
      most.shifts = Math.max(most.shifts ?? 0, sum);
    }
  }).observe({ type: 'layout-shift', buffered: true });
}

/** A page without drawers that is watched from its beginning.  @param {import('playwright-core').BrowserContextOptions} options */
async function watched(options) {
  const opened = await open({ url: 'about:blank', fresh: true, options });
  const other = await open({ fresh: true });
  const url = other.page.url();
  await other.close();
  await opened.page.addInitScript(watchShifts);
  await opened.page.goto(url);
  // The page began as an empty one, from which every request leaves its origin.
  return { ...opened, complaints: () => opened.complaints.filter((complaint) => !complaint.includes(new URL(url).origin)) };
}

const shifts = (/** @type {Page} */ page) => page.evaluate(() => Number(/** @type {{ shifts?: number }} */ (/** @type {unknown} */ (window)).shifts));

/** Fails where a part is not wholly in sight.  @param {Page} page @param {string} id */
async function inSight(page, id) {
  const box = await part(page, id).boundingBox();
  const size = page.viewportSize();
  assert.ok(box && size, id);
  assert.ok(box.x >= 0 && box.y >= 0 && box.x + box.width <= size.width && box.y + box.height <= size.height, `${id}: ${JSON.stringify(box)}`);
}

for (const [width, height] of /** @type {const} */ ([
  [1366, 768],
  [360, 740],
])) {
  test(`verdict, figures, next step and pictures are seen without scrolling at ${width} × ${height} px, and nothing moves`, { skip: SKIP }, async () => {
    const { page, complaints, close } = await watched({ viewport: { width, height } });
    for (const id of ['open-first', 'sample-first', 'sample-block-first']) await inSight(page, id);
    await sample(page);
    assert.equal(await part(page, 'answer').getAttribute('data-verdict'), 'oriented');
    for (const id of ['status', 'figures', 'next', 'view']) await inSight(page, id);
    assert.equal(await page.evaluate(() => window.scrollY), 0);
    assert.ok(((await part(page, 'view').boundingBox())?.height ?? 0) > 0.5 * height);
    assert.equal(await part(page, 'figures').locator('dd').count(), 3);
    // A value has the decimals of its error.
    const kappa = (await part(page, 'figures').locator('dd').nth(2).textContent()) ?? '';
    const [, decimals = '', ofError = ''] = /^−?\d+(?:\.(\d+))?° ± \d+(?:\.(\d+))?°$/.exec(kappa) ?? [];
    assert.ok(kappa !== '' && ofError !== '' && decimals.length === ofError.length, kappa);
    assert.ok((await shifts(page)) < 0.1, String(await shifts(page)));
    // Buttons in sight are large enough for a finger.
    const small = await page.evaluate(() =>
      [...document.querySelectorAll('button')]
        .filter((button) => button.checkVisibility({ visibilityProperty: true }))
        .filter((button) => {
          const box = button.getBoundingClientRect();
          return box.height < 24 || box.width < 24;
        })
        .map((button) => button.outerHTML),
    );
    assert.deepEqual(small, []);
    assert.deepEqual(complaints(), []);
    await close();
  });

  test(`nothing moves in the first view in Arabic at ${width} × ${height} px`, { skip: SKIP }, async () => {
    const { page, complaints, close } = await watched({ viewport: { width, height }, locale: 'ar-EG' });
    await enabled(page, 'sample-first');
    assert.equal(await page.evaluate(() => document.documentElement.dir), 'rtl');
    for (const id of ['status', 'sample-first', 'welcome']) assert.ok(await part(page, id).isVisible(), id);
    assert.ok((await shifts(page)) < 0.02, String(await shifts(page)));
    assert.deepEqual(complaints(), []);
    await close();
  });
}

test('a match that is selected moves neither the answer nor the pictures at 1366 × 768 px', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ options: { viewport: { width: 1366, height: 768 } } });
  await pair(page);
  await part(page, 'tab-matches').click();
  await page.evaluate(() => {
    const seen = { sizes: /** @type {string[]} */ ([]), asked: 0 };
    Object.assign(window, { seen });
    const observer = new ResizeObserver((entries) => {
      for (const { target, contentRect } of entries) seen.sizes.push(`${target.id}: ${contentRect.width} × ${contentRect.height}`);
    });
    for (const id of ['status', 'view']) observer.observe(/** @type {Element} */ (document.querySelector(`[data-testid="${id}"]`)));
    const post = Worker.prototype.postMessage;
    Worker.prototype.postMessage = function (/** @type {any} */ message, /** @type {any} */ ...more) {
      if (message.call === 'gradientCandidates') seen.asked += 1;
      return post.call(this, message, ...more);
    };
  });
  for (const [nth, looked] of /** @type {const} */ ([
    [3, 1],
    [5, 2],
    [8, 3],
  ])) {
    await part(page, 'statistics-row').nth(nth).click();
    await until(page, 'the point is looked up', () => page.evaluate((times) => /** @type {any} */ (window).seen.asked === times, looked));
    await page.waitForTimeout(200);
  }
  // What is observed is told once to begin with.
  const { sizes } = await page.evaluate(() => /** @type {any} */ (window).seen);
  assert.equal(sizes.length, 2, sizes.join('; '));
  assert.deepEqual(complaints, []);
  await close();
});

test('the sentence of an answer has three lines at the most beside open details and three buttons at 1366 × 768 px', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ fresh: true, options: { viewport: { width: 1366, height: 768 } } });
  await pair(page);
  await part(page, 'details').click();
  await page.locator('#panel-results').waitFor();
  // As where a run waits for a press.
  await part(page, 'run').evaluate((run) => run.removeAttribute('hidden'));
  for (const id of ['next', 'run', 'details', 'figures']) assert.ok(await part(page, id).isVisible(), id);
  const lines = await part(page, 'status')
    .locator('strong')
    .evaluate((sentence) => {
      const range = document.createRange();
      range.selectNodeContents(sentence);
      return new Set([...range.getClientRects()].map(({ bottom }) => Math.round(bottom))).size;
    });
  assert.ok(lines > 0 && lines <= 3, `${lines} lines`);
  assert.deepEqual(complaints, []);
  await close();
});

test('matches alone are drawn at first; one press shows the rejected points, and a press on one says why', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ fresh: true });
  await pair(page);
  /** How many pixels of the marks have the colour of the rule that rejects most points of the sample. */
  const rejected = () =>
    page.evaluate(async () => {
      await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
      const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector('[data-testid="layer-marks"]'));
      const { data } = canvas.getContext('2d')?.getImageData(0, 0, canvas.width, canvas.height) ?? { data: [] };
      let found = 0;
      for (let i = 0; i < data.length; i += 4) if ((data[i] ?? 0) > 180 && (data[i + 1] ?? 0) < 140 && (data[i + 3] ?? 0) > 200) found += 1;
      return found;
    });
  assert.equal(await part(page, 'layer-unmatched').getAttribute('aria-pressed'), 'false');
  assert.match((await part(page, 'layer-unmatched').textContent()) ?? '', /^Unmatched \([\d\s]+\)$/);
  assert.equal(await rejected(), 0);
  await part(page, 'layer-unmatched').click();
  assert.ok((await rejected()) > 100);
  await part(page, 'view').focus();
  for (let i = 0; i < 40 && !/Rejected/.test((await part(page, 'selected').textContent()) ?? ''); i++) await page.keyboard.press('n');
  assert.match((await part(page, 'selected').textContent()) ?? '', /^Left point \d+ at [\d.]+, [\d.]+ px\. .*Rejected/);
  // Each button is found by what it shows the details of.
  await page.keyboard.press('Control+k');
  await part(page, 'search-text').fill('details of');
  assert.deepEqual(await page.locator('[data-testid="search-list"] li > span:first-child').allTextContents(), [
    'Details of the results',
    'Details of the selected point',
  ]);
  await page.keyboard.press('Escape');
  await part(page, 'selected-details').click();
  await part(page, 'point-verdict').waitFor();
  // A rule that is ticked in the details is shown by itself.
  await part(page, 'layer-unmatched').click();
  await part(page, 'tab-results').click();
  assert.equal(await part(page, 'show-4').isChecked(), false);
  await part(page, 'show-4').check();
  assert.ok((await rejected()) > 100);
  assert.equal(await part(page, 'show-6').isChecked(), false);
  assert.deepEqual(complaints, []);
  await close();
});

test('tools that work on matches cannot be pressed before there are any', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ fresh: true, options: { viewport: { width: 1366, height: 768 } } });
  await enabled(page, 'sample-first');
  const tools = ['tool-choose', 'tool-measure', 'tool-mask'];
  for (const id of tools) assert.ok(await part(page, id).isDisabled(), id);
  // The search finds what cannot be done yet, after what can be, and does not do it.
  const found = part(page, 'search-list').locator('li');
  await page.keyboard.press('Control+k');
  const disabled = await found.evaluateAll((rows) => rows.map((row) => row.getAttribute('aria-disabled') === 'true'));
  assert.ok(disabled.includes(true) && !disabled.slice(disabled.indexOf(true)).includes(false), String(disabled));
  await part(page, 'search-text').fill('report');
  assert.deepEqual(await found.evaluateAll((rows) => rows.map((row) => [row.firstElementChild?.textContent, row.getAttribute('aria-disabled')])), [
    ['Report', 'true'],
  ]);
  assert.match((await found.first().textContent()) ?? '', /not possible now/);
  await page.keyboard.press('Enter');
  await found.first().dispatchEvent('click');
  assert.ok(await part(page, 'search').isVisible());
  for (const [word, name] of [
    ['dark', 'Theme: auto'],
    ['light', 'Theme: auto'],
    ['language', 'العربية'],
  ]) {
    await part(page, 'search-text').fill(word ?? '');
    assert.ok((await found.locator('> span:first-child').allTextContents()).includes(name ?? ''), word);
  }
  await page.keyboard.press('Escape');
  await pair(page);
  for (const id of tools) assert.ok(await part(page, id).isEnabled(), id);
  assert.deepEqual(complaints, []);
  await close();
});

test('photographs are drawn in colour, exactly where the crate has their pixels, whatever their EXIF orientation', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ fresh: true });
  await part(page, 'file-input').setInputFiles(await coloured(page, pngs()));
  await done(page);
  assert.match((await part(page, 'name-left').getAttribute('title')) ?? '', /270 × 400 px/);
  assert.ok((await shareOfOrange(page)) > 0.9);
  assert.deepEqual(complaints, []);
  await close();
});

test('settings are closed at first, stay as they are left, and what was changed is marked, counted and set back', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ fresh: true });
  await pair(page);
  const button = part(page, 'settings');
  const numberOf = page.locator('#panel-settings [data-key="multiscale.number"]');
  const strategy = page.locator('.control:has(> select[data-key="matching.strategy"])');
  assert.equal(await strategy.isVisible(), false);
  assert.equal(await button.textContent(), 'Settings');
  await button.click();
  // Few at first.
  assert.ok(await strategy.isVisible());
  assert.equal(await numberOf.isVisible(), false);
  await choose(page, 'matching.strategy', 'moments');
  assert.equal(await button.textContent(), 'Settings · 1');
  assert.match((await strategy.getAttribute('class')) ?? '', /is-changed/);
  await part(page, 'reset-matching.strategy').click();
  assert.equal(await button.textContent(), 'Settings');
  await part(page, 'pair-all-settings').click();
  // They scroll by themselves: the page is no longer than its window.
  assert.equal(await page.evaluate(() => document.documentElement.scrollHeight - window.innerHeight), 0);
  await numberOf.fill('5000');
  await page.locator('#panel-settings [data-key="multiscale.levels"]').fill('4');
  assert.equal(await button.textContent(), 'Settings · 2');
  await part(page, 'pair-reset-settings').click();
  assert.equal(await button.textContent(), 'Settings');
  assert.equal(await numberOf.inputValue(), '10000');
  await page.reload();
  await numberOf.waitFor();
  await part(page, 'close-settings').click();
  assert.equal(await strategy.isVisible(), false);
  assert.deepEqual(complaints, []);
  await close();
});

test('each thing on the page has a name of its own, of the settings of a pair and of a block too', { skip: SKIP }, async () => {
  const { page, close } = await block();
  await part(page, 'block-all-settings').waitFor();
  await part(page, 'pair-all-settings').waitFor({ state: 'attached' });
  const named = await page.evaluate(() => [...document.querySelectorAll('[data-testid]')].map((element) => element.getAttribute('data-testid') ?? ''));
  // What belongs to a parameter is named by it, in the panel of its settings.
  const twice = named.filter((name, at) => named.indexOf(name) !== at && !/^(?:help|reset)-\w+\./u.test(name));
  assert.ok(named.length > 200, String(named.length));
  assert.deepEqual(twice, []);
  await close();
});

test('ready-made settings are chosen at once, and named as long as they are what is set', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ fresh: true });
  const button = part(page, 'settings');
  await button.click();
  const preset = part(page, 'preset');
  assert.equal(await preset.inputValue(), 'defaults');
  await preset.selectOption('zahran-2007');
  assert.equal(await page.locator('#panel-settings [data-key="points.threshold"]').inputValue(), '40');
  assert.match((await part(page, 'preset-help').textContent()) ?? '', /^The paper's method/);
  await part(page, 'pair-all-settings').click();
  // The threshold is in the unit of its operator: another one has its own.
  await page.locator('#panel-settings [data-key="points.operator"]').selectOption('forstner');
  const threshold = page.locator('#panel-settings [data-key="points.threshold"]');
  assert.equal(await threshold.inputValue(), '');
  await threshold.fill('1.5');
  await page.locator('#panel-settings [data-key="points.operator"]').selectOption('');
  assert.equal(await threshold.inputValue(), '');
  await page.locator('#panel-settings [data-key="matching.search"]').fill('31');
  assert.equal(await preset.inputValue(), 'own');
  await preset.selectOption('defaults');
  assert.equal(await button.textContent(), 'Settings');
  assert.deepEqual(complaints, []);
  await close();
});

test('a pair without a camera asks for it, and the next step leads there', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ fresh: true });
  await part(page, 'file-input').setInputFiles(pngs());
  await done(page);
  assert.notEqual(await part(page, 'answer').getAttribute('data-verdict'), 'oriented');
  assert.equal(await part(page, 'next').textContent(), 'Give the camera');
  await part(page, 'next').click();
  assert.ok(await part(page, 'camera-focal').isVisible());
  assert.equal(await page.evaluate(() => document.activeElement?.getAttribute('data-testid')), 'camera-focal-px');
  // A focal length alone, in mm, says nothing of the image: the page does not say that it is used.
  await says(page, 'interior-left', /no pixel size is known/);
  await part(page, 'camera-focal').fill('153.38');
  await part(page, 'camera-focal').press('Enter');
  await says(page, 'camera-source', /^The focal length is not used yet: give the pixel size/);
  await says(page, 'interior-left', /no pixel size is known/);
  await part(page, 'camera-pixel').fill('0.2542');
  await part(page, 'camera-pixel').press('Enter');
  await says(page, 'camera-source', /^In use: the values below/);
  await says(page, 'interior-left', /The pixel size is used/);
  // In px it is the same focal length; another one in px gives another one in mm.
  const value = (/** @type {string} */ id) => part(page, id).inputValue();
  assert.ok(Math.abs(Number(await value('camera-focal-px')) - 153.38 / 0.2542) < 1e-6, await value('camera-focal-px'));
  await part(page, 'camera-focal-px').fill('600');
  await part(page, 'camera-focal-px').press('Enter');
  await until(page, 'the focal length in mm follows', async () => (await value('camera-focal')) === '152.52');
  await says(page, 'focal-px-note', /sets that in mm, by the pixel size/);
  // Taken back it takes the pixel size along, by which it is one, and nothing else.
  await part(page, 'camera-k1').fill('0.00001');
  await part(page, 'camera-k1').press('Enter');
  await part(page, 'camera-focal-px').fill('');
  await part(page, 'camera-focal-px').press('Enter');
  await until(page, 'the pixel size is taken back', async () => (await value('camera-pixel')) === '');
  assert.deepEqual([await value('camera-focal'), await value('camera-k1')], ['152.52', '0.00001']);
  await part(page, 'camera-focal-px').fill('600');
  await part(page, 'camera-focal-px').press('Enter');
  await until(page, 'the pixel size is there again', async () => (await value('camera-pixel')) === '0.2542');
  // Who knows no more than that gives no more.
  await part(page, 'clear-camera').click();
  assert.equal(await value('camera-focal-px'), '');
  await part(page, 'camera-focal-px').fill('0');
  await part(page, 'camera-focal-px').press('Enter');
  await says(page, 'camera-focal-px-problem', /^Allowed: 1 to /i);
  await part(page, 'camera-focal-px').fill('603.4');
  await part(page, 'camera-focal-px').press('Enter');
  await says(page, 'camera-source', /^In use: the values below/);
  await says(page, 'interior-left', /The pixel size is used/);
  assert.deepEqual(complaints, []);
  await close();
});

test('the camera of one photo is taken for both, and the keyboard goes on in its fields', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ fresh: true });
  const [named, bare] = [blockPhotos(FLIGHT)[0], barePhotos(FLIGHT, 2)[1]];
  assert.ok(named && bare);
  await part(page, 'file-input').setInputFiles([named, bare].map(({ name, bytes }) => upload(name, bytes, 'image/png')));
  await done(page);
  await part(page, 'settings').click();
  await part(page, 'tab-camera').click();
  await part(page, 'camera-for-both').focus();
  await page.keyboard.press('Enter');
  assert.ok(await part(page, 'camera-for-both').isHidden());
  assert.equal(await page.evaluate(() => document.activeElement?.getAttribute('data-testid')), 'camera-focal-px');
  for (const id of ['camera-focal', 'camera-pixel']) assert.match(await part(page, id).inputValue(), /^[\d.]{1,9}$/);
  assert.deepEqual(complaints, []);
  await close();
});

test('a sample block is photographed, run and answered by one press, and nothing moves', { skip: SKIP }, async () => {
  const { page, complaints, close } = await watched({ viewport: { width: 1366, height: 768 } });
  await enabled(page, 'sample-block-first');
  await part(page, 'sample-block-first').click();
  await page.waitForFunction(() => document.querySelector('[data-testid="block-answer"]')?.getAttribute('data-verdict') === 'oriented');
  for (const id of ['block-status', 'block-figures', 'block-next', 'block-map']) await inSight(page, id);
  // The photos themselves lie where they were taken: of dots and lines alone there would be fewer colours.
  await page.waitForFunction(() => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector('[data-testid="layer-map"]'));
    const { data } = canvas.getContext('2d')?.getImageData(0, 0, canvas.width, canvas.height) ?? { data: new Uint8ClampedArray() };
    let grey = 0;
    for (let i = 0; i < data.length; i += 4) if (data[i + 3] === 255 && data[i] === data[i + 1] && data[i] === data[i + 2]) grey += 1;
    return grey > 0.1 * canvas.width * canvas.height;
  });
  assert.ok((await shifts(page)) < 0.02, String(await shifts(page)));
  // What is drawn on the images is said over them, as far as it is drawn.
  await part(page, 'block-show-images').click();
  const legend = part(page, 'image-legend').locator('> span');
  assert.deepEqual(await legend.allTextContents(), ['accepted', 'measured by hand', 'rejected', 'rejected by hand']);
  const panes = await part(page, 'block-panes').boundingBox();
  await part(page, 'images-vectors').selectOption('100');
  await part(page, 'images-points').click();
  await page.waitForFunction(() => document.querySelectorAll('[data-testid="image-legend"] > span').length === 2);
  assert.deepEqual(await legend.allTextContents(), ['residual', 'residual of a rejected observation']);
  assert.ok(await legend.first().isVisible());
  assert.deepEqual(await part(page, 'block-panes').boundingBox(), panes);
  await part(page, 'block-details').click();
  assert.ok((await number(page, 'block-points-count')) > 0);
  assert.deepEqual(complaints(), []);
  await close();
});

test('images that are given as a block are run without another press', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ fresh: true });
  const [left, right] = pngs();
  assert.ok(left && right);
  await part(page, 'file-input').setInputFiles([left, right, upload('third.png', left.buffer, 'image/png')]);
  await status(page, /More than two images are a block\.$/);
  // Once there is an answer, that says nothing any more.
  assert.doesNotMatch(await status(page, /^(Oriented|Weak orientation|Not oriented|No image)/), /More than two images/);
  assert.deepEqual(complaints, []);
  await close();
});
