/** Multi-scale points and their descriptors: time in wasm, and repeatability and right matches beside native OpenCV's SIFT. */

import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { feature_defaults } from '../../pkg/node.js';
import { DATA, readJson } from '../lib/paths.mjs';
import { have, photoOf } from './data.mjs';

/** Points of one image: x, y and scale in px, stride 3, with 128 bytes each.  @typedef {{ points: Float64Array, descriptors: Uint8Array }} Described */

/** What a rival finds, run by the Python in TIEPOINT_PYTHON (with OpenCV): positions for pixel centres at halves. Its own threshold of contrast would leave it far fewer points. */
const RIVAL = `
import base64, json, sys, time
import cv2, numpy
cv2.setNumThreads(1)
out = []
for path in sys.argv[3:]:
    image = cv2.imread(path, cv2.IMREAD_GRAYSCALE | cv2.IMREAD_IGNORE_ORIENTATION)
    sift, times = cv2.SIFT_create(int(sys.argv[1]), contrastThreshold=0.005), []
    for _ in range(int(sys.argv[2])):
        start = time.process_time(); keys, described = sift.detectAndCompute(image, None); times.append(1000 * (time.process_time() - start))
    points = numpy.array([(k.pt[0] + .5, k.pt[1] + .5, k.size / 2) for k in keys], '<f8')
    text = lambda a: base64.b64encode(a.tobytes()).decode()
    out.append({'ms': times, 'points': text(points), 'descriptors': text(described.astype('u1'))})
print(json.dumps({'version': cv2.__version__, 'images': out}))
`;

/** Images whose times are told. */
const TIMED = [
  ['simulated-a', 'left.png'],
  ['truth_terrestrial_fountain', '0003.jpg'],
  ['block_caliterra', 'IMG_9404.jpg'],
  ['pair_full_caliterra', 'IMG_9401.jpg'],
];

/** @param {string} name @param {string} file @returns {Described} */
function ours(name, file) {
  const photo = photoOf(name, file);
  const { points, descriptors } = photo.features({});
  photo.free();
  return { points: Float64Array.from({ length: (points.length / 5) * 3 }, (_, k) => points[Math.floor(k / 3) * 5 + (k % 3)] ?? NaN), descriptors };
}

/** @param {string} name @param {string[]} files @returns {{ version: string, images: (Described & { ms: number[] })[] } | null} */
function rivals(name, files, runs = 1) {
  const python = process.env.TIEPOINT_PYTHON;
  if (!python) return null;
  const paths = files.map((file) => join(DATA, name, file));
  const { status, stdout, stderr } = spawnSync(python, ['-c', RIVAL, String(feature_defaults().multiscale.number), String(runs), ...paths], {
    maxBuffer: 1 << 28,
  });
  if (status !== 0) throw new Error(`OpenCV did not run: ${stderr}`);
  const { version, images } = JSON.parse(String(stdout));
  const bytes = (/** @type {string} */ text) => new Uint8Array(Buffer.from(text, 'base64'));
  return {
    version,
    images: images.map((/** @type {{ ms: number[], points: string, descriptors: string }} */ image) => ({
      ms: image.ms,
      points: new Float64Array(bytes(image.points).buffer),
      descriptors: bytes(image.descriptors),
    })),
  };
}

/** Runs of each, the first of which does not count. */
const RUNS = 10;

/** Processor times of an action in ms: what else the machine does counts little.  @param {() => unknown} action */
function processorMs(action) {
  return Array.from({ length: RUNS }, () => {
    const start = process.cpuUsage();
    action();
    const { user, system } = process.cpuUsage(start);
    return (user + system) / 1000;
  });
}

/** Median and range of times after a warm-up.  @param {number[]} times */
function spread(times) {
  const sorted = times.slice(1).sort((a, b) => a - b);
  const [median = NaN, least = NaN, most = NaN] = [sorted[sorted.length >> 1], sorted[0], sorted.at(-1)];
  return { median, text: `${median.toFixed(0)} ms (${least.toFixed(0)} to ${most.toFixed(0)})` };
}

function times() {
  console.log(
    `Features: processor time of detection and description (wasm in Node, warm; beside it OpenCV SIFT with a low threshold of contrast, native; one thread each, as many points of both, medians and ranges of ${RUNS - 1} runs)`,
  );
  for (const [name = '', file = ''] of TIMED.filter(([name = '']) => have(name))) {
    const photo = photoOf(name, file);
    const rival = rivals(name, [file], RUNS)?.images[0];
    const options = { multiscale: rival ? { number: rival.points.length / 3 } : {} };
    const number = photo.features(options).points.length / 5;
    const own = spread(processorMs(() => photo.features(options)));
    const upright = spread(processorMs(() => photo.features({ ...options, gradient: { upright: true } })));
    const theirs = rival && spread(rival.ms);
    const beside = theirs ? `; OpenCV ${theirs.text} for ${rival.points.length / 3}, ratio ${(own.median / theirs.median).toFixed(2)}` : '';
    console.log(`  ${name} ${file} (${((photo.width * photo.height) / 1e6).toFixed(1)} MP): ${number} points in ${own.text}, upright ${upright.text}${beside}`);
    photo.free();
  }
}

/** The place of a point in the other image by a homography for pixel centres at whole numbers.  @param {number[][]} h @param {number} x @param {number} y */
export function projected(h, x, y) {
  const [a = 0, b = 0, w = 1] = h.map(([p = 0, q = 0, r = 0]) => p * (x - 0.5) + q * (y - 0.5) + r);
  return [a / w + 0.5, b / w + 0.5];
}

/**
 * The share of the points seen in both images that lie within 1.5 px of a point of the other image whose scale fits within a factor of 1.5,
 * and the right ones (3 px) of the matches that are mutually nearest with a ratio below 0.8.
 * @param {Described} a @param {Described} b @param {number[][]} h @param {number} width @param {number} height of the second image
 */
function score(a, b, h, width, height) {
  let [seen, repeated] = [0, 0];
  for (let i = 0; i < a.points.length; i += 3) {
    const [x = 0, y = 0, scale = 1] = a.points.subarray(i, i + 3);
    const [u = 0, v = 0] = projected(h, x, y);
    if (u < 8 || v < 8 || u > width - 8 || v > height - 8) continue;
    const [px = 0, py = 0] = projected(h, x + 1, y);
    const [qx = 0, qy = 0] = projected(h, x, y + 1);
    const there = scale * Math.sqrt(Math.abs((px - u) * (qy - v) - (qx - u) * (py - v)));
    seen++;
    for (let j = 0; j < b.points.length; j += 3) {
      const [s = 0, t = 0, other = 1] = b.points.subarray(j, j + 3);
      if (Math.hypot(s - u, t - v) <= 1.5 && Math.max(there / other, other / there) <= 1.5) {
        repeated++;
        break;
      }
    }
  }
  const pairs = matches(a.descriptors, b.descriptors);
  const right = pairs.filter(([i = 0, j = 0]) => {
    const [u = 0, v = 0] = projected(h, a.points[3 * i] ?? NaN, a.points[3 * i + 1] ?? NaN);
    return Math.hypot(u - (b.points[3 * j] ?? NaN), v - (b.points[3 * j + 1] ?? NaN)) <= 3;
  }).length;
  return `${a.points.length / 3} and ${b.points.length / 3} points, repeatability ${(repeated / seen).toFixed(3)}, right matches ${right} of ${pairs.length}`;
}

/** Mutually nearest descriptors with a ratio of distances below 0.8, compared one by one.  @param {Uint8Array} a @param {Uint8Array} b */
function matches(a, b) {
  const [m, n] = [a.length / 128, b.length / 128];
  const [best, second, partner] = [new Int32Array(m).fill(2 ** 30), new Int32Array(m).fill(2 ** 30), new Int32Array(m)];
  const [back, backBest] = [new Int32Array(n), new Int32Array(n).fill(2 ** 30)];
  for (let i = 0; i < m; i++) {
    for (let j = 0; j < n; j++) {
      let sum = 0;
      for (let k = 0; k < 128; k++) {
        const d = (a[128 * i + k] ?? 0) - (b[128 * j + k] ?? 0);
        sum += d * d;
      }
      if (sum < (best[i] ?? 0)) {
        second[i] = best[i] ?? 0;
        best[i] = sum;
        partner[i] = j;
      } else if (sum < (second[i] ?? 0)) second[i] = sum;
      if (sum < (backBest[j] ?? 0)) {
        backBest[j] = sum;
        back[j] = i;
      }
    }
  }
  return Array.from({ length: m }, (_, i) => [i, partner[i] ?? 0]).filter(([i = 0, j = 0]) => back[j] === i && (best[i] ?? 0) < 0.64 * (second[i] ?? 0));
}

function repeatability() {
  const name = 'homography_graf';
  if (!have(name)) return;
  for (const { a, b, H } of readJson(join(DATA, name, 'truth.json')).homographies) {
    const { width, height } = photoOf(name, b);
    console.log(`Features: repeatability, ${name} ${a} ${b}`);
    console.log(`  ours: ${score(ours(name, a), ours(name, b), H, width, height)}`);
    const rival = rivals(name, [a, b]);
    const [c, d] = rival?.images ?? [];
    if (c && d) console.log(`  OpenCV ${rival?.version} SIFT: ${score(c, d, H, width, height)}`);
  }
}

/** What `node tools/bench/features.mjs` tells. */
export function featureBench() {
  if (!process.env.TIEPOINT_PYTHON) console.log('OpenCV: skipped, TIEPOINT_PYTHON names no Python that has it');
  times();
  repeatability();
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) featureBench();
