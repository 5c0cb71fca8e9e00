/** The page in Chromium: how soon it is there, how long it takes for the sample, how soon it answers while it works; large images. */

import { chromium } from 'playwright-core';
import { findChromium } from '../lib/setup.mjs';
import { servePage } from '../lib/page-server.mjs';
import { largeImages, watchPauses } from './large.mjs';

const FLAGS = ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'];
const RUNS = 5;

/** What a view has loaded of scripts and styles, in bytes. It runs in the page. */
const loaded = () => {
  const files = /** @type {PerformanceResourceTiming[]} */ (performance.getEntriesByType('resource')).filter(({ name }) => /\.(?:js|css)$/.test(name));
  const sum = (/** @type {(file: PerformanceResourceTiming) => number} */ of) => files.reduce((all, file) => all + of(file), 0);
  return { bytes: sum(({ decodedBodySize }) => decodedBodySize), sent: sum(({ encodedBodySize }) => encodedBodySize) };
};

export async function page() {
  console.log('Page in Chromium');
  const executablePath = findChromium();
  if (!executablePath) return console.log('  skipped: no Chromium (install it or name it in CHROMIUM)');
  const server = await servePage();
  const launch = () => chromium.launch({ executablePath, args: FLAGS });
  const browser = await launch();
  const firsts = [];
  const samples = [];
  const pauses = [];
  const loads = [];
  for (let run = 0; run < RUNS; run += 1) {
    const context = await browser.newContext({ viewport: { width: 1440, height: 900 } });
    const tab = await context.newPage();
    await tab.goto(server.url);
    await tab.waitForFunction(() => document.querySelector('[data-testid="sample"]:not([disabled])'));
    loads.push(await tab.evaluate(loaded));
    firsts.push(await tab.evaluate(() => performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? NaN));
    await watchPauses(tab);
    const started = performance.now();
    await tab.click('[data-testid="sample"]');
    await tab.waitForFunction(() => document.querySelector('[data-testid="status"]')?.textContent?.startsWith('Oriented'));
    samples.push(performance.now() - started);
    pauses.push(await tab.evaluate(() => /** @type {Window & { longestPause?: number }} */ (window).longestPause ?? NaN));
    await context.close();
  }
  await browser.close();
  const median = (/** @type {number[]} */ values) => [...values].sort((a, b) => a - b)[values.length >> 1] ?? NaN;
  console.log(`  first view: ${median(firsts).toFixed(0)} ms (median of ${RUNS})`);
  const [load] = loads;
  if (load)
    console.log(`  scripts and style of the first view: ${Math.round(load.bytes / 1e3)} KB, ${Math.round(load.sent / 1e3)} KB as the server sends them`);
  console.log(`  sample pair, from the click to the result: ${median(samples).toFixed(0)} ms`);
  console.log(`  longest pause of the page meanwhile: ${median(pauses).toFixed(0)} ms`);
  await largeImages(server.url, launch);
  await server.close();
}
