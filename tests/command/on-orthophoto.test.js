/** A block in the system of an orthophoto, by the command. */

import assert from 'node:assert/strict';
import { copyFileSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { folder, json, tiepoint } from './command.js';

const FLIGHT = ['--strips', '1', '--exposures', '3', '--width-px', '480', '--height-px', '360', '--pixel-mm', '0.075', '--relief-m', '40'];

/** @param {string} seed */
function flown(seed) {
  const at = folder();
  json('simulate', '--block', '--out', at, ...FLIGHT, '--seed', seed, '--orthophoto', '0.8');
  const ground = ['--orthophoto', join(at, 'orthophoto.tif'), '--heights', join(at, 'heights.tif'), '--orthophoto-points', '3000'];
  return { photos: join(at, 'photos'), ground, truth: JSON.parse(readFileSync(join(at, 'truth.json'), 'utf8')).block };
}

const OWN = flown('3');
const CALL = ['block', OWN.photos, '--features', '2500'];

test('a block lies in the system of its orthophoto, with check points; its project keeps that', () => {
  const out = folder();
  const { verdict, orthophoto, orientation } = json(...CALL, ...OWN.ground, '--out', out);
  assert.equal(verdict.kind, 'oriented', JSON.stringify(verdict));
  assert.equal(orthophoto.kind, 'linked', JSON.stringify(orthophoto));
  const [model] = orientation.models;
  assert.equal(model.datum, 'control');
  assert.ok(model.checks.points >= 3 && model.checks.rmse_m.every((/** @type {number} */ m) => m < 1), JSON.stringify(model.checks));
  const rows = readFileSync(join(out, 'images.csv'), 'utf8').trim().split('\n').slice(1);
  assert.equal(rows.length, 3);
  const { images } = JSON.parse(readFileSync(join(out, 'summary.json'), 'utf8'));
  assert.equal(images.read, 3);
  const surveyed = readFileSync(join(out, 'surveyed.csv'), 'utf8').trim().split('\n').slice(1);
  assert.ok(surveyed.length >= orthophoto.points && surveyed.every((row) => row.startsWith('orthophoto_')), surveyed[0]);
  // Written again from the project: the same block.
  const again = folder();
  json('edit', join(out, 'project.tiepoint'), '--out', again);
  for (const name of ['images.csv', 'surveyed.csv', 'orientation.json'])
    assert.equal(readFileSync(join(again, name), 'utf8'), readFileSync(join(out, name), 'utf8'), name);
});

test('edits of places hold in the block that is placed by other options, and what does not hold is said', () => {
  const [out, edited, anew, again] = [folder(), folder(), folder(), folder()];
  const project = (/** @type {string} */ at) => join(at, 'project.tiepoint');
  const surveyed = (/** @type {string} */ at) =>
    readFileSync(join(at, 'surveyed.csv'), 'utf8')
      .trim()
      .split('\n')
      .map((row) => row.split(','));
  json(...CALL, ...OWN.ground, '--out', out);
  // More of the places check: others of them take part, and places have the numbers that they had.
  json(...CALL, ...OWN.ground, '--check-share', '0.4', '--out', anew);
  const [, first] = surveyed(out).map(([name]) => name);
  const list = [{ kind: 'reject_points', points: [{ ground_control: 0 }] }];
  writeFileSync(join(edited, 'edits.json'), JSON.stringify(list));
  json('edit', project(out), '--edits', join(edited, 'edits.json'), '--out', join(edited, 'block'));
  const { code, stderr } = tiepoint('edit', project(anew), '--edits', project(join(edited, 'block')), '--out', again);
  assert.ok(code === 0 || code === 3, stderr);
  assert.match(stderr, /what was done to places of the orthophoto holds for 1 that lie there again, and not for 0/);
  const use = (/** @type {string} */ at) => surveyed(at).find(([name]) => name === first) ?? [];
  assert.ok(!use(anew).includes('off') && use(again).includes('off'), `${use(anew)} ${use(again)}`);
  // The project of another block is refused, and a file that is no project is named.
  json('block', OWN.photos, '--features', '1500', '--out', join(anew, 'other'));
  const other = tiepoint('edit', project(join(anew, 'other')), '--edits', project(join(edited, 'block')), '--out', join(anew, 'none'));
  assert.ok(other.code !== 0 && /other images, tie points or ground control points/.test(other.stderr), other.stderr);
});

test('an orthophoto of elsewhere leaves the block as it was, and the exit code says so', () => {
  const [out, plain] = [folder(), folder()];
  const { code, stdout, stderr } = tiepoint(...CALL, ...flown('4').ground, '--out', out);
  assert.equal(code, 3, stderr);
  assert.match(stdout, /not in the system of the orthophoto.*0 of 3 images could be placed/);
  tiepoint(...CALL, '--out', plain);
  for (const name of ['images.csv', 'points.csv', 'orientation.json'])
    assert.equal(readFileSync(join(out, name), 'utf8'), readFileSync(join(plain, name), 'utf8'), name);
});

test('an orthophoto that lies elsewhere than the GNSS positions is doubted before anything is matched, and in the summary', () => {
  const at = folder();
  const [picture, , heights] = [1, 0, 3].map((k) => OWN.ground[k] ?? '');
  const map = join(at, 'map.tif');
  copyFileSync(picture ?? '', map);
  writeFileSync(join(at, 'map.prj'), 'EPSG:25832');
  const call = (/** @type {string[]} */ ...more) =>
    tiepoint(...CALL, '--orthophoto', map, '--heights', heights ?? '', '--orthophoto-points', '3000', '--out', folder(), '--json', ...more);
  const { stdout, stderr } = call();
  // At once, and again beside the result.
  const said = stderr.split('no GNSS position of the 3 images lies within 500 m of the orthophoto: as EPSG:25832 has it');
  assert.equal(said.length, 3, stderr);
  const { remarks, orthophoto } = JSON.parse(stdout);
  assert.equal(remarks.filter((/** @type {any} */ { kind }) => kind === 'orthophoto_elsewhere').length, 1, JSON.stringify(remarks));
  assert.equal(orthophoto.kind, 'linked', JSON.stringify(orthophoto));
  // Positions that take no part say nothing.
  const without = call('--gps', 'ignore');
  assert.ok(!without.stderr.includes('of the orthophoto: as'), without.stderr);
});

test('options of an orthophoto without one, and files that are none, are refused before anything is computed', () => {
  const refused = (/** @type {string[]} */ ...args) => {
    const { code, stdout, stderr } = tiepoint(...CALL, '--out', folder(), ...args);
    assert.equal(stdout, '');
    return `${code} ${stderr}`;
  };
  assert.match(refused('--level', '3'), /^2 .*--level needs --orthophoto/);
  assert.match(refused('--check-share', '0.1'), /^2 .*--check-share needs --orthophoto/);
  assert.match(refused('--orthophoto', join(OWN.photos, 'photo_00000.png')), /^1 [\s\S]*does not say where it lies/);
  assert.match(refused(...OWN.ground, '--check-share', '0.9'), /^2 .*--check-share is 0\.9; allowed: 0 to 0\.5/);
});
