/** One match of the sample pair is rejected by hand: from the key press to the frame that shows the new σ₀, and what of it the worker takes; then the same of a block. */

import { join } from 'node:path';
import { chromium } from 'playwright-core';
import { ROOT } from '../lib/paths.mjs';
import { must } from '../lib/process.mjs';
import { findChromium } from '../lib/setup.mjs';
import { servePage } from '../lib/page-server.mjs';
import { editBlock } from './edit-block.mjs';
import { median } from './median.mjs';

const FLAGS = ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'];
const EDITS = 15;
const PACE_MS = 1000;
/** A block takes this long on a busy machine. */
const PATIENCE_MS = 600_000;

/** What a key press came to, in ms after it. @typedef {{ orientation: number, shown: number, painted: number }} Times */

/** In the worker: notes how long each answer takes, from the moment that its question comes to the one that it is sent. It runs in every worker of the page. */
const timeAnswers = () => {
  /** @type {Map<number, number>} */
  const sent = new Map();
  /** @type {Map<number, number>} */
  const came = new Map();
  /** @type {number[]} */
  const took = [];
  // Told of the question after the page's own listener, which answers at once, or before it.
  const both = (/** @type {number} */ id) => {
    const [from, to] = [came.get(id), sent.get(id)];
    if (from !== undefined && to !== undefined) took.push(to - from);
  };
  self.addEventListener('message', ({ data, timeStamp }) => {
    if (data?.call !== 'orient') return;
    came.set(data.id, timeStamp);
    both(data.id);
  });
  const post = self.postMessage;
  Object.assign(self, {
    took,
    postMessage: (/** @type {any} */ message, /** @type {any} */ ...more) => {
      post.call(self, message, ...more);
      sent.set(message?.id, performance.now());
      both(message?.id);
    },
  });
};

/** In the page: notes what becomes of each key press. */
const timeEdits = () => {
  const at = (/** @type {string} */ id) => document.querySelector(`[data-testid="${id}"]`);
  let pressed = NaN;
  let orientation = NaN;
  const post = Worker.prototype.postMessage;
  Worker.prototype.postMessage = function (/** @type {any} */ message, /** @type {any} */ ...more) {
    if (message?.call === 'orient') {
      const asked = performance.now();
      const answered = (/** @type {MessageEvent} */ { data }) => {
        if (data.id !== message.id) return;
        this.removeEventListener('message', answered);
        orientation = performance.now() - asked;
      };
      this.addEventListener('message', answered);
    }
    return post.call(this, message, ...more);
  };
  window.addEventListener(
    'keydown',
    () => {
      pressed = performance.now();
      orientation = NaN;
    },
    { capture: true },
  );
  /** @type {Times[]} */
  const times = [];
  Object.assign(window, { times });
  const compared = at('edit-compared');
  if (compared === null) throw new Error('the page compares no orientations');
  new MutationObserver(() => {
    if (Number.isNaN(pressed) || !/\d/.test(at('compared-sigma0-now')?.textContent ?? '')) return;
    const [shown, since] = [performance.now() - pressed, pressed];
    pressed = NaN;
    // A message is handled after the frame that a request for one leads to.
    requestAnimationFrame(() => {
      const { port1, port2 } = new MessageChannel();
      port1.onmessage = () => times.push({ orientation, shown, painted: performance.now() - since });
      port2.postMessage(null);
    });
  }).observe(compared, { childList: true, subtree: true });
};

/** Presses the row of a match that is used, in the middle of those in sight. It runs in the page. */
const pressRow = () => {
  const rows = [.../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('[data-testid="statistics-row"]'))];
  const used = rows.filter(({ textContent }) => textContent?.includes('used'));
  used[used.length >> 1]?.click();
};

/** Thousands of random edits in place of the hundreds of the tests. */
async function randomEdits() {
  const file = join(ROOT, 'tests', 'edits.test.js');
  await must(process.execPath, ['--test', '--test-name-pattern=random edits', file], { env: { TIEPOINT_STATISTICS: 'full' }, quiet: true });
  console.log('  thousands of random edits, undone, leave the pair and the bytes of its project file as they were');
}

export async function edit() {
  await randomEdits();
  console.log('An edit of a pair by hand, in Chromium');
  const executablePath = findChromium();
  if (!executablePath) return console.log('  skipped: no Chromium (install it or name it in CHROMIUM)');
  const server = await servePage();
  const browser = await chromium.launch({ executablePath, args: FLAGS });
  try {
    const context = await browser.newContext({ viewport: { width: 1440, height: 900 } });
    const tab = await context.newPage();
    await tab.goto(server.url);
    await tab.click('[data-testid="sample"]:not([disabled])');
    await tab.waitForFunction(() => document.querySelector('[data-testid="status"]')?.textContent?.startsWith('Oriented'));
    await tab.click('[data-testid="details"]');
    await tab.click('[data-testid="tab-matches"]');
    await tab.locator('[data-testid="statistics-row"]').first().waitFor();
    for (const worker of tab.workers()) await worker.evaluate(timeAnswers);
    await tab.evaluate(timeEdits);
    const matches = await tab.locator('[data-testid="statistics-caption"]').textContent();
    for (let k = 0; k < EDITS; k += 1) {
      // A table that is being drawn anew for the edit before takes no press: a person is not as fast.
      await tab.waitForTimeout(PACE_MS);
      await tab.evaluate(pressRow);
      await tab.waitForFunction(() => document.querySelector('[data-testid="reject"]')?.hasAttribute('disabled') === false);
      await tab.focus('[data-testid="view"]');
      await tab.keyboard.press('Delete');
      await tab.waitForFunction((count) => /** @type {any} */ (window).times.length > count, k);
    }
    /** @type {Times[]} */
    const times = await tab.evaluate(() => /** @type {any} */ (window).times);
    const answers = await Promise.all(tab.workers().map((worker) => worker.evaluate(() => /** @type {any} */ (self).took ?? [])));
    const worker = median(answers.flat());
    const of = (/** @type {(times: Times) => number} */ value) => median(times.map(value)).toFixed(0);
    console.log(`  ${matches?.trim()}; medians of ${EDITS} edits, ms`);
    console.log(`  from the key press to the frame that shows the new σ₀: ${of(({ painted }) => painted)}`);
    console.log(`  of these the worker's: ${worker.toFixed(0)}; the page's and the messages': ${of(({ painted }) => painted - worker)}`);
    console.log(`  figures are there after ${of(({ shown }) => shown)}, the worker's answer ${of(({ orientation }) => orientation)} after it was asked`);
    await context.close();
    const other = await (await browser.newContext({ viewport: { width: 1440, height: 900 } })).newPage();
    other.setDefaultTimeout(PATIENCE_MS);
    await other.goto(server.url);
    await editBlock(other);
  } finally {
    await browser.close();
    await server.close();
  }
}
