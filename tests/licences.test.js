/** The list of the crates that the module holds, which stands beside it: the page is built of it without cargo. */

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { crateLicences, cratesOf, metadataArgs, treeArgs } from '../tools/lib/crates.mjs';
import { PKG_WASM, ROOT } from '../tools/lib/paths.mjs';
import { WASM_TARGET, wantedVersion } from '../tools/lib/rust.mjs';

const text = readFileSync(join(PKG_WASM, 'LICENCES.json'), 'utf8');
/** @type {import('../tools/lib/crates.mjs').CrateLicences} */
const listed = JSON.parse(text);

test('the crates that are listed are those of Cargo.lock, each with a text of its licence and no path of a machine', () => {
  const lock = readFileSync(join(ROOT, 'Cargo.lock'), 'utf8');
  const locked = new Set([...lock.matchAll(/^name = "(.+)"\nversion = "(.+)"$/gm)].map(([, name, version]) => `${name} ${version}`));
  // It comes with the compiler.
  const standard = `rust-std ${wantedVersion()}`;
  assert.deepEqual(
    listed.crates.map(({ name, version }) => `${name} ${version}`).filter((crate) => !locked.has(crate)),
    [standard],
  );
  assert.ok(listed.crates.length > 20, `only ${listed.crates.length} crates`);
  assert.deepEqual(
    listed.crates.filter(({ licence, text: at }) => licence === '' || (listed.texts[at]?.length ?? 0) < 400),
    [],
  );
  assert.equal(new Set(listed.texts).size, listed.texts.length);
  assert.doesNotMatch(text, /\.cargo|registry\/src|\/(?:home|root|Users)\//);
});

/** What cargo answers without the network; null where there is no cargo, or it lacks the crates.  @param {string[]} args */
function answered(args) {
  const { status, stdout, stderr, error } = spawnSync('cargo', [...args, '--offline'], { cwd: ROOT, encoding: 'utf8', maxBuffer: 1 << 26 });
  if (/** @type {NodeJS.ErrnoException | undefined} */ (error)?.code === 'ENOENT') return null;
  if (status !== 0 && /(?:using|in the) offline mode|--offline was specified/.test(stderr)) return null;
  assert.ok(status === 0, `${error?.message ?? ''}${stderr}`);
  return stdout;
}

test('they are the crates that the module is linked of', (t) => {
  const [metadata, tree] = [metadataArgs, treeArgs].map((args) => answered(args(WASM_TARGET)));
  if (metadata == null || tree == null) {
    t.skip('skipped: no cargo that has the crates of Cargo.lock');
    return;
  }
  assert.deepEqual(listed, crateLicences(JSON.parse(metadata), tree, wantedVersion()));
});

test('what the tree names is listed once, in order, without the module itself; what it does not name is no part of it', () => {
  const one = (/** @type {string} */ name, version = '1.0.0') => ({ name, version, license: 'MIT', manifest_path: '' });
  const metadata = { packages: [one('own'), one('b'), one('b', '2.0.0'), one('a'), one('optional')] };
  const tree = 'own v1.0.0 (/somewhere/own)\nb v2.0.0\na v1.0.0\nb v1.0.0\na v1.0.0 (*)\n\n';
  assert.deepEqual(
    cratesOf(metadata, tree).map(({ name, version }) => `${name} ${version}`),
    ['a 1.0.0', 'b 1.0.0', 'b 2.0.0'],
  );
  assert.throws(() => cratesOf(metadata, `${tree}c v1.0.0\n`), /nothing of the crate c 1\.0\.0/);
  assert.throws(() => cratesOf(metadata, ''), /names no crates/);
});
