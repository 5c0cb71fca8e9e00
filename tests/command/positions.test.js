/** GNSS positions of a block's images from a table. */

import assert from 'node:assert/strict';
import { mkdirSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { read_exif } from '../../pkg/node.js';
import { file, folder, json, tiepoint } from './command.js';

const FLIGHT = ['--strips', '2', '--exposures', '3', '--width-px', '480', '--height-px', '360', '--pixel-mm', '0.15'];

const AT = folder();
const PHOTOS = join(AT, 'photos');
const BARE = join(AT, 'bare');
json('simulate', '--block', '--out', AT, ...FLIGHT, '--seed', '3');
const NAMES = readdirSync(PHOTOS).sort();

/** A PNG without what it records.  @param {Buffer} png */
function bareOf(png) {
  const parts = [png.subarray(0, 8)];
  for (let at = 8; at < png.length; ) {
    const end = at + 12 + png.readUInt32BE(at);
    if (png.toString('latin1', at + 4, at + 8) !== 'eXIf') parts.push(png.subarray(at, end));
    at = end;
  }
  return Buffer.concat(parts);
}

mkdirSync(BARE);
const RECORDED = NAMES.map((name) => {
  const png = readFileSync(join(PHOTOS, name));
  file(BARE, name, bareOf(png));
  const { position } = read_exif(png, 480, 360);
  assert.ok(position);
  assert.equal(read_exif(readFileSync(join(BARE, name)), 480, 360).position, null);
  return position;
});

const [focal_px] = JSON.parse(readFileSync(join(AT, 'truth.json'), 'utf8')).block.cameras.map((/** @type {{ focal_px: number }} */ camera) => camera.focal_px);
const CAMERAS = ['--cameras', file(AT, 'cameras.json', JSON.stringify({ cameras: [{ focal_px, fixed: true }] }))];

const TABLE = file(
  AT,
  'positions.csv',
  ['image,latitude,longitude,altitude', ...RECORDED.map((at, k) => [NAMES[k], at.latitude_deg, at.longitude_deg, at.height_m].join(','))].join('\n'),
);

/** The orientations of a block, row by row.  @param {string} photos @param {string} name @param {string[]} args */
function orientations(photos, name, ...args) {
  const out = join(AT, name);
  const { code, stderr } = tiepoint('block', photos, ...CAMERAS, ...args, '--out', out);
  assert.ok(code === 0 || code === 3, stderr);
  const [head = '', ...rows] = readFileSync(join(out, 'images.csv'), 'utf8').trim().split('\n');
  const columns = ['name', 'x', 'y', 'z', 'omega_deg', 'phi_deg', 'kappa_deg', 'sigma_x'].map((column) => head.split(',').indexOf(column));
  assert.ok(columns.every((column) => column >= 0));
  const { remarks } = JSON.parse(readFileSync(join(out, 'summary.json'), 'utf8'));
  return { rows: rows.map((row) => columns.map((column) => row.split(',')[column]).join(' ')), remarks: JSON.stringify(remarks) };
}

test('a table georeferences photos that record no position as their own positions do', () => {
  const own = orientations(PHOTOS, 'own');
  assert.equal(own.rows.length, NAMES.length);
  assert.deepEqual(orientations(BARE, 'table', '--positions', TABLE).rows, own.rows);
  assert.notDeepEqual(orientations(BARE, 'none').rows, own.rows);
  // `--gps ignore` leaves both out.
  assert.deepEqual(orientations(PHOTOS, 'ignored', '--gps', 'ignore', '--positions', TABLE).rows, orientations(PHOTOS, 'unplaced', '--gps', 'ignore').rows);
});

test('what a table has beside positions of the images is remarked', () => {
  const other = file(AT, 'other.csv', `Label;Länge;Breite;Höhe;Roll\n${NAMES[0]};8,0001;50;300;1\nstranger.jpg;8;50;300;1\n`);
  const { remarks } = orientations(PHOTOS, 'remarked', '--positions', other);
  assert.match(remarks, /columns of the table of image positions are not understood and not read: Roll/);
  assert.match(remarks, /names other images, too: stranger\.jpg/);
});

test('a table that cannot be used is refused before anything is computed', () => {
  const refused = (/** @type {string} */ text, /** @type {string[]} */ ...args) => {
    const { code, stdout, stderr } = tiepoint('block', PHOTOS, '--positions', file(AT, 'wrong.csv', text), ...args, '--out', join(AT, 'refused'));
    assert.equal(stdout, '');
    return `${code} ${stderr}`;
  };
  const [name = ''] = NAMES;
  assert.match(refused(`${name},50.1,8.2,300\n`), /wrong\.csv: .*50\.1, 8\.2 in line 1, which may be latitude and longitude or longitude and latitude/);
  assert.match(refused(`image,x,y,z\n${name},446833,5594521,300\n`), /\(446833, 5594521\) in line 2, .*without a coordinate system.*\(--crs\)/);
  assert.match(refused(`image,lon,lat\n${name},8,50\n${name.toUpperCase()},8,50\n`), /again in line 3; allowed: each image once/);
  assert.match(refused(`image,lon,lat\n${name},8,x\n`), /wrong\.csv: .*'x' for lat in line 2/);
});
