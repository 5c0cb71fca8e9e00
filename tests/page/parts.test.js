/** The parts of the page: what a first view loads, and what happens where a part cannot be had. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { hosted, open, part, says, singleUrl, SKIP } from './page.js';

hosted();

/** The scripts that a page has asked for.  @param {import('playwright-core').Page} page */
const scripts = (page) =>
  page.evaluate(() => [
    ...new Set(
      performance
        .getEntriesByType('resource')
        .map(({ name }) => name.split('/').at(-1) ?? '')
        .filter((name) => name.endsWith('.js')),
    ),
  ]);

test('a first view loads no block, no licences and one language; they come when they are asked for', { skip: SKIP }, async () => {
  for (const [locale, ready, own, other] of /** @type {const} */ ([
    ['en', /^Ready/, 'en', 'ar'],
    ['ar', /^جاهز/, 'ar', 'en'],
  ])) {
    const { page, complaints, close } = await open({ options: { locale } });
    await says(page, 'status', ready);
    const first = await scripts(page);
    // The document asks for what the first view needs alone; the rest is fetched once that is drawn.
    assert.doesNotMatch(await page.evaluate(async () => (await fetch(document.baseURI)).text()), /program\.js/u);
    assert.ok(first.includes('program.js') && first.includes(`${own}.js`), first.join());
    for (const late of ['block.js', 'about.js', `${own}-block.js`, `${other}.js`]) assert.ok(!first.includes(late), late);
    await part(page, 'mode-block').click();
    await part(page, 'block-welcome').waitFor();
    await part(page, 'about').click();
    await part(page, 'licence-idb').waitFor();
    const then = await scripts(page);
    for (const late of ['block.js', 'about.js', `${own}-block.js`]) assert.ok(then.includes(late), late);
    assert.ok(!then.some((name) => name.startsWith(other)), then.join());
    assert.deepEqual(complaints, []);
    await close();
  }
});

test('it starts where no frame is drawn, as in a frame of another page that is out of sight', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await page.addInitScript(() => {
    window.requestAnimationFrame = () => 0;
  });
  await page.reload();
  await page.waitForFunction(() => /^Ready/.test(document.querySelector('[data-testid="status"]')?.textContent ?? ''), null, { polling: 100, timeout: 60_000 });
  assert.deepEqual(complaints, []);
  await close();
});

test('a part that cannot be had is said, and tried again', { skip: SKIP }, async () => {
  const { page, close } = await open();
  await says(page, 'status', /^Ready/);
  for (const file of ['en-block.js', 'block.js']) {
    await page.route(`**/${file}`, (route) => route.abort());
    await part(page, 'mode-block').click();
    await says(page, 'status', new RegExp(`The part of the page for blocks is not there: .*, ${file}, could not be loaded`));
    await page.unroute(`**/${file}`);
  }
  await part(page, 'mode-block').click();
  await part(page, 'block-welcome').waitFor();
  await page.route('**/about.js', (route) => route.fulfill({ status: 503 }));
  await part(page, 'about').click();
  await says(page, 'about', /about\.js, could not be loaded: HTTP 503/);
  await page.unroute('**/about.js');
  await part(page, 'about').click();
  await part(page, 'about-dialog').waitFor();
  await close();
});

test('a page whose program cannot be had says so, and starts anew', { skip: SKIP }, async () => {
  const { page, close } = await open();
  await says(page, 'status', /^Ready/);
  await page.route('**/program.js', (route) => route.abort());
  await page.reload();
  await part(page, 'load-again').waitFor();
  await page.unroute('**/program.js');
  await part(page, 'load-again').click();
  await says(page, 'status', /^Ready/);
  await close();
});

test('the page in one file has all parts in it', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ url: singleUrl(), options: { offline: true, locale: 'ar' } });
  await says(page, 'status', /^جاهز/);
  await part(page, 'mode-block').click();
  await part(page, 'block-welcome').waitFor();
  await part(page, 'about').click();
  await part(page, 'licence-idb').waitFor();
  assert.deepEqual(complaints, []);
  await close();
});

/** A page that is never quiet. It runs in the page. */
function keepBusy() {
  window.requestIdleCallback = () => 0;
}

test('settings are there for who looks for them before the page is quiet', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ fresh: true });
  await page.addInitScript(keepBusy);
  const made = () => page.locator('#panel-settings [data-key]').count();
  const anew = async () => {
    await page.reload();
    await says(page, 'status', /^Ready/);
    assert.equal(await made(), 0);
  };
  await anew();
  await page.keyboard.press('Control+k');
  await part(page, 'search-text').fill('strategy setting');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.activeElement?.getAttribute('data-key') === 'matching.strategy');
  await part(page, 'close-settings').click();
  await anew();
  await part(page, 'settings').click();
  assert.ok((await made()) > 20);
  assert.deepEqual(complaints, []);
  await close();
});
