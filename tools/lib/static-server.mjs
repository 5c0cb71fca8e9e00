/** A small static file server for this machine alone, with the headers a host should send. */

import { createReadStream } from 'node:fs';
import { realpath, stat } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize, sep } from 'node:path';
import { SERVER_POLICY } from './policy.mjs';

/** @type {Record<string, string>} */
const TYPES = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.json': 'application/json; charset=utf-8',
  '.wasm': 'application/wasm',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.ico': 'image/x-icon',
  '.webmanifest': 'application/manifest+json',
  '.txt': 'text/plain; charset=utf-8',
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
 * @typedef {object} ServeOptions
 * @property {string} [prefix] the path below which the folder appears, `/` unless told
 * @property {number} [port] the port to try first; 0 takes any free one
 * @property {boolean} [policy] send the content-security policy as a header (default); the page carries its own, too
 */

/**
 * Serves a folder on 127.0.0.1.
 * @param {string} folder @param {ServeOptions} [options]
 * @returns {Promise<{ url: string, close: () => Promise<void> }>}
 */
export async function serve(folder, { prefix = '/', port = 0, policy = true } = {}) {
  const root = await realpath(folder);
  const server = createServer((request, response) => {
    answer(root, prefix, policy, request, response).catch(() => {
      response.writeHead(500).end('The file could not be read.\n');
    });
  });
  const taken = await listen(server, port);
  return {
    url: `http://127.0.0.1:${taken}${prefix}`,
    close: () => new Promise((resolve) => {
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

/**
 * @param {string} root @param {string} prefix @param {boolean} policy
 * @param {import('node:http').IncomingMessage} request @param {import('node:http').ServerResponse} response
 */
async function answer(root, prefix, policy, request, response) {
  for (const [name, value] of Object.entries(HEADERS)) response.setHeader(name, value);
  if (request.method !== 'GET' && request.method !== 'HEAD') {
    response.writeHead(405, { Allow: 'GET, HEAD' }).end();
    return;
  }
  const file = await fileOf(root, prefix, request.url ?? '/');
  if (!file) {
    response.writeHead(404, { 'Content-Type': 'text/plain; charset=utf-8' }).end('There is no such file.\n');
    return;
  }
  const type = TYPES[extname(file.path)] ?? 'application/octet-stream';
  // The one-file page names its own scripts by their hashes; the web's policy would forbid them.
  if (policy && !file.path.endsWith('tiepoint.html')) response.setHeader('Content-Security-Policy', SERVER_POLICY);
  response.writeHead(200, { 'Content-Type': type, 'Content-Length': file.size });
  if (request.method === 'HEAD') response.end();
  else createReadStream(file.path).on('error', () => response.destroy()).pipe(response);
}

/**
 * The file an address names, if it lies inside the folder.
 * @param {string} root @param {string} prefix @param {string} address @returns {Promise<{ path: string, size: number } | null>}
 */
async function fileOf(root, prefix, address) {
  try {
    const path = decodeURIComponent(new URL(address, 'http://localhost').pathname);
    if (!path.startsWith(prefix) || path.includes('\0')) return null;
    const wanted = join(root, normalize(`/${path.slice(prefix.length)}`));
    const real = await realpath(path.endsWith('/') ? join(wanted, 'index.html') : wanted);
    if (real !== root && !real.startsWith(root + sep)) return null;
    const found = await stat(real);
    return found.isFile() ? { path: real, size: found.size } : null;
  } catch {
    return null;
  }
}
