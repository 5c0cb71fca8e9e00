#!/usr/bin/env node
/** `npm run build`: rebuilds pkg/wasm from the crate, then dist/ from the page's sources. `-- --fast` builds a module for the inner loop, which is never committed. */

import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { DIST, PKG_WASM } from './lib/paths.mjs';
import { ensureBindgen, ensureToolchain } from './lib/rust.mjs';
import { ensurePackages } from './lib/setup.mjs';

const USAGE = `npm run build -- [--fast] [--wasm-only] [--page-only]
node tools/build.mjs [--fast] [--wasm-only] [--page-only]

Rebuilds pkg/wasm from the crate, then dist/ from the page's sources.

  --fast       a module for the inner loop, which is never committed
  --wasm-only  pkg/wasm alone
  --page-only  dist/ alone
  -h, --help   prints this`;

async function wasm(fast = false) {
  await ensurePackages();
  const toolchain = await ensureToolchain();
  const { buildWasm } = await import('./lib/wasm.mjs');
  await buildWasm(toolchain, await ensureBindgen(toolchain), PKG_WASM, fast);
}

async function page() {
  await ensurePackages();
  const { buildPage } = await import('./lib/page.mjs');
  await buildPage(DIST);
}

/** Builds what a plain checkout would have: pkg/wasm if it is not there, and dist/. */
export async function buildMissing() {
  if (!existsSync(join(PKG_WASM, 'tiepoint_bg.wasm'))) await wasm();
  await page();
}

async function main() {
  const { values } = parseArgs({
    options: { 'wasm-only': { type: 'boolean' }, 'page-only': { type: 'boolean' }, fast: { type: 'boolean' }, help: { type: 'boolean', short: 'h' } },
  });
  if (values.help) {
    console.log(USAGE);
    return;
  }
  const started = performance.now();
  if (!values['page-only']) await wasm(values.fast);
  if (!values['wasm-only']) await page();
  console.log(`built in ${((performance.now() - started) / 1000).toFixed(1)} s`);
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  main().catch((error) => {
    console.error(error instanceof Error ? error.message : String(error));
    process.exitCode = 1;
  });
}
