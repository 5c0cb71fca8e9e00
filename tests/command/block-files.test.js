/** What a block is given beside its images, and what its folder holds after runs: masks, files of earlier runs, the user's own files. */

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { appendFileSync, copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { FinishedBlock, sha256 } from '../../pkg/node.js';
import { Written } from '../../pkg/command/written.js';
import { contents, killed, records, runOnce } from './blocks.js';
import { file, folder, image, json, tiepoint } from './command.js';

const {
  block: BLOCK,
  whole: { out: WHOLE },
  half,
} = runOnce();
const NAMES = readdirSync(BLOCK.photos).sort();
const [WIDTH, HEIGHT] = [480, 360];

/** A folder with a mask that leaves the left half of each of the first photos free.  @param {string[]} names of the masks */
function masks(...names) {
  const at = folder();
  for (const name of names) image(at, name, WIDTH, HEIGHT, (col) => (col < WIDTH / 2 ? 255 : 0));
  return at;
}

/** Where in its image the features of a record are: positions x, y stand behind the head.  @param {Buffer} record */
function columnsOf(record) {
  const [head, rows] = [record.readUInt32LE(8), record.readUInt32LE(12)];
  return Array.from({ length: rows }, (_, i) => record.readFloatLE(48 + head + 8 * i));
}

test('no features are found where a mask is black', () => {
  const [first = '', second = '', third = ''] = NAMES.map((name) => name.replace('.png', ''));
  const out = folder();
  const given = masks(`${first}.png`, `${second}_mask.png`, `${third}.png.png`, 'stranger.png');
  const { code, stdout, stderr } = tiepoint(...BLOCK.call, '--out', out, '--masks', given, '--json');
  // With half of its features the block may be weak.
  assert.ok(code === 0 || code === 3, stderr);
  const summary = JSON.parse(stdout);
  assert.deepEqual([summary.images.read, summary.images.masked], [6, 3]);
  assert.deepEqual(summary.images.stray_masks, ['stranger.png']);
  assert.match(stderr, /the mask stranger\.png belongs to none of the images/);
  let halves = 0;
  for (const name of readdirSync(join(out, 'work', 'features'))) {
    const columns = columnsOf(readFileSync(join(out, 'work', 'features', name)));
    assert.ok(columns.length > 100, name);
    halves += columns.every((x) => x < WIDTH / 2 + 1) ? 1 : 0;
  }
  assert.equal(halves, 3);
  // Another mask makes another record; without masks none of these is taken.
  json(...BLOCK.call, '--out', out);
  assert.equal(records(out, 'features'), 9);
});

test('an image whose mask cannot be used is left out, and masks that mean one image are refused', () => {
  const [first = '', second = ''] = NAMES;
  const given = folder();
  image(given, first, 40, 30, () => 255);
  file(given, second, 'no image');
  const { images } = JSON.parse(tiepoint(...BLOCK.call, '--out', folder(), '--masks', given, '--json').stdout);
  assert.equal(images.read, 4);
  assert.match(images.left_out[0].reason.text, new RegExp(`its mask: got ${first} with 40 x 30 px; allowed: the image's 480 x 360 px`));
  assert.match(images.left_out[1].reason.text, new RegExp(`its mask ${second}: `));
  const twice = masks(first, first.replace('.png', '_mask.png'));
  const refused = tiepoint(...BLOCK.call, '--out', folder(), '--masks', twice);
  assert.deepEqual([refused.code, /which belong to the same image/.test(refused.stderr)], [1, true]);
  assert.match(tiepoint(...BLOCK.call, '--out', folder(), '--masks', join(twice, 'none')).stderr, /--masks is .*none, which is no folder/);
});

test('a folder holds what the last run wrote and what the user put there', () => {
  const out = half();
  json(...BLOCK.call, '--out', out, '--export', 'colmap,bingo,csv');
  const before = contents(out);
  assert.ok(before.has('bingo/bingo.dat') && before.has('csv/points.csv'));
  mkdirSync(join(out, 'bingo', 'mine'));
  writeFileSync(join(out, 'bingo', 'mine', 'notes.txt'), 'mine');
  appendFileSync(join(out, 'csv', 'points.csv'), 'changed\n');
  json(...BLOCK.call, '--out', out, '--export', 'colmap');
  const after = [...contents(out).keys()];
  assert.ok(after.includes('colmap/sparse/images.txt'));
  // Gone but for the user's file, and for the one that was changed.
  assert.deepEqual(
    after.filter((name) => /^(bingo|csv)\//.test(name)),
    ['bingo/mine/notes.txt', 'csv/points.csv'],
  );
  json(...BLOCK.call, '--out', out);
  assert.ok(!existsSync(join(out, 'colmap')));
});

test('a file that no run has written is not written over', () => {
  const out = folder();
  writeFileSync(join(out, 'points.csv'), 'mine');
  const { code, stderr } = tiepoint(...BLOCK.call, '--out', out);
  assert.equal(code, 1);
  assert.match(stderr, /points\.csv is in the way: no run has written it; move it, or name another folder with --out/);
  assert.equal(readFileSync(join(out, 'points.csv'), 'utf8'), 'mine');
  // Found before anything is computed.
  assert.equal(records(out, 'features'), 0);
});

test('files that were changed since a run wrote them are not written over', () => {
  const out = half();
  const call = [...BLOCK.call, '--out', out];
  json(...call, '--export', 'colmap');
  const kept = contents(out, '');
  const refused = (/** @type {string} */ name, /** @type {RegExp} */ pattern, /** @type {string[]} */ ...options) => {
    const { code, stderr } = tiepoint(...call, ...options);
    assert.deepEqual([code, pattern.test(stderr)], [1, true], stderr);
    // Before anything is computed, so that no line of a stage stands before it.
    assert.equal(stderr.trimEnd().split('\n').length, 1, stderr);
    assert.match(readFileSync(join(out, name), 'utf8'), /mine$/);
  };
  appendFileSync(join(out, 'pairs.csv'), 'mine');
  refused('pairs.csv', /pairs\.csv is in the way: it was changed since it was written; move it, or name another folder with --out/);
  writeFileSync(join(out, 'pairs.csv'), kept.get('pairs.csv') ?? '');
  // Kept by a run that does not write it, it is still known as one that was written.
  appendFileSync(join(out, 'colmap', 'matches.txt'), 'mine');
  json(...call);
  refused('colmap/matches.txt', /matches\.txt is in the way: it was changed since it was written/, '--export', 'colmap');
  writeFileSync(join(out, 'colmap', 'matches.txt'), kept.get('colmap/matches.txt') ?? '');
  json(...call, '--export', 'colmap');
  assert.deepEqual(contents(out, ''), kept);
});

test('a file of the user is found before anything is computed, whatever would write it', () => {
  for (const [name, ...options] of [
    ['orientation.json'],
    ['colmap/features/photo_00002.png.txt', '--export', 'colmap'],
    ['bingo/bingo.dat', '--export', 'csv,bingo'],
  ]) {
    const out = folder();
    const path = join(out, ...(name ?? '').split('/'));
    mkdirSync(dirname(path), { recursive: true });
    writeFileSync(path, 'mine');
    const { code, stderr } = tiepoint(...BLOCK.call, '--out', out, ...options);
    assert.deepEqual([code, readFileSync(path, 'utf8')], [1, 'mine'], stderr);
    assert.match(stderr, /^tiepoint: .* is in the way: no run has written it; .*\n$/);
    assert.equal(records(out, 'features'), 0);
  }
});

test('what comes in the way while a run goes on is set aside', async () => {
  const out = folder();
  const written = new Written(out);
  written.put('points.csv', 'ours');
  written.finish();
  const next = new Written(out);
  next.refuseOthers(['points.csv'], []);
  writeFileSync(join(out, 'points.csv'), 'mine');
  next.put('points.csv', 'ours again');
  next.finish();
  assert.deepEqual(next.setAside, [{ path: join(out, 'points.csv'), kept: join(out, 'points.csv.mine') }]);
  assert.deepEqual(
    ['points.csv', 'points.csv.mine'].map((name) => readFileSync(join(out, name), 'utf8')),
    ['ours again', 'mine'],
  );
  const last = new Written(out);
  last.refuseOthers(['points.csv'], []);
  last.finish();
  assert.deepEqual([...contents(out).keys()], ['points.csv.mine']);
});

test('names that a format cannot hold and a truth of other images are refused before anything is computed', () => {
  const named = folder();
  for (const [i, name] of NAMES.entries()) copyFileSync(join(BLOCK.photos, name), join(named, i === 2 ? 'a photo.png' : name));
  const out = folder();
  const call = ['block', named, ...BLOCK.call.slice(2), '--out', out];
  const blank = tiepoint(...call, '--export', 'csv,colmap,nvm');
  assert.deepEqual([blank.code, records(out, 'features')], [1, 0]);
  assert.match(
    blank.stderr,
    /^tiepoint: these images cannot be exported as colmap, nvm \(.*'a photo\.png'; allowed: names without blanks\): rename them, or do not export what cannot hold their names\n$/,
  );
  const truth = structuredClone(BLOCK.truth);
  for (const one of truth.block.images) one.name = `other_${one.name}`;
  const other = tiepoint(...BLOCK.call, '--out', out, '--truth', file(folder(), 'other.json', JSON.stringify(truth)));
  assert.deepEqual([other.code, records(out, 'features')], [1, 0]);
  assert.match(other.stderr, /^tiepoint: .*other\.json: truth of the block: got none of the block's images; allowed: a truth of these images\n$/);
});

test('killed while it writes, the next run knows its files', async () => {
  const out = half();
  const args = [...BLOCK.call, '--out', out, '--export', 'bingo'];
  assert.ok(await killed(args, () => existsSync(join(out, 'project.tiepoint'))));
  json(...BLOCK.call, '--out', out);
  assert.ok(!existsSync(join(out, 'bingo')));
  assert.ok(contents(out).has('summary.json'));
});

test('the exactness of recorded positions is an option', () => {
  const sigma = (/** @type {string[]} */ ...options) => {
    const { crs: _, geoid_m: __, ...errors } = json(...BLOCK.call, '--out', half(), ...options).settings.placing;
    return errors;
  };
  assert.deepEqual(sigma('--receiver-across-m', '0.02', '--receiver-up-m', '0.04'), {
    receiver_across_m: 0.02,
    receiver_up_m: 0.04,
    surveyed_across_m: 0.02,
    surveyed_up_m: 0.03,
    mark_sigma_px: 1,
    gnss_errors: 'none',
    gnss_lever_arm: false,
    shared_errors: null,
    variance_components: false,
  });
  assert.match(tiepoint(...BLOCK.call, '--out', folder(), '--receiver-up-m', '0').stderr, /--receiver-up-m is 0; allowed: 0\.001 to 1000/);
});

test('digests of the module are those of the system', () => {
  for (const length of [0, 1, 55, 56, 63, 64, 65, 1000, 123457]) {
    const bytes = Uint8Array.from({ length }, (_, i) => (i * 7919) % 251);
    assert.equal(Buffer.from(sha256(bytes)).toString('hex'), createHash('sha256').update(bytes).digest('hex'), `${length}`);
  }
});

test('a project that is damaged anywhere is refused', () => {
  const bytes = readFileSync(join(WHOLE, 'project.tiepoint'));
  let state = 1;
  const below = (/** @type {number} */ n) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * n);
  };
  for (let i = 0; i < 200; i++) {
    const damaged = i % 2 === 0 ? bytes.subarray(0, below(bytes.length)) : Buffer.from(bytes);
    const at = below(bytes.length);
    if (i % 2 === 1) damaged[at] = (damaged[at] ?? 0) ^ (1 << below(8));
    assert.throws(
      () => FinishedBlock.open(damaged),
      (/** @type {any} */ error) => error.name === 'TiepointError' && error.message.length > 10,
      `damage ${i} at ${at}`,
    );
  }
});
