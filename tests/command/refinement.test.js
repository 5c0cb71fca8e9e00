/** The refinement of a block's rays, through the command. */

import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { FinishedBlock } from '../../pkg/node.js';
import { contents, killed, photographed, records } from './blocks.js';
import { folder, json, tiepoint } from './command.js';

const BLOCK = photographed();

const WHOLE = folder();
const SUMMARY = json(...BLOCK.call, '--out', WHOLE, '--workers', '2', '--truth', BLOCK.truthFile);

/** @param {string} out */
function rayTable(out) {
  const [header = '', ...lines] = readFileSync(join(out, 'rays.csv'), 'utf8').trimEnd().split('\n');
  const names = header.split(',');
  return lines.map((line) => Object.fromEntries(line.split(',').map((value, i) => [names[i] ?? '', value])));
}

test('rays that were refined meet nearer to each other than those that were not', () => {
  const plain = folder();
  const before = json(...BLOCK.call, '--refine', 'none', '--out', plain, '--truth', BLOCK.truthFile);
  assert.equal(before.refinement, null);
  assert.ok(!existsSync(join(plain, 'work', 'windows')) || records(plain, 'windows') === 0);
  assert.ok(!readFileSync(join(plain, 'rays.csv'), 'utf8').includes('refined'));
  const { refinement, orientation, score } = SUMMARY;
  assert.equal(orientation.oriented, 6);
  assert.ok(refinement.refined > 0.6 * (refinement.rays - refinement.references), JSON.stringify(refinement));
  assert.ok(orientation.models[0].rmse_px < before.orientation.models[0].rmse_px, `${orientation.models[0].rmse_px} ${before.orientation.models[0].rmse_px}`);
  assert.ok(score.right_rmse_px < before.score.right_rmse_px, `${score.right_rmse_px} ${before.score.right_rmse_px}`);
});

test('each ray has its outcome, and those that were refined their precision', () => {
  const { refinement } = SUMMARY;
  const counted = refinement.references + refinement.refined + Object.values(refinement.kept).reduce((sum, count) => sum + count, 0);
  assert.deepEqual([refinement.references, counted], [refinement.points, refinement.rays]);
  const rays = rayTable(WHOLE);
  assert.equal(
    rays.length,
    FinishedBlock.open(readFileSync(join(WHOLE, 'project.tiepoint')))
      .model()
      .points.reduce((sum, point) => sum + point.rays.length, 0),
  );
  const outcomes = ['reference', 'refined', ...Object.keys(refinement.kept)];
  for (const ray of rays) {
    assert.ok(outcomes.includes(ray.refinement ?? ''), JSON.stringify(ray));
    const known = ray.refinement === 'refined';
    assert.equal(Number(ray.standard_error_px) > 0 && Number(ray.standard_error_px) < 1 && Number(ray.correlation) >= 0.8, known, JSON.stringify(ray));
  }
  const references = new Map();
  for (const { point, refinement: outcome } of rays) if (outcome === 'reference') references.set(point, (references.get(point) ?? 0) + 1);
  assert.ok(references.size > 0 && [...references.values()].every((count) => count === 1));
});

test('any number of workers gives the same bytes', () => {
  const out = folder();
  json(...BLOCK.call, '--out', out, '--workers', '1', '--truth', BLOCK.truthFile);
  assert.deepEqual(contents(out), contents(WHOLE));
});

test('killed while windows are kept or points refined, it goes on to the same bytes', async () => {
  const out = folder();
  for (const wanted of [1, 4, 6])
    await killed([...BLOCK.call, '--out', out, '--workers', '1', '--json', '--truth', BLOCK.truthFile], () => records(out, 'windows') >= wanted);
  json(...BLOCK.call, '--out', out, '--workers', '2', '--truth', BLOCK.truthFile);
  assert.deepEqual(contents(out), contents(WHOLE));
});

test('windows that were kept are not cut again; damaged ones are', () => {
  const out = folder();
  const call = [...BLOCK.call, '--out', out, '--workers', '2', '--truth', BLOCK.truthFile];
  assert.match(tiepoint(...call).stderr, /images for windows of observations: 6 in/);
  const at = join(out, 'work', 'windows');
  const [one = '', other = ''] = readdirSync(at).map((name) => join(at, name));
  const bytes = readFileSync(one);
  bytes[bytes.length - 1] = (bytes.at(-1) ?? 0) ^ 1;
  writeFileSync(one, bytes);
  rmSync(other);
  assert.match(tiepoint(...call).stderr, /images for windows of observations: 6 \(4 from an earlier run\) in/);
  assert.deepEqual(contents(out), contents(WHOLE));
});

test('a method that does not exist is refused', () => {
  const { code, stderr } = tiepoint(...BLOCK.call, '--out', folder(), '--refine', 'twice');
  assert.deepEqual([code, /--refine is twice; allowed: none, least-squares/.test(stderr)], [2, true], stderr);
});
