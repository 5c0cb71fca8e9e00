/** Photos of simulated flights on film, as a scanner has them. */

import { readFileSync } from 'node:fs';
import { Photo } from '../../pkg/node.js';
import { file, image } from './command.js';

export const PIXEL_MM = 0.075;

/** Fiducial marks of a film of 36 x 27 mm, whose principal point lies 4 px off their middle. */
export const MARKS_MM = /** @type {const} */ ([
  [-17.2, -12.7],
  [17.2, -12.7],
  [17.2, 12.7],
  [-17.2, 12.7],
  [-17.5, 0],
  [17.5, 0.1],
]);
export const PRINCIPAL_POINT_MM = [0.3, -0.24];

export const SIZE = /** @type {const} */ ([570, 470]);

/**
 * How a film lies in the scanner: turned by an angle in rad, with columns and rows of different length, its middle at a position in px.
 * @typedef {{ turn: number, along: number, across: number, middle: readonly [number, number] }} Lying
 */

/** @type {Lying} */
export const ASKEW = { turn: 0.122, along: 1.003, across: 0.997, middle: [284.3, 236.8] };

/** @param {readonly [number, number]} mm @param {Lying} lying @returns {[number, number]} */
export function inScan([xMm, yMm], { turn, along, across, middle }) {
  const [x, y] = [(xMm * along) / PIXEL_MM, (-yMm * across) / PIXEL_MM];
  return [Math.cos(turn) * x - Math.sin(turn) * y + middle[0], Math.sin(turn) * x + Math.cos(turn) * y + middle[1]];
}

/** Where a scan shows what a photo without distortion has at a position, both in px.  @param {readonly [number, number]} px @param {readonly [number, number]} size of the photo @param {Lying} lying */
export function inScanOfPhoto([x, y], [width, height], lying) {
  const [x0 = 0, y0 = 0] = PRINCIPAL_POINT_MM;
  return inScan([x0 + (x - width / 2) * PIXEL_MM, y0 - (y - height / 2) * PIXEL_MM], lying);
}

/** @param {number} col @param {number} row @param {Lying} lying @returns {[number, number]} mm of the marks */
export function onFilm(col, row, { turn, along, across, middle }) {
  const [u, v] = [col - middle[0], row - middle[1]];
  return [((Math.cos(turn) * u + Math.sin(turn) * v) * PIXEL_MM) / along, (-(Math.cos(turn) * v - Math.sin(turn) * u) * PIXEL_MM) / across];
}

/** The grey value between the middles of pixels.  @param {Uint8Array} grey @param {number} width @param {number} x @param {number} y */
function between(grey, width, x, y) {
  const [c, r] = [Math.floor(x - 0.5), Math.floor(y - 0.5)];
  const [s, t] = [x - 0.5 - c, y - 0.5 - r];
  const at = (/** @type {number} */ col, /** @type {number} */ row) => grey[Math.max(row, 0) * width + Math.max(col, 0)] ?? 0;
  return (1 - t) * ((1 - s) * at(c, r) + s * at(c + 1, r)) + t * ((1 - s) * at(c, r + 1) + s * at(c + 1, r + 1));
}

/**
 * The scan of a photo on film with a dark border and marks, and the table of its marks beside it.
 * @param {string} at a folder @param {string} name without its end @param {string} photo a file @param {Lying} lying
 * @returns {{ scan: string, fiducials: string }}
 */
export function scanOf(at, name, photo, lying) {
  const decoded = Photo.decode(readFileSync(photo));
  const [grey, width, height] = [decoded.grey(), decoded.width, decoded.height];
  decoded.free();
  const scan = image(at, `${name}.png`, ...SIZE, (col, row) => {
    const [xMm, yMm] = onFilm(col + 0.5, row + 0.5, lying);
    const off = Math.min(...MARKS_MM.map(([x, y]) => Math.max(Math.abs(xMm - x), Math.abs(yMm - y))));
    if (off < 0.35) return off < 0.1 ? 255 : 0;
    const [x, y] = [width / 2 + (xMm - (PRINCIPAL_POINT_MM[0] ?? 0)) / PIXEL_MM, height / 2 - (yMm - (PRINCIPAL_POINT_MM[1] ?? 0)) / PIXEL_MM];
    return x >= 0 && y >= 0 && x < width && y < height ? Math.round(between(grey, width, x, y)) : 12;
  });
  const rows = MARKS_MM.map((mark) => [...inScan(mark, lying).map((px) => px.toFixed(1)), ...mark].join(','));
  return { scan, fiducials: file(at, `${name}.csv`, ['col,row,x_mm,y_mm', ...rows, ''].join('\n')) };
}
