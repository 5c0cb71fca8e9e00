/** What the page is made of beside its own sources: the packages in it, and the crates of its module, with versions and licences. */

import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { PKG_WASM, readJson, ROOT } from './paths.mjs';

/** As `www/shared/panel/licences.d.ts` names it. */
const MODULE = 'virtual:licences';

/** Texts of licences that packages may name without holding them.  @type {Record<string, string>} */
const COMMON = { 'Apache-2.0': join(ROOT, 'LICENSE-APACHE') };

/** @param {string} name a package that the page holds */
function licenceOf(name) {
  const folder = join(ROOT, 'node_modules', name);
  const { version, license } = readJson(join(folder, 'package.json'));
  const file = existsSync(folder) ? readdirSync(folder).find((entry) => /^licen[cs]e(\.\w+)?$/i.test(entry)) : undefined;
  const text = file === undefined ? COMMON[license] : join(folder, file);
  if (typeof license !== 'string' || text === undefined) throw new Error(`the package ${name} states no licence`);
  return { name, version, licence: license, text: readFileSync(text, 'utf8').replaceAll('\r\n', '\n').trim() };
}

/** Those of the crates, as they were listed when the module was built, which takes more than Node.  @returns {import('./crates.mjs').CrateLicences} */
const ofCrates = () => readJson(join(PKG_WASM, 'LICENCES.json'));

/** Gives the page the licences of what it holds: of the module's crates, and of the workspace's `dependencies`, among which everything must be that is bundled.  @type {import('vite').Plugin} */
export const licences = {
  name: 'tiepoint-licences',
  resolveId: (id) => (id === MODULE ? `\0${MODULE}` : null),
  load: (id) => {
    if (id !== `\0${MODULE}`) return null;
    const { dependencies } = readJson(join(ROOT, 'package.json'));
    const packages = Object.keys(dependencies).sort().map(licenceOf);
    return `export const LICENCES = ${JSON.stringify(packages, null, 2)};\nexport const CRATES = ${JSON.stringify(ofCrates(), null, 1)};`;
  },
  generateBundle: (_, bundle) => {
    const { dependencies } = readJson(join(ROOT, 'package.json'));
    const held = Object.values(bundle).flatMap((made) => (made.type === 'chunk' ? Object.keys(made.modules) : []));
    const names = held.map((id) => /node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(id.replaceAll('\\', '/'))?.[1]).filter((name) => name !== undefined);
    const unnamed = [...new Set(names)].find((name) => !(name in dependencies));
    if (unnamed !== undefined) throw new Error(`the page holds ${unnamed}, which is none of the dependencies in package.json: its licence would be missing`);
  },
};
