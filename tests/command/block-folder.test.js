/** The folder of a block against what happens to folders: two runs at once, machines that go down, inputs that are no files. */

import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { copyFileSync, existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { hostname } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { Written } from '../../pkg/command/written.js';
import { contents, photographed, records } from './blocks.js';
import { folder, json, PROGRAM, tiepoint } from './command.js';

const BLOCK = photographed();

test('two runs on one folder do not compute everything twice: the second is refused at once', async () => {
  const out = folder();
  const lock = join(out, 'work', 'lock.txt');
  const first = spawn(process.execPath, [PROGRAM, ...BLOCK.call, '--out', out], { stdio: 'ignore' });
  const ended = new Promise((resolve) => {
    first.on('exit', resolve);
  });
  while (!existsSync(lock))
    await new Promise((resolve) => {
      setTimeout(resolve, 2);
    });
  first.kill('SIGSTOP');
  const before = records(out, 'features');
  const { code, stderr } = tiepoint(...BLOCK.call, '--out', out);
  assert.equal(code, 1);
  assert.match(
    stderr,
    new RegExp(
      `^tiepoint: .* is in use: process ${first.pid} on ${hostname()} works on it; wait for it, name another folder with --out, or remove .*lock\\.txt if no such process runs\\n$`,
    ),
  );
  assert.equal(records(out, 'features'), before);
  // The lock of a process that was ended is taken over.
  first.kill('SIGKILL');
  await ended;
  assert.ok(existsSync(lock));
  json(...BLOCK.call, '--out', out);
  assert.ok(!existsSync(lock));
});

test('a lock of another machine is not taken over', () => {
  const out = folder();
  new Written(out);
  writeFileSync(join(out, 'work', 'lock.txt'), 'process 1 on elsewhere\n');
  assert.match(tiepoint(...BLOCK.call, '--out', out).stderr, /is in use: process 1 on elsewhere works on it/);
});

test('a torn list of written files does not end in "is in the way"', () => {
  const out = folder();
  const call = [...BLOCK.call, '--out', out];
  json(...call);
  const whole = contents(out);
  const list = join(out, 'work', 'written.txt');
  const text = readFileSync(list, 'utf8');
  for (const torn of [text.slice(0, text.length / 4), text.replace(/points/, 'points\0'), '\0'.repeat(500)]) {
    writeFileSync(list, torn);
    const { code, stderr } = tiepoint(...call);
    assert.equal(code, 0, stderr);
    assert.match(stderr, /points\.csv was changed while the run went on: what it held is now .*points\.csv\.mine/);
    for (const [name, content] of whole) assert.deepEqual(readFileSync(join(out, name)), content, name);
    assert.equal(readFileSync(list, 'utf8'), text);
  }
});

test('a pipe among the images does not hang a run', { skip: process.platform === 'win32' }, () => {
  const photos = folder();
  const names = readdirSync(BLOCK.photos);
  for (const name of names) copyFileSync(join(BLOCK.photos, name), join(photos, name));
  assert.equal(spawnSync('mkfifo', [join(photos, 'pipe.png')]).status, 0);
  const { code, stdout, stderr } = tiepoint('block', photos, ...BLOCK.call.slice(2), '--out', folder(), '--json');
  assert.equal(code, 0, stderr);
  const { images } = JSON.parse(stdout);
  const message = 'it is no file, but a pipe, a socket or a device';
  const left = [{ name: 'pipe.png', reason: { kind: 'unreadable', message, text: message } }];
  assert.deepEqual([images.read, images.left_out], [names.length, left]);
});

test('names too long for an export are found before the run', () => {
  const photos = folder();
  const long = `${'a'.repeat(248)}.png`;
  for (const [i, name] of readdirSync(BLOCK.photos).entries()) copyFileSync(join(BLOCK.photos, name), join(photos, i === 1 ? long : name));
  const out = folder();
  const call = ['block', photos, ...BLOCK.call.slice(2), '--out', out];
  const { code, stderr } = tiepoint(...call, '--export', 'micmac,csv');
  assert.deepEqual([code, records(out, 'features')], [1, 0]);
  assert.match(stderr, /cannot be exported as micmac .* of 252 bytes; allowed: names of up to 249 bytes/);
  json(...call, '--export', 'csv');
});
