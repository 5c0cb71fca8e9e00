/** Edits of the matches by hand, by mouse and by keyboard: what is rejected, undone and kept. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { open_pair_project, write_pair_project } from '../../pkg/node.js';
import { again, done, enabled, hosted, keptEdits, number, open, pair, part, sample, saved, says, SKIP, until, upload } from './page.js';

hosted();

/** @typedef {import('playwright-core').Page} Page */

/** Draws a rectangle in the left image; with Shift, or by the tool.  @param {Page} page */
async function enclose(page, shift = true) {
  const box = await part(page, 'pane-left').boundingBox();
  assert.ok(box);
  const at = (/** @type {number} */ share) => /** @type {[number, number]} */ ([box.x + box.width * share, box.y + box.height * share]);
  if (shift) await page.keyboard.down('Shift');
  await page.mouse.move(...at(0.4));
  await page.mouse.down();
  await page.mouse.move(...at(0.5));
  await page.mouse.move(...at(0.6));
  await page.mouse.up();
  if (shift) await page.keyboard.up('Shift');
}

/** The orientation of the latest edit is there.  @param {Page} page */
const oriented = (page) => says(page, 'compared-points-now', /\d/);

/** What was done is drawn, and what that changes is told.  @param {Page} page */
const drawn = (page) => page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => resolve(null)))));

/** Matches as the button saves them.  @param {Page} page */
const csv = async (page) => (await saved(page, 'export-csv')).toString();
const rows = (/** @type {string} */ text) => text.trim().split('\n').length - 1;

test('an edit asks for its orientation before anything is drawn, and moves neither pictures nor list', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  await part(page, 'tab-matches').click();
  await part(page, 'statistics-row').nth(3).click();
  await enabled(page, 'reject');
  // With the first edit its buttons come.
  await part(page, 'view').focus();
  await page.keyboard.press('Delete');
  await oriented(page);
  await done(page);
  // What is said of the selected point is true after the edit, too.
  await says(page, 'selected', /^Left point \d+ at [\d.]+, [\d.]+ px\. Matched, then rejected by hand\./);
  await page.evaluate(() => {
    const seen = { asked: /** @type {string[]} */ ([]), resized: 0, heads: 0, rows: 0 };
    Object.assign(window, { seen });
    const post = Worker.prototype.postMessage;
    Worker.prototype.postMessage = function (/** @type {any} */ message, /** @type {any} */ ...more) {
      seen.asked.push(message.call);
      return post.call(this, message, ...more);
    };
    const at = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.querySelector(`[data-testid="${id}"]`));
    // What is observed is told once to begin with.
    let begun = false;
    new ResizeObserver(() => {
      if (begun) seen.resized += 1;
      begun = true;
    }).observe(at('view'));
    new MutationObserver((changes) => {
      seen.heads += changes.length;
    }).observe(/** @type {HTMLElement} */ (at('statistics').querySelector('thead')), { childList: true });
    // Rows come and go together.
    new MutationObserver(() => {
      seen.rows += 1;
    }).observe(/** @type {HTMLElement} */ (at('statistics').querySelector('tbody')), { childList: true });
  });
  await drawn(page);
  const asked = await page.evaluate(() => {
    const { seen } = /** @type {any} */ (window);
    document.querySelector('[data-testid="view"]')?.dispatchEvent(new KeyboardEvent('keydown', { key: 'r', bubbles: true, cancelable: true }));
    return [...seen.asked];
  });
  assert.ok(asked.includes('orient'), `asked for ${asked.join(' ')}`);
  await done(page);
  await until(page, 'the list is drawn', () => page.evaluate(() => /** @type {any} */ (window).seen.rows > 0));
  await drawn(page);
  await drawn(page);
  const { resized, heads, rows: draws } = await page.evaluate(() => /** @type {any} */ (window).seen);
  // With the figures of the new orientation, not before, and with the selected row in sight, which is another one.
  assert.deepEqual({ resized, heads, draws }, { resized: 0, heads: 0, draws: 1 });
  assert.deepEqual(complaints, []);
  await close();
});

test('an edit draws no panel that is not in sight; it is up to date when it is shown', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  const before = await number(page, 'count-matches');
  await part(page, 'tab-matches').click();
  await part(page, 'statistics-row').nth(3).click();
  await enabled(page, 'reject');
  await page.evaluate(() => {
    const drawn = new Set();
    Object.assign(window, { drawn });
    for (const id of ['panel-results', 'panel-point'])
      new MutationObserver((changes) => {
        for (const { target } of changes) if (target instanceof Element && target.id !== id) drawn.add(id);
      }).observe(/** @type {Element} */ (document.getElementById(id)), { childList: true, subtree: true });
  });
  await part(page, 'view').focus();
  await page.keyboard.press('Delete');
  await oriented(page);
  await done(page);
  await drawn(page);
  assert.deepEqual(await page.evaluate(() => [.../** @type {any} */ (window).drawn]), []);
  await part(page, 'tab-results').click();
  assert.equal(await part(page, 'count-matches').textContent(), String(before - 1).replace(/\B(?=\d{3}$)/, '\u202f'));
  assert.deepEqual(complaints, []);
  await close();
});

test('matches in a rectangle are rejected, the orientation follows, and after a reload all of it is undone to the byte', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  const before = { csv: await csv(page), project: await saved(page, 'export-project'), line: (await part(page, 'status').textContent())?.split('.')[0] };
  await part(page, 'tab-matches').click();
  assert.ok(await part(page, 'reject').isDisabled());
  assert.ok(await part(page, 'undo').isHidden());
  await enclose(page);
  const text = await says(page, 'reject', /^Reject \d+$/);
  const count = Number(text.replace(/\D/g, ''));
  await page.keyboard.press('Delete');
  await oriented(page);
  assert.equal(await part(page, 'undo').textContent(), `Undo: reject ${count} matches`);
  assert.equal(await part(page, 'restore').textContent(), `Restore ${count}`);
  assert.ok((await number(page, 'compared-points-now')) < (await number(page, 'compared-points-before')));
  assert.equal(rows(await csv(page)), rows(before.csv) - count);
  const everything = JSON.parse((await saved(page, 'export-json')).toString());
  assert.equal(everything.edits.rejected_by_hand.length, count);
  assert.equal(everything.matches.length, rows(before.csv) - count);
  await part(page, 'tab-results').click();
  assert.equal(await number(page, 'count-rejected-by-hand'), count);
  // Listed apart from what the adjustment rejected.
  await part(page, 'tab-matches').click();
  await part(page, 'statistics-filter').selectOption('by-hand');
  await says(page, 'statistics-caption', new RegExp(`: ${count} of `));
  assert.match((await part(page, 'statistics').textContent()) ?? '', /rejected by hand/);
  // Another one, by the list: then the tab is loaded anew.
  await part(page, 'statistics-filter').selectOption('used');
  await part(page, 'statistics-row').first().click();
  await page.keyboard.press('Delete');
  await says(page, 'undo', /^Undo: reject 1 match$/);
  await keptEdits(page, 'pair/edits', 2, 2);
  await page.reload();
  await says(page, 'status', /Restored from this browser/);
  await part(page, 'tab-matches').click();
  await says(page, 'undo', /^Undo: reject 1 match$/);
  assert.equal(rows(await csv(page)), rows(before.csv) - count - 1);
  await page.keyboard.press('Control+z');
  await says(page, 'undo', new RegExp(`^Undo: reject ${count} matches$`));
  await page.keyboard.press('Control+z');
  await says(page, 'redo', new RegExp(`^Redo: reject ${count} matches$`));
  assert.ok(await part(page, 'undo').isDisabled());
  await done(page);
  assert.equal(await csv(page), before.csv);
  await page.waitForFunction(() => /\d/.test(document.querySelector('[data-testid="compared-points-now"]')?.textContent ?? ''));
  assert.equal((await saved(page, 'export-project')).toString(), before.project.toString());
  assert.equal((await part(page, 'status').textContent())?.split('.')[0], before.line);
  assert.deepEqual(complaints, []);
  await close();
});

test('matches are chosen, rejected, restored, undone and done again by the keyboard alone', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await enabled(page, 'sample');
  await part(page, 'sample').focus();
  await page.keyboard.press('Enter');
  await done(page);
  await part(page, 'view').focus();
  const all = await number(page, 'count-matches');
  const isRejecting = () => part(page, 'reject').isEnabled();
  /** The next point that was matched. */
  const next = async () => {
    await part(page, 'view').focus();
    for (let i = 0; i < 50; i++) {
      await page.keyboard.press('n');
      if (await isRejecting()) return;
    }
    assert.fail('there is no match');
  };
  await next();
  await page.keyboard.press('x');
  await next();
  await page.keyboard.press('x');
  assert.equal(await part(page, 'reject').textContent(), 'Reject 2');
  await page.keyboard.press('Delete');
  await says(page, 'count-matches', new RegExp(`^${String(all - 2).replace(/\B(?=\d{3}$)/, '\u202f')}$`));
  await page.keyboard.press('r');
  await says(page, 'count-matches', new RegExp(`^${String(all).replace(/\B(?=\d{3}$)/, '\u202f')}$`));
  assert.equal(await part(page, 'tool-undo').getAttribute('aria-label'), 'Undo: restore 2 matches');
  await page.keyboard.press('Control+z');
  assert.equal(await part(page, 'tool-undo').getAttribute('aria-label'), 'Undo: reject 2 matches');
  await page.keyboard.press('Control+Shift+z');
  assert.equal(await part(page, 'tool-undo').getAttribute('aria-label'), 'Undo: restore 2 matches');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+y');
  assert.equal(await part(page, 'tool-undo').getAttribute('aria-label'), 'Undo: restore 2 matches');
  // The history is a list: any state is gone to.
  await part(page, 'tab-matches').focus();
  await page.keyboard.press('Enter');
  await part(page, 'history-section').locator('summary').focus();
  await page.keyboard.press('Enter');
  await part(page, 'history-1').focus();
  await page.keyboard.press('Enter');
  await says(page, 'redo', /^Redo: restore 2 matches$/);
  assert.equal(await part(page, 'history-1').getAttribute('aria-current'), 'step');
  assert.equal(await page.evaluate(() => document.activeElement?.getAttribute('data-testid')), 'history-1');
  // In a field Ctrl+Z belongs to the field.
  await part(page, 'tab-settings').click();
  await page.locator('input[type="number"]:visible').first().focus();
  await page.keyboard.press('Control+z');
  assert.match((await part(page, 'undo').textContent()) ?? '', /reject 2 matches/);
  // A tool draws the rectangle without Shift, and Escape ends it.
  await part(page, 'view').focus();
  await page.keyboard.press('s');
  assert.equal(await part(page, 'tool-choose').getAttribute('aria-pressed'), 'true');
  await enclose(page, false);
  await says(page, 'reject', /^Reject \d+$/);
  // Whoever chooses in the pictures finds the button there.
  assert.equal(await part(page, 'tool-reject').textContent(), await part(page, 'reject').textContent());
  await page.keyboard.press('Escape');
  assert.equal(await part(page, 'tool-choose').getAttribute('aria-pressed'), 'false');
  await page.keyboard.press('Escape');
  await says(page, 'reject', /^Reject$/);
  assert.ok(await part(page, 'tool-reject').isHidden());
  assert.deepEqual(complaints, []);
  await close();
});

test('a file holds the edits, which are undone elsewhere, or says that it does not; a new run keeps the rejections', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  await enclose(page);
  await says(page, 'reject', /^Reject \d+$/);
  await page.keyboard.press('Delete');
  await done(page);
  await oriented(page);
  const left = await number(page, 'count-matches');
  const rejected = await number(page, 'count-rejected-by-hand');
  const project = await saved(page, 'export-project');
  const kept = open_pair_project(project);
  const { output } = kept;
  assert.equal(output.match.matches.length, 5 * left);
  assert.equal(output.orientation?.residuals_mm.length, 4 * left);
  const fresh = await open();
  await enabled(fresh.page, 'sample');
  await part(fresh.page, 'file-input').setInputFiles([upload('pair.tiepoint', project)]);
  assert.doesNotMatch(await says(fresh.page, 'status', /was opened/), /history/);
  assert.equal(await number(fresh.page, 'count-matches'), left);
  assert.equal(await number(fresh.page, 'count-rejected-by-hand'), rejected);
  assert.equal((await lastMatch(fresh.page)).edits.rejected_by_hand.length, rejected);
  assert.equal((await saved(fresh.page, 'export-project')).toString(), project.toString());
  await part(fresh.page, 'view').focus();
  await fresh.page.keyboard.press('Control+z');
  await until(fresh.page, 'the rejection is undone', async () => (await number(fresh.page, 'count-matches')) === left + rejected);
  assert.ok(await part(fresh.page, 'count-rejected-by-hand').isHidden());
  await part(fresh.page, 'file-input').setInputFiles([upload('former.tiepoint', Buffer.from(write_pair_project({ ...kept, edited: null })))]);
  const told = await says(fresh.page, 'status', /former.tiepoint was opened/);
  assert.match(told, new RegExp(`It holds ${rejected} matches rejected by hand; the history of these edits is not in the file`));
  assert.deepEqual(fresh.complaints, []);
  await fresh.close();
  // Another rule, other matches: what was rejected stays so where it is found again.
  await part(page, 'tab-settings').click();
  await page.locator('select[data-key="matching.refine"]').selectOption('least-squares');
  await again(page);
  const line = await says(page, 'status', /Kept: \d+ match(es)? rejected by hand/);
  assert.ok(Number(/Kept: (\d+)/.exec(line)?.[1]) > rejected / 2, line);
  assert.deepEqual(complaints, []);
  await close();
});

/** Where the points of the draft lie, as the bar says.  @param {Page} page */
async function drafted(page) {
  const text = await says(page, 'draft-text', /right −?\d/);
  const [, x, y, u, v] = /left ([\d.]+), ([\d.]+) · right ([\d.]+), ([\d.]+)/.exec(text) ?? [];
  return /** @type {[number, number, number, number]} */ ([x, y, u, v].map(Number));
}

/** The same once the right point is there: the bar is written with the next frame.  @param {Page} page @param {[number, number]} right */
async function draftedNear(page, right) {
  return until(page, `the right point is drafted at ${String(right)}`, async () => {
    const now = await drafted(page);
    return Math.abs(now[2] - right[0]) < 0.011 && Math.abs(now[3] - right[1]) < 0.011 && now;
  });
}

/** The last match of the exported JSON, and what it says of edits.  @param {Page} page @returns {Promise<{ match: [number, number, number, number, number], edits: any, count: number }>} */
async function lastMatch(page) {
  const { matches, edits } = JSON.parse((await saved(page, 'export-json')).toString());
  return { match: matches.at(-1), edits, count: matches.length };
}

test('a match is measured by mouse: the second point is expected on the epipolar line, fitted, accepted, and moved', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  const all = await number(page, 'count-matches');
  await part(page, 'tool-measure').click();
  const box = await part(page, 'pane-left').boundingBox();
  assert.ok(box);
  await page.mouse.click(box.x + 0.6 * box.width, box.y + 0.55 * box.height);
  const [x, y, u, v] = await drafted(page);
  // The simulated photos are nearly alike.
  assert.ok(Math.hypot(u - x, v - y) < 10, `${u}, ${v}`);
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Shift+ArrowUp');
  const moved = await draftedNear(page, [u + 0.1, v - 1]);
  assert.deepEqual(moved.slice(0, 2), [x, y]);
  await part(page, 'draft-accept').click();
  await says(page, 'undo', /^Undo: add 1 match$/);
  const added = await lastMatch(page);
  assert.deepEqual(added.match, [...moved, -1]);
  assert.deepEqual([added.count, added.edits.measured_by_hand], [all + 1, [all]]);
  assert.match((await csv(page)).trim().split('\n').at(-1) ?? '', /,-1(\.0)?,(used|rejected)$/);
  await part(page, 'tab-results').click();
  assert.equal(await number(page, 'count-manual'), 1);
  // What was measured is selected: its right point is moved, and Escape gives that up.
  await part(page, 'tab-point').click();
  await says(page, 'point-verdict', /Measured by hand|rejected from the relative orientation/);
  await part(page, 'view').focus();
  await page.keyboard.press('Escape');
  await page.keyboard.press('e');
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('Escape');
  assert.ok(await part(page, 'draft').isHidden());
  assert.deepEqual((await lastMatch(page)).match, added.match);
  await part(page, 'view').focus();
  await page.keyboard.press('e');
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('Enter');
  await says(page, 'undo', /^Undo: move 1 match$/);
  const { match } = await lastMatch(page);
  assert.ok(Math.abs(match[2] - added.match[2] + 0.1) < 0.011, `${match} ${added.match}`);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await done(page);
  assert.equal(await number(page, 'count-matches'), all);
  assert.deepEqual(complaints, []);
  await close();
});

test('keys that nothing has are left to the browser; a match of the list is moved by keys, and from a button of the bar', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  const held = () => page.evaluate(() => document.activeElement?.getAttribute('data-testid') ?? document.activeElement?.tagName);
  assert.equal(await held(), 'BODY');
  await page.evaluate(() => {
    addEventListener('keydown', ({ key, defaultPrevented }) => Object.assign(globalThis, { pressed: [key, defaultPrevented] }));
  });
  for (const key of ['ArrowDown', 'n', 'w']) {
    await page.keyboard.press(key);
    assert.deepEqual(await page.evaluate(() => Reflect.get(globalThis, 'pressed')), [key, false]);
  }
  assert.doesNotMatch((await part(page, 'selected').textContent()) ?? '', /point/);
  assert.equal(await part(page, 'tool-mask').getAttribute('aria-pressed'), 'false');
  // From the list.
  await part(page, 'tab-matches').click();
  await part(page, 'statistics-row').nth(1).click();
  await enabled(page, 'move');
  assert.notEqual(await held(), 'view');
  await page.keyboard.press('e');
  assert.equal(await held(), 'view');
  const [, , x, y] = await drafted(page);
  await page.keyboard.press('ArrowRight');
  await draftedNear(page, [x + 0.1, y]);
  await page.keyboard.press('Enter');
  await says(page, 'undo', /^Undo: move 1 match$/);
  // From a button over the pictures, which Enter would press.
  await part(page, 'tool-undo').click();
  await says(page, 'redo', /^Redo: move 1 match$/);
  await part(page, 'tool-choose').click();
  await part(page, 'tool-choose').click();
  assert.equal(await held(), 'tool-choose');
  await page.keyboard.press('e');
  assert.equal(await held(), 'view');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  await says(page, 'undo', /^Undo: move 1 match$/);
  assert.equal(await part(page, 'tool-choose').getAttribute('aria-pressed'), 'false');
  // By its button in the panel, and a new one by that in the bar.
  await part(page, 'move').click();
  assert.equal(await held(), 'view');
  await page.keyboard.press('Escape');
  await part(page, 'tool-measure').click();
  assert.equal(await held(), 'view');
  // Buttons that are pressed no more give the keyboard back.
  await page.keyboard.press('Enter');
  await drafted(page);
  await page.keyboard.press('ArrowRight');
  await enabled(page, 'draft-accept');
  await part(page, 'draft-accept').focus();
  await page.keyboard.press('Enter');
  await says(page, 'undo', /^Undo: add 1 match$/);
  assert.equal(await held(), 'view');
  await part(page, 'draft-cancel').focus();
  await page.keyboard.press('Enter');
  assert.ok(await part(page, 'draft').isHidden());
  assert.equal(await held(), 'view');
  assert.deepEqual(complaints, []);
  await close();
});

test('a match is measured by the keyboard alone, survives a crash of the tab, and is rejected like any other', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await sample(page);
  const all = await number(page, 'count-matches');
  await part(page, 'view').focus();
  for (const key of ['+', '+', '+', '+', 'a', 'Enter']) await page.keyboard.press(key);
  await drafted(page);
  // Where the other point is only predicted, nothing is accepted.
  await says(page, 'draft-text', /The right point is predicted: /);
  assert.ok(await part(page, 'draft-accept').isDisabled());
  await page.keyboard.press('Enter');
  assert.ok(await part(page, 'draft').isVisible());
  await says(page, 'draft-text', /The right point is predicted: /);
  // Least squares matching finds the place; then the left point, and back.
  await page.keyboard.press('f');
  await says(page, 'draft-text', /Place the right point/);
  assert.ok(await part(page, 'draft-accept').isEnabled());
  // What was placed last is taken back first, without an edit before it, too, and nothing is made again meanwhile.
  assert.equal(await part(page, 'tool-undo').getAttribute('aria-label'), 'Undo: place a point of the match');
  await page.keyboard.press('Control+z');
  await says(page, 'draft-text', /The right point is predicted: /);
  await page.keyboard.press('Control+y');
  await page.keyboard.press('Control+z');
  await part(page, 'tool-undo').waitFor({ state: 'hidden' });
  await page.keyboard.press('Enter');
  await drafted(page);
  await says(page, 'draft-text', /The right point is predicted: /);
  await page.keyboard.press('f');
  await says(page, 'draft-text', /Place the right point/);
  await page.keyboard.press('o');
  await says(page, 'draft-text', /Place the left point/);
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('o');
  await says(page, 'draft-text', /Place the right point/);
  const places = await drafted(page);
  await page.keyboard.press('Enter');
  await says(page, 'undo', /^Undo: add 1 match$/);
  await keptEdits(page, 'pair/edits', 1, 1);
  assert.deepEqual(complaints, []);
  const context = page.context();
  const url = page.url();
  const session = await context.newCDPSession(page);
  await Promise.race([session.send('Page.crash').catch(() => undefined), page.waitForEvent('crash')]);
  const again = await context.newPage();
  await again.goto(url);
  // What was not kept of the results yet is computed again, and what was measured holds for it.
  await says(again, 'status', /Restored from this browser|Kept: 1 match measured by hand/);
  await done(again);
  assert.deepEqual((await lastMatch(again)).match.slice(0, 4), places);
  // It is the last one that has a point of its own.
  await part(again, 'tab-matches').click();
  await part(again, 'statistics-filter').selectOption('by-hand');
  await part(again, 'statistics-row').first().click();
  await again.keyboard.press('Delete');
  await says(again, 'undo', /^Undo: reject 1 match$/);
  await part(again, 'tab-results').click();
  await done(again);
  assert.equal(await number(again, 'count-matches'), all);
  assert.equal(await number(again, 'count-rejected-by-hand'), 1);
  await again.keyboard.press('Control+z');
  await again.keyboard.press('Control+z');
  await done(again);
  assert.equal((await lastMatch(again)).edits, null);
  await close();
});
