/** A block in the system of an orthophoto, by the command. */

import assert from 'node:assert/strict';
import { copyFileSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { read_exif } from '../../pkg/node.js';
import { marksOf } from './blocks.js';
import { file, folder, json, tiepoint } from './command.js';

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

test('check points alone stand beside an orthophoto; what differs alike from it is told, each point being within its error or not', () => {
  const at = folder();
  const positions = OWN.truth.images.map((/** @type {any} */ image) => image.pose.position);
  const middle = [0, 1].map((k) => positions.reduce((/** @type {number} */ sum, /** @type {number[]} */ position) => sum + (position[k] ?? 0), 0) / 3);
  const points = Array.from({ length: 9 }, (_, i) => ({
    name: `P${i}`,
    at: [(middle[0] ?? 0) + 25 * ((i % 3) - 1), (middle[1] ?? 0) + 25 * (Math.floor(i / 3) - 1), 10 + (i % 4)],
  }));
  const marks = file(at, 'marks.csv', marksOf(OWN.truth, points).join('\n'));
  const call = (/** @type {string} */ use, /** @type {number} */ raised, number = 9) => {
    const rows = points.slice(0, number).map(({ name, at: [x = 0, y = 0, z = 0] }) => [name, x, y, z + raised, use].join());
    const seen = file(
      at,
      'some.csv',
      readFileSync(marks, 'utf8')
        .split('\n')
        .filter((row) => rows.some((own) => own.startsWith(`${row.split(',')[1]},`)))
        .join('\n'),
    );
    const table = file(at, 'points.csv', `name,x,y,z,use\n${rows.join('\n')}\n`);
    const { code, stdout, stderr } = tiepoint(
      ...CALL,
      ...OWN.ground,
      '--control',
      table,
      '--marks',
      seen,
      '--mark-sigma-px',
      '0.3',
      '--out',
      folder(),
      '--json',
    );
    assert.ok(code === 0 || code === 3, `${code} ${stderr} ${stdout}`);
    return JSON.parse(stdout);
  };
  const right = call('check', 0);
  assert.equal(right.verdict.kind, 'oriented', JSON.stringify(right.verdict));
  const { rmse_m } = right.orientation.models[0].checks;
  assert.ok(
    rmse_m.every((/** @type {number} */ m) => m < 2),
    JSON.stringify(rmse_m),
  );
  assert.equal(call('control', 0, 1).verdict.kind, 'oriented');
  const raised = call('check', 6);
  assert.ok(raised.orientation.models[0].checks.ratio < 3.29, JSON.stringify(raised.orientation.models[0].checks));
  assert.equal(raised.verdict.kind, 'weak');
  assert.match(raised.verdict.text, /The 9 check points all differ from the block in z, by -[567]\.\d\d ± /);
  // Control points keep a block off an orthophoto that they contradict.
  const contradicted = call('control', 6);
  assert.equal(contradicted.orthophoto.kind, 'not_linked', JSON.stringify(contradicted.orthophoto));
  assert.match(contradicted.orthophoto.text, /the ground control points contradict it\. .* [567]\.\d\d m below where they have it/);
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

/** A transverse Mercator about the origin of the flight, so far east: that is where its orthophoto lies, and its heights 100 m below the ellipsoid.  @param {number} east_m */
const about = (east_m) =>
  `PROJCS["about",GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],PARAMETER["latitude_of_origin",50],PARAMETER["central_meridian",8],PARAMETER["scale_factor",1],PARAMETER["false_easting",${east_m}],PARAMETER["false_northing",0],UNIT["metre",1]]`;

test('a block that its orthophoto has apart from the GNSS positions is weak, in plan, and in height by what these state', () => {
  const at = folder();
  const [picture = '', , heights = ''] = [1, 0, 3].map((k) => OWN.ground[k]);
  const rows = readdirSync(OWN.photos).map((name) => {
    const { position } = read_exif(readFileSync(join(OWN.photos, name)), 480, 360);
    return [name, position?.longitude_deg, position?.latitude_deg, position?.height_m, 1, 1].join();
  });
  const table = file(at, 'positions.csv', ['image,longitude,latitude,height,accuracy horizontal,accuracy vertical', ...rows].join('\n'));
  const called = (/** @type {number} */ east_m, /** @type {string[]} */ ...more) => {
    const map = join(at, `map-${east_m}.tif`);
    copyFileSync(picture, map);
    writeFileSync(map.replace('.tif', '.prj'), about(-east_m));
    const { stdout, stderr } = tiepoint(
      ...CALL,
      '--orthophoto',
      map,
      '--heights',
      heights,
      '--orthophoto-points',
      '3000',
      '--out',
      folder(),
      '--json',
      ...more,
    );
    assert.ok(stdout !== '', stderr);
    const { orthophoto, verdict } = JSON.parse(stdout);
    assert.equal(orthophoto.kind, 'linked', JSON.stringify(orthophoto));
    return verdict;
  };
  // Receivers that state nothing of their heights may be off by as much, or count from elsewhere.
  const right = called(0);
  assert.equal(right.kind, 'oriented', JSON.stringify(right));
  const beside = called(100);
  assert.equal(beside.kind, 'weak', JSON.stringify(beside));
  assert.match(
    beside.text,
    /The orthophoto has the block (9\d|10\d) m from the GNSS positions of its images in plan, in the median of 3, where 3\d m are usual/,
  );
  const below = /The orthophoto has the block (9\d|10\d)\.\d m below the GNSS positions of its images, in the median of 3, where [3-9]\.\d m are usual/;
  assert.match(called(0, '--positions', table).text, below);
  assert.equal(called(0, '--positions', table, '--heights-geoid-m', '100').kind, 'oriented');
  assert.equal(called(100, '--gps', 'ignore').kind, 'oriented');
  // In a system of its own the positions take part, and are rejected.
  const inSystem = called(0, '--positions', table, '--crs', 'EPSG:25832', '--geoid-m', '0');
  assert.equal(inSystem.kind, 'weak');
  assert.match(inSystem.text, below);
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
  assert.match(refused(...OWN.ground, '--near-x', '5'), /^2 .*--near-x needs --near-y beside it/);
  assert.match(refused(...OWN.ground, '--check-share', '0.9'), /^2 .*--check-share is 0\.9; allowed: 0 to 0\.5/);
});
