/** The orthophoto of a simulated block in a coordinate reference system, as other programs give it: for tests of the page. */

import assert from 'node:assert/strict';
import { BlockScene, geographic_positions, grey_png, OrthophotoReference, system_coordinates } from '../../pkg/node.js';

/** The code of longitudes and latitudes of WGS 84. */
const DEGREES = 4326;

/** @typedef {[number, number, number, number, number, number]} Affine columns and rows become (a c + b r + x, d c + e r + y): a, b, x, d, e, y */

/**
 * GeoTIFF of a projected system, or in degrees, red where the ground is bright and blue where it is dark, and the same picture in grey as PNG with its world file.
 * @param {Uint8Array} picture the orthophoto in the system of its flight @param {number} epsg
 * @param {{ longitude_deg: number, latitude_deg: number, height_m: number }} origin of the flight @param {number} ground height of the ground in the flight
 */
export function georeferenced(picture, epsg, origin, ground) {
  const reference = OrthophotoReference.open(picture);
  const { width, height, georeference } = reference.info();
  const grey = Uint8Array.from(reference.picture(0, 0, width, height, 0));
  reference.free();
  const { origin: corner, by_column: column, by_row: row } = georeference;
  const place = (/** @type {number} */ c, /** @type {number} */ r) =>
    system_coordinates(
      `EPSG:${epsg}`,
      geographic_positions(
        Float64Array.of(
          origin.longitude_deg,
          origin.latitude_deg,
          origin.height_m,
          corner[0] + c * column[0] + r * row[0],
          corner[1] + c * column[1] + r * row[1],
          ground,
        ),
      ),
    );
  const [at, right, below] = [place(0, 0), place(width, 0), place(0, height)];
  const part = (/** @type {Float64Array} */ to, /** @type {number} */ k, /** @type {number} */ count) => ((to[k] ?? NaN) - (at[k] ?? NaN)) / count;
  /** @type {Affine} */
  const affine = [part(right, 0, width), part(below, 0, height), at[0] ?? NaN, part(right, 1, width), part(below, 1, height), at[1] ?? NaN];
  const [a, b, x, d, e, y] = affine;
  // World files name the middle of the first pixel.
  const world = [a, d, b, e, x + (a + b) / 2, y + (d + e) / 2].map((value) => value.toFixed(12)).join('\n');
  const colours = new Uint8Array(3 * grey.length);
  for (const [k, value] of grey.entries()) colours.set(value === 0 ? [0, 0, 0] : [value, value >> 1, 256 - value], 3 * k);
  return { tif: geotiff(width, height, colours, affine, epsg), png: grey_png(width, height, grey), world, affine, georeference };
}

/** An uncompressed TIFF of red, green and blue with its GeoTIFF keys.  @param {number} width @param {number} height @param {Uint8Array} colours @param {Affine} affine @param {number} epsg */
function geotiff(width, height, colours, [a, b, x, d, e, y], epsg) {
  const [SHORT, LONG, DOUBLE] = [3, 4, 12];
  const matrix = [a, b, 0, x, d, e, 0, y, 0, 0, 0, 0, 0, 0, 0, 1];
  // Projected or in degrees, pixels are areas, and the code.
  const [kind, system] = epsg === DEGREES ? [2, 2048] : [1, 3072];
  const keys = [1, 1, 0, 3, 1024, 0, 1, kind, 1025, 0, 1, 1, system, 0, 1, epsg];
  const bits = [8, 8, 8];
  const values = 8 + colours.length + (colours.length % 2);
  const afterKeys = values + 128 + 2 * keys.length;
  const tags = [
    [256, LONG, 1, width],
    [257, LONG, 1, height],
    [258, SHORT, bits.length, afterKeys],
    [259, SHORT, 1, 1],
    [262, SHORT, 1, 2],
    [273, LONG, 1, 8],
    [277, SHORT, 1, bits.length],
    [278, LONG, 1, height],
    [279, LONG, 1, colours.length],
    [34264, DOUBLE, 16, values],
    [34735, SHORT, keys.length, values + 128],
  ];
  const directory = afterKeys + 2 * bits.length;
  const bytes = new Uint8Array(directory + 2 + 12 * tags.length + 4);
  const view = new DataView(bytes.buffer);
  bytes.set([0x49, 0x49, 42, 0]);
  view.setUint32(4, directory, true);
  bytes.set(colours, 8);
  for (const [i, value] of matrix.entries()) view.setFloat64(values + 8 * i, value, true);
  for (const [i, value] of keys.entries()) view.setUint16(values + 128 + 2 * i, value, true);
  for (const [i, value] of bits.entries()) view.setUint16(afterKeys + 2 * i, value, true);
  view.setUint16(directory, tags.length, true);
  tags.forEach(([tag = 0, type = 0, count = 0, value = 0], i) => {
    const entry = directory + 2 + 12 * i;
    view.setUint16(entry, tag, true);
    view.setUint16(entry + 2, type, true);
    view.setUint32(entry + 4, count, true);
    if (type === SHORT && count === 1) view.setUint16(entry + 8, value, true);
    else view.setUint32(entry + 8, value, true);
  });
  return bytes;
}

/** The same GeoTIFF with keys that say longitudes and latitudes.  @param {Uint8Array} file */
export function inDegrees(file) {
  const changed = Uint8Array.from(file);
  // GTModelTypeGeoKey, which stands in the directory of keys, once: projected.
  const key = [0, 4, 0, 0, 1, 0, 1, 0];
  const at = changed.findIndex((_, from) => key.every((byte, k) => changed[from + k] === byte));
  assert.ok(at > 0);
  changed[at + 6] = 2;
  return changed;
}

/** A geoid in GTX, 47 m above the ellipsoid about the place of simulated blocks. */
export function flatGeoid() {
  const [south, west, step, rows, columns] = [49.5, 7.5, 0.25, 5, 5];
  const file = Buffer.alloc(40 + 4 * rows * columns);
  for (const [k, value] of [south, west, step, step].entries()) file.writeDoubleBE(value, 8 * k);
  for (const [k, value] of [rows, columns].entries()) file.writeInt32BE(value, 32 + 4 * k);
  for (let k = 0; k < rows * columns; k += 1) file.writeFloatBE(47, 40 + 4 * k);
  return new Uint8Array(file);
}

/**
 * A table of control points of a simulated block in a coordinate system, with heights above a geoid that lies so high above the ellipsoid.
 * @param {string} table @param {object} flight @param {string} crs @param {number} geoidM
 */
export function pointsInSystem(table, flight, crs, geoidM) {
  const scene = new BlockScene(flight);
  const { origin } = scene.truth();
  scene.free();
  assert.ok(origin);
  const [head = '', ...rows] = table.trim().split('\n');
  const placed = rows.map((row) => {
    const [name, x, y, z, use] = row.split(',');
    const geographic = geographic_positions([origin.longitude_deg, origin.latitude_deg, origin.height_m, Number(x), Number(y), Number(z)]);
    const [east = NaN, north = NaN, up = NaN] = system_coordinates(crs, geographic.slice(-3));
    return [name, east.toFixed(4), north.toFixed(4), (up - geoidM).toFixed(4), use].join(',');
  });
  return `${[head, ...placed].join('\n')}\n`;
}
