/** The options of the command are those of the catalogue. */

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { block_parameters, parameters } from '../../pkg/node.js';
import { IMAGE_FILE } from '../../pkg/block/image-files.js';
import { OPTIONS_FILE, optionsPage } from '../../tools/docs.mjs';
import { tiepoint } from './command.js';

test('the table of options is what the catalogue says; npm run docs writes it', () => {
  assert.equal(readFileSync(OPTIONS_FILE, 'utf8'), optionsPage());
});

test('every option has a name of its own', () => {
  for (const [command, count] of /** @type {const} */ ([
    ['match', parameters().length],
    ['block', block_parameters().length],
    ['simulate', 1],
  ])) {
    const names = [...tiepoint(command, '--help').stdout.matchAll(/^ {2}--([\w-]+)/gm)].map(([, name]) => name);
    assert.equal(new Set(names).size, names.length, names.join(' '));
    assert.ok(names.length > count, `${command} takes ${names.length} options`);
  }
});

test('native programs and the command take the same files for images', () => {
  const source = readFileSync(new URL('../../src/pipeline/host.rs', import.meta.url), 'utf8');
  const endings = [...(/const ENDINGS: [^=]+= \[([^\]]+)\]/.exec(source)?.[1] ?? '').matchAll(/"(\w+)"/g)].map(([, ending = '']) => ending);
  assert.equal(endings.length, 10);
  for (const ending of endings) assert.ok(IMAGE_FILE.test(`a.${ending}`) && IMAGE_FILE.test(`A.${ending.toUpperCase()}`), ending);
  const named = IMAGE_FILE.source.slice(IMAGE_FILE.source.indexOf(':') + 1, -2).split('|');
  assert.deepEqual(new Set(named.flatMap((one) => (one.includes('?') ? [one.replace(/.\?/, ''), one.replace('?', '')] : [one]))), new Set(endings));
});
