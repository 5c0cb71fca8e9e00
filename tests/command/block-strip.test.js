/** Blocks of photographs that do not settle easily. */

import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { DATA } from '../../tools/lib/paths.mjs';
import { folder, json } from './command.js';

const STRIP = join(DATA, 'block_caliterra');
const OBLIQUE = join(DATA, 'oblique_lewis');

/** The angle in degrees between the vertical and the mean direction of the camera axes in a table of images, whose angles are ω, φ and κ. */
function meanTiltDeg(/** @type {string} */ csv) {
  const [head = '', ...rows] = csv.trim().split('\n');
  const columns = ['omega_deg', 'phi_deg'].map((name) => head.split(',').indexOf(name));
  assert.ok(!columns.includes(-1), head);
  let [x, y, z] = [0, 0, 0];
  for (const row of rows) {
    const cells = columns.map((column) => row.split(',')[column] ?? '');
    // Images that are not oriented have no angles.
    if (cells.includes('')) continue;
    const [omega = 0, phi = 0] = cells.map((cell) => (Number(cell) * Math.PI) / 180);
    x += Math.sin(phi);
    y -= Math.sin(omega) * Math.cos(phi);
    z += Math.cos(omega) * Math.cos(phi);
  }
  return (Math.atan2(Math.hypot(x, y), z) * 180) / Math.PI;
}

test('the mean tilt is that of the mean axis', () => {
  assert.ok(Math.abs(meanTiltDeg('name,omega_deg,phi_deg\na,10,0\nb,-10,0\n')) < 1e-9);
  assert.ok(Math.abs(meanTiltDeg('name,omega_deg,phi_deg\na,39,0\nb,39,0\nc,,\n') - 39) < 1e-9);
  assert.ok(Math.abs(meanTiltDeg('name,omega_deg,phi_deg\na,0,-5\n') - 5) < 1e-9);
});

test('nadir images whose recorded positions do not settle their rotation are level to 3°', { skip: existsSync(STRIP) ? false : `${STRIP} is absent` }, () => {
  const photos = readdirSync(STRIP)
    .filter((name) => name.endsWith('.jpg'))
    .sort()
    .map((name) => join(STRIP, name));
  assert.equal(photos.length, 12);
  const out = folder();
  const { orientation } = json('block', ...photos, '--out', out, '--workers', '2');
  assert.equal(orientation.oriented, 12, JSON.stringify(orientation));
  const tilt = meanTiltDeg(readFileSync(join(out, 'images.csv'), 'utf8'));
  assert.ok(tilt < 3, `${tilt}°`);
});

test('one strip is oriented where its poor recorded positions do not settle', { skip: existsSync(STRIP) ? false : `${STRIP} is absent` }, () => {
  const photos = readdirSync(STRIP)
    .filter((name) => name.endsWith('.jpg'))
    .sort()
    .slice(0, 6)
    .map((name) => join(STRIP, name));
  const out = folder();
  const { orientation } = json('block', ...photos, '--out', out, '--workers', '2');
  assert.equal(orientation.oriented, 6, JSON.stringify(orientation));
  const [model] = orientation.models;
  assert.ok(model.sigma0_px < 0.5, JSON.stringify(model));
  // Its views level it.
  assert.ok(model.in_system && model.warnings.some((/** @type {{ kind: string }} */ { kind }) => kind === 'levelled'), JSON.stringify(model));
  const tilt = meanTiltDeg(readFileSync(join(out, 'images.csv'), 'utf8'));
  assert.ok(tilt < 3, `${tilt}°`);
});

test('a block of two oblique images settles though their weights follow each other back and forth', {
  skip: existsSync(OBLIQUE) ? false : `${OBLIQUE} is absent`,
}, () => {
  const photos = ['img_4346.jpg', 'img_4348.jpg'].map((name) => join(OBLIQUE, name));
  const { orientation } = json('block', ...photos, '--gps', 'ignore', '--out', folder(), '--workers', '2');
  assert.equal(orientation.oriented, 2, JSON.stringify(orientation));
  const [model] = orientation.models;
  assert.ok(model.sigma0_px < 0.5, JSON.stringify(model));
});
