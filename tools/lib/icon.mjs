/** The page's icon: two points and the line that ties them. One drawing, as SVG and in pixels. */

import { deflateSync } from 'node:zlib';

/** The drawing in a square of this size. */
const SIZE = 16;
const GROUND = { corner: 3, colour: '#264653' };
const LINE = { x: 4, y: 8, length: 8, width: 1.5, colour: '#00c08b' };
const POINTS = { at: [4, 12], y: 8, radius: 2, colour: '#ffffff' };

/** @returns {string} */
export function iconSvg() {
  const points = POINTS.at.map((x) => `<circle cx="${x}" cy="${POINTS.y}" r="${POINTS.radius}" fill="${POINTS.colour}"/>`).join('');
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${SIZE} ${SIZE}">` +
    `<rect width="${SIZE}" height="${SIZE}" rx="${GROUND.corner}" fill="${GROUND.colour}"/>` +
    `<path d="M${LINE.x} ${LINE.y}h${LINE.length}" stroke="${LINE.colour}" stroke-width="${LINE.width}"/>${points}</svg>`
  );
}

/** Samples a side within a pixel. */
const SAMPLES = 3;

/** @param {string} colour */
const rgb = (colour) => [1, 3, 5].map((at) => Number.parseInt(colour.slice(at, at + 2), 16));
const [GROUND_RGB, LINE_RGB, POINT_RGB] = [rgb(GROUND.colour), rgb(LINE.colour), rgb(POINTS.colour)];

/**
 * The drawing as PNG. `full`: without round corners and with a margin, for systems that cut icons to a shape of their own.
 * @param {number} size px @returns {Buffer}
 */
export function iconPng(size, full = false) {
  const rows = Buffer.alloc(size * (4 * size + 1));
  for (let row = 0; row < size; row++)
    for (let column = 0; column < size; column++) rows.set(pixel(column, row, SIZE / size, full), row * (4 * size + 1) + 1 + 4 * column);
  const head = Buffer.alloc(13);
  head.writeUInt32BE(size, 0);
  head.writeUInt32BE(size, 4);
  // Eight bits, red green blue and opacity.
  head.set([8, 6], 8);
  const signature = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
  return Buffer.concat([signature, chunk('IHDR', head), chunk('IDAT', deflateSync(rows, { level: 9 })), chunk('IEND', Buffer.alloc(0))]);
}

/** The mean of a pixel's samples.  @param {number} column @param {number} row @param {number} step @param {boolean} full @returns {number[]} */
function pixel(column, row, step, full) {
  const sum = [0, 0, 0, 0];
  for (let i = 0; i < SAMPLES * SAMPLES; i++) {
    const x = (column + ((i % SAMPLES) + 0.5) / SAMPLES) * step;
    const y = (row + (Math.floor(i / SAMPLES) + 0.5) / SAMPLES) * step;
    const colour = full ? colourAt((x - SIZE / 2) / 0.8 + SIZE / 2, (y - SIZE / 2) / 0.8 + SIZE / 2, true) : colourAt(x, y, false);
    if (colour === null) continue;
    for (let k = 0; k < 3; k++) sum[k] = (sum[k] ?? 0) + (colour[k] ?? 0);
    sum[3] = (sum[3] ?? 0) + 1;
  }
  const opaque = sum[3] ?? 0;
  if (opaque === 0) return [0, 0, 0, 0];
  return [...sum.slice(0, 3).map((v) => Math.round(v / opaque)), Math.round((255 * opaque) / (SAMPLES * SAMPLES))];
}

/** @param {number} x @param {number} y @param {boolean} full @returns {number[] | null} */
function colourAt(x, y, full) {
  if (POINTS.at.some((at) => Math.hypot(x - at, y - POINTS.y) <= POINTS.radius)) return POINT_RGB;
  if (x >= LINE.x && x <= LINE.x + LINE.length && Math.abs(y - LINE.y) <= LINE.width / 2) return LINE_RGB;
  if (full) return GROUND_RGB;
  const [dx, dy] = [x, y].map((v) => Math.max(GROUND.corner - v, v - (SIZE - GROUND.corner), 0));
  return Math.hypot(dx ?? 0, dy ?? 0) <= GROUND.corner ? GROUND_RGB : null;
}

/** @param {string} type @param {Buffer} data */
function chunk(type, data) {
  const named = Buffer.concat([Buffer.from(type, 'latin1'), data]);
  const [length, check] = [Buffer.alloc(4), Buffer.alloc(4)];
  length.writeUInt32BE(data.length);
  check.writeUInt32BE(crc32(named));
  return Buffer.concat([length, named, check]);
}

/** @param {Buffer} bytes */
function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit++) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return (crc ^ 0xffffffff) >>> 0;
}
