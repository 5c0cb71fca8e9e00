/** OpenCV.js from npm on the pairs: ORB with as many points (it has no SIFT), the ratio and the mutual check; of geometry it has homographies alone. */

import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';
import { feature_defaults } from '../../../pkg/node.js';
import { ensurePackages } from '../../lib/setup.mjs';
import { photoOf } from '../data.mjs';

/** The module, ready, in a box: it is a thenable that gives itself, on which `await` never ends.  @returns {Promise<{ cv: any }>} */
async function library() {
  await ensurePackages(fileURLToPath(new URL('.', import.meta.url)));
  const cv = createRequire(import.meta.url)('@techstark/opencv-js');
  if (!cv.Mat)
    await new Promise((resolve) => {
      cv.onRuntimeInitialized = () => resolve(null);
    });
  return { cv };
}

/** Positions, descriptors and time in ms.  @param {any} cv @param {string} name @param {string} file */
function described(cv, name, file) {
  const photo = photoOf(name, file);
  const image = cv.matFromArray(photo.height, photo.width, cv.CV_8UC1, photo.grey());
  photo.free();
  const [detector, points, descriptors, mask] = [new cv.ORB(feature_defaults().multiscale.number), new cv.KeyPointVector(), new cv.Mat(), new cv.Mat()];
  detector.detectAndCompute(image, mask, points, descriptors);
  const start = performance.now();
  detector.detectAndCompute(image, mask, points, descriptors);
  const ms = performance.now() - start;
  const positions = Array.from({ length: points.size() }, (_, k) => points.get(k).pt).map(({ x, y }) => [x + 0.5, y + 0.5]);
  for (const part of [image, detector, points, mask]) part.delete();
  return { positions, descriptors, ms };
}

/** @param {import('./pairs.mjs').Pair[]} pairs @returns {Promise<import('./ours.mjs').Entry[]>} */
export async function byOpenCvJs(pairs) {
  const { cv } = await library();
  return pairs.map(({ name, a, b, cameras }) => {
    const [left, right] = [described(cv, name, a), described(cv, name, b)];
    const start = performance.now();
    const pairs = mutual(cv, left.descriptors, right.descriptors);
    const matching = performance.now() - start;
    const all = pairs.map(([i, j]) => [...(left.positions[i] ?? []), ...(right.positions[j] ?? [])]);
    const began = performance.now();
    const matches = cameras ? all : onPlane(cv, all);
    const geometry = performance.now() - began;
    for (const side of [left, right]) side.descriptors.delete();
    const seconds = { features: (left.ms + right.ms) / 1000, matching: matching / 1000, geometry: geometry / 1000 };
    return { case: name, a, b, matches, R: null, t: null, points: [left, right].map((side) => side.positions.length), seconds };
  });
}

/** @param {any} cv @param {any} left @param {any} right @returns {[number, number][]} */
function mutual(cv, left, right) {
  const [matcher, two, back, mask] = [new cv.BFMatcher(cv.NORM_HAMMING, false), new cv.DMatchVectorVector(), new cv.DMatchVector(), new cv.Mat()];
  matcher.knnMatch(left, right, two, 2, mask, false);
  matcher.match(right, left, back, mask);
  const partner = Array.from({ length: back.size() }, (_, k) => back.get(k).trainIdx);
  /** @type {[number, number][]} */
  const found = [];
  for (let k = 0; k < two.size(); k++) {
    const of = two.get(k);
    const [best, second] = [of.get(0), of.get(1)];
    if (best && second && best.distance < 0.8 * second.distance && partner[best.trainIdx] === best.queryIdx) found.push([best.queryIdx, best.trainIdx]);
    of.delete();
  }
  for (const part of [matcher, two, back, mask]) part.delete();
  return found;
}

/** Those that agree with a homography at 1 px.  @param {any} cv @param {number[][]} matches */
function onPlane(cv, matches) {
  if (matches.length < 4) return matches;
  const side = (/** @type {number} */ first) =>
    cv.matFromArray(
      matches.length,
      1,
      cv.CV_32FC2,
      matches.flatMap((m) => m.slice(first, first + 2)),
    );
  const [left, right, mask] = [side(0), side(2), new cv.Mat()];
  const homography = cv.findHomography(left, right, cv.USAC_MAGSAC, 1.0, mask, 2000, 0.9999);
  const kept = matches.filter((_, k) => mask.data[k]);
  for (const part of [left, right, mask, homography]) part.delete();
  return kept;
}
