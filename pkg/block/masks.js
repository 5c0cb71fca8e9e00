// @ts-check
/** Which mask belongs to which image: by their names. */

import { BlockError } from './errors.js';

/** @typedef {import('./types.js').Source} Source */

/** @param {string} name */
const withoutEnding = (name) => name.replace(/\.[^.]*$/, '');

/** @param {string} name a file, perhaps below a folder @returns {string} */
const lastPart = (name) => (name.split('/').at(-1) ?? name).toLowerCase();

/**
 * A mask has the name of its image, whatever its ending, perhaps with _mask behind it, or the whole name of the image with its own ending
 * behind it: IMG_1.png, IMG_1_mask.png and IMG_1.jpg.png belong to IMG_1.jpg.
 * @param {readonly Source[]} sources @param {readonly Source[]} given
 * @returns {{ masks: (Source | null)[], strays: string[] }} the mask of each source; masks that belong to none
 */
export function masksOf(sources, given) {
  /** @type {Map<string, Source>} */
  const byName = new Map();
  for (const mask of given) {
    const name = withoutEnding(lastPart(mask.name)).replace(/_mask$/, '');
    const other = byName.get(name);
    if (other) throw new BlockError(`the masks ${other.name} and ${mask.name} belong to the same image; allowed: one mask an image`);
    byName.set(name, mask);
  }
  const used = new Set();
  const masks = sources.map(({ name }) => {
    const own = lastPart(name);
    const mask = byName.get(own) ?? byName.get(withoutEnding(own)) ?? null;
    if (mask) used.add(mask);
    return mask;
  });
  return { masks, strays: given.filter((mask) => !used.has(mask)).map(({ name }) => name) };
}
