import assert from 'node:assert/strict';
import { readdirSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { Photo } from '../../pkg/node.js';
import { file, folder, json, tiepoint } from './command.js';
import { ASKEW, MARKS_MM, PIXEL_MM, PRINCIPAL_POINT_MM, scanOf } from './scans.js';

const FLIGHT = ['--strips', '2', '--exposures', '3', '--width-px', '480', '--height-px', '360', '--pixel-mm', String(PIXEL_MM), '--relief-m', '40'];

/** No two lie alike: one upside down, one a little larger. */
const LYING = [
  ASKEW,
  { ...ASKEW, turn: -0.05 },
  { ...ASKEW, turn: Math.PI + 0.02 },
  { ...ASKEW, along: 0.996, across: 1.002, middle: /** @type {const} */ ([290, 230]) },
  { ...ASKEW, turn: 0.01, along: 1.02, across: 1.021 },
  { ...ASKEW, turn: 0.06, middle: /** @type {const} */ ([281.2, 240.4]) },
];

/** A flight on film: its scans with their marks, its camera, and its truth. */
function scanned() {
  const at = folder();
  const { photos, truth } = json('simulate', '--block', '--out', at, ...FLIGHT, '--seed', '4');
  const scans = photos.map((/** @type {string} */ photo, /** @type {number} */ k) => scanOf(at, `film_${k}`, photo, LYING[k] ?? ASKEW).scan);
  const { block } = JSON.parse(readFileSync(truth, 'utf8'));
  const camera = { focal_mm: block.cameras[0].focal_px * PIXEL_MM, principal_point_mm: PRINCIPAL_POINT_MM };
  return { scans, camera: file(at, 'film.json', JSON.stringify(camera)), poses: block.images.map((/** @type {any} */ { pose }) => pose) };
}

const FILM = scanned();

/** How far apart two places are. @param {number[]} a @param {number[]} b */
const apart = (a, b) => Math.hypot(...a.map((v, k) => v - (b[k] ?? NaN)));

test('scans of film become images of one camera, and a block is made of them', () => {
  const out = folder();
  const { scans, cameras } = json('film', ...FILM.scans, '--camera', FILM.camera, '--out', out);
  assert.equal(scans.length, FILM.scans.length);
  for (const { marks } of scans) assert.ok(marks.residuals_mm.length === MARKS_MM.length && marks.sigma0_mm < 0.01, JSON.stringify(marks.sigma0_mm));
  assert.equal(cameras.length, 1, JSON.stringify(cameras));
  const [{ images, fixed, pixel_mm }] = cameras;
  assert.deepEqual([images, fixed], ['*-film.png', true]);
  assert.ok(Math.abs(pixel_mm - PIXEL_MM) < 0.001, `${pixel_mm}`);
  const sizes = scans.map((/** @type {{ image: string }} */ { image }) => {
    const photo = Photo.decode(readFileSync(join(out, 'images', image)));
    const size = [photo.width, photo.height];
    photo.free();
    return size.join(' x ');
  });
  assert.equal(new Set(sizes).size, 1, sizes.join(', '));
  assert.match(readFileSync(join(out, 'film.csv'), 'utf8'), /^scan,image,marks,sigma0_mm,rmse_mm\nfilm_0\.png,film_0-film\.png,6,0\.00\d+,0\.00\d+\n/);
  const again = tiepoint('film', ...FILM.scans, '--camera', FILM.camera, '--out', out);
  assert.ok(again.code === 1 && /images is there already; name another folder/.test(again.stderr), again.stderr);
  const block = join(out, 'block');
  const summary = json('block', join(out, 'images'), '--cameras', join(out, 'cameras.json'), '--masks', join(out, 'masks'), '--out', block);
  assert.equal(summary.verdict.kind, 'oriented', JSON.stringify(summary.verdict));
  // Scans as they are have other scales along columns and rows, each its own.
  const all = file(out, 'all.json', readFileSync(join(out, 'cameras.json'), 'utf8').replace('*-film.png', '*'));
  const raw = json('block', ...FILM.scans, '--cameras', all, '--out', join(out, 'raw'));
  assert.ok(raw.verdict.sigma0_px > 1.3 * summary.verdict.sigma0_px, `${raw.verdict.sigma0_px} ${summary.verdict.sigma0_px} px`);
  // Without positions the shape is what is known: distances between projection centres in that of the first two.
  const rows = readFileSync(join(block, 'images.csv'), 'utf8').trim().split('\n');
  const head = (rows.shift() ?? '').split(',');
  const places = rows.map((row) => ['x', 'y', 'z'].map((name) => Number(row.split(',')[head.indexOf(name)])));
  const truth = FILM.poses.map((/** @type {any} */ { position }) => position);
  const scale = apart(truth[0], truth[1]) / apart(places[0] ?? [], places[1] ?? []);
  for (let k = 2; k < places.length; k += 1) {
    const [known, found] = [apart(truth[0], truth[k]), scale * apart(places[0] ?? [], places[k] ?? [])];
    assert.ok(Math.abs(found / known - 1) < 0.03, `${k}: ${found} of ${known} m`);
  }
  rmSync(out, { recursive: true });
});

test('a mark that one scan lacks, and a scan that cannot be read, cost the others nothing', () => {
  const [at, out] = [folder(), join(folder(), 'out')];
  const scans = FILM.scans.slice(0, 3).map((/** @type {string} */ scan, /** @type {number} */ k) => {
    const rows = readFileSync(scan.replace(/png$/, 'csv'), 'utf8').trim().split('\n');
    file(at, `s${k}.csv`, (k === 1 ? rows.filter((row) => !row.endsWith(',17.5,0.1')) : rows).join('\n'));
    return file(at, `s${k}.png`, k === 2 ? 'no picture' : readFileSync(scan));
  });
  const { code, stderr } = tiepoint('film', ...scans, '--camera', FILM.camera, '--out', out);
  assert.ok(code === 1 && /s2\.png/.test(stderr) && !/s[01]\.png/.test(stderr), stderr);
  const { cameras } = JSON.parse(readFileSync(join(out, 'cameras.json'), 'utf8'));
  assert.equal(cameras.length, 1, JSON.stringify(cameras));
  assert.deepEqual(readdirSync(join(out, 'images')), ['s0-film.png', 's1-film.png']);
});

test('scans without marks, and without a camera, are refused', () => {
  const at = folder();
  const refused = (/** @type {string[]} */ ...args) => {
    const { code, stdout, stderr } = tiepoint('film', ...args, '--out', join(at, 'out'));
    assert.equal(stdout, '');
    return `${code} ${stderr}`;
  };
  const [scan = ''] = FILM.scans;
  assert.match(refused(scan), /^2 .*--camera is missing/);
  assert.match(refused('--camera', FILM.camera), /^2 .*name the scans/);
  assert.match(refused(scan, scan, '--camera', FILM.camera), /^2 .*images of the same name/);
  assert.match(refused(scan, '--camera', FILM.camera, '--fiducials', at), /^1 .*film_0\.png: its fiducial marks are missing: there is no .*film_0\.csv/);
  assert.match(refused(join(at, 'none.png'), '--camera', FILM.camera), /^1 .*there is no such file/);
  file(at, 'film_0.csv', 'col,row,x_mm,y_mm\n1,2,3,4\n');
  assert.match(refused(scan, '--camera', FILM.camera, '--fiducials', at), /^1 .*film_0\.csv: fiducial marks: 1 given/);
});
