// @ts-check
/** Writes the EXIF of a simulated photo (CIPA DC-008): its camera and its recorded position, no more than that. */

/** Types of values, with their bytes. */
const [BYTE, ASCII, SHORT, LONG, RATIONAL] = [1, 2, 3, 4, 5];

/** Tags that point to the other two lists. */
const [EXIF_LIST, GPS_LIST] = [0x8769, 0x8825];

/**
 * @typedef {{ tag: number, type: number, count: number, bytes: Uint8Array }} Entry
 * @param {{ make: string, model: string, focalMm: number, pixelMm: number, longitude: number, latitude: number, height: number }} facts
 * @returns {Uint8Array} a TIFF structure of big-endian numbers
 */
export function exifBlock({ make, model, focalMm, pixelMm, longitude, latitude, height }) {
  const exif = [rational(0x920a, focalMm), rational(0xa20e, 1 / pixelMm), rational(0xa20f, 1 / pixelMm), entry(0xa210, SHORT, 1, [0, 4])];
  const gps = [
    entry(0, BYTE, 4, [2, 3, 0, 0]),
    ascii(1, latitude < 0 ? 'S' : 'N'), angle(2, Math.abs(latitude)),
    ascii(3, longitude < 0 ? 'W' : 'E'), angle(4, Math.abs(longitude)),
    entry(5, BYTE, 1, [height < 0 ? 1 : 0]), rational(6, Math.abs(height)),
  ];
  const main = [ascii(0x010f, make), ascii(0x0110, model), entry(0x0112, SHORT, 1, [0, 1])];
  const pointers = (/** @type {number} */ a, /** @type {number} */ b) => [...main, long(EXIF_LIST, a), long(GPS_LIST, b)];
  const first = 8 + list(pointers(0, 0), 8).length;
  const second = first + list(exif, first).length;
  const header = [0x4d, 0x4d, 0, 42, 0, 0, 0, 8];
  return Uint8Array.from([...header, ...list(pointers(first, second), 8), ...list(exif, first), ...list(gps, second)]);
}

/** A list of entries at an offset; what does not fit into an entry stands behind them.  @param {Entry[]} entries @param {number} offset */
function list(entries, offset) {
  const table = [...uint(entries.length, 2)];
  /** @type {number[]} */
  const behind = [];
  const after = offset + 2 + 12 * entries.length + 4;
  for (const { tag, type, count, bytes } of entries) {
    table.push(...uint(tag, 2), ...uint(type, 2), ...uint(count, 4));
    if (bytes.length <= 4) {
      table.push(...bytes, ...new Array(4 - bytes.length).fill(0));
      continue;
    }
    table.push(...uint(after + behind.length, 4));
    // Values begin at whole words.
    behind.push(...bytes, ...new Array(bytes.length % 2).fill(0));
  }
  return [...table, 0, 0, 0, 0, ...behind];
}

/** @param {number} value @param {number} bytes @returns {number[]} */
const uint = (value, bytes) => Array.from({ length: bytes }, (_, i) => Math.floor(value / 256 ** (bytes - 1 - i)) % 256);

/** @param {number} tag @param {number} type @param {number} count @param {ArrayLike<number>} bytes @returns {Entry} */
const entry = (tag, type, count, bytes) => ({ tag, type, count, bytes: Uint8Array.from(bytes) });

/** @param {number} tag @param {string} text */
const ascii = (tag, text) => entry(tag, ASCII, text.length + 1, new TextEncoder().encode(`${text}\0`));

/** @param {number} tag @param {number} value */
const long = (tag, value) => entry(tag, LONG, 1, uint(value, 4));

/** To one part in a hundred thousand or better.  @param {number} value @param {number} denominator */
const ratio = (value, denominator) => [...uint(Math.round(value * denominator), 4), ...uint(denominator, 4)];

/** @param {number} tag @param {number} value */
const rational = (tag, value) => entry(tag, RATIONAL, 1, ratio(value, 100_000));

/** Degrees, minutes, and seconds to a millionth: 0.03 mm on the ground.  @param {number} tag @param {number} degrees */
function angle(tag, degrees) {
  const whole = Math.floor(degrees);
  const minutes = Math.floor((degrees - whole) * 60);
  const seconds = Math.max(0, ((degrees - whole) * 60 - minutes) * 60);
  return entry(tag, RATIONAL, 3, [...ratio(whole, 1), ...ratio(minutes, 1), ...ratio(seconds, 1_000_000)]);
}
