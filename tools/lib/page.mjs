/** Builds the page's text files from `www/`: dist/index.html, page.js, page.css, worker.js. They are readable and keep their names, so that a small change is a small difference. */

import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { build } from 'vite';
import { ROOT } from './paths.mjs';
import { WEB_POLICY } from './policy.mjs';

const WWW = join(ROOT, 'www');

/** @type {import('vite').BuildOptions} */
const READABLE = { target: 'es2022', minify: false, cssMinify: false, modulePreload: false, reportCompressedSize: false, assetsInlineLimit: 0 };

/** The policy stands in the page itself, for hosts that send no headers.  @type {import('vite').Plugin} */
const policy = {
  name: 'tiepoint-policy',
  transformIndexHtml: () => [{ tag: 'meta', attrs: { 'http-equiv': 'Content-Security-Policy', content: WEB_POLICY }, injectTo: 'head-prepend' }],
};

/** @param {string} out folder that receives the page; emptied first */
export async function buildPage(out) {
  const common = /** @type {import('vite').InlineConfig} */ ({ configFile: false, root: WWW, base: './', logLevel: 'warn' });
  await build({
    ...common,
    plugins: [policy],
    build: {
      ...READABLE,
      outDir: out,
      emptyOutDir: true,
      rollupOptions: { output: { entryFileNames: 'page.js', assetFileNames: 'page[extname]', codeSplitting: false } },
    },
  });
  const worker = await build({
    ...common,
    build: { ...READABLE, write: false, rollupOptions: { input: join(WWW, 'worker.ts'), output: { format: 'iife', codeSplitting: false } } },
  });
  writeFileSync(join(out, 'worker.js'), onlyScript(worker));
}

/** @param {Awaited<ReturnType<typeof build>>} result @returns {string} */
function onlyScript(result) {
  const built = Array.isArray(result) ? result[0] : result;
  const files = built && 'output' in built ? built.output : [];
  const [script, ...others] = files;
  if (script?.type !== 'chunk' || others.length > 0)
    throw new Error(`the worker must be one script, Vite made ${files.map(({ fileName }) => fileName).join(', ')}`);
  return script.code;
}
