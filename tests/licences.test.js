/** The list of the crates that the module holds, which stands beside it: the page is built of it without cargo. */

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { crateLicences, cratesOf, metadataArgs } from '../tools/lib/crates.mjs';
import { PKG_WASM, ROOT } from '../tools/lib/paths.mjs';

const text = readFileSync(join(PKG_WASM, 'LICENCES.json'), 'utf8');
/** @type {import('../tools/lib/crates.mjs').CrateLicences} */
const listed = JSON.parse(text);

test('the crates that are listed are those of Cargo.lock, each with a text of its licence and no path of a machine', () => {
  const lock = readFileSync(join(ROOT, 'Cargo.lock'), 'utf8');
  const locked = new Set([...lock.matchAll(/^name = "(.+)"\nversion = "(.+)"$/gm)].map(([, name, version]) => `${name} ${version}`));
  assert.deepEqual(
    listed.crates.map(({ name, version }) => `${name} ${version}`).filter((crate) => !locked.has(crate)),
    [],
  );
  assert.ok(listed.crates.length > 20, `only ${listed.crates.length} crates`);
  assert.deepEqual(
    listed.crates.filter(({ licence, text: at }) => licence === '' || (listed.texts[at]?.length ?? 0) < 400),
    [],
  );
  assert.equal(new Set(listed.texts).size, listed.texts.length);
  assert.doesNotMatch(text, /\.cargo|registry\/src|\/(?:home|root|Users)\//);
});

test('they are the crates that the module is linked of', (t) => {
  const { status, stdout } = spawnSync('cargo', [...metadataArgs('wasm32-unknown-unknown'), '--offline'], { cwd: ROOT, encoding: 'utf8', maxBuffer: 1 << 26 });
  if (status !== 0) {
    t.skip('skipped: no cargo that has the crates of Cargo.lock');
    return;
  }
  assert.deepEqual(listed, crateLicences(JSON.parse(stdout)));
});

test('what builds the module, tests it or runs in the compiler is no part of it', () => {
  const one = (/** @type {string} */ id, kind = 'lib') => ({ id, name: id, version: '1.0.0', license: 'MIT', manifest_path: '', targets: [{ kind: [kind] }] });
  const dep = (/** @type {string} */ pkg, /** @type {string | null} */ kind = null) => ({ pkg, dep_kinds: [{ kind }] });
  const node = (/** @type {string} */ id, .../** @type {ReturnType<typeof dep>[]} */ deps) => ({ id, deps });
  const metadata = {
    packages: [one('own'), one('b'), one('a'), one('macros', 'proc-macro'), one('syntax'), one('builder'), one('tester')],
    resolve: {
      root: 'own',
      nodes: [
        node('own', dep('b'), dep('macros'), dep('builder', 'build'), dep('tester', 'dev')),
        node('b', dep('a')),
        node('a', dep('b')),
        node('macros', dep('syntax')),
      ],
    },
  };
  assert.deepEqual(
    cratesOf(metadata).map(({ name }) => name),
    ['a', 'b'],
  );
});
