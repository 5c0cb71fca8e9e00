/** Simulated blocks on disk, and runs of the command on them, also ones that are ended on the way. */

import { spawn } from 'node:child_process';
import { cpSync, readdirSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { folder, json, NODE, PROGRAM } from './command.js';

/** Small photos that are soon rendered: two strips of three. */
export const SMALL = ['--strips', '2', '--exposures', '3', '--width-px', '480', '--height-px', '360', '--pixel-mm', '0.12', '--workers', '2'];

/** @param {string[]} options @returns {{ photos: string, truth: any, truthFile: string, call: string[] }} its folder of photos, and the call that matches it, without --out */
export function photographed(...options) {
  const { truth, block } = json('simulate', '--block', '--out', folder(), ...SMALL, ...options);
  const photos = block[2];
  return { photos, truthFile: truth, truth: JSON.parse(readFileSync(truth, 'utf8')), call: ['block', photos, '--features', '1200'] };
}

/** Pairs of these photos. */
export const PAIRS = 15;

/**
 * A block that was run from the beginning, with these options. `half`: a folder with what another run finds of it, images and pairs, but nothing that follows
 * from them; `ran`: such a run.
 * @param {string[]} options
 */
export function runOnce(...options) {
  const block = photographed();
  /** @param {string} out @param {string[]} own */
  const run = (out, ...own) => ({ out, summary: json(...block.call, '--out', out, '--workers', '2', ...own) });
  const whole = run(folder(), ...options);
  const half = () => begun(whole.out);
  return { block, whole, half, ran: (/** @type {string[]} */ ...own) => run(half(), ...own) };
}

/**
 * Where the photos of a truth show places in space, as rows of image, point, x, y: photos face any place, whether it is on the ground or not.
 * @param {{ images: any[], cameras: any[] }} truth @param {readonly { name: string, at: readonly number[] }[]} points
 */
export function marksOf({ images, cameras: [camera] }, points) {
  /** @type {string[]} */
  const marks = [];
  for (const { name, at: place } of points) {
    for (const { name: image, pose } of images) {
      const d = place.map((v, k) => v - pose.position[k]);
      const [u = 0, v = 0, w = 0] = pose.rotation.map((/** @type {number[]} */ row) => row.reduce((sum, m, k) => sum + m * (d[k] ?? 0), 0));
      const [x, y] = [camera.width_px / 2 - (camera.focal_px * u) / w, camera.height_px / 2 + (camera.focal_px * v) / w];
      if (w < 0 && x > 0 && y > 0 && x < camera.width_px && y < camera.height_px) marks.push([image, name, x, y].join());
    }
  }
  return marks;
}

/** All files below a folder with their contents, but for those of one folder.  @param {string} at @param {string} [without] @returns {Map<string, Buffer>} */
export function contents(at, without = 'work') {
  /** @type {Map<string, Buffer>} */
  const files = new Map();
  for (const name of readdirSync(at).sort()) {
    const path = join(at, name);
    if (statSync(path).isDirectory()) {
      if (name !== without) for (const [inner, content] of contents(path, without)) files.set(`${name}/${inner}`, content);
    } else files.set(name, readFileSync(path));
  }
  return files;
}

/**
 * Runs the command and kills it as soon as a condition holds, which is asked again and again.
 * @param {string[]} args @param {() => boolean} until @returns {Promise<boolean>} whether it was killed before its end
 */
export function killed(args, until) {
  return new Promise((resolve) => {
    const child = spawn(process.execPath, [...NODE, PROGRAM, ...args], { stdio: 'ignore' });
    const timer = setInterval(() => {
      if (until()) child.kill('SIGKILL');
    }, 1);
    child.on('exit', (_code, signal) => {
      clearInterval(timer);
      resolve(signal === 'SIGKILL');
    });
  });
}

/** A folder that holds what a run has kept of its images and pairs: another run of the block computes them no more.  @param {string} out of that run */
function begun(out) {
  const at = folder();
  for (const part of ['features', 'pairs']) cpSync(join(out, 'work', part), join(at, 'work', part), { recursive: true });
  return at;
}

/** How many records a run has kept.  @param {string} out @param {string} part */
export function records(out, part) {
  try {
    return readdirSync(join(out, 'work', part)).filter((name) => name.endsWith('.record')).length;
  } catch {
    return 0;
  }
}
