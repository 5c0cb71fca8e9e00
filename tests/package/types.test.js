/** Programs are checked against the types of the package, whatever libraries of types they have themselves. */

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { after } from 'node:test';
import { fileURLToPath } from 'node:url';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const COMPILER = join(ROOT, 'node_modules/typescript/bin/tsc');
const SKIP = existsSync(COMPILER) ? false : 'the npm packages are not set up';

const home = mkdtempSync(join(tmpdir(), 'tiepoint-types-'));
after(() => rmSync(home, { recursive: true, force: true }));
mkdirSync(join(home, 'node_modules'));
symlinkSync(join(ROOT, 'pkg'), join(home, 'node_modules/tiepoint'), 'junction');
writeFileSync(join(home, 'package.json'), '{ "private": true, "type": "module" }');

const HOSTS = {
  node: { lib: ['es2022'], module: 'nodenext', moduleResolution: 'nodenext' },
  browser: { lib: ['es2022', 'dom'], module: 'esnext', moduleResolution: 'bundler', customConditions: ['browser'] },
};

/** What the compiler says of a program.  @param {keyof typeof HOSTS} host @param {string} program */
function said(host, program) {
  writeFileSync(join(home, 'program.ts'), program);
  const compilerOptions = { target: 'es2022', types: [], strict: true, noEmit: true, skipLibCheck: false, preserveSymlinks: true, ...HOSTS[host] };
  writeFileSync(join(home, 'tsconfig.json'), JSON.stringify({ compilerOptions, files: ['program.ts'] }));
  return spawnSync(process.execPath, [COMPILER, '-p', home], { encoding: 'utf8' }).stdout;
}

const PROGRAM = `
  import address from 'tiepoint/tiepoint.wasm';
  import load, { check_control, check_geoid, message, positions_of_images, OrthophotoReference, Photo, type ErrorCode, type TiepointError } from 'tiepoint';
  import { errorOf, plainError, runBlock, type Pool } from 'tiepoint/block';
  import { jobs } from 'tiepoint/block/jobs';
  await load();
  declare const worker: { postMessage(message: unknown, transfer: ArrayBuffer[]): void };
  export const pool: Pool = {
    size: 2,
    run: (name, input, transfer) => {
      worker.postMessage({ name, input }, transfer);
      return jobs[name](input);
    },
  };
  export const arabic = (error: TiepointError) => message('error', error.error, null, 'ar');
  export const code: ErrorCode = 'invalid-option';
  export const photo = (bytes: ArrayBuffer) => Photo.decode(bytes);
  export { errorOf, OrthophotoReference, plainError, runBlock };
  export const bundled = () => load(address);
  export const positions = positions_of_images('', [], { crs: 'EPSG:25832' });
  export const none = positions_of_images('', []);
  check_control('', '', []);
  check_geoid('geoid.tif', {});
`;

for (const host of /** @type {const} */ (['node', 'browser']))
  test(`a program of ${host} is checked, with the package's own types`, { skip: SKIP }, () => {
    assert.equal(said(host, PROGRAM), '');
  });

test('a message of another family, a code that there is none of, and grey values of 16 bits are refused', { skip: SKIP }, () => {
  const wrong = said(
    'node',
    `import { message, Photo, type ErrorCode, type Warning } from 'tiepoint';
     declare const warning: Warning;
     message('warning', warning);
     message('pair_verdict', warning);
     message('foo', 1);
     export const code: ErrorCode = 'gone';
     Photo.from_grey(1, 1, new Uint16Array(1));`,
  );
  assert.deepEqual(
    [...wrong.matchAll(/program\.ts\((\d+),/g)].map(([, line]) => Number(line)),
    [4, 5, 6, 7],
    wrong,
  );
});
