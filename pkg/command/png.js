// @ts-check
/** Writes 8-bit grey PNG files in Node. */

import { deflateSync } from 'node:zlib';
import { pngOf } from '../block/png.js';

/**
 * @param {number} width @param {number} height @param {Uint8Array} grey row by row @param {Uint8Array} [exif] @returns {Buffer} the file
 */
export const greyPng = (width, height, grey, exif) => Buffer.from(pngOf(width, height, grey, deflateSync, exif).buffer);
