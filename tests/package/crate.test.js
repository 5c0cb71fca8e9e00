/** What `cargo package` would publish: everything that the crate needs to build, and nothing else. */

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const TOOLCHAIN = process.env.CARGO_TOOLCHAIN ?? 'stable';

/** @param {string[]} args @param {string} [cwd] */
function cargo(args, cwd = ROOT) {
  const { status, stdout, stderr } = spawnSync('rustup', ['run', TOOLCHAIN, 'cargo', ...args], { cwd, encoding: 'utf8', maxBuffer: 1 << 26 });
  assert.equal(status, 0, stderr);
  return stdout;
}

/** @param {string} file of the project @param {RegExp} pattern with one group */
const read = (file, pattern) => pattern.exec(readFileSync(join(ROOT, file), 'utf8'))?.[1];

test('the crate holds its sources, its texts and its licences, and no test, page or data', () => {
  const files = cargo(['package', '--list', '--allow-dirty']).trim().split('\n');
  for (const needed of ['Cargo.toml', 'README.md', 'CHANGELOG.md', 'LICENSE-APACHE', 'LICENSE-MIT', 'src/lib.rs'])
    assert.ok(files.includes(needed), `${needed} is missing`);
  const allowed =
    /^(src\/|examples\/[\w-]+\.rs$|build\.rs$|Cargo\.(toml|toml\.orig|lock)$|README\.md$|docs\/rust\.md$|CHANGELOG\.md$|LICENSE-|\.cargo_vcs_info\.json$)/;
  assert.deepEqual(
    files.filter((file) => !allowed.test(file)),
    [],
  );
});

test('the packed crate compiles by itself', () => {
  const [name, version] = [read('Cargo.toml', /^name = "(.+)"/m), read('Cargo.toml', /^version = "(.+)"/m)];
  cargo(['package', '--no-verify', '--allow-dirty', '--locked']);
  const packed = join(ROOT, 'target', 'package', `${name}-${version}`);
  rmSync(packed, { recursive: true, force: true });
  const unpacked = spawnSync('tar', ['-xzf', `${packed}.crate`, '-C', join(ROOT, 'target', 'package')], { encoding: 'utf8' });
  assert.equal(unpacked.status, 0, unpacked.stderr);
  // Its dependencies are compiled already where the other checks ran.
  cargo(['check', '--locked', '--target-dir', join(ROOT, 'target')], packed);
});

test('the least Rust version that the crate claims is the one that the tests run on', () => {
  const claimed = read('Cargo.toml', /^rust-version = "([\d.]+)"/m) ?? '';
  const channel = read('rust-toolchain.toml', /^channel = "([\d.]+)"/m) ?? '';
  assert.ok(claimed !== '' && channel.startsWith(claimed), `Cargo.toml claims ${claimed}; rust-toolchain.toml names ${channel}`);
});
