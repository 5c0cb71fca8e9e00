/** The installed page: offline, a later release when the user says so, files that the system opens with it, and whose work it holds. */

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { createServer } from 'node:http';
import { join } from 'node:path';
import { test } from 'node:test';
import { contentOf, FILES } from '../../tools/lib/compose.mjs';
import { webPolicy } from '../../tools/lib/policy.mjs';
import { done, hosted, number, open, pair, part, saved, says, SHOTS, SKIP } from './page.js';

hosted('/installed/');

/** @typedef {import('playwright-core').Page} Page */

const LATER = '\n.of-a-later-release { color: red; }\n';

const digest = (/** @type {Buffer} */ content) => `sha256-${createHash('sha256').update(content).digest('base64')}`;

/** A host of the page in its first release, and then in a later one. */
async function host() {
  const state = { later: false };
  const style = contentOf('page.css');
  const changed = Buffer.from(`${style}${LATER}`);
  const given = (/** @type {string} */ name) => {
    const content = contentOf(name);
    if (!state.later) return content;
    if (name === 'page.css') return changed;
    return name === 'service-worker.js' ? Buffer.from(`${content}`.replace(digest(style), digest(changed)).replace(/"name": "/, '"name": "later-')) : content;
  };
  /** @type {Record<string, string>} */
  const types = {
    html: 'text/html',
    js: 'text/javascript',
    css: 'text/css',
    wasm: 'application/wasm',
    webmanifest: 'application/manifest+json',
    svg: 'image/svg+xml',
  };
  const server = createServer((request, response) => {
    const name = new URL(request.url ?? '/', 'http://host').pathname.slice(1) || 'index.html';
    if (!FILES.includes(name)) {
      response.writeHead(404).end();
      return;
    }
    const type = types[name.split('.').at(-1) ?? ''] ?? 'image/png';
    response
      .writeHead(200, { 'Content-Type': type, 'Cache-Control': 'no-cache', 'Content-Security-Policy': webPolicy(String(given('index.html'))) })
      .end(given(name));
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(undefined)));
  const address = /** @type {import('node:net').AddressInfo} */ (server.address());
  return {
    url: `http://127.0.0.1:${address.port}/`,
    release: () => {
      state.later = true;
    },
    close: () => {
      server.close();
      server.closeAllConnections();
    },
  };
}

/** Waits until the browser keeps the page's files.  @param {Page} page */
const ready = (page) => page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));

/** Whether the page has the style of the later release.  @param {Page} page */
const isLater = (page) => page.evaluate(async () => (await (await fetch('page.css')).text()).includes('of-a-later-release'));

test('the page starts offline, keeps to its release until the user updates, and loses nothing', { skip: SKIP }, async (t) => {
  const { url, release, close: closeHost } = await host();
  t.after(closeHost);
  const { page, complaints, close } = await open({ url, options: { serviceWorkers: 'allow' } });
  await ready(page);
  await pair(page);
  const matches = await number(page, 'count-matches');
  const session = await page.context().newCDPSession(page);
  const { errors } = await session.send('Page.getAppManifest');
  assert.deepEqual(errors, []);

  // Without a network.
  await page.context().setOffline(true);
  await page.reload();
  await says(page, 'status', /Restored from this browser: left\.png and right\.png\.$/);
  assert.equal(await number(page, 'count-matches'), matches);
  await part(page, 'anew').click();
  await pair(page);
  await page.context().setOffline(false);

  // A later release waits, over a new start too.
  release();
  await page.evaluate(() => navigator.serviceWorker.getRegistration().then((found) => found?.update()));
  await says(page, 'update', /new version of Tiepoint is ready/);
  await part(page, 'update-later').click();
  assert.ok(await part(page, 'update').isHidden());
  await page.reload();
  await says(page, 'update', /new version of Tiepoint is ready/);
  assert.equal(await isLater(page), false);
  await says(page, 'status', /Restored from this browser/);
  const second = await page.context().newPage();
  await second.goto(url);
  await says(second, 'status', /^Ready/);

  // Both tabs go on with it, and with what they had.
  const reloaded = second.waitForEvent('load');
  await Promise.all([page.waitForEvent('load'), part(page, 'update-take').click()]);
  await reloaded;
  await says(page, 'status', /Restored from this browser: left\.png and right\.png\.$/);
  assert.equal(await isLater(page), true);
  assert.equal(await isLater(second), true);
  assert.ok(await part(page, 'update').isHidden());
  assert.equal(await number(page, 'count-matches'), matches);
  assert.deepEqual(complaints, []);
  await close();
});

test('a project that the system opens with the page is shown, and the page says whose work it holds', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  const matches = await number(page, 'count-matches');
  const project = await saved(page, 'export-project');
  await part(page, 'about').click();
  await part(page, 'licence-fflate').locator('summary').click();
  assert.match((await part(page, 'about-dialog').textContent()) ?? '', /fflate \d+\.\d+\.\d+ \(MIT\).*Copyright.*idb \d+\.\d+\.\d+ \(ISC\)/s);
  await part(page, 'crates').locator('summary').first().click();
  const nalgebra = page.locator('[data-testid^="crate-nalgebra-"]');
  await nalgebra.locator('summary').click();
  assert.match((await nalgebra.textContent()) ?? '', /^nalgebra \d+\.\d+\.\d+ \(Apache-2\.0\).*TERMS AND CONDITIONS/s);
  await page.screenshot({ path: join(SHOTS, 'about.png') });
  await part(page, 'about-close').click();
  const launched = await page.context().newPage();
  await launched.addInitScript(
    ([text]) => {
      const file = new File([text ?? ''], 'flight.tiepoint');
      const launchQueue = { setConsumer: (/** @type {any} */ take) => take({ files: [{ getFile: () => Promise.resolve(file) }] }) };
      Object.defineProperty(window, 'launchQueue', { value: launchQueue });
    },
    [project.toString()],
  );
  await launched.goto(page.url());
  await says(launched, 'status', /flight\.tiepoint was opened/);
  await done(launched);
  assert.equal(await number(launched, 'count-matches'), matches);
  assert.deepEqual(complaints, []);
  await close();
});
