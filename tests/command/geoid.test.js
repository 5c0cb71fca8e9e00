import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { FinishedBlock } from '../../pkg/node.js';
import { pageModules } from '../www.js';
import { file, folder, json, tiepoint } from './command.js';

const FLIGHT = ['--strips', '1', '--exposures', '3', '--width-px', '480', '--height-px', '360', '--pixel-mm', '0.15'];
const UTM = ['--crs', 'EPSG:32632'];

/** About simulated blocks, which lie at 8° and 50°: its height rises by 4 m a degree to the east, and by so many to the north. */
const heightOf = (/** @type {number} */ longitude, /** @type {number} */ latitude, north = 0) => 47 + 4 * (longitude - 8) + north * (latitude - 50);

const [WEST, SOUTH, STEP, SIDE] = [7, 49, 0.25, 9];

/** The heights row by row from the south; where they do not rise to the north the same from there. */
const heights = (north = 0) => Array.from({ length: SIDE * SIDE }, (_, k) => heightOf(WEST + STEP * (k % SIDE), SOUTH + STEP * Math.floor(k / SIDE), north));

function gtx(north = 0) {
  const bytes = Buffer.alloc(40 + 4 * SIDE * SIDE);
  for (const [k, value] of [SOUTH, WEST, STEP, STEP].entries()) bytes.writeDoubleBE(value, 8 * k);
  for (const [k, value] of [SIDE, SIDE].entries()) bytes.writeInt32BE(value, 32 + 4 * k);
  for (const [k, value] of heights(north).entries()) bytes.writeFloatBE(value, 40 + 4 * k);
  return bytes;
}

/** A GeoTIFF of longitudes and latitudes whose pixels are points, as PROJ has geoids; `model` 1 says that it is projected.  @param {number} model */
function geoTiff(model = 2) {
  const values = Buffer.alloc(4 * SIDE * SIDE);
  for (const [k, value] of heights().entries()) values.writeFloatLE(value, 4 * k);
  const scale = Buffer.alloc(24);
  for (const [k, value] of [STEP, STEP, 0].entries()) scale.writeDoubleLE(value, 8 * k);
  const ties = Buffer.alloc(48);
  for (const [k, value] of [0, 0, 0, WEST, SOUTH + STEP * (SIDE - 1), 0].entries()) ties.writeDoubleLE(value, 8 * k);
  const keys = Buffer.alloc(24);
  for (const [k, value] of [1, 1, 0, 2, 1024, 0, 1, model, 1025, 0, 1, 2].entries()) keys.writeUInt16LE(value, 2 * k);
  const parts = [values, scale, ties, keys];
  const places = parts.map((_, k) => 8 + parts.slice(0, k).reduce((sum, part) => sum + part.length, 0));
  const [ofValues = 0, ofScale = 0, ofTies = 0, ofKeys = 0] = places;
  /** Tag, type, count, value. @type {[number, number, number, number][]} */
  const tags = [
    [256, 3, 1, SIDE],
    [257, 3, 1, SIDE],
    [258, 3, 1, 32],
    [259, 3, 1, 1],
    [262, 3, 1, 1],
    [273, 4, 1, ofValues],
    [277, 3, 1, 1],
    [278, 3, 1, SIDE],
    [279, 4, 1, values.length],
    [339, 3, 1, 3],
    [33550, 12, 3, ofScale],
    [33922, 12, 6, ofTies],
    [34735, 3, 12, ofKeys],
  ];
  const directory = Buffer.alloc(2 + 12 * tags.length + 4);
  directory.writeUInt16LE(tags.length, 0);
  for (const [k, [tag, type, count, value]] of tags.entries()) {
    directory.writeUInt16LE(tag, 2 + 12 * k);
    directory.writeUInt16LE(type, 4 + 12 * k);
    directory.writeUInt32LE(count, 6 + 12 * k);
    directory.writeUInt32LE(value, 10 + 12 * k);
  }
  const head = Buffer.alloc(8);
  head.write('II*\0', 'latin1');
  head.writeUInt32LE(8 + parts.reduce((sum, part) => sum + part.length, 0), 4);
  return Buffer.concat([head, ...parts, directory]);
}

const AT = folder();
const PHOTOS = join(AT, 'photos');
json('simulate', '--block', '--out', AT, ...FLIGHT, '--seed', '2');

/** A block in one strip is weakly oriented, whatever its heights count from.  @param {string[]} args */
function summaryOf(...args) {
  const out = args.at(-1) ?? '';
  const { code, stderr } = tiepoint('block', PHOTOS, ...args);
  assert.ok(code === 0 || code === 3, stderr);
  return JSON.parse(readFileSync(join(out, 'summary.json'), 'utf8'));
}

test('heights of a block count from a geoid in GTX and in GeoTIFF alike', () => {
  const found = [file(AT, 'flat.gtx', gtx()), file(AT, 'flat.tif', geoTiff())].map((geoid, k) => {
    const { crs, remarks } = summaryOf(...UTM, '--geoid', geoid, '--out', join(AT, `block_${k}`));
    assert.match(JSON.stringify(remarks), /heights count from the geoid of flat\.(gtx|tif), which lies 4[67]\.\d\d to 4[67]\.\d\d m above the ellipsoid/);
    return crs;
  });
  assert.deepEqual(
    found.map(({ geoid }) => geoid),
    ['flat.gtx', 'flat.tif'],
  );
  const [one = NaN, other = NaN] = found.map((crs) => crs.geoid_m);
  assert.ok(Math.abs(one - 47) < 0.05 && Math.abs(one - other) < 1e-3, `${one} ${other}`);
});

/** Rows of a table as numbers by the names of their columns.  @param {string} path @param {readonly string[]} names */
function numbersOf(path, names) {
  const [head = '', ...rows] = readFileSync(path, 'utf8').trim().split('\n');
  const places = names.map((name) => head.split(',').indexOf(name));
  return rows.map((row) => places.map((place) => Number(row.split(',')[place])));
}

test('tables of the page have the coordinates that the command writes, where the geoid slopes, to 1 mm from one end of the block to the other', async () => {
  const page = await pageModules(['block/engine/outcome', 'block/state/columns']);
  const out = join(AT, 'sloping');
  summaryOf(...UTM, '--geoid', file(AT, 'sloping.gtx', gtx(100)), '--out', out);
  const block = FinishedBlock.open(readFileSync(join(out, 'project.tiepoint')));
  // As it comes from its worker.
  const view = structuredClone(page.outcome.viewOf(block));
  block.free();
  for (const [subject, keys] of Object.entries({ images: ['X', 'Y', 'Z'], points: ['x', 'y', 'z'] })) {
    const written = numbersOf(join(out, `${subject}.csv`), ['x', 'y', 'z']);
    const { columns } = page.columns.rowsOf(subject, { view, given: [], asGiven: undefined });
    const shown = written.map((_, row) => keys.map((key) => columns.find((/** @type {any} */ column) => column.key === key).value(row)));
    const apart = written.flatMap((row, i) => row.map((value, k) => Math.abs(value - (shown[i]?.[k] ?? NaN))));
    assert.ok(written.length > 2 && apart.every((value) => value < 1e-3), `${subject}: ${Math.max(...apart)} m`);
  }
  // By more than that the geoid differs from one end to the other.
  const [south, north] = [Math.min, Math.max].map((of) => of(...numbersOf(join(out, 'points.csv'), ['y']).flat()));
  assert.ok((100 * ((north ?? NaN) - (south ?? NaN))) / 111_000 > 0.05, `${south} to ${north}`);
});

test('a geoid that no heights count from, and what is none, are refused', () => {
  const geoid = file(AT, 'flat.gtx', gtx());
  const refused = (/** @type {string[]} */ ...args) => {
    const { code, stdout, stderr } = tiepoint('block', PHOTOS, ...args, '--out', join(AT, 'refused'));
    assert.equal(stdout, '');
    return `${code} ${stderr}`;
  };
  assert.match(refused('--geoid', geoid), /flat\.gtx without a coordinate system/);
  assert.match(refused(...UTM, '--geoid', geoid, '--geoid-m', '46'), /46 m and the file flat\.gtx/);
  assert.match(refused('--crs', 'EPSG:4979', '--geoid', geoid), /flat\.gtx beside WGS 84, whose heights are ellipsoidal/);
  assert.match(refused(...UTM, '--geoid', join(AT, 'none.gtx')), /none\.gtx: there is no such file/);
  assert.match(refused(...UTM, '--geoid', AT), /there is no such file/);
  assert.match(refused(...UTM, '--geoid', file(AT, 'projected.tif', geoTiff(1))), /projected\.tif, which is not a geoid file that can be read/);
  const elsewhere = gtx();
  elsewhere.writeDoubleBE(-30, 0);
  assert.match(
    refused(...UTM, '--geoid', file(AT, 'south.gtx', elsewhere)),
    /south\.gtx, which covers longitudes 7\.00 to 9\.00 and latitudes -30\.00 to -28\.00/,
  );
});
