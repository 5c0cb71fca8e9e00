/** Looks at states of the page with axe, on a laptop and on a phone, in both themes. */

import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

/** @typedef {import('playwright-core').Page} Page */

const AXE = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

export const LAPTOP = { width: 1366, height: 768 };
const PHONE = { width: 360, height: 740 };

/** Rules whose answer is another one in the other theme. */
const COLOURS = ['color-contrast', 'link-in-text-block'];

/**
 * What axe finds: rule and place, and why.
 * @param {Page} page @param {readonly string[] | null} only these rules, or all @param {string} within what is looked at @returns {Promise<[string, string][]>}
 */
async function axe(page, only, within) {
  if (!(await page.evaluate(() => 'axe' in window))) await page.evaluate(AXE);
  return page.evaluate(
    async ([rules, selector]) => {
      const options = rules === null ? { rules: { 'target-size': { enabled: true } } } : { runOnly: { type: 'rule', values: rules } };
      const { violations } = await /** @type {any} */ (window).axe.run(selector, { resultTypes: ['violations'], ...options });
      return violations.flatMap((/** @type {any} */ { id, nodes }) =>
        nodes.map((/** @type {any} */ { target, failureSummary }) => [`${id}: ${target.join(' ')}`, failureSummary.replaceAll(/\s+/g, ' ')]),
      );
    },
    /** @type {[readonly string[] | null, string]} */ ([only, within]),
  );
}

/** Notes what axe found, with the first state where it did.  @param {Map<string, string>} found */
const notedIn = (found) => (/** @type {string} */ where, /** @type {[string, string][]} */ findings) => {
  for (const [what, why] of findings) if (!found.has(what)) found.set(what, `${where}: ${what}: ${why}`);
};

/**
 * Looks at the colours of a state of the page where the system gives them, light and dark ones, as `looker` does at the page's own.
 * @param {Page} page @param {Map<string, string>} found @returns {(where: string) => Promise<void>}
 */
export function forcedLooker(page, found) {
  const note = notedIn(found);
  return async (where) => {
    for (const colorScheme of /** @type {const} */ (['light', 'dark'])) {
      await page.emulateMedia({ colorScheme, forcedColors: 'active', reducedMotion: 'reduce' });
      note(`${where}, forced colours, ${colorScheme}`, await axe(page, COLOURS, 'html'));
    }
    await page.emulateMedia({ colorScheme: 'light', forcedColors: 'none' });
  };
}

/**
 * Looks at a state of the page on both screens and in both themes; collects what axe finds, with the first state where it does.
 * @param {Page} page @param {Map<string, string>} found @returns {(where: string, within?: string) => Promise<void>} within: the parts that the
 * state changed of one that was looked at as a whole; a part that is not there is an error
 */
export function looker(page, found) {
  const note = notedIn(found);
  return async (where, within = 'html') => {
    // A dialog may open a moment after the press.
    await page.locator(within).first().waitFor();
    for (const [screen, size] of /** @type {const} */ ([
      ['laptop', LAPTOP],
      ['phone', PHONE],
    ])) {
      await page.setViewportSize(size);
      await page.emulateMedia({ colorScheme: 'light', reducedMotion: 'reduce' });
      // What follows the size of the window (observers of sizes) is done a frame after it.
      await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
      note(`${where}, ${screen}, light`, await axe(page, null, within));
      await page.emulateMedia({ colorScheme: 'dark', reducedMotion: 'reduce' });
      note(`${where}, ${screen}, dark`, await axe(page, COLOURS, within));
    }
    await page.setViewportSize(LAPTOP);
  };
}
