/** The page for a host: `www/` to `dist/`, with relative addresses, so that it works in any folder. */
import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';
import { WEB_POLICY } from './tools/lib/policy.mjs';

/** The policy stands in the built page itself, for hosts that send no headers. The development server needs inline scripts. */
const policy: Plugin = {
  name: 'tiepoint-policy',
  apply: 'build',
  transformIndexHtml: () => [{ tag: 'meta', attrs: { 'http-equiv': 'Content-Security-Policy', content: WEB_POLICY }, injectTo: 'head-prepend' }],
};

export default defineConfig({
  root: fileURLToPath(new URL('./www', import.meta.url)),
  base: './',
  plugins: [policy],
  worker: { format: 'es' },
  server: { fs: { allow: [fileURLToPath(new URL('.', import.meta.url))] } },
  build: {
    outDir: fileURLToPath(new URL('./dist', import.meta.url)),
    emptyOutDir: true,
    target: 'es2022',
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    reportCompressedSize: false,
  },
});
