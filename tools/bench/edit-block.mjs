/** Edits of a block of simulated photographs by hand: from the key press to the frame that shows the new σ₀. */

import { BlockScene } from '../../pkg/node.js';

/** @typedef {import('playwright-core').Page} Page */

const FLIGHT = { strips: 5, exposures: 6, width_px: 640, height_px: 480, pixel_mm: 0.1125 };
const EDITS = 10;
/** Points between one that is edited and the next. */
const STEPS = 3;

/** In the page: notes what becomes of each press of Delete. */
const timeEdits = () => {
  const text = document.querySelector('[data-testid="block-edit-text"]');
  if (text === null) throw new Error('the page has no edits');
  /** @type {number[]} */
  const painted = [];
  Object.assign(window, { painted });
  let pressed = NaN;
  let isAdjusting = false;
  window.addEventListener(
    'keydown',
    ({ key }) => {
      if (key !== 'Delete') return;
      pressed = performance.now();
      isAdjusting = false;
    },
    { capture: true },
  );
  new MutationObserver(() => {
    if (Number.isNaN(pressed)) return;
    if (!/^σ₀/.test(text.textContent ?? '')) {
      isAdjusting = true;
      return;
    }
    if (!isAdjusting) return;
    const since = pressed;
    pressed = NaN;
    // A message is handled after the frame that a request for one leads to.
    requestAnimationFrame(() => {
      const { port1, port2 } = new MessageChannel();
      port1.onmessage = () => painted.push(performance.now() - since);
      port2.postMessage(null);
    });
  }).observe(text, { childList: true, characterData: true, subtree: true });
};

/** Runs the block in the page.  @param {Page} tab */
async function run(tab) {
  const scene = new BlockScene(FLIGHT);
  const { images } = scene.truth();
  const files = images.map(({ name }, index) => ({ name: `${name}.png`, mimeType: 'image/png', buffer: Buffer.from(scene.photo_file(index)) }));
  scene.free();
  await tab.click('[data-testid="mode-block"]');
  await tab.waitForFunction(() => document.querySelector('[data-testid="block-simulate"]')?.hasAttribute('disabled') === false);
  await tab.setInputFiles('[data-testid="block-files-input"]', files);
  await tab.waitForFunction(() => document.querySelector('[data-testid="block-run"]')?.hasAttribute('disabled') === false);
  // A page that is not told to wait begins by itself.
  await tab.click('[data-testid="block-run"]');
  await tab.waitForFunction(() => /^(Oriented|Weak orientation|Not oriented)/.test(document.querySelector('[data-testid="block-status"]')?.textContent ?? ''));
  const line = (await tab.locator('[data-testid="block-status"]').textContent()) ?? '';
  if (!/^(Oriented|Weak orientation)/.test(line)) throw new Error(line);
  return line;
}

/** @param {Page} tab the page, freshly loaded */
export async function editBlock(tab) {
  console.log(`Edits of a block of ${FLIGHT.strips * FLIGHT.exposures} simulated photographs by hand, in Chromium`);
  await tab.evaluate(() => localStorage.setItem('tiepoint-wait', 'yes'));
  await tab.reload();
  console.log(`  ${await run(tab)}`);
  await tab.click('[data-testid="block-show-images"]');
  await tab.evaluate(timeEdits);
  for (const [what, keys] of /** @type {const} */ ([
    ['an observation is rejected', 'Delete'],
    ['a point is rejected', 'Shift+Delete'],
  ])) {
    /** @type {number[]} */
    const times = [];
    for (let k = 0; k < EDITS; k += 1) {
      await tab.focus('[data-testid="block-panes"]');
      for (let step = 0; step < STEPS; step += 1) await tab.keyboard.press('n');
      await tab.waitForFunction(() => {
        const button = document.querySelector('[data-testid="block-reject"]');
        return button?.hasAttribute('disabled') === false && button.checkVisibility();
      });
      const before = await tab.evaluate(() => /** @type {any} */ (window).painted.length);
      await tab.keyboard.press(keys);
      await tab.waitForFunction((count) => /** @type {any} */ (window).painted.length > count, before);
      times.push(await tab.evaluate(() => /** @type {any} */ (window).painted.at(-1)));
    }
    times.sort((a, b) => a - b);
    console.log(
      `  ${what}, to the frame that shows the new σ₀: ${times[times.length >> 1]?.toFixed(0)} ms in the median of ${EDITS}, ${times.at(-1)?.toFixed(0)} ms at most (asked: 1,000)`,
    );
  }
  console.log(`  ${await tab.locator('[data-testid="block-edit-text"]').textContent()}`);
}
