/**
 * Builds the page's text files from `www/`, as `compose.mjs` names them. They are readable and keep their names, so that a small change is a small difference.
 */

import { readdirSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { build } from 'vite';
import { TEXTS } from './compose.mjs';
import { iconSvg } from './icon.mjs';
import { licences } from './licences.mjs';
import { ROOT } from './paths.mjs';
import { webPolicy } from './policy.mjs';

const WWW = join(ROOT, 'www');

/** @type {import('vite').BuildOptions} */
const READABLE = { target: 'es2022', minify: false, cssMinify: false, modulePreload: false, reportCompressedSize: false, assetsInlineLimit: 0 };

/** They stand in the sources; those of licences remain. */
const COMMENTS = { legal: true, annotation: false, jsdoc: false };

/** The policy stands in the page itself, for hosts that send no headers.  @type {import('vite').Plugin} */
const policy = {
  name: 'tiepoint-policy',
  transformIndexHtml: {
    order: 'post',
    handler: (html) => [{ tag: 'meta', attrs: { 'http-equiv': 'Content-Security-Policy', content: webPolicy(html) }, injectTo: 'head-prepend' }],
  },
};

/** What runs before anything is drawn stands in the page itself: a file would have the first view wait for it.  @param {string} script @returns {import('vite').Plugin} */
const first = (script) => ({
  name: 'tiepoint-first',
  transformIndexHtml: {
    order: 'pre',
    handler: (html) => html.replace('<script type="module" src="./turn.ts"></script>', () => `<script>\n${script}</script>`),
  },
});

/** The icon stands in the page itself: so the page in one file has it too.  @type {import('vite').Plugin} */
const icon = {
  name: 'tiepoint-icon',
  transformIndexHtml: () => [{ tag: 'link', attrs: { rel: 'icon', href: `data:image/svg+xml,${encodeURIComponent(iconSvg())}` }, injectTo: 'head' }],
};

/** What Vite puts around an import loads the styles of a part first: these have none of their own.  @type {import('vite').Plugin} */
const plainImports = {
  name: 'tiepoint-plain-imports',
  load: { order: 'pre', handler: (id) => (id.includes('vite/preload-helper') ? 'export const __vitePreload = (load) => load();' : null) },
};

/** @param {string} out folder that receives the page; emptied first */
export async function buildPage(out) {
  // Packages may be linked into the checkout: what is built does not say from where.
  const common = /** @type {import('vite').InlineConfig} */ ({
    configFile: false,
    root: WWW,
    base: './',
    logLevel: 'warn',
    resolve: { preserveSymlinks: true },
  });
  const scriptOf = async (/** @type {string} */ name) => {
    const rollupOptions = { input: join(WWW, `${name}.ts`), output: { comments: COMMENTS, format: /** @type {const} */ ('iife'), codeSplitting: false } };
    return onlyScript(await build({ ...common, build: { ...READABLE, write: false, rollupOptions } }));
  };
  await build({
    ...common,
    plugins: [first(await scriptOf('turn')), policy, icon, plainImports, licences],
    build: {
      ...READABLE,
      // Vite takes a relative folder from the sources of the page.
      outDir: resolve(out),
      emptyOutDir: true,
      cssCodeSplit: false,
      // Parts give and take names as they stand in the sources: another one renames none.
      rollupOptions: {
        output: { comments: COMMENTS, entryFileNames: 'page.js', chunkFileNames: '[name].js', assetFileNames: 'page[extname]', minifyInternalExports: false },
      },
    },
  });
  for (const script of ['worker', 'service-worker']) writeFileSync(join(out, `${script}.js`), await scriptOf(script));
  const [made, named] = [readdirSync(out).sort().join(', '), [...TEXTS].sort().join(', ')];
  if (made !== named) throw new Error(`Vite made other files than the page has: ${made}; named in compose.mjs: ${named}`);
}

/** @param {Awaited<ReturnType<typeof build>>} result @returns {string} */
function onlyScript(result) {
  const built = Array.isArray(result) ? result[0] : result;
  const files = built && 'output' in built ? built.output : [];
  const [script, ...others] = files;
  if (script?.type !== 'chunk' || others.length > 0) throw new Error(`this must be one script, Vite made ${files.map(({ fileName }) => fileName).join(', ')}`);
  return script.code;
}
