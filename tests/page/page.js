/** Opens the built page in a browser, Chromium unless another one is named, and looks at it as a user does. */

import { mkdirSync, mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, afterEach, before } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';
import { writeSingle } from '../../tools/lib/compose.mjs';
import { findHeadlessChromium } from '../../tools/lib/setup.mjs';
import { servePage } from '../../tools/lib/page-server.mjs';
import { pairPhotos } from './rendered.js';

export const ROOT = fileURLToPath(new URL('../..', import.meta.url));
export const SHOTS = join(ROOT, 'target', 'screenshots');

/**
 * What the browser is not to do. Its last list of features counts: Playwright's own that bear on pages of this machine come again. The two of the address bar
 * load pages of their own beside each test's, which took a third of what opening the page takes.
 */
const FEATURES = [
  'WebUIOmniboxPopup',
  'WebUIOmniboxAimPopup',
  'AvoidUnnecessaryBeforeUnloadCheckSync',
  'DestroyProfileOnBrowserClose',
  'HttpsUpgrades',
  'HttpsFirstBalancedModeAutoEnable',
  'LensOverlay',
  'MediaRouter',
  'PaintHolding',
  'ThirdPartyStoragePartitioning',
  'OptimizationHints',
  'NetworkTimeServiceQuerying',
  'AimEnabled',
  'PreconnectToSearch',
];

const FLAGS = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  `--disable-features=${FEATURES.join()}`,
];
const program = findHeadlessChromium();

/** Why the tests of the page cannot run; false where they can. */
export const SKIP = program ? false : `skipped: no Chromium (${process.env.NO_CHROMIUM || 'install it or name it in CHROMIUM'})`;

/** @type {import('playwright-core').Browser} */
let browser;
/** @type {Awaited<ReturnType<typeof servePage>>} */
let server;

/** How long a test waits for what the page does. None measures speed by it: two tests at a time on a small machine are slow. */
const PATIENCE_MS = 180_000;

/** What the tests of a file have opened. @type {Set<import('playwright-core').BrowserContext>} */
const opened = new Set();

/** How often Chromium is started before its failure counts: on a loaded machine one start in hundreds dies before it draws anything. */
const STARTS = 3;

/** A browser of its own, with these arguments.  @param {string[]} args @returns {Promise<import('playwright-core').Browser>} */
export async function launch(args) {
  for (let start = 1; ; start++) {
    try {
      return await chromium.launch({ executablePath: program ?? '', args });
    } catch (error) {
      if (start === STARTS) throw error;
      console.log(`Chromium did not start: ${String(error).split('\n')[0]}`);
    }
  }
}

/**
 * Starts browser and server for the tests of a file; gives the page's address below a folder.
 * @param {string} [prefix] @param {(() => Promise<import('playwright-core').Browser>) | null} [starts] another browser than Chromium; null: there is none
 */
export function hosted(prefix = '/', starts = program ? () => launch(FLAGS) : null) {
  before(async () => {
    if (starts === null) return;
    mkdirSync(SHOTS, { recursive: true });
    // What it sends is not compressed: each file of tests would compress the module anew (tests/server.test.js holds what a host sends).
    server = await servePage({ prefix, compresses: false });
    browser = await starts();
  });
  // A test that failed leaves its page to go on, and would slow down those after it.
  afterEach(async () => {
    for (const context of opened) await context.close();
    opened.clear();
  });
  after(async () => {
    await browser?.close();
    await server?.close();
  });
}

/** The address of the page in one file, as on a memory stick: alone in its folder. */
export function singleUrl() {
  const file = join(mkdtempSync(join(tmpdir(), 'tiepoint-stick-')), 'tiepoint.html');
  writeSingle(file);
  return pathToFileURL(file).href;
}

/**
 * A fresh page. `complaints` collects what no page may have: console errors, uncaught errors, requests that leave its origin.
 * @param {{ url?: string, options?: import('playwright-core').BrowserContextOptions, workers?: number, fresh?: boolean }} [how] workers: as many as the
 * processor seems to allow; fresh: with its drawers closed, as a stranger finds it
 */
export async function open({ url = server.url, options = {}, workers, fresh = false } = {}) {
  // The files that a browser keeps of the page would be fetched anew by each test.
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, serviceWorkers: 'block', ...options });
  context.setDefaultTimeout(PATIENCE_MS);
  opened.add(context);
  const page = await context.newPage();
  if (!fresh) await page.addInitScript(openDrawers);
  if (workers !== undefined)
    await page.addInitScript((number) => {
      Object.defineProperty(navigator, 'hardwareConcurrency', { get: () => number });
    }, workers);
  /** @type {string[]} */
  const complaints = [];
  const origin = url.startsWith('file:') ? 'file:' : new URL(url).origin;
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(`console: ${message.text()}`);
  });
  page.on('pageerror', (error) => complaints.push(`uncaught: ${error.message}`));
  page.on('request', (request) => {
    if (!request.url().startsWith(origin) && !/^(blob|data):/.test(request.url())) complaints.push(`request: ${request.url()}`);
  });
  await page.goto(url);
  return { page, complaints, close: () => context.close() };
}

/** Opens what a user has opened who looks at everything, and who sets a block before it runs. It runs in the page. */
export function openDrawers() {
  try {
    if (localStorage.getItem('tiepoint-open') !== null) return;
    localStorage.setItem('tiepoint-open', 'settings details all-settings table');
    localStorage.setItem('tiepoint-wait', 'yes');
  } catch {
    // A page without storage.
  }
}

/**
 * Asks until the answer is neither null nor false; gives it.
 * @template T @param {import('playwright-core').Page} page @param {string} what is waited for @param {() => Promise<T | null | false>} question @returns {Promise<T>}
 */
export async function until(page, what, question) {
  for (const end = Date.now() + PATIENCE_MS; Date.now() < end; await page.waitForTimeout(100)) {
    const answer = await question();
    if (answer !== null && answer !== false) return answer;
  }
  throw new Error(`waited ${PATIENCE_MS} ms until ${what}`);
}

/** @param {import('playwright-core').Page} page @param {string} id */
export const part = (page, id) => page.locator(`[data-testid="${id}"]`);

/** Whether a run has ended, oriented or not. It runs in the page. */
const hasEnded = () => /^(done|partial)$/.test(document.querySelector('[data-testid="status"]')?.getAttribute('data-kind') ?? '');

/** Waits for a run to end, oriented or not; gives the status line.  @param {import('playwright-core').Page} page */
export async function done(page) {
  await page.waitForFunction(hasEnded);
  return (await part(page, 'status').textContent()) ?? '';
}

/** What stands in the panel of the results, which is drawn while it is in sight. */
const OF_RESULTS = /^(?:count|refused|orientation|sigma|geometry|global|degenerate|warning|histogram)-|^sigma0$/;

/** Shows the panel of the results for a moment where another tab is shown, as who wants to read there does.  @param {import('playwright-core').Page} page @param {string} id */
async function glance(page, id) {
  if (!OF_RESULTS.test(id)) return;
  await page.evaluate(async () => {
    const [tab, panel] = ['tab-results', 'panel-results'].map((id) => document.getElementById(id));
    const chosen = /** @type {HTMLElement | null} */ (tab?.parentElement?.querySelector('[aria-selected="true"]'));
    if (panel?.hidden !== true || !tab || !chosen) return;
    tab.click();
    await null;
    chosen.click();
  });
}

/** The number in a cell.  @param {import('playwright-core').Page} page @param {string} id */
export async function number(page, id) {
  await glance(page, id);
  return Number(((await part(page, id).textContent()) ?? '').replaceAll(/[^\d.−-]/g, '').replace('−', '-'));
}

/** Waits until a button can be pressed. A press that has to wait is tried again and again, and scrolls the page while it is.  @param {import('playwright-core').Page} page @param {string} id */
export const enabled = (page, id) => page.waitForFunction((at) => document.querySelector(`[data-testid="${at}"]`)?.hasAttribute('disabled') === false, id);

/** Starts the sample and waits for it.  @param {import('playwright-core').Page} page */
export async function sample(page) {
  const first = (await part(page, 'sample-first').isVisible()) ? 'sample-first' : 'sample';
  await enabled(page, first);
  await part(page, first).click();
  return done(page);
}

/** What a button saves, as text.  @param {import('playwright-core').Page} page @param {string} id */
export async function saved(page, id) {
  if (!(await part(page, id).isVisible())) await part(page, 'export-menu').click();
  const [download] = await Promise.all([page.waitForEvent('download'), part(page, id).click()]);
  const stream = await download.createReadStream();
  /** @type {Buffer[]} */
  const chunks = [];
  for await (const chunk of stream) chunks.push(/** @type {Buffer} */ (chunk));
  return Buffer.concat(chunks);
}

/** @param {string} name @param {Uint8Array} content @param {string} [mimeType] */
export const upload = (name, content, mimeType = 'application/octet-stream') => ({ name, mimeType, buffer: Buffer.from(content) });

/** Photos of a third of the area of the sample: they are matched in a third of its time. */
export const SMALL = { width_px: 270, height_px: 400 };

/** Two simulated photos as PNG files: small ones, or others than these.  @param {object} [flight] */
export const pngs = (flight = SMALL) => pairPhotos(flight).map(({ name, bytes }) => upload(name, bytes, 'image/png'));

/** Files as they are dropped.  @param {import('playwright-core').Page} page @param {{ name: string, mimeType: string, buffer: Buffer }[]} files */
export function transferOf(page, files) {
  const plain = files.map(({ name, mimeType, buffer }) => ({ name, mimeType, bytes: [...buffer] }));
  return page.evaluateHandle((given) => {
    const data = new DataTransfer();
    for (const { name, mimeType, bytes } of given) data.items.add(new File([new Uint8Array(bytes)], name, { type: mimeType }));
    return data;
  }, plain);
}

/** The camera of the simulated photos. */
export const CAMERA = upload('camera.json', Buffer.from('{"focal_mm": 153.38, "pixel_mm": 0.2542}'), 'application/json');

/** Gives a small pair with its camera, as a user does, and waits for it.  @param {import('playwright-core').Page} page */
export async function pair(page) {
  await part(page, 'file-input').setInputFiles([...pngs(), CAMERA]);
  return done(page);
}

/** Matches and refused points together.  @param {import('playwright-core').Page} page */
export async function verdicts(page) {
  let sum = await number(page, 'count-matches');
  for (const cell of await page.locator('[data-testid^="refused-"]').all()) sum += Number((await cell.textContent())?.replaceAll(/\D/g, ''));
  return sum;
}

/** Chooses a value of a setting and waits for the run that follows.  @param {import('playwright-core').Page} page @param {string} key @param {string} value */
export async function choose(page, key, value) {
  await page.locator(`select[data-key="${key}"]`).selectOption(value);
  await again(page);
}

/** Waits until a changed setting has been computed.  @param {import('playwright-core').Page} page */
export async function again(page) {
  // A run may have ended before it was seen to begin.
  await page
    .waitForFunction(() => !/^(done|partial)$/.test(document.querySelector('[data-testid="status"]')?.getAttribute('data-kind') ?? ''), undefined, {
      timeout: 10_000,
    })
    .catch(() => {});
  await done(page);
}

/** Waits until a part says something.  @param {import('playwright-core').Page} page @param {string} id @param {RegExp} pattern */
export async function says(page, id, pattern) {
  if (OF_RESULTS.test(id))
    await until(page, `${id} says ${pattern}`, async () => {
      await glance(page, id);
      return part(page, id).evaluateAll((parts, source) => parts.some(({ textContent }) => new RegExp(source).test(textContent)), pattern.source);
    });
  await page.waitForFunction(
    ([at = '', source = '', flags = '']) => new RegExp(source, flags).test(document.querySelector(`[data-testid="${at}"]`)?.textContent ?? ''),
    [id, pattern.source, pattern.flags],
  );
  return (await part(page, id).textContent()) ?? '';
}

/**
 * The parts of projects that the browser keeps whose names begin so, each with its project: files are empty objects. None while there is no database,
 * which must not come of the question: the page would find it without its stores.
 * @param {import('playwright-core').Page} page @param {string} start @param {boolean} [isWhole] with their values, which may have megabytes
 * @returns {Promise<{ project: string, part: string, value: any }[]>}
 */
export const rowsKept = (page, start, isWhole = true) =>
  page.evaluate(
    ([from, whole]) =>
      new Promise((resolve) => {
        const opening = indexedDB.open('tiepoint');
        opening.onupgradeneeded = () => opening.transaction?.abort();
        opening.onerror = () => resolve([]);
        opening.onsuccess = () => {
          const reading = opening.result.transaction('parts').objectStore('parts').getAll();
          reading.onsuccess = () => {
            opening.result.close();
            const named = reading.result.filter(({ part }) => part.startsWith(from));
            resolve(named.map(({ project, part, value }) => ({ project, part, value: whole ? value : null })));
          };
        };
      }),
    /** @type {const} */ ([start, isWhole]),
  );

/** The same parts by their names.  @param {import('playwright-core').Page} page @param {string} start @returns {Promise<Map<string, any>>} */
export const partsKept = async (page, start) => new Map((await rowsKept(page, start)).map(({ part, value }) => [part, value]));

/** The edits that the browser keeps under a name.  @param {import('playwright-core').Page} page @param {string} name @returns {Promise<{ done: number, edits: any[] }>} */
export async function journal(page, name) {
  const kept = await partsKept(page, name);
  const head = kept.get(name) ?? { done: 0, pieces: 0 };
  return { done: head.done, edits: Array.from({ length: head.pieces }, (_, i) => kept.get(`${name}/${i}`)).flat() };
}

/** Waits until so many edits are kept under a name.  @param {import('playwright-core').Page} page @param {string} name @param {number} edits @param {number} held */
export async function keptEdits(page, name, edits, held) {
  return until(page, `${edits} edits are kept`, async () => {
    const kept = await journal(page, name);
    return kept.edits.length === edits && kept.done === held ? kept : null;
  });
}

/** How many parts of these names the browser keeps.  @param {import('playwright-core').Page} page @param {string} name */
export const partsNamed = async (page, name) => (await rowsKept(page, name, false)).length;
