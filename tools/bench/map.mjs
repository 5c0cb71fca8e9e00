/** The workbench of a block at 100,000 tie points in headless Chromium: what pan, zoom, a rectangle, and the tables take of a frame. */

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import { build } from 'vite';
import { ROOT } from '../lib/paths.mjs';
import { findChromium } from '../lib/setup.mjs';

const POINTS = 100_000;
const IMAGES = 400;
/** How often each thing is done. */
const STEPS = 100;
const BRUSHES = 40;
const STYLES = ['shared/style/base', 'shared/style/layout', 'shared/style/panels', 'shared/style/view', 'block/style/block'];
const ENTRY = join(ROOT, 'tools', 'bench', 'map', 'workbench.ts');

export async function map() {
  console.log(`Map and tables of ${POINTS.toLocaleString('en')} tie points in Chromium, 1440 x 900`);
  const executablePath = findChromium();
  if (!executablePath) return console.log('  skipped: no Chromium (install it or name it in CHROMIUM)');
  const browser = await chromium.launch({ executablePath, args: ['--no-sandbox', '--disable-quic', '--no-first-run'] });
  try {
    const tab = await browser.newPage({ viewport: { width: 1440, height: 900 } });
    for (const style of STYLES) await tab.addStyleTag({ content: readFileSync(join(ROOT, 'www', `${style}.css`), 'utf8') });
    await tab.addScriptTag({ content: await workbench() });
    /** @type {[string, number[]][]} */
    const taken = await tab.evaluate(
      (sizes) => /** @type {any} */ (window).workbench.measured(...sizes),
      /** @type {[number, number, number, number]} */ ([POINTS, IMAGES, STEPS, BRUSHES]),
    );
    for (const [what, times] of taken) {
      const sorted = [...times].sort((a, b) => a - b);
      const at = (/** @type {number} */ share) => (sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? NaN).toFixed(1);
      console.log(`  ${what.padEnd(38)} median ${at(0.5).padStart(6)} ms, p95 ${at(0.95).padStart(6)} ms, of ${sorted.length}`);
    }
  } finally {
    await browser.close();
  }
}

/** The page's own map and table over a made block, as one script. */
async function workbench() {
  const result = await build({
    configFile: false,
    logLevel: 'warn',
    build: { write: false, minify: false, lib: { entry: ENTRY, formats: ['iife'], name: 'workbench' } },
  });
  const [built] = Array.isArray(result) ? result : [result];
  const chunk = built && 'output' in built ? built.output[0] : undefined;
  if (chunk?.type !== 'chunk') throw new Error('the workbench was not built');
  return chunk.code;
}
