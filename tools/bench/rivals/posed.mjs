/** What OpenCV's SIFT and USAC_MAGSAC make of any pairs. */

import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { ROOT, readJson } from '../../lib/paths.mjs';
import { must } from '../../lib/process.mjs';
import { PYTHON, pythonLacks } from '../python.mjs';

/**
 * @typedef {{ affine: number[][], radial: [number, number] }} Lens the affine map from px to the picture at a distance of 1 (x right, y down), and its distortion
 * @typedef {{ left: string, right: string, cameras: [Lens, Lens][] }} Job paths of the images, and the cameras with which they are oriented, one pair after the other
 * @typedef {{ matches: number[][], rotation: number[][] | null, direction: number[] | null }} Found matches: x, y in the left and in the right image in px
 */

/** The reason why OpenCV cannot be asked, if there is one. */
export const lacksOpenCv = () => pythonLacks({ cv2: 'opencv-python-headless' });

/** @param {Job[]} jobs @returns {Promise<Found[][]>} of each job, for each of its pairs of cameras */
export async function byOpenCv(jobs) {
  const folder = mkdtempSync(join(tmpdir(), 'tiepoint-opencv-'));
  try {
    const [wanted, found] = ['jobs.json', 'results.json'].map((name) => join(folder, name));
    if (!wanted || !found) throw new Error('two files');
    writeFileSync(wanted, JSON.stringify(jobs));
    await must(PYTHON, [join(ROOT, 'tools', 'bench', 'rivals', 'pairs.py'), wanted, found], { quiet: true });
    return readJson(found);
  } finally {
    rmSync(folder, { recursive: true });
  }
}
