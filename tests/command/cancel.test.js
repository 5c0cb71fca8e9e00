/** How long it takes to cancel the command while it runs a block. */

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { test } from 'node:test';
import { photographed, records } from './blocks.js';
import { folder, json, PROGRAM } from './command.js';

/** What a user takes for at once, in ms of a machine that does nothing else. */
const AT_ONCE_MS = 100;

/** How many times as long as alone a process takes now: other tests run beside this one. */
function busyness() {
  const [start, used] = [performance.now(), process.cpuUsage()];
  while (performance.now() - start < 200);
  const { user, system } = process.cpuUsage(used);
  return Math.max(1, (1000 * (performance.now() - start)) / (user + system));
}

/** Runs the command and interrupts it, as Ctrl+C does, as soon as a condition holds; the time until it has ended, in ms.  @param {string[]} args @param {() => boolean} until */
function interrupted(args, until) {
  return new Promise((resolve, reject) => {
    const child = spawn(process.execPath, [PROGRAM, ...args], { stdio: 'ignore' });
    let sent = 0;
    const timer = setInterval(() => {
      if (sent > 0 || !until()) return;
      sent = performance.now();
      child.kill('SIGINT');
    }, 1);
    child.on('exit', (_code, signal) => {
      clearInterval(timer);
      if (signal === 'SIGINT') resolve(performance.now() - sent);
      else reject(new Error('it ended before it was interrupted'));
    });
  });
}

test('the command is cancelled at once, and goes on from what it kept', {
  skip: process.platform === 'win32' && 'signals end no process in order',
}, async () => {
  const { call } = photographed();
  const out = folder();
  /** @type {number[]} */
  const times = [];
  // While features are detected and while pairs are matched.
  for (const [part, number] of /** @type {const} */ ([
    ['features', 1],
    ['features', 4],
    ['pairs', 2],
  ])) {
    times.push((await interrupted([...call, '--out', out], () => records(out, part) >= number)) / busyness());
  }
  assert.ok(Math.min(...times) < AT_ONCE_MS, `${times.map((time) => time.toFixed(0)).join(', ')} ms`);
  const { images } = json(...call, '--out', out);
  assert.equal(images.read, 6);
});
