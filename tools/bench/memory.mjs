/** How much memory the command takes for a block of many photos: all of its threads, as the system counts it. */

import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { ROOT } from '../lib/paths.mjs';
import { must } from '../lib/process.mjs';
import { numberOption } from './options.mjs';

const PROGRAM = join(ROOT, 'pkg/bin/tiepoint.js');

/** Photos of 4 million pixels that show the ground of the photos of the usual size. */
const PHOTO = ['--width-px', '2304', '--height-px', '1728', '--pixel-mm', '0.03125'];

/** After so many images every thread has had several, and memory has grown to what an image takes. */
const FIRST = 10;

const STEP_MS = 20;

export async function memory() {
  if (!existsSync('/proc/self/status')) return console.log('Memory: skipped: it is read from /proc, which this system has not');
  const photos = numberOption('photos', 200);
  const workers = String(numberOption('workers', 2));
  const strips = Math.max(1, Math.round(Math.sqrt(photos / 2)));
  const exposures = Math.ceil(photos / strips);
  const folder = mkdtempSync(join(tmpdir(), 'tiepoint-memory-'));
  try {
    await must(process.execPath, [PROGRAM, 'simulate', '--block', '--out', folder, '--strips', String(strips), '--exposures', String(exposures), ...PHOTO], {
      quiet: true,
    });
    const { code, marks, peaks, output } = await watched(join(folder, 'photos'), join(folder, 'block'), workers);
    if (code !== 0) throw new Error(`the block of ${strips * exposures} photos ended with ${code}\n${output.slice(-1500)}`);
    const mb = (/** @type {number} */ kb) => `${(kb / 1000).toFixed(0)} MB`;
    console.log(`Memory of the command, ${strips * exposures} simulated photos of 4 MP, ${workers} workers (resident, all threads; peaks)`);
    console.log(
      `  until ${FIRST} images were done: ${mb(peaks.first)}; during the other images: ${mb(peaks.images)}, ratio ${(peaks.images / peaks.first).toFixed(2)}`,
    );
    console.log(
      `  by shares of the other images: ${tenths(marks)
        .map((kb) => mb(kb))
        .join(', ')}`,
    );
    console.log(`  during the pairs: ${mb(peaks.pairs)}; points and orientation: ${mb(peaks.end)}`);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** @typedef {'first' | 'images' | 'pairs' | 'end'} Phase */

/** Runs the command and looks at its memory.  @param {string} photos @param {string} out @param {string} workers */
function watched(photos, out, workers) {
  /** @type {Record<Phase, number>} */
  const peaks = { first: 0, images: 0, pairs: 0, end: 0 };
  /** Of each look during the images after the first ones, in kB.  @type {number[]} */
  const marks = [];
  let output = '';
  return /** @type {Promise<{ code: number, marks: number[], peaks: Record<Phase, number>, output: string }>} */ (
    new Promise((resolve) => {
      const child = spawn(process.execPath, [PROGRAM, 'block', photos, '--out', out, '--workers', workers], { stdio: ['ignore', 'pipe', 'pipe'] });
      for (const stream of [child.stdout, child.stderr])
        stream.on('data', (chunk) => {
          output += chunk;
        });
      const timer = setInterval(() => {
        const kb = residentKb(child.pid ?? 0);
        const phase = phaseOf(output, join(out, 'work', 'features'));
        peaks[phase] = Math.max(peaks[phase], kb);
        if (phase === 'images') marks.push(kb);
      }, STEP_MS);
      child.on('close', (code) => {
        clearInterval(timer);
        resolve({ code: code ?? 1, marks, peaks, output });
      });
    })
  );
}

/** @param {string} output what the command has said @param {string} features the folder of the images' records @returns {Phase} */
function phaseOf(output, features) {
  if (/^pairs: /m.test(output)) return 'end';
  if (/^images: /m.test(output)) return 'pairs';
  return existsSync(features) && readdirSync(features).length > FIRST ? 'images' : 'first';
}

/** @param {number} pid @returns {number} 0 once the process has ended */
function residentKb(pid) {
  try {
    return Number(/VmRSS:\s+(\d+) kB/.exec(readFileSync(`/proc/${pid}/status`, 'utf8'))?.[1] ?? 0);
  } catch {
    return 0;
  }
}

/** The peaks of ten equal parts of a list.  @param {number[]} list */
function tenths(list) {
  const parts = Math.min(10, list.length);
  const from = (/** @type {number} */ k) => Math.floor((k * list.length) / parts);
  return Array.from({ length: parts }, (_, k) => list.slice(from(k), from(k + 1)).reduce((a, b) => Math.max(a, b)));
}
