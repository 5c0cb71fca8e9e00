/** The page as Lighthouse judges it, for a first visitor on a phone and on a desktop: medians of several runs. */

import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { servePage } from '../lib/page-server.mjs';
import { readJson } from '../lib/paths.mjs';
import { run } from '../lib/process.mjs';
import { ensurePackages, findChromium } from '../lib/setup.mjs';
import { median } from './median.mjs';

const RUNS = 5;

const FOLDER = fileURLToPath(new URL('lighthouse/', import.meta.url));
const PROGRAM = join(FOLDER, 'node_modules', 'lighthouse', 'cli', 'index.js');

/** @type {Record<string, string[]>} */
const DEVICES = { mobile: [], desktop: ['--preset=desktop'] };

const CATEGORIES = { performance: 'performance', accessibility: 'accessibility', 'best-practices': 'best practices', seo: 'SEO' };

/** @type {[audit: string, name: string, show: (value: number) => string][]} */
const FIGURES = [
  ['first-contentful-paint', 'FCP', (value) => `${(value / 1000).toFixed(2)} s`],
  ['largest-contentful-paint', 'LCP', (value) => `${(value / 1000).toFixed(2)} s`],
  ['total-blocking-time', 'TBT', (value) => `${value.toFixed(0)} ms`],
  ['cumulative-layout-shift', 'CLS', (value) => value.toFixed(3)],
];

/** What one run reports. @typedef {{ categories: Record<string, { score: number | null }>, audits: Record<string, { numericValue?: number }>, environment: { benchmarkIndex: number } }} Judged */

/** @param {string} url @param {string} chromium @param {string[]} how @param {string} folder @returns {Promise<Judged>} */
async function judged(url, chromium, how, folder) {
  const file = join(folder, 'report.json');
  const flags = ['--quiet', '--output=json', `--output-path=${file}`, '--chrome-flags=--headless=new --no-sandbox', ...how];
  const { code, output } = await run(process.execPath, [PROGRAM, url, ...flags], { env: { CHROME_PATH: chromium }, quiet: true });
  if (code !== 0) throw new Error(`Lighthouse ended with ${code}\n${output.trimEnd().split('\n').slice(-20).join('\n')}`);
  return readJson(file);
}

export async function lighthouse() {
  console.log('The page by Lighthouse');
  const chromium = findChromium();
  if (!chromium) return console.log('  skipped: no Chromium (install it or name it in CHROMIUM)');
  try {
    await ensurePackages(FOLDER);
  } catch (error) {
    return console.log(`  skipped: Lighthouse could not be installed (${error instanceof Error ? error.message.split('\n')[0] : String(error)})`);
  }
  const server = await servePage();
  const folder = mkdtempSync(join(tmpdir(), 'tiepoint-lighthouse-'));
  try {
    // What the server compresses it does once: no visitor of a host waits for it.
    await judged(server.url, chromium, [], folder);
    for (const [device, how] of Object.entries(DEVICES)) {
      /** @type {Judged[]} */
      const runs = [];
      for (let k = 0; k < RUNS; k += 1) runs.push(await judged(server.url, chromium, how, folder));
      const scores = Object.entries(CATEGORIES).map(
        ([key, name]) => `${name} ${(100 * median(runs.map((one) => one.categories[key]?.score ?? NaN))).toFixed(0)}`,
      );
      const figures = FIGURES.map(([key, name, show]) => `${name} ${show(median(runs.map((one) => one.audits[key]?.numericValue ?? NaN)))}`);
      const machine = median(runs.map(({ environment }) => environment.benchmarkIndex));
      console.log(`  ${device} (median of ${RUNS}): ${scores.join(', ')}; ${figures.join(', ')}; Lighthouse's index of this machine ${machine.toFixed(0)}`);
    }
  } finally {
    rmSync(folder, { recursive: true, force: true });
    await server.close();
  }
}
