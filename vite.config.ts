/** The development server, `npm run dev`; `tools/lib/page.mjs` builds the page. */
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import type { Plugin } from 'vite';
import { pathOf } from './tools/lib/compose.mjs';
import { licences } from './tools/lib/licences.mjs';

/** What the built page has beside it. */
const beside: Plugin = {
  name: 'tiepoint-beside',
  configureServer: ({ middlewares }) => {
    middlewares.use('/worker.js', (_, response) => void response.setHeader('Content-Type', 'text/javascript').end("import '/worker.ts';"));
    middlewares.use(
      '/tiepoint_bg.wasm',
      (_, response) => void response.setHeader('Content-Type', 'application/wasm').end(readFileSync(pathOf('tiepoint_bg.wasm'))),
    );
  },
};

export default defineConfig({
  root: fileURLToPath(new URL('./www', import.meta.url)),
  plugins: [beside, licences],
  server: { fs: { allow: [fileURLToPath(new URL('.', import.meta.url))] } },
});
