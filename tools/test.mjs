#!/usr/bin/env node
/**
 * `npm test`: sets up what is missing and runs every check; the last line gives the totals. Names of groups run these alone:
 * `npm test -- rust wasm build types package command page`; `npm test -- quick` is the inner loop: formatting, lints, types, unit tests.
 */

import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { compareFolders } from './lib/compare.mjs';
import { cargoCounts, tapCounts } from './lib/counts.mjs';
import { DIST, PKG_WASM, readJson, ROOT, TARGET } from './lib/paths.mjs';
import { must, run } from './lib/process.mjs';
import { cargo, ensureBindgen, ensureToolchain, WASM_TARGET } from './lib/rust.mjs';
import { ensureChromium, ensurePackages } from './lib/setup.mjs';
import { Steps } from './lib/steps.mjs';

/** Files of tests of the command that run at the same time: as many as the processors of a small machine. */
const COMMAND_FILES = 2;

const GROUPS = ['rust', 'wasm', 'build', 'types', 'package', 'command', 'page'];

/** @typedef {import('./lib/rust.mjs').Toolchain} Toolchain @typedef {import('./lib/rust.mjs').BindgenPrograms} BindgenPrograms */

/** @param {Toolchain} toolchain @param {string[]} args @param {Record<string, string>} [env] */
const mustCargo =
  (toolchain, args, env = {}) =>
  async () =>
    void (await must(...cargo(toolchain, args), { env, quiet: true }));

/** Formatting and lints.  @param {Steps} steps @param {Toolchain} toolchain */
async function rustLints(steps, toolchain) {
  await steps.check('rust', 'formatting', mustCargo(toolchain, ['fmt', '--check']));
  await steps.check('rust', 'clippy, native', mustCargo(toolchain, ['clippy', '--locked', '--all-targets', '--', '-D', 'warnings']));
}

/** @param {Steps} steps @param {Toolchain} toolchain */
async function rustTests(steps, toolchain) {
  await steps.check('rust', 'rustdoc', mustCargo(toolchain, ['doc', '--locked', '--no-deps', '--lib'], { RUSTDOCFLAGS: '-D warnings' }));
  // Examples are compiled by clippy: linking them takes longer than all tests of a module.
  await steps.check('rust', 'tests, native', () => cargoTest(toolchain, ['--lib', '--tests', '--', '--show-output']));
  await steps.check('rust', 'examples of the documentation', () => cargoTest(toolchain, ['--doc']));
}

/** Runs cargo's tests without their chatter; a failure shows all of it.  @param {Toolchain} toolchain @param {string[]} args @param {Record<string, string>} [env] */
async function cargoTest(toolchain, args, env = {}) {
  const { code, output } = await run(...cargo(toolchain, ['test', '--locked', '--no-fail-fast', ...args]), { env, quiet: true });
  console.log(
    code === 0
      ? output
          .split('\n')
          .filter((line) => /Running|Doc-tests|test result|skipped: /.test(line))
          .join('\n')
      : output,
  );
  return cargoCounts(output, code);
}

/** The library and those integration tests that have tests for wasm: the others need not be compiled for it.  @returns {string[]} */
function wasmTargets() {
  const tests = readdirSync(join(ROOT, 'tests')).filter(
    (file) => file.endsWith('.rs') && readFileSync(join(ROOT, 'tests', file), 'utf8').includes('wasm_bindgen_test'),
  );
  return ['--target', WASM_TARGET, '--lib', ...tests.sort().flatMap((file) => ['--test', file.replace(/\.rs$/, '')])];
}

/** @param {Steps} steps @param {Toolchain} toolchain @param {BindgenPrograms} programs */
async function wasmTests(steps, toolchain, programs) {
  const env = { CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER: programs.runner, WASM_BINDGEN_TEST_TIMEOUT: '600' };
  await steps.check('wasm', 'clippy, wasm', mustCargo(toolchain, ['clippy', '--locked', ...wasmTargets(), '--', '-D', 'warnings']));
  await steps.check('wasm', 'tests, wasm under Node', () => cargoTest(toolchain, wasmTargets(), env));
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
    return compareFolders('dist', DIST, out, (file) => file !== 'tiepoint.html');
  });
}

/** @param {Steps} steps */
async function typeChecks(steps) {
  const program =
    (/** @type {string[]} */ path, /** @type {string[]} */ ...args) =>
    async () =>
      void (await must(process.execPath, [join(ROOT, 'node_modules', ...path), ...args]));
  const tsc = (/** @type {string} */ project) => program(['typescript', 'bin', 'tsc'], '--noEmit', '-p', project);
  await steps.check('types', 'format and lints of JavaScript and TypeScript', program(['@biomejs', 'biome', 'bin', 'biome'], 'ci', '--error-on-warnings'));
  await steps.check('types', 'types of the page', tsc('tsconfig.json'));
  await steps.check('types', 'types of package, tools and tests', tsc('tsconfig.node.json'));
  await steps.check('types', 'layers, texts and edits of the page, judge of the bench', () =>
    nodeTest(['layers', 'words', 'judge', 'edits'].map((name) => join(ROOT, 'tests', `${name}.test.js`))),
  );
}

/** `concurrency`: so many files at the same time.  @param {Steps} steps @param {string} group @param {string} name @param {Record<string, string>} env */
async function nodeTests(steps, group, name, env, concurrency = 1) {
  const folder = join(ROOT, 'tests', group);
  const files = readdirSync(folder)
    .filter((file) => file.endsWith('.test.js'))
    .sort()
    .map((file) => join(folder, file));
  await steps.check(group, name, () => nodeTest(files, env, concurrency));
}

/** Runs Node's tests without their chatter; a failure shows all of it.  @param {string[]} files @param {Record<string, string>} [env] */
async function nodeTest(files, env = {}, concurrency = 1) {
  const { code, output } = await run(process.execPath, ['--test', '--test-reporter=tap', `--test-concurrency=${concurrency}`, ...files], { env, quiet: true });
  console.log(
    code === 0
      ? output
          .split('\n')
          .filter((line) => /^# \w+ \d|# SKIP/.test(line))
          .join('\n')
      : output,
  );
  return tapCounts(output, code);
}

/** What is run again and again while one works: no wasm, no browser.  @param {Steps} steps */
async function quick(steps) {
  await steps.prepare('npm packages', () => ensurePackages().then(() => true));
  const toolchain = await steps.prepare('Rust', ensureToolchain);
  await typeChecks(steps);
  if (!toolchain) return;
  await rustLints(steps, toolchain);
  await steps.check('rust', 'unit tests, native', () => cargoTest(toolchain, ['--lib']));
}

/** @param {Steps} steps */
async function everything(steps) {
  const needs = (/** @type {string[]} */ ...groups) => groups.some((group) => steps.wanted(group));
  const packages = needs('build', 'types', 'page') && (await steps.prepare('npm packages', () => ensurePackages().then(() => true)));
  const toolchain = needs('rust', 'wasm', 'build', 'package') ? await steps.prepare('Rust', ensureToolchain) : null;

  // Linking the module and optimising it keep one core busy for minutes: the native tests take the other one.
  const building = (async () => {
    const programs = toolchain && needs('wasm', 'build') ? await steps.prepare('wasm-bindgen', () => ensureBindgen(toolchain)) : null;
    if (toolchain && programs && packages) await rebuild(steps, toolchain, programs);
    return programs;
  })();
  const testing = (async () => {
    if (!toolchain) return;
    await rustLints(steps, toolchain);
    await rustTests(steps, toolchain);
  })();
  const [programs] = await Promise.all([building, testing]);

  if (toolchain && programs) await wasmTests(steps, toolchain, programs);
  if (packages) await typeChecks(steps);
  if (toolchain) await nodeTests(steps, 'package', 'tests, contents of crate and package', { CARGO_TOOLCHAIN: toolchain.name });
  // The files of its tests share nothing, and each waits for one process at a time.
  await nodeTests(steps, 'command', 'tests, command', {}, COMMAND_FILES);
  const chromium = needs('page') ? await steps.prepare('Chromium', ensureChromium) : null;
  if (packages) await nodeTests(steps, 'page', 'tests, page in Chromium', { CHROMIUM: chromium?.path ?? '', NO_CHROMIUM: chromium?.reason ?? '' });
}

async function main() {
  const named = process.argv.slice(2);
  const isQuick = named.length === 1 && named[0] === 'quick';
  const unknown = named.find((group) => !GROUPS.includes(group));
  if (unknown && !isQuick) {
    console.error(`there is no group ${unknown}; allowed: ${GROUPS.join(', ')}, or quick alone`);
    return 2;
  }
  const steps = new Steps((group) => isQuick || named.length === 0 || named.includes(group));
  await (isQuick ? quick(steps) : everything(steps));
  return steps.report() === 0 ? 0 : 1;
}

process.exitCode = await main();
