// @ts-check
/** What workers do of one pair: describing an image, and a piece of the search for nearest descriptors. */

import { nearest_piece, Photo } from '../node.js';

/**
 * @typedef {import('../node.js').PairSettings} PairSettings
 * @typedef {{ width: number, height: number, grey: Uint8Array, mask: Uint8Array | undefined, settings: PairSettings }} DescribeJob
 * @typedef {{ left: Uint8Array, first: number, end: number, right: Uint8Array }} NearestJob
 */

/** @param {DescribeJob} job */
export async function describe({ width, height, grey, mask, settings }) {
  const photo = Photo.from_grey(width, height, grey);
  try {
    return photo.describe_points(settings, mask);
  } finally {
    photo.free();
  }
}

/** @param {NearestJob} job */
export const nearest = async ({ left, first, end, right }) => nearest_piece(left, first, end, right);
