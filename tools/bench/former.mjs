/**
 * Processor time of the command beside that of another checkout, run in turns: `npm run bench -- former --checkout=FOLDER`. The adjustment of a pair, which the
 * start of the command outweighs, once more by itself.
 */

import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { ROOT } from '../lib/paths.mjs';
import { asked, must, run } from '../lib/process.mjs';
import { numberOption, textOption } from './options.mjs';
import { normal } from './dice.mjs';
import { median } from './median.mjs';

const PROGRAM = 'pkg/bin/tiepoint.js';
const WARM = fileURLToPath(new URL('warm-adjustment.mjs', import.meta.url));

/** Observations of pairs that are adjusted by themselves. */
const OBSERVATIONS = [20, 200, 5000];

/** Of the small flights below, so that a run of all takes minutes. */
const PHOTO = ['--width-px', '1200', '--height-px', '900', '--pixel-mm', '0.048'];

/** Of the photos of the sample in the scans whose fiducial marks were measured. */
const ORIGINS = { left: '413,107', right: '48,114' };

/** A process that is loaded before the command tells the time it took, of all threads, when it ends. */
const CLOCK = `data:text/javascript,${encodeURIComponent(`
process.on('exit', () => { const { user, system } = process.cpuUsage(); process.stderr.write('\\nprocessor ' + (user + system) + ' us\\n'); });`)}`;

export async function former() {
  const checkout = textOption('checkout');
  if (checkout === null || !existsSync(join(checkout, PROGRAM)))
    return console.log('Former: skipped: --checkout=FOLDER names no other checkout of the project');
  const runs = numberOption('runs', 5);
  const folder = mkdtempSync(join(tmpdir(), 'tiepoint-former-'));
  try {
    const jobs = await made(folder);
    console.log(`Processor time beside ${checkout} (medians of ${runs} runs in turns; the command with its start, all threads)`);
    for (const [name, args] of jobs) await compared(name, 's', runs, (which) => seconds(which === 0 ? ROOT : resolve(checkout), args));
    for (const count of OBSERVATIONS) {
      const table = observations(folder, count);
      await compared(`adjustment of ${count} observations`, 'ms', runs, async (which) =>
        Number(await asked(process.execPath, [WARM, which === 0 ? ROOT : resolve(checkout), table])),
      );
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/**
 * Prints medians of both and their ratio. `time`: of this checkout (0) or the other one.
 * @param {string} name @param {string} unit @param {number} runs @param {(which: 0 | 1) => Promise<number>} time
 */
async function compared(name, unit, runs, time) {
  /** @type {[number[], number[]]} */
  const times = [[], []];
  for (let k = 0; k < runs; k++) {
    // The one that is first changes from run to run.
    for (const which of /** @type {(0 | 1)[]} */ (k % 2 === 0 ? [0, 1] : [1, 0])) times[which].push(await time(which));
  }
  const [own = NaN, other = NaN] = times.map(median);
  console.log(`  ${name.padEnd(34)} ${own.toFixed(2)} ${unit}, former ${other.toFixed(2)} ${unit}, ratio ${(own / other).toFixed(2)}`);
}

/** Writes a table of so many.  @param {string} folder @param {number} count */
function observations(folder, count) {
  const path = join(folder, `observations-${count}.csv`);
  writeFileSync(path, ofModel(count));
  return path;
}

/** Flights by this checkout, and what both do with them.  @param {string} folder @returns {Promise<[string, string[]][]>} */
async function made(folder) {
  const [pair, block] = [join(folder, 'pair'), join(folder, 'block')];
  await must(process.execPath, [join(ROOT, PROGRAM), 'sample', '--out', pair], { quiet: true });
  await must(process.execPath, [join(ROOT, PROGRAM), 'simulate', '--block', '--out', block, '--strips', '2', '--exposures', '4', ...PHOTO], { quiet: true });
  const [left, right] = ['left.png', 'right.png'].map((name) => join(pair, name));
  // With a camera of the fields that earlier releases read, too: without one a pair has no orientation, and is looked at for what would do.
  const { tangential_distortion: _, ...camera } = JSON.parse(readFileSync(join(pair, 'camera.json'), 'utf8'));
  const own = join(folder, 'camera.json');
  writeFileSync(own, JSON.stringify(camera));
  const fiducials = ['left', 'right'].flatMap((side) => [
    `--${side}-fiducials`,
    join(pair, `${side}-fiducials.csv`),
    `--${side}-origin`,
    ORIGINS[/** @type {'left' | 'right'} */ (side)],
  ]);
  const match = (/** @type {string} */ strategy) => ['match', left ?? '', right ?? '', '--camera', own, ...fiducials, '--strategy', strategy, '--json'];
  const orient = (/** @type {number} */ count) => ['orient', observations(folder, count), '--focal-mm', '153', '--base-mm', '92', '--json'];
  const blockOf = (/** @type {string[]} */ ...more) => ['block', join(block, 'photos'), '--out', join(folder, 'out'), '--json', '--workers', '2', ...more];
  return [
    ['help (the start alone)', ['help']],
    ['match, moments', match('moments')],
    ['match, least squares', match('least-squares')],
    ['match, gradient', match('gradient')],
    ['orient, 20 observations', orient(20)],
    ['orient, 5,000 observations', orient(5000)],
    ['block of 8 photos', blockOf()],
  ];
}

/** Observations of a relief under two photos, with errors of 5 µm.  @param {number} count */
function ofModel(count) {
  const error = normal(count);
  const lines = Array.from({ length: count }, (_, i) => {
    const [x, y] = [10 + ((i * 37) % 80), -100 + ((i * 53) % 200)];
    const parallax = 92 + 6 * Math.sin(0.05 * x) * Math.cos(0.03 * y);
    return [x, y, x - parallax, y].map((value) => (value + 0.005 * error()).toFixed(5)).join(',');
  });
  return `x_left_mm,y_left_mm,x_right_mm,y_right_mm\n${lines.join('\n')}\n`;
}

/** @param {string} checkout @param {string[]} args @returns {Promise<number>} of the processor */
async function seconds(checkout, args) {
  const out = args[args.indexOf('--out') + 1];
  if (args.includes('--out') && out !== undefined) rmSync(out, { recursive: true, force: true });
  const { code, output } = await run(process.execPath, ['--import', CLOCK, join(checkout, PROGRAM), ...args], { quiet: true });
  const found = [...output.matchAll(/processor (\d+) us/g)].at(-1);
  // 3 and 4 are verdicts.
  if (!found || ![0, 3, 4].includes(code)) throw new Error(`${args.join(' ')} ended with ${code} in ${checkout}\n${output.slice(-1500)}`);
  return Number(found[1]) / 1e6;
}
