/** GeoTIFFs of the command, read by GDAL; and what GDAL writes of them, read again. */

import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { inParts } from '../../pkg/command/files.js';
import { OrthophotoReference, Photo } from '../../pkg/node.js';
import { readJson, ROOT } from '../lib/paths.mjs';
import { must, run } from '../lib/process.mjs';
import { PYTHON, pythonLacks } from './python.mjs';

const COMMAND = join(ROOT, 'pkg', 'bin', 'tiepoint.js');
const TOWN = ['--strips', '2', '--exposures', '3', '--width-px', '800', '--height-px', '600', '--pixel-mm', '0.045', '--orthophoto', '0.5'];
/** Of `tools/bench/geotiff_copies.py`. */
const CODE = 25833;

/** @typedef {{ origin: number[], by_column: number[], by_row: number[] }} Place */

export async function geotiffs() {
  const lacks = pythonLacks({ rasterio: 'rasterio', scipy: 'scipy' });
  if (lacks) return console.log(`GeoTIFFs beside GDAL: skipped, ${lacks}`);
  console.log('GeoTIFFs beside GDAL');
  const folder = mkdtempSync(join(tmpdir(), 'tiepoint-geotiffs-'));
  try {
    const entries = await written(folder);
    const list = join(folder, 'list.json');
    writeFileSync(list, JSON.stringify(entries));
    const { code, output } = await run(PYTHON, [join(ROOT, 'tools', 'check_geotiffs.py'), list], { quiet: true });
    console.log(indented(output));
    if (code !== 0) throw new Error('GDAL does not read what was written');
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** @param {string} output */
const indented = (output) =>
  output
    .trimEnd()
    .split('\n')
    .map((line) => `  ${line}`)
    .join('\n');

/** Writes GeoTIFFs of all kinds, and says what is in them.  @param {string} folder @returns {Promise<object[]>} */
async function written(folder) {
  const town = join(folder, 'town');
  await tiepoint(['simulate', '--block', '--out', town, ...TOWN]);
  const [orthophoto, heights] = [join(town, 'orthophoto.tif'), join(town, 'heights.tif')];
  /** @type {object[]} */
  const entries = [
    picture(folder, 'orthophoto of the simulated town', orthophoto, null),
    heightsOf(folder, 'heights of the simulated town', orthophoto, heights),
  ];
  const ground = ['--orthophoto', orthophoto, '--heights', heights];
  const cameras = join(folder, 'cameras.json');
  const [{ focal_px }] = readJson(join(town, 'truth.json')).block.cameras;
  writeFileSync(cameras, JSON.stringify({ cameras: [{ focal_px, fixed: true }] }));
  entries.push(await rectified(folder, 'a photograph, rectified', town, orthophoto, heights, cameras, null));

  const [cog, turned] = ['cog', 'turned'].map((kind) => (/** @type {string} */ what) => join(folder, `${kind}-${what}.tif`));
  for (const [what, file] of Object.entries({ orthophoto, heights }))
    await must(PYTHON, [join(ROOT, 'tools', 'bench', 'geotiff_copies.py'), file, cog?.(what) ?? '', turned?.(what) ?? ''], { quiet: true });
  for (const [kind, copy] of Object.entries({ 'the COG that GDAL makes of it': cog, 'the turned one that GDAL makes of it': turned })) {
    if (!copy) continue;
    entries.push(picture(folder, `orthophoto, ${kind}`, copy('orthophoto'), CODE));
    entries.push(await rectified(folder, `a photograph, rectified on ${kind}`, town, copy('orthophoto'), copy('heights'), cameras, CODE));
  }

  const block = join(folder, 'block');
  await tiepoint(['block', join(town, 'photos'), '--out', block, '--workers', '2', ...ground]);
  const project = join(block, 'project.tiepoint');
  const mosaic = join(folder, 'mosaic.tif');
  await tiepoint(['mosaic', project, join(town, 'photos'), '--out', mosaic, '--heights', heights]);
  entries.push({ ...picture(folder, 'mosaic of the block', mosaic, null), near: orthophoto, near_name: 'the orthophoto' });
  const inColours = join(folder, 'mosaic-in-colours.tif');
  await tiepoint(['mosaic', project, coloured(join(town, 'photos'), join(folder, 'coloured')), '--out', inColours, '--heights', heights]);
  entries.push(picture(folder, 'mosaic of the block in colours', inColours, null));
  const accuracy = join(folder, 'accuracy');
  await tiepoint(['accuracy', project, '--out', accuracy]);
  return [...entries, ...maps(accuracy)];
}

/** @param {string[]} args */
const tiepoint = (args) => must(process.execPath, [COMMAND, ...args], { quiet: true });

/** The same photos in colours that are made of their grey values.  @param {string} photos @param {string} folder */
function coloured(photos, folder) {
  mkdirSync(folder);
  for (const name of readdirSync(photos)) {
    const photo = Photo.decode(readFileSync(join(photos, name)));
    const { width, height } = photo;
    const colours = Buffer.from(Uint8Array.from([...photo.grey()].flatMap((grey) => [grey, 255 - grey, grey >> 1])));
    photo.free();
    writeFileSync(join(folder, name), Buffer.concat([Buffer.from(`P6\n${width} ${height}\n255\n`), colours]));
  }
  return folder;
}

let files = 0;

/** Writes pixels as they are.  @param {string} folder @param {Uint8Array | Float32Array} values @returns {string} */
function raw(folder, values) {
  files += 1;
  const file = join(folder, `${files}.raw`);
  writeFileSync(file, new Uint8Array(values.buffer, values.byteOffset, values.byteLength));
  return file;
}

/** A GeoTIFF, as Tiepoint reads it, grey and in its colours.  @param {string} folder @param {string} name @param {string} file @param {number | null} epsg the system that it must have */
function picture(folder, name, file, epsg) {
  const reference = OrthophotoReference.open(inParts(file));
  const { width, height, georeference, epsg: code } = reference.info();
  if ((code ?? null) !== epsg) throw new Error(`${name}: its system is ${code}, not ${epsg}`);
  const values = raw(folder, reference.picture(0, 0, width, height, 0));
  const colours = raw(folder, reference.colours(0, 0, width, height, 0));
  reference.free();
  return { name, file, size: [width, height], georeference, epsg, values, colours };
}

/** Heights at the middles of the pixels of an orthophoto on the same grid.  @param {string} folder @param {string} name @param {string} orthophoto @param {string} file */
function heightsOf(folder, name, orthophoto, file) {
  const reference = OrthophotoReference.open(inParts(orthophoto));
  reference.set_heights(readFileSync(file));
  const { width, height, georeference } = reference.info();
  const places = Array.from({ length: width * height }, (_, k) => placeOf(georeference, (k % width) + 0.5, Math.floor(k / width) + 0.5)).flat();
  const values = raw(folder, Float32Array.from(reference.heights_at(new Float64Array(places))));
  reference.free();
  return { name, file, size: [width, height], georeference, epsg: null, values };
}

/** @param {Place} place @param {number} column @param {number} row */
const placeOf = ({ origin, by_column, by_row }, column, row) => origin.map((v, axis) => v + (by_column[axis] ?? NaN) * column + (by_row[axis] ?? NaN) * row);

/** A photograph that is placed and resampled to the ground.  @param {string} folder @param {string} name @param {string} town @param {string} orthophoto @param {string} heights @param {string} cameras @param {number | null} epsg */
async function rectified(folder, name, town, orthophoto, heights, cameras, epsg) {
  const photo = join(town, 'photos', readdirSync(join(town, 'photos')).sort()[1] ?? '');
  const out = mkdtempSync(join(folder, 'placed-'));
  await tiepoint(['place', photo, '--orthophoto', orthophoto, '--heights', heights, '--cameras', cameras, '--out', out, '--rectified']);
  const [{ placement }] = readJson(join(out, 'result.json')).images;
  const decoded = Photo.decode(readFileSync(photo));
  const grey = raw(folder, decoded.grey());
  decoded.free();
  const file = readdirSync(out).find((other) => other.endsWith('-rectified.tif')) ?? '';
  return { ...picture(folder, name, join(out, file), epsg), photo: { grey, heights, camera: placement.camera, pose: placement.pose } };
}

/** Maps of the accuracy, each with the column of the table beside them that it shows.  @param {string} accuracy */
function maps(accuracy) {
  const columns = { plan: 'plan_error', height: 'height_error', images: 'images' };
  return Object.entries(columns).map(([map, column]) => ({
    name: `accuracy, ${map}.tif`,
    file: join(accuracy, `${map}.tif`),
    table: join(accuracy, 'accuracy.csv'),
    column,
  }));
}
