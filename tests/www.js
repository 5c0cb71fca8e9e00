/** The page's own code without a browser: modules of `www/`, bundled for Node. */

import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { build } from 'vite';
import '../pkg/node.js';

const ROOT = fileURLToPath(new URL('..', import.meta.url));
const WASM = pathToFileURL(join(ROOT, 'pkg', 'wasm', 'tiepoint.js')).href;

/**
 * The modules by the names of their files. `names`: files below `www/`, as `pair/state/edits`; no two with the same last part.
 * @param {readonly string[]} names @returns {Promise<Record<string, any>>}
 */
export async function pageModules(names) {
  const folder = mkdtempSync(join(tmpdir(), 'tiepoint-www-'));
  try {
    const entry = join(folder, 'entry.ts');
    // Many texts are said as soon as a module is there: they are learned before.
    const lines = names.map((name) => `export const ${name.split('/').at(-1)?.replaceAll('-', '_')} = await import('${join(ROOT, 'www', name)}');`);
    const learned = ['en', 'en-block'].map((name) => `learn((await import('${join(ROOT, 'www/shared/text', name)}')).TEXTS);`);
    writeFileSync(entry, [`import { learn } from '${join(ROOT, 'www/shared/text/words')}';`, ...learned, ...lines].join('\n'));
    const result = await build({
      configFile: false,
      root: folder,
      logLevel: 'warn',
      build: {
        write: false,
        minify: false,
        target: 'es2022',
        lib: { entry, formats: ['es'] },
        // The module that Node has loaded already.
        rollupOptions: { output: { codeSplitting: false }, external: (id) => id.includes('pkg/wasm/tiepoint.js') },
      },
    });
    const [built] = Array.isArray(result) ? result : [result];
    const chunk = built && 'output' in built ? built.output[0] : undefined;
    const file = join(folder, 'state.mjs');
    writeFileSync(file, chunk?.type === 'chunk' ? chunk.code.replaceAll(/from "[^"]*tiepoint\.js"/gu, `from '${WASM}'`) : '');
    return await import(pathToFileURL(file).href);
  } finally {
    rmSync(folder, { recursive: true });
  }
}
