/** What workers gain for one pair: the search for nearest descriptors in pieces, and the command on a pair of 12 MP. */

import { spawnSync } from 'node:child_process';
import { pathToFileURL } from 'node:url';
import { join } from 'node:path';
import { ThreadPool } from '../../pkg/command/pool.js';
import { ROOT } from '../lib/paths.mjs';
import { pairFiles } from './large.mjs';

const DESCRIPTORS = 10_000;
const BYTES = 128;
const RUNS = 7;
const WORKERS = [1, 2, 3];

export async function workers() {
  console.log(`Nearest neighbours of ${DESCRIPTORS} x ${DESCRIPTORS} descriptors`);
  const [left, right] = [noise(1), noise(2)];
  /** @type {Map<number, ThreadPool>} */
  const pools = new Map(WORKERS.map((count) => [count, new ThreadPool(count)]));
  const times = new Map(WORKERS.map((count) => [count, /** @type {number[]} */ ([])]));
  for (const pool of pools.values()) await searched(pool, left.subarray(0, 100 * BYTES), right.subarray(0, 100 * BYTES));
  // By turns: what else the machine does meets all of them.
  for (let run = 0; run < RUNS; run += 1) for (const [count, pool] of pools) times.get(count)?.push(await searched(pool, left, right));
  await Promise.all([...pools.values()].map((pool) => pool.close()));
  const best = (/** @type {number} */ count) => Math.min(...(times.get(count) ?? []));
  for (const count of WORKERS)
    console.log(`  ${count} workers: ${best(count).toFixed(0)} ms, ${(best(1) / best(count)).toFixed(2)} times as fast as one (best of ${RUNS})`);
  console.log('tiepoint match --strategy gradient, a pair of 12 MP');
  const files = await pairFiles();
  for (const count of WORKERS) console.log(`  ${count} workers: ${matched(files, count)}`);
}

/** Descriptors like nothing.  @param {number} seed */
function noise(seed) {
  let state = seed;
  return Uint8Array.from({ length: DESCRIPTORS * BYTES }, () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return (state >>> 24) % 200;
  });
}

/** @param {ThreadPool} pool @param {Uint8Array} left @param {Uint8Array} right @returns {Promise<number>} ms */
async function searched(pool, left, right) {
  const count = left.length / BYTES;
  const cut = (/** @type {number} */ piece) => Math.round((count * piece) / pool.size);
  const started = performance.now();
  await Promise.all(Array.from({ length: pool.size }, (_, piece) => pool.run('nearest', { left, first: cut(piece), end: cut(piece + 1), right })));
  return performance.now() - started;
}

/** @param {string[]} files @param {number} count */
function matched(files, count) {
  const program = pathToFileURL(join(ROOT, 'pkg', 'command', 'main.js')).href;
  const args = JSON.stringify(['match', ...files, '--strategy', 'gradient', '--workers', String(count)]);
  const script = `import(${JSON.stringify(program)}).then(async ({ main }) => {
    const started = performance.now();
    const code = await main(${args});
    const { maxRSS, userCPUTime } = process.resourceUsage();
    process.stderr.write(JSON.stringify({ code, wall: performance.now() - started, user: userCPUTime / 1000, memory: maxRSS / 1024 }));
  });`;
  const { stderr } = spawnSync(process.execPath, ['-e', script], { encoding: 'utf8' });
  const { code, wall, user, memory } = JSON.parse(stderr);
  if (code !== 0) throw new Error(`tiepoint match ended with ${code}`);
  return `${(wall / 1000).toFixed(1)} s, ${(user / 1000).toFixed(1)} s of processor time, at most ${memory.toFixed(0)} MiB`;
}
