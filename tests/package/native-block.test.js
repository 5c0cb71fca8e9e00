/** A native program runs a block by the crate alone, and writes what the command writes. */

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { contents, photographed, records } from '../command/blocks.js';
import { folder, json } from '../command/command.js';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const TOOLCHAIN = process.env.CARGO_TOOLCHAIN ?? 'stable';

/** The example as it is built, with the library that the examples of the documentation have compiled (`tools/test.mjs`).  @param {string[]} args */
function natively(...args) {
  const cargo = ['run', TOOLCHAIN, 'cargo', 'run', '--locked', '--quiet', '--profile', 'test', '--example', 'run_block', '--', ...args];
  const env = { ...process.env, CARGO_PROFILE_TEST_OPT_LEVEL: '0' };
  const { status, stderr } = spawnSync('rustup', cargo, { cwd: ROOT, encoding: 'utf8', env });
  assert.equal(status, 0, stderr);
  return stderr;
}

test('a native program writes the same bytes as the command, and takes up what the command has kept', () => {
  const { photos } = photographed();
  const [ours, own] = [folder(), folder()];
  json('block', photos, '--out', ours, '--workers', '2');
  natively(photos, own);
  const wanted = contents(ours);
  const made = contents(own);
  assert.ok(wanted.get('project.tiepoint')?.equals(made.get('project.tiepoint') ?? Buffer.alloc(0)), 'project.tiepoint differs');
  assert.deepEqual(
    [...made.keys()],
    [...wanted.keys()].filter((name) => made.has(name)),
  );
  for (const [name, content] of made) assert.ok(wanted.get(name)?.equals(content), name);
  // Keys and records are the same: built of the same sources, what one host has kept is done for the other.
  const before = records(ours, 'pairs');
  const told = natively(photos, ours);
  assert.match(told, /Pairs: 15 of 15/);
  assert.equal(records(ours, 'pairs'), before);
  const kept = (/** @type {string} */ at) => [...contents(join(at, 'work')).keys()].filter((name) => name.endsWith('.record')).sort();
  assert.deepEqual(kept(own), kept(ours));
});
