/** Photographs on an orthophoto that another program made of other photographs of the block, beside where COLMAP has them; photographs of elsewhere, none of which may be placed. */

import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { DATA, readJson, ROOT } from '../lib/paths.mjs';
import { must, run } from '../lib/process.mjs';
import { have } from './data.mjs';
import { median } from './median.mjs';
import { PYTHON, pythonLacks } from './python.mjs';

const NAME = 'block_caliterra';
const PACKAGES = { pycolmap: 'pycolmap', rasterio: 'rasterio', cv2: 'opencv-python-headless', scipy: 'scipy' };
const COMMAND = join(ROOT, 'pkg', 'bin', 'tiepoint.js');
/** Folders of the same place, whose photographs may be placed. */
const SAME_PLACE = 'caliterra';
const AXES = 3;
/** Exit status of a block with doubt. */
const WEAK = 3;

/** `position`, `errors`: in m; `verdict` in words.  @typedef {{ name: string, position: number[], errors: number[], verdict: string }} Found */
/** @typedef {{ gsd_m: number, size_px: number[], half: string[], share_of_matched_heights: number, code: number, camera: Record<string, number | number[]>, others: Record<string, { position: number[] }> }} Truth */

export async function orthophotoReference() {
  const lacks = pythonLacks(PACKAGES);
  if (lacks) return console.log(`Orthophoto of another program: skipped, ${lacks}`);
  if (!have(NAME)) return;
  const folder = mkdtempSync(join(tmpdir(), 'tiepoint-orthophoto-reference-'));
  try {
    const started = performance.now();
    await must(PYTHON, [join(ROOT, 'tools', 'bench', 'colmap_orthophoto.py'), join(DATA, NAME), folder], { quiet: true });
    /** @type {Truth} */
    const truth = readJson(join(folder, 'truth.json'));
    const names = Object.keys(truth.others);
    console.log(
      `Orthophoto by COLMAP, OpenCV and GDAL of ${truth.half.length} photographs of ${NAME}, in ${seconds(started)} s: ${truth.size_px.join(' x ')} px of ${truth.gsd_m.toFixed(3)} m, EPSG:${truth.code}, ` +
        `${percent(truth.share_of_matched_heights)} of its heights matched, the others those of COLMAP's points`,
    );
    console.log(`  its camera: ${JSON.stringify(truth.camera)}`);
    const ground = ['--orthophoto', join(folder, 'orthophoto.tif'), '--heights', join(folder, 'heights.tif')];
    const cameras = join(folder, 'cameras.json');
    writeFileSync(cameras, JSON.stringify({ cameras: [{ ...truth.camera, fixed: true }] }));
    for (const [what, more] of /** @type {[string, string[]][]} */ ([
      ['camera calibrated by COLMAP', ['--cameras', cameras]],
      ['camera of EXIF', []],
    ])) {
      const before = performance.now();
      const placed = await placedBy([...names.map((name) => join(DATA, NAME, name)), ...ground, ...more]);
      tell(`${names.length} other photographs, each by itself, ${what}`, placed, truth, before);
      const block = performance.now();
      tell(`the same as a block, ${what}`, await asBlock(folder, names, [...ground, ...more]), truth, block);
    }
    await elsewhere(ground);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const seconds = (/** @type {number} */ since) => ((performance.now() - since) / 1000).toFixed(0);
const percent = (/** @type {number} */ share) => `${(100 * share).toFixed(0)} %`;

/** What `tiepoint place` says.  @param {string[]} args */
async function placing(args) {
  const { code, answer, output } = await run(process.execPath, [COMMAND, 'place', ...args, '--json'], { quiet: true });
  if (![0, 3, 4].includes(code)) throw new Error(`placing ended with ${code}\n${output.slice(-2000)}`);
  return JSON.parse(answer).images;
}

/** @param {string[]} args @returns {Promise<Found[]>} */
async function placedBy(args) {
  return (await placing(args)).flatMap((/** @type {any} */ { name, verdict, placement }) =>
    placement
      ? [{ name, verdict: `${verdict.kind}, σ0 ${placement.sigma0_px.toFixed(2)} px`, position: placement.pose.position, errors: placement.position_errors_m }]
      : [],
  );
}

/** @param {string} folder @param {string[]} names @param {string[]} more @returns {Promise<Found[]>} */
async function asBlock(folder, names, more) {
  const photos = mkdtempSync(join(folder, 'photos-'));
  for (const name of names) symlinkSync(join(DATA, NAME, name), join(photos, name));
  const out = join(photos, 'block');
  mkdirSync(out);
  const { code, output } = await run(process.execPath, [COMMAND, 'block', photos, '--out', out, '--workers', '2', ...more], { quiet: true });
  if (![0, WEAK].includes(code)) throw new Error(`the block ended with ${code}\n${output.slice(-2000)}`);
  const { verdict, orthophoto } = readJson(join(out, 'summary.json'));
  console.log(
    `  ${verdict.text} ${orthophoto.kind === 'linked' ? `${orthophoto.linked} of ${orthophoto.images} images linked` : 'not linked to the orthophoto'}`,
  );
  if (orthophoto.kind !== 'linked') return [];
  const [head = '', ...rows] = readFileSync(join(out, 'images.csv'), 'utf8').trim().split('\n');
  const columns = head.split(',');
  return rows.flatMap((row) => {
    const cells = row.split(',');
    const of = (/** @type {string} */ name) => cells[columns.indexOf(name)] ?? '';
    if (of('x') === '') return [];
    return [
      {
        name: of('name'),
        verdict: 'oriented',
        position: ['x', 'y', 'z'].map((axis) => Number(of(axis))),
        errors: ['x', 'y', 'z'].map((axis) => Number(of(`sigma_${axis}`))),
      },
    ];
  });
}

/** Errors in GSD, each and in the median, and by standard errors.  @param {string} what @param {Found[]} found @param {Truth} truth @param {number} started */
function tell(what, found, truth, started) {
  const number = Object.keys(truth.others).length;
  console.log(`  ${what}: ${found.length} of ${number} placed, in ${seconds(started)} s; errors of the projection centre in GSD (by standard errors)`);
  const rows = found.flatMap(({ name, verdict, position, errors }) => {
    const own = truth.others[name];
    if (!own) return [];
    const off = position.map((v, axis) => v - (own.position[axis] ?? NaN));
    return [{ name, verdict, gsd: off.map((v) => v / truth.gsd_m), ratio: off.map((v, axis) => v / (errors[axis] ?? NaN)) }];
  });
  for (const { name, verdict, gsd, ratio } of rows)
    console.log(`    ${name} ${verdict}: ${gsd.map((v, axis) => `${'XYZ'[axis]} ${v.toFixed(2)} (${(ratio[axis] ?? NaN).toFixed(1)})`).join(', ')}`);
  const plan = rows.map(({ gsd: [x = NaN, y = NaN] }) => Math.hypot(x, y));
  const height = rows.map(({ gsd }) => Math.abs(gsd[2] ?? NaN));
  const squares = Array.from({ length: AXES }, (_, axis) => rows.reduce((sum, { ratio }) => sum + (ratio[axis] ?? NaN) ** 2, 0) / rows.length);
  console.log(
    `    median in plan ${median(plan).toFixed(2)}, in height ${median(height).toFixed(2)}; mean square of error by standard error, X Y Z: ${squares.map((v) => v.toFixed(1)).join(' ')}, ` +
      `their sizes in the median ${median(rows.flatMap(({ ratio }) => ratio.map(Math.abs))).toFixed(2)}`,
  );
}

/** @param {string[]} ground */
async function elsewhere(ground) {
  const folders = readdirSync(DATA, { withFileTypes: true }).filter((entry) => entry.isDirectory() && !entry.name.includes(SAME_PLACE));
  let [tried, placed] = [0, 0];
  for (const { name } of folders) {
    const files = readdirSync(join(DATA, name))
      .filter((file) => /\.(jpe?g|png|tiff?)$/i.test(file))
      .map((file) => join(DATA, name, file));
    if (files.length === 0) continue;
    const images = await placing([...files, ...ground]);
    const wrong = images.filter((/** @type {any} */ { placement }) => placement);
    [tried, placed] = [tried + images.length, placed + wrong.length];
    for (const { name: file, verdict } of wrong) console.log(`    ${name} ${file}: ${verdict.kind}`);
  }
  console.log(`  photographs of elsewhere: ${tried}, of which ${placed} were placed`);
}
