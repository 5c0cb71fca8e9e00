/** What `npm pack` would publish, installed as a user installs it. */

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, normalize } from 'node:path';
import test, { after } from 'node:test';
import { fileURLToPath } from 'node:url';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const PKG = join(ROOT, 'pkg');
const NPM = process.platform === 'win32' ? 'npm.cmd' : 'npm';

/** @param {string} program @param {string[]} args @param {string} cwd */
function run(program, args, cwd) {
  const { status, stdout, stderr } = spawnSync(program, args, { cwd, encoding: 'utf8', maxBuffer: 1 << 26 });
  assert.equal(status, 0, stderr);
  return stdout;
}

const work = mkdtempSync(join(tmpdir(), 'tiepoint-pack-'));
after(() => rmSync(work, { recursive: true, force: true }));

const README = readFileSync(join(PKG, 'README.md'), 'utf8');

/** @type {{ filename: string, files: { path: string }[] }[]} */
const [pack] = JSON.parse(run(NPM, ['pack', '--json', '--pack-destination', work], PKG).replace(/^[^[]*(?=\[)/, ''));
const files = (pack?.files ?? []).map(({ path }) => path);

test('the package holds the module, both entries with their types, the command, the documents and the licences, and nothing else', () => {
  const { exports, bin, files: listed } = JSON.parse(readFileSync(join(PKG, 'package.json'), 'utf8'));
  // What stands behind a colon is a file; a name before it is what programs import.
  const named =
    JSON.stringify([exports, bin])
      .match(/:"\.\/[^"]+/g)
      ?.map((path) => path.slice(4)) ?? [];
  assert.deepEqual(
    [...named, 'README.md', 'docs/javascript.md', 'LICENSE-APACHE', 'LICENSE-MIT'].filter((file) => !files.includes(file)),
    [],
  );
  assert.deepEqual(
    files.filter((file) => file !== 'package.json' && !listed.includes(file.split('/')[0])),
    [],
  );
  assert.ok(
    files.every((file) => !/test|node_modules|\.map$/.test(file)),
    files.join(' '),
  );
});

test('what a packed document links to is packed, and no copy of it stays beside the sources', () => {
  const home = join(work, 'unpacked');
  mkdirSync(home);
  run('tar', ['-xzf', join(work, pack?.filename ?? ''), '-C', home], work);
  const documents = files.filter((file) => file.endsWith('.md'));
  const linked = documents.flatMap((file) => {
    const text = readFileSync(join(home, 'package', file), 'utf8').replace(/```[\s\S]*?```/g, '');
    return [...text.matchAll(/\]\(([^)#\s]+)(?:#[^)]*)?\)/g)].map(([, link = '']) => normalize(join(dirname(file), link)).replaceAll('\\', '/'));
  });
  assert.ok(linked.includes('docs/javascript.md') && linked.includes('docs/blocks.md'), linked.join(' '));
  assert.deepEqual(
    linked.filter((file) => !files.includes(file)),
    [],
  );
  assert.equal(existsSync(join(PKG, 'docs')), false);
});

test('packed documents call the command as it is installed, and say of other commands that they need the repository', () => {
  const home = join(work, 'documents');
  mkdirSync(home);
  run('tar', ['-xzf', join(work, pack?.filename ?? ''), '-C', home], work);
  const documents = files.filter((file) => file.endsWith('.md')).map((file) => ({ file, text: readFileSync(join(home, 'package', file), 'utf8') }));
  const named = (/** @type {RegExp} */ words) => documents.filter(({ text }) => words.test(text)).map(({ file }) => file);
  assert.deepEqual(named(/pkg\/bin/), []);
  assert.ok(named(/^npx tiepoint match /m).includes('docs/command.md'));
  const ofRepository = named(/(?:npm|cargo) run /);
  assert.ok(ofRepository.includes('docs/placing.md'), ofRepository.join(' '));
  assert.deepEqual(ofRepository, named(/^# .+\n\nCommands that begin with `npm run` or `cargo run` need the project's own repository\.\n\n/));
});

test('the README of the package leads to the documents of the checkout too, and is as it was after it was packed', () => {
  const linked = [...README.matchAll(/\]\(([^)#\s]+)(?:#[^)]*)?\)/g)].map(([, link = '']) => link);
  assert.ok(linked.length > 8, linked.join(' '));
  assert.deepEqual(
    linked.filter((link) => !existsSync(join(PKG, link))),
    [],
  );
  assert.equal(readFileSync(join(PKG, 'README.md'), 'utf8'), README);
});

test('every file that a packed script imports is packed', () => {
  const missing = files
    .filter((file) => file.endsWith('.js'))
    .flatMap((file) => {
      const code = readFileSync(join(PKG, file), 'utf8').replace(/\/\*[\s\S]*?\*\//g, '');
      const imports = [...code.matchAll(/(?:from|import)\s*\(?\s*'(\.[^']+)'/g)].map(([, path]) => path ?? '');
      return imports
        .map((path) => normalize(join(dirname(file), path)).replaceAll('\\', '/'))
        .filter((path) => !files.includes(path))
        .map((path) => `${file}: ${path}`);
    });
  assert.deepEqual(missing, []);
});

test('the installed package matches the sample pair, from a program and by its command', () => {
  const home = join(work, 'home');
  mkdirSync(home);
  writeFileSync(join(home, 'package.json'), '{ "private": true, "type": "module" }');
  run(NPM, ['install', '--offline', '--no-audit', '--no-fund', join(work, pack?.filename ?? '')], home);
  const command = join(home, 'node_modules', '.bin', 'tiepoint');
  run(process.execPath, [command, 'sample', '--out', 'sample'], home);
  assert.ok(readdirSync(join(home, 'sample')).includes('left.png'));
  const program = `
    import { readFileSync } from 'node:fs';
    import { Photo, match_pair } from 'tiepoint';
    const [left, right] = ['left', 'right'].map((name) => Photo.decode(readFileSync('sample/' + name + '.png')));
    console.log(match_pair(left, right, {}, { points: { fraction: 0.148 } }).match.counts.matches);`;
  writeFileSync(join(home, 'program.js'), program);
  assert.ok(Number(run(process.execPath, ['program.js'], home)) > 100);
});
