#!/usr/bin/env node
/** `npm run picture`: the picture of the README, docs/page.png: the page in Chromium with the sample pair matched and oriented. */

import { join } from 'node:path';
import { servePage } from './lib/page-server.mjs';
import { ROOT } from './lib/paths.mjs';
import { ensureChromium } from './lib/setup.mjs';
import { namedOrUsage } from './lib/usage.mjs';

const USAGE = `npm run picture
node tools/picture.mjs

Takes docs/page.png, the picture of the README, in Chromium.

  -h, --help  prints this`;

namedOrUsage(USAGE, 0);

// What only a picture needs: the help is given without the npm packages, too.
const { chromium } = await import('playwright-core');
const { path, reason } = await ensureChromium();
if (path === null) throw new Error(reason);
const server = await servePage();
const browser = await chromium.launch({
  executablePath: path,
  args: ['--headless', '--no-sandbox', '--disable-background-networking', '--disable-sync', '--no-first-run'],
});
try {
  const page = await browser.newPage({ viewport: { width: 1366, height: 768 } });
  await page.goto(server.url);
  await page.locator('[data-testid="sample"]').click();
  await page.locator('[data-testid="status"][data-kind="done"]').waitFor({ timeout: 60_000 });
  await page.screenshot({ path: join(ROOT, 'docs', 'page.png') });
} finally {
  await browser.close();
  await server.close();
}
