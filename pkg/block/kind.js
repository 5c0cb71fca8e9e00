// @ts-check
/** What kind of value a host has given. */

/**
 * In a word: the name that the language has for the class of an object, the same in every window, as `Uint8Array` or `Map`; else the type.
 * @param {unknown} value
 */
export function kindOf(value) {
  if (value === null) return 'null';
  return typeof value === 'object' ? Object.prototype.toString.call(value).slice(8, -1) : typeof value;
}
