/** Matching by descriptors and two-view geometry: how fast the wasm module is in Node, one thread, warm, medians. */

import { join_nearest, match_descriptors, match_guided_descriptors, nearest_piece, orient_relative, two_view } from '../../pkg/node.js';
import { dice } from './dice.mjs';
import { medianMs, spoiled } from './speed.mjs';

const DESCRIPTOR_BYTES = 128;
const [WIDTH, HEIGHT, FOCAL] = [4000, 3000, 3500];

/** @param {string} what @param {number} ms */
const tell = (what, ms) => console.log(`  ${what}: ${ms.toFixed(1)} ms`);

export function geometry() {
  console.log('Matching by descriptors and two-view geometry (wasm in Node, one thread, warm, medians)');
  descriptors();
  for (const share of [0, 0.3, 0.6]) views(share);
  orientations();
}

/** 10,000 descriptors on either side, half of them seen again with other noise. */
function descriptors() {
  const uniform = dice(1);
  const count = 10000;
  const left = Uint8Array.from({ length: count * DESCRIPTOR_BYTES }, () => 120 * uniform() * uniform());
  const right = left.map((v, i) => (i < left.length / 2 ? v + 8 * uniform() : 120 * uniform() * uniform()));
  const found = match_descriptors(left, right, {}).indices.length / 2;
  tell(
    `10,000 x 10,000 descriptors, exactly, ratio and mutual check (${found} matches)`,
    medianMs(7, () => match_descriptors(left, right, {})),
  );
  const pieces = () =>
    join_nearest(
      [0, 1].map((k) => nearest_piece(left, (k * count) / 2, ((k + 1) * count) / 2, right)),
      {},
    );
  const joined = pieces().indices;
  if (joined.length !== 2 * found) throw new Error('pieces give other matches than the whole');
  tell('the same in two pieces', medianMs(7, pieces));
  const positions = Float64Array.from({ length: 2 * count }, (_, i) => uniform() * (i % 2 === 0 ? WIDTH : HEIGHT));
  const shifted = positions.map((v, i) => (i % 2 === 0 ? v + 300 : v + 2 * uniform() - 1));
  const rows = { fundamental: [0, 0, 0, 0, 0, -1, 0, 1, 0] };
  tell(
    'the same guided, within 3 px of epipolar lines',
    medianMs(7, () => match_guided_descriptors(positions, left, shifted, right, rows, {})),
  );
}

/** 2,000 matches of two tilted views over relief, a share of them anywhere.  @param {number} share */
function views(share) {
  const uniform = dice(7);
  const normal = () => (uniform() + uniform() + uniform() + uniform() - 2) * Math.sqrt(3);
  const points = Float64Array.from(Array.from({ length: 2000 }, (_, i) => match(uniform, normal, i < 2000 * share)).flat());
  const camera = { principal_px: [WIDTH / 2, HEIGHT / 2] };
  const known = { ...camera, focal_px: FOCAL };
  const percent = `2,000 matches, ${100 * share} % blunders`;
  /** @param {import('../../pkg/node.js').TwoViewOptions | object} options */
  const time = (options) => medianMs(15, () => two_view(points, options));
  tell(`five points, ${percent}`, time({ left: known, right: known }));
  tell(`seven points, ${percent}`, time({}));
  tell(`seven points and the focal length, ${percent}`, time({ left: camera, right: camera }));
}

/** @param {() => number} uniform @param {() => number} normal @param {boolean} wrong @returns {number[]} */
function match(uniform, normal, wrong) {
  const turn = 0.3;
  for (;;) {
    const [x, y] = [(uniform() - 0.5) * (WIDTH / FOCAL), (uniform() - 0.5) * (HEIGHT / FOCAL)];
    const depth = 1 + 0.15 * (2 * uniform() - 1);
    const [dx, dy, dz] = [x * depth - 0.4, y * depth - 0.05, depth - 0.02];
    const u = (Math.cos(turn) * dx + Math.sin(turn) * dy) / dz;
    const v = (-Math.sin(turn) * dx + Math.cos(turn) * dy) / dz;
    const px = [WIDTH / 2 + FOCAL * x, HEIGHT / 2 + FOCAL * y, WIDTH / 2 + FOCAL * u, HEIGHT / 2 + FOCAL * v];
    const [, , right = 0, below = 0] = px;
    if (right < 0 || right > WIDTH || below < 0 || below > HEIGHT) continue;
    const noisy = px.map((value) => value + 0.5 * normal());
    return wrong ? [...noisy.slice(0, 2), uniform() * WIDTH, uniform() * HEIGHT] : noisy;
  }
}

/** The whole relative orientation with its statistics, of observations in mm. */
function orientations() {
  for (const share of [0, 0.3, 0.6]) {
    const observations = spoiled(share);
    tell(
      `robust orientation of 2,000 observations, ${100 * share} % blunders`,
      medianMs(15, () => orient_relative(observations, 153.38, {}, null)),
    );
  }
}
