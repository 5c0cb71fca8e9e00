// @ts-check

/** What marks a text as one of UTF-16, as spreadsheets save "Unicode text". */
const UTF_16 = /** @type {const} */ ([
  ['utf-16le', 0xff, 0xfe],
  ['utf-16be', 0xfe, 0xff],
]);

/** What older spreadsheets of western languages save. */
const OTHERWISE = 'windows-1252';

/** The text of a file, without the mark that may stand before it: in UTF-16 where it is marked so, else in UTF-8 where it can be.  @param {Uint8Array} bytes @returns {string} */
export function textOf(bytes) {
  const marked = UTF_16.find(([, first, second]) => bytes[0] === first && bytes[1] === second);
  if (marked !== undefined) return new TextDecoder(marked[0]).decode(bytes);
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    return new TextDecoder(OTHERWISE).decode(bytes);
  }
}
