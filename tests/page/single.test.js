import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { hosted, number, open, sample, saved, SHOTS, singleUrl, SKIP } from './page.js';

hosted();

/** Runs in the page: text that becomes markup by itself, which Trusted Types refuse. */
const injected = () => {
  try {
    document.createElement('div').innerHTML = '<img src=x onerror=alert(1)>';
    return 'taken';
  } catch (error) {
    return /** @type {Error} */ (error).name;
  }
};

test('text does not become markup or a script of the page, in one file or on a host', { skip: SKIP }, async () => {
  for (const options of [{}, { url: singleUrl() }]) {
    const { page, close } = await open(options);
    assert.equal(await page.evaluate(injected), 'TypeError');
    await close();
  }
});

test('the page in one file runs from a double-click, alone and offline', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ url: singleUrl(), options: { offline: true } });
  await sample(page);
  assert.ok((await number(page, 'count-matches')) > 500);
  assert.match((await saved(page, 'export-csv')).toString(), /^x_left_px,/);
  await page.screenshot({ path: join(SHOTS, 'single.png') });
  assert.deepEqual(complaints, []);
  await close();
});
