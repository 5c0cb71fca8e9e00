/** What is made of the tracked files with Node alone: the page in ONE file, and the folder for a static host. */

import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { deflateRawSync } from 'node:zlib';
import { iconPng, iconSvg } from './icon.mjs';
import { DIST, PKG_WASM } from './paths.mjs';
import { joined } from './join.mjs';
import { hash, singlePolicy } from './policy.mjs';

/** The script that starts the page, and the parts that are loaded when they are needed: the program, what few views need, and the texts of each language. */
const START = 'page.js';
const PARTS = ['program.js', 'block.js', 'about.js', 'en.js', 'en-block.js', 'ar.js', 'ar-block.js'];

/** The page's text files, built from `www/` and tracked. */
export const TEXTS = ['index.html', START, ...PARTS, 'page.css', 'worker.js', 'manifest.webmanifest', 'service-worker.js'];

/** The module as the page names it; it lies with the package, once. */
const MODULE = 'tiepoint_bg.wasm';

/** What keeps the other files in a browser. */
const KEEPER = 'service-worker.js';

/** The icons of an installed page, drawn when they are asked for. @type {Record<string, () => Buffer>} */
const ICONS = {
  'icon.svg': () => Buffer.from(iconSvg()),
  'icon-192.png': () => iconPng(192),
  'icon-512.png': () => iconPng(512),
  'icon-full.png': () => iconPng(512, true),
};

/** All files of the page. */
export const FILES = [...TEXTS, MODULE, ...Object.keys(ICONS)];

/** Where a file of the page lies that is not made when it is asked for.  @param {string} name */
export const pathOf = (name) => join(name === MODULE ? PKG_WASM : DIST, name);

/** Whether a file is as it lies there.  @param {string} name */
export const isAsItLies = (name) => name !== KEEPER && !(name in ICONS);

/** A file of the page as a host gives it.  @param {string} name @returns {Buffer} */
export function contentOf(name) {
  const drawn = ICONS[name];
  if (drawn !== undefined) return drawn();
  const content = readFileSync(pathOf(name));
  return name === KEEPER ? Buffer.concat([Buffer.from(release()), content]) : content;
}

/** What the service worker is told of the release: its files with their digests, and a name that another release does not have.  @returns {string} */
function release() {
  const kept = FILES.filter(isAsItLies).map((name) => [name === 'index.html' ? '' : name, hash(readFileSync(pathOf(name)))]);
  const name = createHash('sha256').update(JSON.stringify(kept)).update(text(KEEPER)).digest('hex').slice(0, 16);
  return `const RELEASE = ${JSON.stringify({ name, files: Object.fromEntries(kept) }, null, 2)};\n`;
}

/** @param {string} name */
const text = (name) => readFileSync(pathOf(name), 'utf8');

/** A script as it may stand inside an HTML script element. Both sequences occur in strings and patterns only.  @param {string} code */
const inline = (code) =>
  code
    .trim()
    .replace(/<\/(script)/gi, '<\\/$1')
    .replace(/<!--/g, '\\x3c!--');

/** The whole page as one HTML text, which also runs from a double-click.  @returns {string} */
export function singleFile() {
  const [script, style, worker] = [inline(joined(START, PARTS, text)), text('page.css').trim(), inline(text('worker.js'))];
  const wasm = deflateRawSync(readFileSync(pathOf(MODULE)), { level: 9 }).toString('base64');
  const bare = text('index.html')
    .replace(/\s*<meta http-equiv="Content-Security-Policy"[^>]*>/, '')
    .replace(/\s*<script type="module"[^>]*><\/script>/, '')
    .replace(/\s*<link rel="(?:stylesheet|manifest|modulepreload)"[^>]*>/g, '');
  if (/(?:src|href)="\.\//.test(bare)) throw new Error('the page in one file still names a file beside it');
  const policy = `<meta http-equiv="Content-Security-Policy" content="${singlePolicy(bare, script, style)}">`;
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
  for (const name of FILES) writeFileSync(join(folder, name), contentOf(name));
  writeSingle(join(folder, 'tiepoint.html'));
}
