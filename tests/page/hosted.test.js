import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { sample as samplePair, sample_seed } from '../../pkg/node.js';
import { greyPng } from '../../pkg/command/png.js';
import { done, hosted, number, open, part, ROOT, sample, saved, SHOTS, SKIP } from './page.js';

hosted('/some/folder/');

/** @param {string} name @param {Uint8Array} content @param {string} [mimeType] */
const upload = (name, content, mimeType = 'application/octet-stream') => ({ name, mimeType, buffer: Buffer.from(content) });

/** The sample pair as two PNG files. */
function pngs() {
  const { left, right } = samplePair(sample_seed());
  const png = (/** @type {{ width: number, height: number, grey: Uint8Array }} */ i) => greyPng(i.width, i.height, i.grey);
  return [upload('left.png', png(left), 'image/png'), upload('right.png', png(right), 'image/png')];
}

test('the sample pair is matched and oriented, from a subfolder under the policy', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await sample(page);
  assert.ok(await number(page, 'count-matches') > 500);
  const refused = ['threshold', 'ambiguous', 'many_to_one', 'parallax', 'no_descriptor', 'no_candidate'];
  let sum = await number(page, 'count-matches');
  for (const rule of refused) sum += await number(page, `refused-${rule}`);
  assert.equal(sum, await number(page, 'count-left-after_suppression'));
  await page.screenshot({ path: join(SHOTS, 'sample.png') });
  assert.deepEqual(complaints, []);
  await close();
});

test('the browser finds the matches of the golden file', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await sample(page);
  await part(page, 'tab-settings').click();
  const field = page.locator('input[data-key="points.fraction"]:not([type="range"])').first();
  await field.fill('0.148');
  await field.press('Enter');
  await page.waitForFunction(() => !document.querySelector('[data-testid="status"]')?.textContent?.startsWith('Done'), undefined, { timeout: 10_000 }).catch(() => {});
  await done(page);
  const csv = (await saved(page, 'export-csv')).toString();
  // The golden file ends with a line of the orientation.
  const golden = readFileSync(join(ROOT, 'tests', 'golden', 'sample.csv'), 'utf8').split('\n').slice(0, -2).join('\n');
  assert.equal(csv.trimEnd(), golden);
  const everything = JSON.parse((await saved(page, 'export-json')).toString());
  assert.ok(everything !== null && typeof everything === 'object');
  assert.equal((await saved(page, 'export-png')).subarray(1, 4).toString(), 'PNG');
  assert.deepEqual(complaints, []);
  await close();
});

test('two files are opened, matched, and a parameter recomputes what depends on it', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await part(page, 'file-input').setInputFiles(pngs());
  await done(page);
  const before = { points: await number(page, 'count-left-after_suppression'), matches: await number(page, 'count-matches') };
  assert.ok(before.matches > 500);
  const field = page.locator('input[data-key="matching.max_measure"]:not([type="range"])').first();
  await field.fill('2');
  await field.press('Enter');
  await page.waitForFunction((matches) => Number(document.querySelector('[data-testid="count-matches"]')?.textContent?.replaceAll(/\D/g, '')) !== matches, before.matches, { timeout: 20_000 });
  assert.ok(await number(page, 'count-matches') < before.matches);
  assert.equal(await number(page, 'count-left-after_suppression'), before.points);
  assert.deepEqual(complaints, []);
  await close();
});

test('dropped files are opened', { skip: SKIP }, async () => {
  const { page, close } = await open();
  const files = pngs().map(({ name, mimeType, buffer }) => ({ name, mimeType, bytes: [...buffer] }));
  const transfer = await page.evaluateHandle((given) => {
    const data = new DataTransfer();
    for (const { name, mimeType, bytes } of given) data.items.add(new File([new Uint8Array(bytes)], name, { type: mimeType }));
    return data;
  }, files);
  for (const type of ['dragenter', 'dragover', 'drop']) await part(page, 'view').dispatchEvent(type, { dataTransfer: transfer });
  await done(page);
  assert.ok(await number(page, 'count-matches') > 500);
  await close();
});

test('a bad file is named and what was there stays', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await sample(page);
  const matches = await number(page, 'count-matches');
  const [good] = pngs();
  assert.ok(good);
  const cut = upload('cut.png', good.buffer.subarray(0, 2000), 'image/png');
  await part(page, 'file-input').setInputFiles([cut]);
  await page.waitForFunction(() => document.body.textContent?.includes('cut.png'), undefined, { timeout: 10_000 });
  await page.waitForTimeout(500);
  assert.match((await page.locator('body').textContent()) ?? '', /cut\.png/);
  assert.equal(await number(page, 'count-matches'), matches);
  await page.screenshot({ path: join(SHOTS, 'bad-file.png') });
  assert.deepEqual(complaints.filter((c) => c.startsWith('uncaught')), []);
  await close();
});

test('a run can be cancelled and started again', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await part(page, 'sample').click();
  await part(page, 'cancel').click({ timeout: 5000 });
  await page.waitForFunction(() => /cancel/i.test(document.querySelector('[data-testid="status"]')?.textContent ?? ''), undefined, { timeout: 5000 });
  const again = part(page, 'run');
  if (await again.isVisible()) await again.click();
  else await part(page, 'sample').click();
  await done(page);
  assert.ok(await number(page, 'count-matches') > 500);
  assert.deepEqual(complaints, []);
  await close();
});

test('a click and a key choose points, which tell their rule, moments and candidates', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await sample(page);
  await part(page, 'view').focus();
  await page.keyboard.press('n');
  await part(page, 'tab-point').click();
  // The first point lies at the upper border, where no window fits.
  await page.waitForFunction(() => /no moments/.test(document.querySelector('[data-testid="point-verdict"]')?.textContent ?? ''));
  const box = await part(page, 'view').boundingBox();
  assert.ok(box);
  await page.mouse.click(box.x + box.width * 0.25, box.y + box.height * 0.5);
  await part(page, 'point-candidates').waitFor();
  assert.ok(await page.locator('[data-testid="point-candidates"] tbody tr').count() > 0);
  assert.match((await part(page, 'point-moments').textContent()) ?? '', /µ/);
  await page.screenshot({ path: join(SHOTS, 'point.png') });
  assert.deepEqual(complaints, []);
  await close();
});

for (const [name, width, height, colorScheme] of /** @type {const} */ ([['narrow', 360, 740, 'light'], ['tablet', 820, 1180, 'dark'], ['wide', 3840, 2160, 'light']])) {
  test(`a ${name} screen shows everything without scrolling sideways`, { skip: SKIP }, async () => {
    const { page, complaints, close } = await open({ options: { viewport: { width, height }, colorScheme } });
    await sample(page);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth));
    await page.screenshot({ path: join(SHOTS, `${name}.png`) });
    assert.deepEqual(complaints, []);
    await close();
  });
}
