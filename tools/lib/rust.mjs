/** The Rust toolchain, always by name: nothing here depends on a default or on automatic installation. */

import { existsSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT, TOOLS } from './paths.mjs';
import { must, run } from './process.mjs';

export const WASM_TARGET = 'wasm32-unknown-unknown';

/** The version rust-toolchain.toml names.  @returns {string} */
export function wantedVersion() {
  const found = /channel\s*=\s*"([^"]+)"/.exec(readFileSync(join(ROOT, 'rust-toolchain.toml'), 'utf8'));
  if (!found?.[1]) throw new Error('rust-toolchain.toml names no channel');
  return found[1];
}

/**
 * @typedef {object} Toolchain
 * @property {string} name as rustup knows it
 * @property {string} rustc the compiler's version line
 * @property {string} commit of the compiler
 * @property {string} sysroot
 */

/** @param {string} name @returns {Promise<Toolchain | null>} null where rustup has no such toolchain */
async function describe(name) {
  const { code, output } = await run('rustup', ['run', name, 'rustc', '-vV'], { quiet: true });
  if (code !== 0) return null;
  const rustc = output.split('\n').find((line) => line.startsWith('rustc ')) ?? '';
  const commit = /commit-hash: (\w+)/.exec(output)?.[1] ?? '';
  const sysroot = (await must('rustup', ['run', name, 'rustc', '--print', 'sysroot'], { quiet: true })).trim();
  return { name, rustc, commit, sysroot };
}

/** The wanted toolchain if it is on this machine, under its number or as `stable`.  @returns {Promise<Toolchain | null>} */
async function findToolchain() {
  const version = wantedVersion();
  for (const name of [version, 'stable']) {
    const toolchain = await describe(name);
    if (toolchain?.rustc.startsWith(`rustc ${version} `)) return toolchain;
  }
  return null;
}

/** Finds or installs the toolchain with its components and the wasm target.  @returns {Promise<Toolchain>} */
export async function ensureToolchain() {
  if ((await run('rustup', ['--version'], { quiet: true })).code !== 0) {
    throw new Error('rustup is not installed: follow https://rustup.rs, then run this again');
  }
  const version = wantedVersion();
  let toolchain = await findToolchain();
  if (!toolchain) {
    console.log(`installing Rust ${version}`);
    await must('rustup', ['toolchain', 'install', version, '--profile', 'minimal', '--no-self-update'], { quiet: true });
    toolchain = await findToolchain();
    if (!toolchain) throw new Error(`rustup installed Rust ${version}, yet rustc ${version} does not run`);
  }
  const has = await must('rustup', ['component', 'list', '--toolchain', toolchain.name, '--installed'], { quiet: true });
  for (const component of ['clippy', 'rustfmt'].filter((c) => !has.includes(c))) {
    console.log(`adding ${component} to Rust ${version}`);
    await must('rustup', ['component', 'add', '--toolchain', toolchain.name, component], { quiet: true });
  }
  if (!has.includes(`rust-std-${WASM_TARGET}`)) {
    console.log(`adding the target ${WASM_TARGET} to Rust ${version}`);
    await must('rustup', ['target', 'add', '--toolchain', toolchain.name, WASM_TARGET], { quiet: true });
  }
  return toolchain;
}

/**
 * The command line that runs cargo of a toolchain.
 * @param {Toolchain} toolchain @param {string[]} args @returns {[string, string[]]}
 */
export const cargo = (toolchain, args) => ['rustup', ['run', toolchain.name, 'cargo', ...args]];

/** The version of the wasm-bindgen crate in Cargo.lock: its programs must be of the same.  @returns {string} */
export function bindgenVersion() {
  const lock = readFileSync(join(ROOT, 'Cargo.lock'), 'utf8');
  const found = /name = "wasm-bindgen"\nversion = "([^"]+)"/.exec(lock);
  if (!found?.[1]) throw new Error('Cargo.lock has no wasm-bindgen');
  return found[1];
}

/** @typedef {{ bindgen: string, runner: string }} BindgenPrograms their paths */

/**
 * Finds wasm-bindgen and its test runner of the right version, or compiles them from tools/wasm-bindgen.
 * @param {Toolchain} toolchain @returns {Promise<BindgenPrograms>}
 */
export async function ensureBindgen(toolchain) {
  const version = bindgenVersion();
  const own = { bindgen: join(TOOLS, 'bin', 'wasm-bindgen'), runner: join(TOOLS, 'bin', 'wasm-bindgen-test-runner') };
  if (await isVersion(own.bindgen, version)) return own;
  console.log(`compiling wasm-bindgen ${version} (once; a few minutes)`);
  const [crate, build] = [join(ROOT, 'tools', 'wasm-bindgen'), join(TOOLS, 'build')];
  const args = ['install', '--locked', '--force', '--path', crate, '--root', TOOLS, '--target-dir', build];
  await must(...cargo(toolchain, args), { quiet: true });
  rmSync(build, { recursive: true });
  if (!(await isVersion(own.bindgen, version))) {
    throw new Error(`tools/wasm-bindgen/Cargo.toml does not give wasm-bindgen ${version}, which Cargo.lock names`);
  }
  return own;
}

/** @param {string} program @param {string} version */
async function isVersion(program, version) {
  if (!existsSync(program)) return false;
  return (await run(program, ['--version'], { quiet: true })).output.includes(` ${version}`);
}
