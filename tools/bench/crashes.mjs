/**
 * The page crashed at random moments while matches and a block are edited in all ways that are quick, and while a block is run, and opened again each time: no
 * edit that was kept is lost, undone or made again, none comes in another order, and a run goes on to what it gives where nothing breaks it off.
 */

import { chromium } from 'playwright-core';
import { servePage } from '../lib/page-server.mjs';
import { findChromium } from '../lib/setup.mjs';
import { blockPhotos } from '../../tests/page/rendered.js';
import { done, enabled, journal, openDrawers, pair, part, partsNamed, saved, until, upload } from '../../tests/page/page.js';
import { FLIGHT, status } from '../../tests/page/blocks.js';
import { drawn, OF_BLOCK, OF_PAIR } from './crash-edits.mjs';
import { acknowledged, countKinds, stateOf, watch, wrongWith } from './crash-states.mjs';
import { dice } from './dice.mjs';
import { numberOption } from './options.mjs';

/** @typedef {import('playwright-core').Page} Page @typedef {import('playwright-core').BrowserContext} Context */

const FLAGS = ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'];
const PATIENCE_MS = 60_000;
/** Edits go on for this long at most before a crash. */
const EDITING_MS = 12_000;
/** What an edit does is on the screen so soon. */
const AFTER_EDIT_MS = 120;
/** A run that goes on by itself is under way so soon. */
const SOON_MS = 500;
const FINISHED = /^(Oriented|Weak orientation|Not oriented|The block was)/;

export async function crashes() {
  const executablePath = findChromium();
  if (!executablePath) return console.log('Crashes of the page: skipped: no Chromium (install it or name it in CHROMIUM)');
  const wanted = numberOption('crashes', 20);
  const uniform = dice(numberOption('seed', 1));
  const server = await servePage();
  const browser = await chromium.launch({ executablePath, args: FLAGS });
  try {
    const context = async () => {
      const made = await browser.newContext({ viewport: { width: 1366, height: 768 }, serviceWorkers: 'block' });
      made.setDefaultTimeout(PATIENCE_MS);
      await made.addInitScript(openDrawers);
      return made;
    };
    const share = Math.max(1, Math.floor(wanted / 3));
    await editing(PAIR, await context(), server.url, share, uniform);
    await editing(BLOCK, await context(), server.url, share, uniform);
    await running(context, server.url, Math.max(1, wanted - 2 * share), uniform);
  } finally {
    await browser.close();
    await server.close();
  }
}

/** What is edited: how it is opened, found again, and of which edits one is drawn. @typedef {{ what: string, journal: string, history: string, open: (page: Page) => Promise<void>, again: (page: Page) => Promise<void>, kinds: import('./crash-edits.mjs').Kinds }} Edited */

/** @type {Edited} */
const PAIR = {
  what: 'matches were edited',
  journal: 'pair/edits',
  history: 'history',
  open: async (page) => {
    await pair(page);
    await part(page, 'tab-matches').click();
  },
  again: async (page) => {
    await restored(page, () => hasEdits(page, 'history'));
    await done(page);
    await part(page, 'tab-matches').click();
  },
  kinds: OF_PAIR,
};

/** @type {Edited} */
const BLOCK = {
  what: 'a block was edited',
  journal: 'block/edits',
  history: 'block-history',
  open: async (page) => {
    await blockOf(page);
    await part(page, 'block-run').click();
    await status(page, FINISHED);
    await part(page, 'tab-block-points').click();
    await part(page, 'block-show-images').click();
  },
  again: async (page) => {
    await restored(page, () => hasEdits(page, 'block-history'));
    await status(page, FINISHED);
    await part(page, 'tab-block-points').click();
    await part(page, 'block-show-images').click();
  },
  kinds: OF_BLOCK,
};

/** Gives the page the photos of a block.  @param {Page} page */
async function blockOf(page) {
  await part(page, 'mode-block').click();
  await enabled(page, 'block-simulate');
  await part(page, 'block-files-input').setInputFiles(blockPhotos(FLIGHT).map(({ name, bytes }) => upload(name, bytes, 'image/png')));
  await status(page, /Press Run/);
}

/** The tab breaks off, and another one is opened at its address.  @param {Page} page */
async function crash(page) {
  const session = await page.context().newCDPSession(page);
  await Promise.race([session.send('Page.crash').catch(() => undefined), page.waitForEvent('crash')]);
}

/** Waits until what was kept is on the page again; where it broke off twice in a row, the page asks before it opens it.  @param {Page} page @param {() => Promise<boolean>} isThere */
async function restored(page, isThere) {
  for (const end = Date.now() + PATIENCE_MS; Date.now() < end; await page.waitForTimeout(100)) {
    await page.evaluate(() => /** @type {HTMLElement | null} */ (document.querySelector('[data-testid="keeping-open"]'))?.click());
    if (await isThere()) return;
  }
  const said = await page.evaluate(() => document.body.innerText.slice(0, 500));
  throw new Error(`what was kept is not on the page again: ${said}`);
}

/** Whether the page shows edits, be they undone.  @param {Page} page @param {string} of */
const hasEdits = async (page, of) => ((await stateOf(page, of))?.names.length ?? 0) > 0;

/** The edits that are kept, once the page has kept what it shows; the state and they.  @param {Page} page @param {Edited} edited @returns {Promise<[import('./crash-states.mjs').State, string]>} */
async function settled(page, edited) {
  for (const end = Date.now() + PATIENCE_MS; ; await page.waitForTimeout(100)) {
    const [state, { edits, done: held }] = [await stateOf(page, edited.history), await journal(page, edited.journal)];
    if (state !== null && held === state.held && edits.length === state.names.length) return [state, JSON.stringify(edits)];
    if (Date.now() > end) throw new Error(`${edits.length} edits are kept, ${held} of which hold, and others shown: ${JSON.stringify(state)}`);
  }
}

/** @param {Edited} edited @param {Context} context @param {string} url @param {number} wanted @param {() => number} uniform */
async function editing(edited, context, url, wanted, uniform) {
  let page = await context.newPage();
  await page.goto(url);
  await edited.open(page);
  // What was found is kept before it is edited.
  await edited.kinds[0]?.[1](page, uniform);
  await until(page, 'an edit is kept', async () => (await journal(page, edited.journal)).edits.length > 0);
  let [made, acknowledgedSteps, lost] = [0, 0, 0];
  /** @type {Map<string, number>} */
  const kinds = new Map();
  for (let k = 0; k < wanted; k += 1) {
    const present = page;
    const [start, kept] = await settled(present, edited);
    /** @type {import('./crash-states.mjs').Seen[]} */
    const seen = [{ state: start, key: JSON.stringify(start), at: performance.now(), kept }];
    const ending = { isOver: false };
    const moment = uniform() * EDITING_MS;
    const breaking = new Promise((resolve) => setTimeout(resolve, moment)).then(async () => {
      ending.isOver = true;
      const at = performance.now();
      await crash(present);
      return at;
    });
    const working = (async () => {
      while (!ending.isOver) {
        await drawn(edited.kinds, uniform)(present, uniform);
        await present.waitForTimeout(AFTER_EDIT_MS);
      }
    })();
    const all = Promise.all([working, watch(present, edited.history, edited.journal, ending, seen)]).catch((error) => {
      // What is asked of a page that has crashed is never answered.
      if (!ending.isOver) throw error;
    });
    const at = await Promise.race([breaking, all.then(() => breaking)]);
    await Promise.race([all, new Promise((resolve) => setTimeout(resolve, 2000))]);
    await present.close().catch(() => undefined);
    page = await context.newPage();
    await page.goto(url);
    await edited.again(page);
    const first = acknowledged(seen, at);
    const wrong = wrongWith(seen, first, ...(await settled(page, edited)));
    countKinds(seen, kinds);
    made += seen.length - 1;
    acknowledgedSteps += first;
    if (wrong !== '') {
      lost += 1;
      console.log(`  ${edited.what}: after ${(moment / 1000).toFixed(1)} s the page came back with ${wrong}`);
    }
  }
  const drew = [...kinds].map(([kind, count]) => `${kind} ${count}`).join(', ');
  console.log(
    `The page crashed ${wanted} times at random moments while ${edited.what}: ${made} steps were shown (${drew}), ${acknowledgedSteps} of them kept before a crash; edits were lost in ${lost} crashes`,
  );
  await context.close();
  if (lost > 0) throw new Error('an edit was lost that had been kept');
}

/** The block as a project file.  @param {Page} page */
async function project(page) {
  await part(page, 'block-export-kind').selectOption('project');
  return saved(page, 'block-export');
}

/** @param {Page} page */
const isRunning = (page) => page.evaluate(() => document.querySelector('[data-testid="block-cancel"]:enabled') !== null);

/** @param {() => Promise<Context>} fresh @param {string} url @param {number} wanted @param {() => number} uniform */
async function running(fresh, url, wanted, uniform) {
  const begun = async () => {
    const page = await (await fresh()).newPage();
    await page.goto(url);
    await blockOf(page);
    // Files that are not kept yet when the tab breaks off have to be given again.
    await until(page, 'the photographs are kept', async () => (await partsNamed(page, 'block/file/')) >= FLIGHT.strips * FLIGHT.exposures);
    return page;
  };
  const whole = await begun();
  const began = performance.now();
  await part(whole, 'block-run').click();
  const line = await status(whole, FINISHED);
  const took = performance.now() - began;
  const expected = await project(whole);
  await whole.context().close();
  let [crashed, blocks, wrong, resumed] = [0, 0, 0, 0];
  while (crashed < wanted) {
    let page = await begun();
    let kept = 0;
    for (;;) {
      // A run that had made something goes on by itself.
      if (!(await isRunning(page))) await part(page, 'block-run').click();
      const ended = status(page, FINISHED).then(
        () => true,
        () => false,
      );
      const moment = uniform() * took;
      const first = crashed < wanted ? await Promise.race([ended, new Promise((resolve) => setTimeout(resolve, moment, null))]) : await ended;
      if (first !== null) break;
      kept = await partsNamed(page, 'block/record/').catch(() => kept);
      await crash(page);
      crashed += 1;
      const context = page.context();
      await page.close().catch(() => undefined);
      page = await context.newPage();
      await page.goto(url);
      const opened = page;
      await restored(
        opened,
        async () =>
          (await isRunning(opened)) ||
          // It is not there before the part of the block is.
          opened.evaluate(() => /Restored from this browser/.test(document.querySelector('[data-testid="block-status"]')?.textContent ?? '')),
      );
      await opened.waitForTimeout(SOON_MS);
      if ((await partsNamed(page, 'block/record/')) < kept) throw new Error('the work of a run was lost that had been kept');
    }
    const stage = (await part(page, 'stage-images').textContent()) ?? '';
    if (/from an earlier run/.test(stage)) resumed += 1;
    if (!(await project(page)).equals(expected)) wrong += 1;
    blocks += 1;
    await page.context().close();
  }
  console.log(
    `The page crashed ${crashed} times at random moments within a run of ${(took / 1000).toFixed(1)} s, which went on by itself, or was started again where it had made nothing: ${blocks - wrong} of ${blocks} blocks ended with the bytes of an uninterrupted run, ${resumed} went on with images of an earlier one (${line})`,
  );
  if (wrong > 0) throw new Error('a run that was broken off and started again gave another block');
}
