/** The page's server, for this machine alone, with the headers a host should send. It knows the page's files and no others. */

import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname } from 'node:path';
import { FILES, pathOf, singleFile } from './compose.mjs';
import { SERVER_POLICY } from './policy.mjs';

/** @type {Record<string, string>} */
const TYPES = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.wasm': 'application/wasm',
};

const HEADERS = {
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cross-Origin-Embedder-Policy': 'require-corp',
  'Cross-Origin-Resource-Policy': 'same-origin',
  'X-Content-Type-Options': 'nosniff',
  'Referrer-Policy': 'no-referrer',
  'Cache-Control': 'no-cache',
};

/**
 * Serves the page on 127.0.0.1.
 * @param {{ prefix?: string, port?: number }} [options] prefix: the path below which it appears; port: the one to try first, 0 takes any free one
 * @returns {Promise<{ url: string, close: () => Promise<void> }>}
 */
export async function servePage({ prefix = '/', port = 0 } = {}) {
  const server = createServer((request, response) => {
    answer(prefix, request, response).catch(() => {
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

/** @param {string} prefix @param {import('node:http').IncomingMessage} request @param {import('node:http').ServerResponse} response */
async function answer(prefix, request, response) {
  for (const [name, value] of Object.entries(HEADERS)) response.setHeader(name, value);
  if (request.method !== 'GET' && request.method !== 'HEAD') {
    response.writeHead(405, { Allow: 'GET, HEAD' }).end();
    return;
  }
  const [path = ''] = (request.url ?? '/').split('?');
  const name = path === prefix ? 'index.html' : path.startsWith(prefix) ? path.slice(prefix.length) : '';
  const content = await contentOf(name);
  if (content === null) {
    response.writeHead(404, { 'Content-Type': 'text/plain; charset=utf-8' }).end('There is no such file.\n');
    return;
  }
  // The page in one file names its own scripts by their hashes; the web's policy would forbid them.
  if (name !== 'tiepoint.html') response.setHeader('Content-Security-Policy', SERVER_POLICY);
  response.writeHead(200, { 'Content-Type': TYPES[extname(name)], 'Content-Length': content.length });
  response.end(request.method === 'HEAD' ? undefined : content);
}

/** @param {string} name @returns {Promise<Buffer | null>} null where the page has no such file */
async function contentOf(name) {
  if (name === 'tiepoint.html') return Buffer.from(singleFile());
  return FILES.includes(name) ? readFile(pathOf(name)) : null;
}
