/** The crates that are compiled into the module, with versions, licences and their texts, as cargo and the crates' own files state them. */

import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { ROOT } from './paths.mjs';

/**
 * @typedef {{ id: string, name: string, version: string, license: string | null, manifest_path: string, targets: { kind: string[] }[] }} Package
 * @typedef {{ packages: Package[], resolve: { root: string, nodes: { id: string, deps: { pkg: string, dep_kinds: { kind: string | null }[] }[] }[] } }} Metadata
 *   of `cargo metadata` for the target of the module
 * @typedef {{ crates: { name: string, version: string, licence: string, text: number }[], texts: string[] }} CrateLicences `text`: its place in `texts`
 */

/** Asks cargo for what `cratesOf` reads. */
export const metadataArgs = (/** @type {string} */ target) => ['metadata', '--format-version', '1', '--locked', '--filter-platform', target];

/** What a licence is at least long: shorter files name one. */
const LEAST_TEXT = 400;

/** Of crates that hold none: the text of a licence that all of them allow. */
const COMMON = { name: 'Apache-2.0', file: join(ROOT, 'LICENSE-APACHE') };

/** The crates that the module is linked of: neither what builds it nor what its tests need, nor macros, which run in the compiler.  @param {Metadata} metadata @returns {Package[]} */
export function cratesOf({ packages, resolve: { root, nodes } }) {
  const byId = new Map(packages.map((one) => [one.id, one]));
  const depends = new Map(nodes.map(({ id, deps }) => [id, deps]));
  /** @type {Set<string>} */
  const linked = new Set();
  const visit = (/** @type {string} */ id) => {
    if (linked.has(id) || byId.get(id)?.targets.some(({ kind }) => kind.includes('proc-macro'))) return;
    linked.add(id);
    for (const { pkg, dep_kinds: kinds } of depends.get(id) ?? []) if (kinds.some(({ kind }) => kind === null)) visit(pkg);
  };
  visit(root);
  linked.delete(root);
  const order = (/** @type {Package} */ { name, version }) => `${name} ${version}`;
  return [...linked].flatMap((id) => byId.get(id) ?? []).sort((a, b) => (order(a) < order(b) ? -1 : 1));
}

/** Their licences; texts that are the same stand there once.  @param {Metadata} metadata @returns {CrateLicences} */
export function crateLicences(metadata) {
  /** @type {string[]} */
  const texts = [];
  const crates = cratesOf(metadata).map(({ name, version, license, manifest_path: manifest }) => {
    if (license === null) throw new Error(`the crate ${name} states no licence`);
    const text = textOf(name, license, dirname(manifest));
    if (!texts.includes(text)) texts.push(text);
    return { name, version, licence: license, text: texts.indexOf(text) };
  });
  return { crates, texts };
}

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
  return readFileSync(COMMON.file, 'utf8').trim();
}
