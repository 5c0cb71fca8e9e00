/** The crates that are compiled into the module, with versions, licences and their texts, as cargo and the crates' own files state them. */

import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { ROOT } from './paths.mjs';

/**
 * @typedef {{ name: string, version: string, license: string | null, manifest_path: string }} Package
 * @typedef {{ packages: Package[] }} Metadata of `cargo metadata`, which holds packages that only other features need, too
 * @typedef {{ crates: { name: string, version: string, licence: string, text: number }[], texts: string[] }} CrateLicences `text`: its place in `texts`
 */

/** Asks cargo what packages state of themselves. */
export const metadataArgs = (/** @type {string} */ target) => ['metadata', '--format-version', '1', '--locked', '--filter-platform', target];

/** Asks cargo what the module is linked of: neither what builds it nor what its tests need, nor macros, which run in the compiler. */
export const treeArgs = (/** @type {string} */ target) => [
  'tree',
  '--locked',
  '-e',
  'normal,no-proc-macro',
  '--target',
  target,
  '--prefix',
  'none',
  '--format',
  '{p}',
];

/** What a licence is at least long: shorter files name one. */
const LEAST_TEXT = 400;

/** Of crates that hold none: the text of a licence that all of them allow. */
const COMMON = { name: 'Apache-2.0', file: join(ROOT, 'LICENSE-APACHE') };

/** What is linked into every module beside the crates; its licence is that of Rust, by its COPYRIGHT. */
const STANDARD_LIBRARY = { name: 'rust-std', license: 'MIT OR Apache-2.0' };

/** The crates of a tree, each once, without the one at its root.  @param {Metadata} metadata @param {string} tree as cargo answers `treeArgs` @returns {Package[]} */
export function cratesOf({ packages }, tree) {
  const [root, ...linked] = new Set(tree.split('\n').flatMap((line) => /^(\S+) v(\S+)/.exec(line)?.slice(1).join(' ') ?? []));
  if (root === undefined || linked.length === 0) throw new Error('cargo names no crates that the module is linked of');
  return linked.sort().map((crate) => {
    const found = packages.find(({ name, version }) => `${name} ${version}` === crate);
    if (found === undefined) throw new Error(`cargo knows nothing of the crate ${crate}`);
    return found;
  });
}

/** Their licences, and that of Rust's standard library; texts that are the same stand there once.  @param {Metadata} metadata @param {string} tree @param {string} rust its version @returns {CrateLicences} */
export function crateLicences(metadata, tree, rust) {
  /** @type {string[]} */
  const texts = [];
  const listed = (/** @type {string} */ name, /** @type {string} */ version, /** @type {string} */ licence, /** @type {string} */ text) => {
    if (!texts.includes(text)) texts.push(text);
    return { name, version, licence, text: texts.indexOf(text) };
  };
  const crates = cratesOf(metadata, tree).map(({ name, version, license, manifest_path: manifest }) => {
    if (license === null) throw new Error(`the crate ${name} states no licence`);
    return listed(name, version, license, textOf(name, license, dirname(manifest)));
  });
  crates.push(listed(STANDARD_LIBRARY.name, rust, STANDARD_LIBRARY.license, commonText()));
  return { crates, texts };
}

const commonText = () => readFileSync(COMMON.file, 'utf8').trim();

/** The text of a crate's licence: where the crate leaves the choice, the shortest one.  @param {string} name @param {string} licence @param {string} folder */
function textOf(name, licence, folder) {
  const found = readdirSync(folder)
    .filter((file) => /^(un)?licen[cs]e|^copying/i.test(file))
    .sort()
    .map((file) => readFileSync(join(folder, file), 'utf8').replaceAll('\r\n', '\n').trim())
    .filter((text) => text.length >= LEAST_TEXT);
  const isChoice = /\/| OR /.test(licence) && !licence.includes(' AND ');
  if (isChoice) found.sort((a, b) => a.length - b.length).splice(1);
  if (found.length > 0) return found.join('\n\n');
  if (!licence.includes(COMMON.name)) throw new Error(`the crate ${name} holds no text of its licence, ${licence}`);
  return commonText();
}
