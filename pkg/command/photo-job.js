// @ts-check
/** Renders one photo of a simulated block as a file. */

import { deflateSync } from 'node:zlib';
import '../node.js';
import { photoFile } from '../block/photo.js';

/** @param {{ flight: import('../node.js').BlockFlight, index: number }} job @returns {Promise<Uint8Array>} a PNG file with EXIF */
export const photo = async ({ flight, index }) => photoFile(flight, index, deflateSync);
