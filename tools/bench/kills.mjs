/** The command killed at random moments, and started again each time: its last bytes beside those of a run that nothing interrupted. */

import { spawn } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { ROOT } from '../lib/paths.mjs';
import { must } from '../lib/process.mjs';
import { dice } from './dice.mjs';
import { numberOption } from './options.mjs';

const PROGRAM = join(ROOT, 'pkg/bin/tiepoint.js');
const PHOTOS = ['--strips', '2', '--exposures', '4', '--width-px', '480', '--height-px', '360', '--pixel-mm', '0.12'];

export async function kills() {
  const wanted = numberOption('kills', 20);
  const folder = mkdtempSync(join(tmpdir(), 'tiepoint-kills-'));
  try {
    await must(process.execPath, [PROGRAM, 'simulate', '--block', '--out', folder, ...PHOTOS], { quiet: true });
    const args = (/** @type {string} */ name) => ['block', join(folder, 'photos'), '--out', join(folder, name), '--export', 'colmap,bingo', '--workers', '2'];
    const began = performance.now();
    await must(process.execPath, [PROGRAM, ...args('whole')], { quiet: true });
    const whole = performance.now() - began;
    const expected = contents(join(folder, 'whole'));
    const uniform = dice(numberOption('seed', 1));
    let [done, blocks, wrong] = [0, 0, 0];
    while (done < wanted) {
      const name = `killed-${blocks}`;
      // Later starts find more done, and end sooner: a block is killed until it ends before its moment comes.
      while (done < wanted && (await killed(args(name), uniform() * whole))) done += 1;
      await must(process.execPath, [PROGRAM, ...args(name)], { quiet: true });
      wrong += same(expected, contents(join(folder, name))) ? 0 : 1;
      blocks += 1;
    }
    console.log(
      `Killed ${done} times at random moments within ${(whole / 1000).toFixed(1)} s, started again each time: ${blocks - wrong} of ${blocks} blocks ended with the bytes of an uninterrupted run`,
    );
    if (wrong > 0) throw new Error('a run that was killed and started again gave other bytes');
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** Whether the command was killed before its end.  @param {string[]} args @param {number} afterMs @returns {Promise<boolean>} */
function killed(args, afterMs) {
  return new Promise((resolve) => {
    const child = spawn(process.execPath, [PROGRAM, ...args], { stdio: 'ignore' });
    const timer = setTimeout(() => child.kill('SIGKILL'), afterMs);
    child.on('exit', (_code, signal) => {
      clearTimeout(timer);
      resolve(signal === 'SIGKILL');
    });
  });
}

/** All files below a folder, but for the records of the work.  @param {string} at @returns {Map<string, Buffer>} */
function contents(at) {
  const names = readdirSync(at, { recursive: true, encoding: 'utf8' }).sort();
  const files = names.filter((name) => !/^work(\/|$)/.test(name) && statSync(join(at, name)).isFile());
  return new Map(files.map((name) => [name, readFileSync(join(at, name))]));
}

/** @param {Map<string, Buffer>} a @param {Map<string, Buffer>} b */
const same = (a, b) => a.size === b.size && [...a].every(([name, bytes]) => b.get(name)?.equals(bytes) === true);
