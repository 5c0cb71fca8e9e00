/** Builds the page: dist/ for a host, and dist/tiepoint.html, the page in ONE file that also runs from a double-click. */

import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import { deflateSync } from 'fflate';
import { build } from 'vite';
import { PKG_WASM, ROOT } from './paths.mjs';
import { singlePolicy } from './policy.mjs';

/** @typedef {import('vite').Rollup.OutputBundle[string]} Output one file of a build */

const WWW = join(ROOT, 'www');

/** @type {Record<string, string>} */
const IMAGE_TYPES = { '.svg': 'image/svg+xml', '.png': 'image/png', '.ico': 'image/x-icon', '.webp': 'image/webp' };

/** @param {string} out folder that receives the page; emptied first */
export async function buildPage(out) {
  await build({ configFile: join(ROOT, 'vite.config.ts'), logLevel: 'warn', build: { outDir: out } });
  writeFileSync(join(out, 'tiepoint.html'), await singleFile());
}

/** The whole page as one HTML text.  @returns {Promise<string>} */
async function singleFile() {
  const worker = onlyScript(await bundle({ input: join(WWW, 'worker.ts'), output: { format: 'iife' } }));
  const page = await bundle({ input: join(WWW, 'index.html') });
  const html = embedImages(text(page.find((file) => file.fileName.endsWith('.html'))), page);
  const style = page.filter((file) => file.fileName.endsWith('.css')).map(text).join('\n').replace(/\/\*\$vite\$:\d+\*\//g, '').trim();
  return compose(html, inline(onlyScript(page)), style, inline(worker));
}

/**
 * Runs Vite without writing, with the one-file platform in place of the web's.
 * @param {import('vite').Rollup.RollupOptions} options @returns {Promise<Output[]>}
 */
async function bundle(options) {
  const result = await build({
    configFile: false,
    root: WWW,
    base: './',
    logLevel: 'warn',
    resolve: { alias: [{ find: /^\.\/platform$/, replacement: join(WWW, 'shared', 'engine', 'platform.single.ts') }] },
    build: {
      write: false, target: 'es2022', modulePreload: false, cssCodeSplit: false, reportCompressedSize: false,
      assetsInlineLimit: Number.MAX_SAFE_INTEGER, rollupOptions: { ...options, output: { ...options.output, codeSplitting: false } },
    },
  });
  const built = Array.isArray(result) ? result[0] : result;
  if (!built || !('output' in built)) throw new Error('Vite returned no output');
  return built.output;
}

/** @param {Output[]} files @returns {string} */
function onlyScript(files) {
  const scripts = files.filter((file) => file.type === 'chunk');
  if (scripts.length !== 1) throw new Error(`the one-file page needs one script, Vite made ${scripts.map((s) => s.fileName).join(', ')}`);
  return text(scripts[0]);
}

/** @param {Output | undefined} file @returns {string} */
function text(file) {
  if (!file) throw new Error('Vite left a file out');
  if (file.type === 'chunk') return file.code;
  return typeof file.source === 'string' ? file.source : Buffer.from(file.source).toString();
}

/** Images that the document names, as data addresses.  @param {string} html @param {Output[]} files @returns {string} */
function embedImages(html, files) {
  return files.reduce((page, file) => {
    const type = IMAGE_TYPES[extname(file.fileName)];
    if (file.type !== 'asset' || !type) return page;
    return page.replaceAll(`./${file.fileName}`, `data:${type};base64,${Buffer.from(file.source).toString('base64')}`);
  }, html);
}

/** A script as it may stand inside an HTML script element. Both sequences occur in strings and patterns only.  @param {string} code */
const inline = (code) => code.trim().replace(/<\/(script)/gi, '<\\/$1').replace(/<!--/g, '\\x3c!--');

/** @param {string} content @returns {string} the hash by which a policy names an inline element */
const hash = (content) => `sha256-${createHash('sha256').update(content).digest('base64')}`;

/** @param {string} html @param {string} script @param {string} style @param {string} worker */
function compose(html, script, style, worker) {
  // fflate rather than Node's zlib, whose bytes differ between versions and processors.
  const wasm = Buffer.from(deflateSync(readFileSync(join(PKG_WASM, 'tiepoint_bg.wasm')), { level: 9 })).toString('base64');
  const bare = html
    .replace(/\s*<script type="module"[^>]*src="[^"]*"[^>]*><\/script>/g, '')
    .replace(/\s*<link rel="(?:stylesheet|modulepreload|manifest)"[^>]*>/g, '');
  if (bare.includes('assets/')) throw new Error('the one-file page still names a file beside it');
  const policy = `<meta http-equiv="Content-Security-Policy" content="${singlePolicy(hash(script), hash(style))}">`;
  return bare
    .replace(/<meta charset="[^"]*"\s*\/?>/i, (charset) => `${charset}\n    ${policy}`)
    .replace(/\s*<\/head>/, () => `\n    <style>${style}</style>\n  </head>`)
    .replace('</body>', () => [
      `<script type="text/plain" id="tiepoint-wasm">${wasm}</script>`,
      `<script type="text/plain" id="tiepoint-worker">${worker}</script>`,
      `<script type="module">${script}</script>`,
      '</body>',
    ].join('\n'));
}
