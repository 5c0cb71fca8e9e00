/** Data flows one way through the page: which file may import which. */

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, posix } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { importsOf } from './syntax.js';

const WWW = join(dirname(dirname(fileURLToPath(import.meta.url))), 'www');

/** The rooms of a part, from the first to the last: a file imports its own room and those before it. */
const ROOMS = ['crate', 'choices', 'text', 'state', 'engine', 'view', 'files', 'panel', 'mount'];

/** The parts; a part imports `shared` and itself. */
const PARTS = ['shared', 'pair', 'block'];

/** Files that may look into another part. */
const SEAMS = new Set(['block/pair.ts', 'block/scans.ts']);

/** What puts the parts together, and what runs apart from them. */
const TOP = new Set(['turn.ts', 'main.ts', 'program.ts', 'block.ts', 'worker.ts', 'service-worker.ts']);

const files = readdirSync(WWW, { recursive: true, encoding: 'utf8' })
  .map((file) => file.replaceAll('\\', '/'))
  .filter((file) => /\.ts$/.test(file));

const named = new Map(files.map((file) => [file, importsOf(file, readFileSync(join(WWW, file), 'utf8'))]));

/** The files of the page that each file imports; `isLoaded`: only those that are loaded before it.  @param {boolean} isLoaded */
const importedBy = (isLoaded) =>
  new Map(
    [...named].map(([file, all]) => {
      const paths = all.filter((one) => one.isLoaded || !isLoaded).map(({ from }) => posix.join(posix.dirname(file), from));
      return [file, paths.map((name) => [name, `${name}.ts`, `${name}.d.ts`].find((path) => files.includes(path))).filter((path) => path !== undefined)];
    }),
  );

/** All that each file imports, types too. */
const imports = importedBy(false);
/** What each file has loaded before itself. */
const loads = importedBy(true);

const partOf = (/** @type {string} */ file) => file.split('/')[0] ?? '';
const roomOf = (/** @type {string} */ file) => (SEAMS.has(file) ? 'mount' : (file.split('/')[1] ?? '').replace(/\.ts$/, ''));

/** Each import of a file by another, as [from, to]. */
const edges = [...imports].flatMap(([from, named]) => named.map((to) => /** @type {[string, string]} */ ([from, to])));

test('every file has a place', () => {
  const homeless = files.filter((file) => !TOP.has(file) && !(PARTS.includes(partOf(file)) && ROOMS.includes(roomOf(file))));
  assert.deepEqual(homeless, []);
  assert.ok(edges.length > 300, `only ${edges.length} imports were found`);
});

test('shared imports no part, and no part another one', () => {
  const wrong = edges.filter(([from, to]) => !TOP.has(from) && !SEAMS.has(from) && partOf(to) !== 'shared' && partOf(to) !== partOf(from));
  assert.deepEqual(
    wrong.map((edge) => edge.join(' imports ')),
    [],
  );
});

test('a room imports only rooms before it', () => {
  const place = (/** @type {string} */ file) => ROOMS.indexOf(roomOf(file));
  const wrong = edges.filter(([from, to]) => !TOP.has(from) && place(to) > place(from));
  assert.deepEqual(
    wrong.map((edge) => edge.join(' imports ')),
    [],
  );
});

/** A file with all that is loaded before it.  @param {string} file @param {Set<string>} seen */
function reach(file, seen = new Set()) {
  if (seen.has(file)) return seen;
  seen.add(file);
  for (const to of loads.get(file) ?? []) reach(to, seen);
  return seen;
}

test('the worker says no texts of the page, and the pair needs none of the block', () => {
  assert.equal(reach('worker.ts').has('shared/text/words.ts'), false);
  // What files hold is told before the block is loaded.
  const ofBlock = [...reach('program.ts')].filter((file) => partOf(file) === 'block' && file !== 'block/files/rasters.ts');
  assert.deepEqual(ofBlock, []);
});

test('no files import each other in a circle', () => {
  /** @type {Map<string, 'open' | 'done'>} */
  const seen = new Map();
  /** @type {string[]} */
  const circles = [];
  const visit = (/** @type {string} */ file, /** @type {string[]} */ path) => {
    if (seen.get(file) === 'open') circles.push([...path.slice(path.indexOf(file)), file].join(' > '));
    if (seen.has(file)) return;
    seen.set(file, 'open');
    for (const to of imports.get(file) ?? []) visit(to, [...path, file]);
    seen.set(file, 'done');
  };
  for (const file of files) visit(file, []);
  assert.deepEqual(circles, []);
});
