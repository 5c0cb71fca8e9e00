// @ts-check
/** Files that cannot be used: how many of their first bytes tell their kind, and each reason once. */

/** So many bytes tell every kind but raw files of cameras. */
export const START_BYTES = 64;

/** The first directory of a TIFF, which tells raw files from others, stands within so many bytes. */
const DIRECTORY_BYTES = 1 << 16;

/** How many of the first bytes of a file tell its kind, by its first `START_BYTES`.  @param {Uint8Array} start */
export function bytesOfKind([a, b, c, d]) {
  const isTiff = (a === 0x49 && b === 0x49 && c === 42 && d === 0) || (a === 0x4d && b === 0x4d && c === 0 && d === 42);
  return isTiff ? DIRECTORY_BYTES : START_BYTES;
}

/**
 * The names of files by what is said of them, in the order in which these come first.
 * @param {readonly { name: string, reason: string }[]} files @returns {Map<string, string[]>}
 */
export function byReason(files) {
  /** @type {Map<string, string[]>} */
  const names = new Map();
  for (const { name, reason } of files) {
    const of = names.get(reason);
    if (of === undefined) names.set(reason, [name]);
    else of.push(name);
  }
  return names;
}
