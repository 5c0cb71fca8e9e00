/** What is made of the tracked files with Node alone: the page in ONE file, and the folder for a static host. */

import { createHash } from 'node:crypto';
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { deflateRawSync } from 'node:zlib';
import { DIST, PKG_WASM } from './paths.mjs';
import { singlePolicy } from './policy.mjs';

/** The page's text files, built from `www/` and tracked. */
export const TEXTS = ['index.html', 'page.js', 'page.css', 'worker.js'];

/** The module as the page names it; it lies with the package, once. */
const MODULE = 'tiepoint_bg.wasm';

/** All files of the page. */
export const FILES = [...TEXTS, MODULE];

/** Where a file of the page lies.  @param {string} name */
export const pathOf = (name) => join(name === MODULE ? PKG_WASM : DIST, name);

/** @param {string} name */
const text = (name) => readFileSync(pathOf(name), 'utf8');

/** A script as it may stand inside an HTML script element. Both sequences occur in strings and patterns only.  @param {string} code */
const inline = (code) =>
  code
    .trim()
    .replace(/<\/(script)/gi, '<\\/$1')
    .replace(/<!--/g, '\\x3c!--');

/** @param {string} content @returns {string} the hash by which a policy names an inline element */
const hash = (content) => `sha256-${createHash('sha256').update(content).digest('base64')}`;

/** The whole page as one HTML text, which also runs from a double-click.  @returns {string} */
export function singleFile() {
  const [script, style, worker] = [inline(text('page.js')), text('page.css').trim(), inline(text('worker.js'))];
  const wasm = deflateRawSync(readFileSync(pathOf(MODULE)), { level: 9 }).toString('base64');
  const bare = text('index.html')
    .replace(/\s*<meta http-equiv="Content-Security-Policy"[^>]*>/, '')
    .replace(/\s*<script type="module"[^>]*><\/script>/, '')
    .replace(/\s*<link rel="stylesheet"[^>]*>/, '');
  if (/(?:src|href)="\.\//.test(bare)) throw new Error('the page in one file still names a file beside it');
  const policy = `<meta http-equiv="Content-Security-Policy" content="${singlePolicy(hash(script), hash(style))}">`;
  return bare
    .replace(/<meta charset="[^"]*"\s*\/?>/i, (charset) => `${charset}\n    ${policy}`)
    .replace(/\s*<\/head>/, () => `\n    <style>${style}</style>\n  </head>`)
    .replace('</body>', () =>
      [
        `<script type="text/plain" id="tiepoint-wasm">${wasm}</script>`,
        `<script type="text/plain" id="tiepoint-worker">${worker}</script>`,
        `<script type="module">${script}</script>`,
        '</body>',
      ].join('\n'),
    );
}

/** Writes the page in one file.  @param {string} path */
export function writeSingle(path) {
  writeFileSync(path, singleFile());
}

/** Writes all that a static host needs, and the page in one file beside it.  @param {string} folder */
export function writeSite(folder) {
  mkdirSync(folder, { recursive: true });
  for (const name of FILES) copyFileSync(pathOf(name), join(folder, name));
  writeSingle(join(folder, 'tiepoint.html'));
}
