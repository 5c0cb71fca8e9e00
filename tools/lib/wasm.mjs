/**
 * Builds pkg/wasm from the crate, the same bytes on every machine with the same compiler: all versions are pinned, and every
 * path that could reach the module (checkout, cargo's registry, standard library) is replaced by a fixed name.
 */

import { mkdirSync, readdirSync, readFileSync, realpathSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { homedir } from 'node:os';
import { join } from 'node:path';
import { crateLicences, metadataArgs, treeArgs } from './crates.mjs';
import { explained, withOptional } from './glue.mjs';
import { pinned, ROOT, TARGET } from './paths.mjs';
import { asked, must } from './process.mjs';
import { bindgenVersion, cargo, WASM_TARGET, wantedVersion } from './rust.mjs';

/** What wasm-opt may assume of the engine; every browser that has SIMD has the rest. */
const FEATURES = ['simd', 'bulk-memory', 'nontrapping-float-to-int', 'sign-ext', 'mutable-globals', 'multivalue', 'reference-types'];

const FAST = {
  CARGO_PROFILE_RELEASE_LTO: 'off',
  CARGO_PROFILE_RELEASE_CODEGEN_UNITS: '16',
  CARGO_PROFILE_RELEASE_OPT_LEVEL: '2',
  CARGO_PROFILE_RELEASE_INCREMENTAL: 'true',
};

/**
 * @param {import('./rust.mjs').Toolchain} toolchain @param {import('./rust.mjs').BindgenPrograms} programs
 * @param {string} out folder that receives the module, its JavaScript, its types, BUILD.json, and LICENCES.json of the crates in it
 * @param {boolean} [fast] for the inner loop: neither linked as a whole nor optimised, so that the same numbers come slower and the bytes are others
 */
export async function buildWasm(toolchain, programs, out, fast = false) {
  await must(...cargo(toolchain, ['fetch', '--locked', '--target', WASM_TARGET]), { quiet: true });
  // Before anything is built or removed: whatever is wrong with them is told at once.
  const licences = crateLicences(
    JSON.parse(await asked(...cargo(toolchain, metadataArgs(WASM_TARGET)))),
    await asked(...cargo(toolchain, treeArgs(WASM_TARGET))),
    wantedVersion(),
  );
  const build = ['build', '--locked', '--release', '--lib', '--target', WASM_TARGET, '--target-dir', TARGET];
  await must(...cargo(toolchain, build), { env: { CARGO_ENCODED_RUSTFLAGS: rustFlags(toolchain).join('\x1f'), ...(fast && FAST) } });

  rmSync(out, { recursive: true, force: true });
  mkdirSync(out, { recursive: true });
  const compiled = join(TARGET, WASM_TARGET, 'release', 'tiepoint.wasm');
  // The callers say where the module lies, so that no bundler guesses a second copy of it.
  const bindgen = ['--target', 'web', '--omit-default-module-path', '--remove-name-section', '--remove-producers-section'];
  await must(programs.bindgen, [...bindgen, '--out-dir', out, '--out-name', 'tiepoint', compiled], { quiet: true });
  const glue = join(out, 'tiepoint.js');
  writeFileSync(glue, explained(readFileSync(glue, 'utf8')));
  const types = join(out, 'tiepoint.d.ts');
  writeFileSync(types, withOptional(readFileSync(types, 'utf8')));
  if (!fast) await optimise(join(out, 'tiepoint_bg.wasm'));
  const record = { rustc: toolchain.rustc, wasm_bindgen: bindgenVersion(), binaryen: pinned('binaryen') };
  writeFileSync(join(out, 'BUILD.json'), `${JSON.stringify(record, null, 2)}\n`);
  writeFileSync(join(out, 'LICENCES.json'), `${JSON.stringify(licences, null, 1)}\n`);
}

/** @param {import('./rust.mjs').Toolchain} toolchain @returns {string[]} */
function rustFlags(toolchain) {
  const remap = [
    [ROOT, '/tiepoint'],
    [realpathSync(ROOT), '/tiepoint'],
  ];
  const registry = join(process.env.CARGO_HOME ?? join(homedir(), '.cargo'), 'registry', 'src');
  // The folder below is named after the registry's host.
  for (const host of readdirSync(registry).sort()) {
    remap.push([join(registry, host), '/crates'], [join(realpathSync(registry), host), '/crates']);
  }
  for (const sysroot of [toolchain.sysroot, realpathSync(toolchain.sysroot)]) {
    remap.push([join(sysroot, 'lib', 'rustlib', 'src', 'rust'), `/rustc/${toolchain.commit}`]);
  }
  return ['-Ctarget-feature=+simd128', ...remap.map(([from, to]) => `--remap-path-prefix=${from}=${to}`)];
}

/** @param {string} module optimised in place */
async function optimise(module) {
  const program = join(ROOT, 'node_modules', 'binaryen', 'bin', 'wasm-opt');
  const features = FEATURES.map((name) => `--enable-${name}`);
  await must(process.execPath, [program, module, '-O3', ...features, '--strip-debug', '--strip-producers', '--strip-target-features', '-o', module], {
    quiet: true,
  });
  if (statSync(module).size === 0) throw new Error('wasm-opt wrote an empty module');
}
