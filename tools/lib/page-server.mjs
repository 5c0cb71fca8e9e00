/** The page's server, for this machine alone, with the headers a host should send. It knows the page's files and no others. */

import { createHash } from 'node:crypto';
import { readFile, stat } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname } from 'node:path';
import { promisify } from 'node:util';
import { brotliCompress, constants, gzip } from 'node:zlib';
import { contentOf, FILES, isAsItLies, pathOf, singleFile } from './compose.mjs';
import { serverPolicy } from './policy.mjs';

/** @type {Record<string, string>} */
const TYPES = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json; charset=utf-8',
  '.svg': 'image/svg+xml; charset=utf-8',
  '.png': 'image/png',
};

const HEADERS = {
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cross-Origin-Embedder-Policy': 'require-corp',
  'Cross-Origin-Resource-Policy': 'same-origin',
  'X-Content-Type-Options': 'nosniff',
  'Referrer-Policy': 'no-referrer',
  // Names of files say nothing of their content: a browser asks whether they are still the same, and mostly hears that they are.
  'Cache-Control': 'no-cache',
  Vary: 'Accept-Encoding',
};

/** Brotli gains little by more effort than this in as much time: of texts, and of the module, which is large. */
const EFFORT = { text: 9, module: 5 };

/** How content is compressed, best first. @type {Record<string, (content: Buffer, effort: number) => Promise<Buffer>>} */
const ENCODINGS = {
  br: (content, effort) =>
    promisify(brotliCompress)(content, { params: { [constants.BROTLI_PARAM_QUALITY]: effort, [constants.BROTLI_PARAM_SIZE_HINT]: content.length } }),
  gzip: (content) => promisify(gzip)(content),
};

/**
 * Serves the page on 127.0.0.1.
 * @param {{ prefix?: string, port?: number, compresses?: boolean }} [options] prefix: the path below which it appears; port: the one to try first,
 * 0 takes any free one; compresses: false sends files as they lie, which costs less where nothing but this machine lies between
 * @returns {Promise<{ url: string, close: () => Promise<void> }>}
 */
export async function servePage({ prefix = '/', port = 0, compresses = true } = {}) {
  const server = createServer((request, response) => {
    answer(prefix, compresses, request, response).catch(() => {
      response.writeHead(500).end('The file could not be read.\n');
    });
  });
  const taken = await listen(server, port);
  return {
    url: `http://127.0.0.1:${taken}${prefix}`,
    close: () =>
      new Promise((resolve) => {
        server.close(() => resolve());
        server.closeAllConnections();
      }),
  };
}

/**
 * Listens on the port, or on one of the next, or on any that is free.
 * @param {import('node:http').Server} server @param {number} port @returns {Promise<number>} the port taken
 */
async function listen(server, port) {
  for (const candidate of port === 0 ? [0] : [port, port + 1, port + 2, port + 3, 0]) {
    const taken = await new Promise((resolve, reject) => {
      server.once('error', (/** @type {NodeJS.ErrnoException} */ error) => {
        if (error.code === 'EADDRINUSE' || error.code === 'EACCES') resolve(null);
        else reject(error);
      });
      server.listen(candidate, '127.0.0.1', () => {
        const address = server.address();
        resolve(typeof address === 'object' && address ? address.port : null);
      });
    });
    server.removeAllListeners('error');
    if (taken !== null) return taken;
  }
  throw new Error('no port is free on 127.0.0.1');
}

/** @param {string} prefix @param {boolean} compresses @param {import('node:http').IncomingMessage} request @param {import('node:http').ServerResponse} response */
async function answer(prefix, compresses, request, response) {
  for (const [name, value] of Object.entries(HEADERS)) response.setHeader(name, value);
  if (request.method !== 'GET' && request.method !== 'HEAD') {
    response.writeHead(405, { Allow: 'GET, HEAD' }).end();
    return;
  }
  const [path = ''] = (request.url ?? '/').split('?');
  const name = path === prefix ? 'index.html' : path.startsWith(prefix) ? path.slice(prefix.length) : '';
  const file = await fileOf(name);
  if (file === null) {
    response.writeHead(404, { 'Content-Type': 'text/plain; charset=utf-8' }).end('There is no such file.\n');
    return;
  }
  // The page in one file names its own scripts by their hashes; the web's policy would forbid them.
  if (name !== 'tiepoint.html') response.setHeader('Content-Security-Policy', serverPolicy(await readFile(pathOf('index.html'), 'utf8')));
  const encoding = compresses ? encodingOf(request.headers['accept-encoding']) : null;
  const tag = `"${file.digest}${encoding === null ? '' : `-${encoding}`}"`;
  response.setHeader('ETag', tag);
  if (isNamed(request.headers['if-none-match'], tag)) {
    response.writeHead(304).end();
    return;
  }
  const content = await file.encoded(encoding);
  if (encoding !== null) response.setHeader('Content-Encoding', encoding);
  response.writeHead(200, { 'Content-Type': TYPES[extname(name)], 'Content-Length': content.length });
  response.end(request.method === 'HEAD' ? undefined : content);
}

/** The first of the encodings that a browser takes; null where it takes none.  @param {string | string[] | undefined} accepted */
function encodingOf(accepted = '') {
  const taken = String(accepted)
    .split(',')
    .map((part) => part.trim().split(/\s*;\s*q=/))
    .filter(([, weight = '1']) => Number(weight) > 0)
    .map(([coding]) => coding);
  return Object.keys(ENCODINGS).find((encoding) => taken.includes(encoding)) ?? null;
}

/** Whether a browser has what a tag names.  @param {string | undefined} known @param {string} tag */
const isNamed = (known, tag) => known?.split(',').some((one) => one.trim().replace(/^W\//, '') === tag) ?? false;

/** A file of the page as it was read last, with what it was compressed to. */
class Served {
  /** @type {Map<string, Promise<Buffer>>} */
  #made = new Map();

  /** @param {Buffer} content @param {number} changed when its file was written */
  constructor(content, changed) {
    this.content = content;
    this.changed = changed;
    this.digest = createHash('sha256').update(content).digest('base64url');
  }

  /** @param {string | null} encoding @returns {Promise<Buffer>} */
  encoded(encoding) {
    const encode = encoding === null ? undefined : ENCODINGS[encoding];
    if (encode === undefined || encoding === null) return Promise.resolve(this.content);
    const made = this.#made.get(encoding) ?? encode(this.content, this.content.length > 1e6 ? EFFORT.module : EFFORT.text);
    this.#made.set(encoding, made);
    return made;
  }
}

/** @type {Map<string, Served>} */
const served = new Map();

/** @param {string} name @returns {Promise<Served | null>} null where the page has no such file */
async function fileOf(name) {
  if (name === 'tiepoint.html') return new Served(Buffer.from(singleFile()), 0);
  if (!FILES.includes(name)) return null;
  if (!isAsItLies(name)) return new Served(contentOf(name), 0);
  const { mtimeMs } = await stat(pathOf(name));
  const known = served.get(name);
  if (known?.changed === mtimeMs) return known;
  const fresh = new Served(await readFile(pathOf(name)), mtimeMs);
  served.set(name, fresh);
  return fresh;
}
