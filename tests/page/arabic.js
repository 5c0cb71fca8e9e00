/** What a page in Arabic says, and which of it is English. */

import { SAME } from '../english.js';

/** @typedef {import('playwright-core').Page} Page */

/** What people read in the page, and what is read out to them; without keys, code and the names of files.  @param {Page} page */
export const texts = (page) =>
  page.evaluate(() => {
    const found = new Set();
    for (const element of document.body.querySelectorAll('*')) {
      if (!element.checkVisibility() || element.closest('kbd, code, pre, [lang="en"], .pane-name, .project-name') !== null) continue;
      for (const node of element.childNodes) if (node.nodeType === Node.TEXT_NODE) found.add(node.textContent?.trim() ?? '');
      for (const name of ['title', 'aria-label', 'aria-roledescription', 'placeholder']) found.add(element.getAttribute(name) ?? '');
    }
    return [...found].filter((text) => text !== '');
  });

/** Words that are names of keys, files, operators or options in every language. */
const NAMES =
  /"[^"]*"|\.(?:tfw|jgw|pgw|wld|prj)\b|\b[\w-]+\.(?:png|jpe?g|tif|json|csv|tiepoint|tfw|jgw|pgw|wld|zip)\b|\b(?:[a-z]+_[a-z_]+|radial|tangential|fixed|mask|auto|Förstner|Moravec|Ground|Huber|Agisoft|Bundler|NVM|VisualSFM|ESRI|ASCII|Apache-2\.0|MIT|COLMAP|images|cameras|world file|Baarda|DJI|WebP|GTX|PGM|GeographicLib|col|row|English|Simulated)\b/gu;

/** Texts with a word in Latin letters that is neither a name nor a unit.  @param {readonly string[]} all */
export const english = (all) => all.filter((text) => (text.replaceAll(NAMES, ' ').match(/[A-Za-z][A-Za-z’-]{2,}/gu) ?? []).some((word) => !SAME.test(word)));
