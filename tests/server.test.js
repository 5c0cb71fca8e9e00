/** The page's server: what it sends is compressed as a browser takes it, and is not sent twice; and what `npm start` takes. */

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { request } from 'node:http';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { brotliDecompressSync, gunzipSync } from 'node:zlib';
import { pathOf } from '../tools/lib/compose.mjs';
import { servePage } from '../tools/lib/page-server.mjs';

/** An answer as it comes, not unpacked.  @param {string} url @param {Record<string, string>} headers @param {string} method */
const get = (url, headers = {}, method = 'GET') =>
  new Promise((resolve, reject) => {
    const asked = request(url, { headers, method }, (answer) => {
      /** @type {Buffer[]} */
      const chunks = [];
      answer.on('data', (chunk) => chunks.push(chunk));
      answer.on('end', () => resolve({ status: answer.statusCode, headers: answer.headers, body: Buffer.concat(chunks) }));
    });
    asked.on('error', reject);
    asked.end();
  });

test('files are compressed, have a tag by which a browser asks again, and names that are none are refused', async () => {
  const { url, close } = await servePage({ prefix: '/below/' });
  try {
    const plain = readFileSync(pathOf('page.js'));
    for (const [accepted, encoding, unpack] of /** @type {const} */ ([
      ['gzip, deflate, br, zstd', 'br', brotliDecompressSync],
      ['gzip;q=0.8, br;q=0', 'gzip', gunzipSync],
      ['identity', undefined, (/** @type {Buffer} */ body) => body],
    ])) {
      const first = await get(`${url}page.js`, { 'accept-encoding': accepted });
      assert.equal(first.headers['content-encoding'], encoding);
      assert.equal(first.headers.vary, 'Accept-Encoding');
      assert.equal(Number(first.headers['content-length']), first.body.length);
      assert.ok(plain.equals(unpack(first.body)));
      const again = await get(`${url}page.js`, { 'accept-encoding': accepted, 'if-none-match': first.headers.etag });
      assert.deepEqual([again.status, again.body.length, again.headers.etag], [304, 0, first.headers.etag]);
    }
    const module = await get(`${url}tiepoint_bg.wasm`, { 'accept-encoding': 'br' });
    assert.ok(module.body.length < 0.4 * readFileSync(pathOf('tiepoint_bg.wasm')).length);
    assert.equal((await get(url, {}, 'HEAD')).body.length, 0);
    assert.equal((await get(`${url}..%2fpackage.json`)).status, 404);
    assert.equal((await get(url, {}, 'POST')).status, 405);
  } finally {
    await close();
  }
});

test('programs that write where nothing is named print what they take, and write nothing', () => {
  const folder = mkdtempSync(join(tmpdir(), 'tiepoint-usage-'));
  const run = (/** @type {string} */ name, /** @type {string[]} */ ...given) =>
    spawnSync(process.execPath, [fileURLToPath(new URL(`../tools/${name}.mjs`, import.meta.url)), ...given], { encoding: 'utf8', cwd: folder });
  for (const name of ['single', 'site', 'docs', 'picture', 'build', 'test']) {
    const help = run(name, '--help');
    assert.deepEqual([help.status, help.stderr], [0, ''], name);
    assert.match(help.stdout, /^npm /, name);
  }
  for (const name of ['single', 'site', 'docs', 'picture']) {
    const slip = run(name, '--hlep');
    assert.deepEqual([slip.status, slip.stdout], [2, ''], name);
    assert.match(slip.stderr, /--hlep[\s\S]*npm run/, name);
  }
  assert.match(run('single', 'a.html', 'b.html').stderr, /^got a\.html b\.html; allowed: one path/);
  assert.deepEqual(readdirSync(folder), []);
  rmSync(folder, { recursive: true });
});

test('how a picture is taken is told where the npm packages are not installed', () => {
  const clone = mkdtempSync(join(tmpdir(), 'tiepoint-clone-'));
  const tools = fileURLToPath(new URL('../tools', import.meta.url));
  cpSync(tools, join(clone, 'tools'), { recursive: true, filter: (path) => basename(path) !== 'node_modules' });
  const { status, stdout, stderr } = spawnSync(process.execPath, [join(clone, 'tools', 'picture.mjs'), '--help'], { encoding: 'utf8' });
  assert.deepEqual([status, stderr], [0, '']);
  assert.match(stdout, /^npm run picture/);
  rmSync(clone, { recursive: true });
});

test('what it takes is printed, and said of an option that it does not know', () => {
  const serve = (/** @type {string} */ option) =>
    spawnSync(process.execPath, [fileURLToPath(new URL('../tools/serve.mjs', import.meta.url)), option], { encoding: 'utf8' });
  const help = serve('--help');
  assert.deepEqual([help.status, help.stderr], [0, '']);
  assert.match(help.stdout, /^ {2}--port PORT {2}0 to 65535/m);
  const slip = serve('--prot');
  assert.deepEqual([slip.status, slip.stdout], [2, '']);
  assert.match(slip.stderr, /--prot[\s\S]*--port PORT/);
  assert.doesNotMatch(slip.stderr, /^ +at /m);
});
