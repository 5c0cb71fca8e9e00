#!/usr/bin/env node
/**
 * `npm test`: sets up what is missing and runs every check; the last line tells the totals. Names of groups run these alone:
 * `npm test -- rust wasm build types command page`.
 */

import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { cargoCounts, tapCounts } from './lib/counts.mjs';
import { compareFolders } from './lib/compare.mjs';
import { DIST, PKG_WASM, readJson, ROOT, TARGET } from './lib/paths.mjs';
import { must, run } from './lib/process.mjs';
import { cargo, ensureBindgen, ensureToolchain, WASM_TARGET } from './lib/rust.mjs';
import { ensureChromium, ensurePackages } from './lib/setup.mjs';
import { Steps } from './lib/steps.mjs';

const GROUPS = ['rust', 'wasm', 'build', 'types', 'command', 'page'];

/** @typedef {import('./lib/rust.mjs').Toolchain} Toolchain @typedef {import('./lib/rust.mjs').BindgenPrograms} BindgenPrograms */

/** @param {Steps} steps @param {Toolchain} toolchain */
async function rustChecks(steps, toolchain) {
  const go = (/** @type {string[]} */ ...args) => async () => void (await must(...cargo(toolchain, args)));
  const doc = { env: { RUSTDOCFLAGS: '-D warnings' } };
  await steps.check('rust', 'formatting', go('fmt', '--check'));
  await steps.check('rust', 'clippy, native', go('clippy', '--locked', '--all-targets', '--', '-D', 'warnings'));
  await steps.check('rust', 'clippy, wasm', go('clippy', '--locked', '--target', WASM_TARGET, '--lib', '--tests', '--', '-D', 'warnings'));
  await steps.check('rust', 'rustdoc', async () => void (await must(...cargo(toolchain, ['doc', '--locked', '--no-deps', '--lib']), doc)));
  await steps.check('rust', 'tests, native', () => cargoTest(toolchain, ['--', '--show-output']));
}

/** Runs cargo's tests without their chatter; a failure shows all of it.  @param {Toolchain} toolchain @param {string[]} args @param {Record<string, string>} [env] */
async function cargoTest(toolchain, args, env = {}) {
  const { code, output } = await run(...cargo(toolchain, ['test', '--locked', '--no-fail-fast', ...args]), { env, quiet: true });
  console.log(code === 0 ? output.split('\n').filter((line) => /Running|Doc-tests|test result|skipped: /.test(line)).join('\n') : output);
  return cargoCounts(output, code);
}

/** @param {Steps} steps @param {Toolchain} toolchain @param {BindgenPrograms} programs */
async function wasmTests(steps, toolchain, programs) {
  const env = { CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER: programs.runner, WASM_BINDGEN_TEST_TIMEOUT: '600' };
  await steps.check('wasm', 'tests, wasm under Node', () => cargoTest(toolchain, ['--target', WASM_TARGET, '--lib', '--tests'], env));
}

/** Builds from source beside the tracked files and compares the bytes.  @param {Steps} steps @param {Toolchain} toolchain @param {BindgenPrograms} programs */
async function rebuild(steps, toolchain, programs) {
  await steps.check('build', 'pkg/wasm is what its source gives', async () => {
    const record = existsSync(join(PKG_WASM, 'BUILD.json')) ? readJson(join(PKG_WASM, 'BUILD.json')) : {};
    const { buildWasm } = await import('./lib/wasm.mjs');
    const out = join(TARGET, 'rebuilt', 'wasm');
    await buildWasm(toolchain, programs, out);
    if (record.rustc && record.rustc !== toolchain.rustc) {
      return { skipped: 1, skips: [`built with ${record.rustc}; this machine has ${toolchain.rustc}`] };
    }
    return compareFolders('pkg/wasm', PKG_WASM, out);
  });
  await steps.check('build', 'dist is what its source gives', async () => {
    const { buildPage } = await import('./lib/page.mjs');
    const out = join(TARGET, 'rebuilt', 'dist');
    await buildPage(out);
    return compareFolders('dist', DIST, out);
  });
}

/** @param {Steps} steps */
async function typeChecks(steps) {
  const tsc = (/** @type {string} */ project) => async () =>
    void (await must(process.execPath, [join(ROOT, 'node_modules', 'typescript', 'bin', 'tsc'), '--noEmit', '-p', project]));
  await steps.check('types', 'types of the page', tsc('tsconfig.json'));
  await steps.check('types', 'types of package, tools and tests', tsc('tsconfig.node.json'));
  await steps.check('types', 'layers of the page', () => nodeTest([join(ROOT, 'tests', 'layers.test.js')]));
}

/** @param {Steps} steps @param {string} group @param {string} name @param {Record<string, string>} env */
async function nodeTests(steps, group, name, env) {
  const folder = join(ROOT, 'tests', group);
  const files = readdirSync(folder).filter((file) => file.endsWith('.test.js')).sort().map((file) => join(folder, file));
  await steps.check(group, name, () => nodeTest(files, env));
}

/** Runs Node's tests without their chatter; a failure shows all of it.  @param {string[]} files @param {Record<string, string>} [env] */
async function nodeTest(files, env = {}) {
  const { code, output } = await run(process.execPath, ['--test', '--test-reporter=tap', '--test-concurrency=1', ...files], { env, quiet: true });
  console.log(code === 0 ? output.split('\n').filter((line) => /^# \w+ \d|# SKIP/.test(line)).join('\n') : output);
  return tapCounts(output, code);
}

async function main() {
  const named = process.argv.slice(2);
  const stranger = named.find((group) => !GROUPS.includes(group));
  if (stranger) {
    console.error(`there is no group ${stranger}; allowed: ${GROUPS.join(', ')}`);
    return 2;
  }
  const steps = new Steps((group) => named.length === 0 || named.includes(group));
  const needs = (/** @type {string[]} */ ...groups) => groups.some((group) => steps.wanted(group));

  const packages = needs('build', 'types', 'page') && (await steps.prepare('npm packages', async () => (await ensurePackages(), true)));
  const toolchain = needs('rust', 'wasm', 'build') ? await steps.prepare('Rust', ensureToolchain) : null;
  const programs = toolchain && needs('wasm', 'build') ? await steps.prepare('wasm-bindgen', () => ensureBindgen(toolchain)) : null;
  const chromium = needs('page') ? await steps.prepare('Chromium', ensureChromium) : null;

  if (toolchain) await rustChecks(steps, toolchain);
  if (toolchain && programs) await wasmTests(steps, toolchain, programs);
  if (toolchain && programs && packages) await rebuild(steps, toolchain, programs);
  if (packages) await typeChecks(steps);
  await nodeTests(steps, 'command', 'tests, command', {});
  if (packages) await nodeTests(steps, 'page', 'tests, page in Chromium', { CHROMIUM: chromium?.path ?? '', NO_CHROMIUM: chromium?.reason ?? '' });
  return steps.report() === 0 ? 0 : 1;
}

process.exitCode = await main();
