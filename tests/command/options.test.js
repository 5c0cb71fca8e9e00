/** The options of the command are those of the catalogue. */

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { block_parameters, parameters } from '../../pkg/node.js';
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
