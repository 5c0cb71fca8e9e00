/** Edits that the bench of crashes draws from: each is made as a user makes it, by keys and buttons, and may find nothing to do. */

import { done, enabled, part } from '../../tests/page/page.js';

/** @typedef {import('playwright-core').Page} Page */
/** @typedef {(page: Page, uniform: () => number) => Promise<void>} Edit */

/** What is not there so soon is not there for this edit. */
const SOON_MS = 1500;

/** Rows that are in sight. */
const FEW = 5;

/** Presses what can be pressed soon.  @param {import('playwright-core').Locator} what */
const tried = (what) =>
  what.click({ timeout: SOON_MS }).then(
    () => true,
    () => false,
  );

/** Presses a button, where it can be pressed.  @param {Page} page @param {string} id */
async function press(page, id) {
  const button = part(page, id).first();
  return (await button.isVisible()) && (await button.isEnabled()) && (await tried(button));
}

/** Whether something is so soon.  @param {Page} page @param {string} id */
const comes = (page, id) =>
  page
    .waitForFunction(
      (at) => {
        const button = document.querySelector(`[data-testid="${at}"]`);
        return button?.hasAttribute('disabled') === false && button.checkVisibility();
      },
      id,
      { timeout: SOON_MS },
    )
    .then(
      () => true,
      () => false,
    );

/** @param {Page} page @param {string[]} keys */
async function type(page, ...keys) {
  for (const key of keys) await page.keyboard.press(key);
}

/** @type {Edit} */
const undo = (page) => page.keyboard.press('Control+z');
/** @type {Edit} */
const redo = (page) => page.keyboard.press('Control+Shift+z');

/** Chooses a row of the list of matches.  @param {Page} page @param {() => number} uniform */
async function match(page, uniform) {
  await press(page, 'draft-cancel');
  const rows = page.locator('[data-testid="statistics-row"]');
  await rows.nth(Math.floor(uniform() * (await rows.count()))).click();
  await enabled(page, 'move');
}

/** A list of kinds, each as often as it is to be drawn. @typedef {readonly (readonly [weight: number, edit: Edit])[]} Kinds */

/** @type {Kinds} */
export const OF_PAIR = [
  [
    // One is rejected.
    4,
    async (page, uniform) => {
      await match(page, uniform);
      await part(page, 'view').focus();
      await page.keyboard.press('Delete');
    },
  ],
  [
    // What was chosen last is used again.
    2,
    async (page) => {
      await part(page, 'view').focus();
      await type(page, 'r');
    },
  ],
  [
    // One is measured anew.
    2,
    async (page, uniform) => {
      await match(page, uniform);
      await type(page, 'e', 'ArrowRight', 'ArrowDown', 'Enter');
    },
  ],
  [
    // One is measured.
    2,
    async (page) => {
      await press(page, 'draft-cancel');
      await part(page, 'view').focus();
      await type(page, 'a', 'Enter', 'ArrowRight', 'ArrowLeft');
      if (await comes(page, 'draft-accept')) await page.keyboard.press('Enter');
      await press(page, 'draft-cancel');
    },
  ],
  [
    // An area is masked, or that undone.
    1,
    async (page) => {
      if (!(await press(page, 'unmask-left'))) {
        await part(page, 'view').focus();
        await type(page, 'w', 'Enter', 'ArrowRight', 'ArrowRight', 'Enter', 'ArrowDown', 'ArrowDown', 'Enter', 'k');
        await comes(page, 'unmask-left');
        await press(page, 'mask-end');
      }
      await done(page);
    },
  ],
  [2, undo],
  [1, redo],
];

/** Chooses the next tie points of the images that are shown.  @param {Page} page @param {() => number} uniform */
async function point(page, uniform) {
  await press(page, 'block-leave');
  await part(page, 'block-panes').focus();
  for (let step = 0; step <= 3 * uniform(); step += 1) await page.keyboard.press('n');
}

/** Chooses a point of four rays in the table, and shows it in two images.  @param {Page} page @param {() => number} uniform */
async function longPoint(page, uniform) {
  await press(page, 'block-leave');
  await part(page, 'block-points-filter-point-rays').fill('4..');
  const rows = page.locator('[data-testid="block-points"] tbody tr:not(.filler)');
  const count = Math.min(await rows.count(), FEW);
  if (count > 0) await tried(rows.nth(Math.floor(uniform() * count)));
  await part(page, 'block-points-filter-point-rays').fill('');
  const closes = page.locator('[data-testid^="close-image-"]');
  for (let shown = await closes.count(); shown > 2; shown -= 1) await tried(closes.first());
}

/** @type {Kinds} */
export const OF_BLOCK = [
  [
    // One is rejected.
    4,
    async (page, uniform) => {
      await point(page, uniform);
      if (await comes(page, 'block-reject')) await page.keyboard.press('Delete');
    },
  ],
  [
    // What was chosen last is used again.
    2,
    async (page) => {
      await press(page, 'block-leave');
      await part(page, 'block-panes').focus();
      await page.keyboard.press('r');
    },
  ],
  [
    // One is measured anew.
    2,
    async (page, uniform) => {
      await point(page, uniform);
      if (!(await comes(page, 'block-measure'))) return;
      await type(page, 'e', 'Enter', 'ArrowRight', 'ArrowDown');
      if (await comes(page, 'block-accept')) await press(page, 'block-accept');
      await press(page, 'block-leave');
    },
  ],
  [
    // One is measured.
    2,
    async (page, uniform) => {
      await point(page, uniform);
      await type(page, 'a', 'Enter', 'o', 'Shift+ArrowRight', 'ArrowLeft', 'o', 'Shift+ArrowRight', 'ArrowLeft');
      if (await comes(page, 'block-accept')) await press(page, 'block-accept');
      await press(page, 'block-leave');
    },
  ],
  [
    // One is split by the images that show it.
    2,
    async (page, uniform) => {
      await longPoint(page, uniform);
      if (await comes(page, 'block-split')) await press(page, 'block-split');
    },
  ],
  [
    // The last two are joined.
    2,
    async (page) => {
      await press(page, 'block-leave');
      // Both parts of a point that was split stand at the end.
      await part(page, 'block-points-filter-point-part').fill('accepted');
      await part(page, 'block-points').focus();
      await type(page, 'End', 'Enter', 'Shift+ArrowUp');
      if (await comes(page, 'block-join')) await press(page, 'block-join');
      await part(page, 'block-points-filter-point-part').fill('');
    },
  ],
  [2, undo],
  [1, redo],
];

/** One of them by chance.  @param {Kinds} kinds @param {() => number} uniform */
export function drawn(kinds, uniform) {
  const all = kinds.flatMap(([weight, edit]) => Array.from({ length: weight }, () => edit));
  const found = all[Math.floor(uniform() * all.length)];
  if (found === undefined) throw new Error('no kinds of edits');
  return found;
}
