/** What is sent to a browser, after brotli. */

import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { brotliCompressSync, constants } from 'node:zlib';
import { DIST, PKG_WASM } from '../lib/paths.mjs';

/** @param {string} path */
function sizes(path) {
  const bytes = readFileSync(path);
  const packed = brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length } });
  return { raw: bytes.length, packed: packed.length };
}

/** @param {number} bytes */
const kb = (bytes) => `${(bytes / 1000).toFixed(0)} KB`;

export function sizesOfAll() {
  console.log('Sizes');
  const wasm = sizes(join(PKG_WASM, 'tiepoint_bg.wasm'));
  console.log(`  wasm: ${kb(wasm.raw)}, ${kb(wasm.packed)} after brotli`);
  const shell = readdirSync(DIST, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && !entry.name.endsWith('.wasm') && entry.name !== 'tiepoint.html')
    .map((entry) => sizes(join(entry.parentPath ?? entry.path, entry.name)));
  const total = (/** @type {'raw' | 'packed'} */ key) => shell.reduce((sum, file) => sum + file[key], 0);
  console.log(`  page shell (all of dist but wasm and tiepoint.html): ${kb(total('raw'))}, ${kb(total('packed'))} after brotli`);
  const single = sizes(join(DIST, 'tiepoint.html'));
  console.log(`  tiepoint.html, the page in one file: ${kb(single.raw)}`);
}
