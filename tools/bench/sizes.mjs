/** What is sent to a browser, after brotli, and what git packs, which is about what gzip makes. */

import { readFileSync } from 'node:fs';
import { brotliCompressSync, constants, gzipSync } from 'node:zlib';
import { pathOf, singleFile, TEXTS } from '../lib/compose.mjs';

/** @param {Buffer} bytes */
function sizes(bytes) {
  const packed = brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length } });
  return { raw: bytes.length, packed: packed.length, zipped: gzipSync(bytes).length };
}

/** @param {number} bytes */
const kb = (bytes) => `${(bytes / 1000).toFixed(0)} KB`;

export function sizesOfAll() {
  console.log('Sizes');
  const wasm = sizes(readFileSync(pathOf('tiepoint_bg.wasm')));
  console.log(`  wasm: ${kb(wasm.raw)}, ${kb(wasm.zipped)} after gzip, ${kb(wasm.packed)} after brotli`);
  const shell = TEXTS.map((name) => sizes(readFileSync(pathOf(name))));
  const total = (/** @type {'raw' | 'packed' | 'zipped'} */ key) => shell.reduce((sum, file) => sum + file[key], 0);
  console.log(`  page shell (all that is beside the module): ${kb(total('raw'))}, ${kb(total('zipped'))} after gzip, ${kb(total('packed'))} after brotli`);
  const single = sizes(Buffer.from(singleFile()));
  console.log(`  tiepoint.html, the page in one file: ${kb(single.raw)}`);
}
