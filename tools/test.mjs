#!/usr/bin/env node
/**
 * `npm test`: sets up what is missing and runs every check; the last line gives the totals. Names of groups run these alone:
 * `npm test -- rust wasm build types package command page firefox`; `npm test -- quick` is the inner loop: formatting, lints, types, unit tests.
 *
 * Without `build` the tracked module is not built anew, which takes ten minutes: a native test compares the digest of the sources that it holds.
 */

import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { compareFolders } from './lib/compare.mjs';
import { cargoCounts, tapCounts } from './lib/counts.mjs';
import { DIST, PKG_WASM, readJson, ROOT, TARGET } from './lib/paths.mjs';
import { must, run } from './lib/process.mjs';
import { cargo, ensureBindgen, ensureToolchain, WASM_TARGET } from './lib/rust.mjs';
import { ensureFirefox, ensureHeadlessChromium, ensurePackages } from './lib/setup.mjs';
import { Steps } from './lib/steps.mjs';

/** Files of tests of the command, and of the page, that run at the same time: as many as the processors of a small machine. */
const FILES = 2;

const GROUPS = ['rust', 'wasm', 'build', 'types', 'package', 'command', 'page', 'firefox'];

/** @typedef {import('./lib/rust.mjs').Toolchain} Toolchain @typedef {import('./lib/rust.mjs').BindgenPrograms} BindgenPrograms */

/** @param {Toolchain} toolchain @param {string[]} args @param {Record<string, string>} [env] */
const mustCargo =
  (toolchain, args, env = {}) =>
  async () =>
    void (await must(...cargo(toolchain, args), { env, quiet: true }));

/** Formatting and lints.  @param {Steps} steps @param {Toolchain} toolchain */
async function rustLints(steps, toolchain) {
  await steps.check('rust', 'formatting', mustCargo(toolchain, ['fmt', '--check']));
  // The integration tests once more, as they see the crate from outside.
  for (const targets of [['--all-targets'], ['--test', 'integration']]) {
    const name = `clippy, native, ${targets.at(-1)?.replace('--', '').replace('-', ' ')}`;
    await steps.check('rust', name, mustCargo(toolchain, ['clippy', '--locked', ...targets, '--', '-D', 'warnings']));
  }
}

/** How the library is compiled for what needs it as others do, and computes little: in a quarter of the time. The decoders beside it stay optimised. */
const UNOPTIMISED = { CARGO_PROFILE_TEST_OPT_LEVEL: '0' };

/** @param {Steps} steps @param {Toolchain} toolchain */
async function rustTests(steps, toolchain) {
  await steps.check('rust', 'rustdoc', mustCargo(toolchain, ['doc', '--locked', '--no-deps', '--lib'], { RUSTDOCFLAGS: '-D warnings' }));
  // The library's own program of tests holds the integration tests, so that the library is compiled once. Examples are compiled by clippy: linking
  // them takes longer than all tests of a module.
  const env = { TIEPOINT_MODULE: join(PKG_WASM, 'tiepoint_bg.wasm'), NODE: process.execPath };
  await steps.check('rust', 'tests, native', () => cargoTest(toolchain, ['--lib', '--', '--show-output'], env));
  await steps.check('rust', 'tests of memory', () => cargoTest(toolchain, ['--test', 'decode_memory'], UNOPTIMISED));
  await steps.check('rust', 'examples of the documentation', () => cargoTest(toolchain, ['--doc'], UNOPTIMISED));
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

/** The library alone: it holds those integration tests that run as wasm (`src/wasm/everywhere.rs`). In the folder of the native build, whose macros serve both. */
const WASM_TARGETS = ['--target', WASM_TARGET, '--lib'];

/** @param {Steps} steps @param {Toolchain} toolchain @param {BindgenPrograms} programs */
async function wasmTests(steps, toolchain, programs) {
  const env = { CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER: programs.runner, WASM_BINDGEN_TEST_TIMEOUT: '600' };
  await steps.check('wasm', 'clippy, wasm', mustCargo(toolchain, ['clippy', '--locked', ...WASM_TARGETS, '--', '-D', 'warnings']));
  await steps.check('wasm', 'tests, wasm under Node', () => cargoTest(toolchain, WASM_TARGETS, env));
}

/** Builds the module beside the tracked one and compares the bytes.  @param {Steps} steps @param {Toolchain} toolchain @param {BindgenPrograms} programs */
async function rebuiltModule(steps, toolchain, programs) {
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
}

/** @param {Steps} steps */
async function rebuiltPage(steps) {
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
  // What needs neither browser nor command: layers, texts and states of the page, judge of the bench.
  await steps.check('types', 'tests without a browser', () => nodeTest(testsIn(join(ROOT, 'tests'))));
}

/** The files of Node's tests in a folder.  @param {string} folder */
function testsIn(folder) {
  const files = readdirSync(folder).filter((file) => file.endsWith('.test.js'));
  return files.sort().map((file) => join(folder, file));
}

/** `concurrency`: so many files at the same time.  @param {Steps} steps @param {string} group @param {string} name @param {Record<string, string>} env */
async function nodeTests(steps, group, name, env, concurrency = 1) {
  await steps.check(group, name, () => nodeTest(testsIn(join(ROOT, 'tests', group)), env, concurrency));
}

/** No file of tests takes a fifth of this: one that hangs is told, and does not hold up all the others. */
const FILE_MS = 900_000;

/** Runs Node's tests without their chatter; a failure shows all of it.  @param {string[]} files @param {Record<string, string>} [env] */
async function nodeTest(files, env = {}, concurrency = 1) {
  const flags = ['--test', '--test-reporter=tap', `--test-concurrency=${concurrency}`, `--test-timeout=${FILE_MS}`];
  const { code, output } = await run(process.execPath, [...flags, ...files], { env, quiet: true });
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
  await steps.check('rust', 'unit tests, native', () => cargoTest(toolchain, ['--lib', '--', '--skip', 'integration::']));
}

/** @param {Steps} steps @param {boolean} rebuilds the module too */
async function everything(steps, rebuilds) {
  const needs = (/** @type {string[]} */ ...groups) => groups.some((group) => steps.wanted(group));
  const packages = needs('build', 'types', 'page', 'firefox') && (await steps.prepare('npm packages', () => ensurePackages().then(() => true)));
  const toolchain = needs('rust', 'wasm', 'build', 'package') ? await steps.prepare('Rust', ensureToolchain) : null;

  // Two lanes for two processors: what cargo does natively, and what Node runs on the tracked module and page. The files of the command's tests,
  // and of the page's, share nothing, and wait for one process or page at a time. What is compiled to wasm comes last, when the folder of the
  // build, which a call of cargo locks, has long been free: native tests take longer to run than to compile.
  const native = async () => {
    if (!toolchain) return;
    await rustLints(steps, toolchain);
    await rustTests(steps, toolchain);
    await nodeTests(steps, 'package', 'tests, contents of crate and package', { CARGO_TOOLCHAIN: toolchain.name });
  };
  const executed = async () => {
    if (packages) await typeChecks(steps);
    if (packages) await rebuiltPage(steps);
    const chromium = needs('page') ? await steps.prepare('Chromium', ensureHeadlessChromium) : null;
    const firefox = needs('firefox') ? await steps.prepare('Firefox', ensureFirefox) : null;
    const programs = { CHROMIUM: chromium?.path ?? '', NO_CHROMIUM: chromium?.reason ?? '', FIREFOX: firefox?.path ?? '', NO_FIREFOX: firefox?.reason ?? '' };
    if (packages) await nodeTests(steps, 'page', 'tests, page in Chromium', programs, FILES);
    if (packages) await nodeTests(steps, 'firefox', 'tests, page in Firefox', programs, FILES);
    await nodeTests(steps, 'command', 'tests, command', {}, FILES);
    const bindgen = toolchain && (needs('wasm') || rebuilds) ? await steps.prepare('wasm-bindgen', () => ensureBindgen(toolchain)) : null;
    if (toolchain && bindgen) await wasmTests(steps, toolchain, bindgen);
    if (toolchain && bindgen && rebuilds) await rebuiltModule(steps, toolchain, bindgen);
  };
  await Promise.all([native(), executed()]);
}

async function main() {
  // A clean checkout is compiled as a whole: what serves a second compilation would only cost.
  if (!existsSync(join(TARGET, 'debug'))) process.env.CARGO_INCREMENTAL ??= '0';
  const named = process.argv.slice(2);
  const isQuick = named.length === 1 && named[0] === 'quick';
  if (named.includes('--help') || named.includes('-h')) {
    console.log(`npm test -- [GROUP …]\n\nGroups: ${GROUPS.join(', ')}, or quick alone; all of them where none is named.`);
    return 0;
  }
  const unknown = named.find((group) => !GROUPS.includes(group));
  if (unknown && !isQuick) {
    console.error(`there is no group ${unknown}; allowed: ${GROUPS.join(', ')}, or quick alone`);
    return 2;
  }
  const steps = new Steps((group) => isQuick || named.length === 0 || named.includes(group));
  await (isQuick ? quick(steps) : everything(steps, named.includes('build')));
  return steps.report() === 0 ? 0 : 1;
}

process.exitCode = await main();
