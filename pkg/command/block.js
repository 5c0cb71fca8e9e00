// @ts-check
import { readFile } from 'node:fs/promises';
import { basename, join } from 'node:path';
import { runBlock } from '../block/index.js';
import {
  acting_block_parameters,
  block_parameters,
  block_settings,
  check_block_truth,
  check_geoid,
  export_formats,
  parse_camera_rules,
  parse_ground_control_points,
  parse_image_measurements,
  positions_of_images,
} from '../node.js';
import { noteNotActing } from './acting.js';
import { BlockFolder, formatsOf } from './block-folder.js';
import { about, DataError, UsageError } from './errors.js';
import { exists, imagesIn, imagesOf, isFile, isFolder, readText, reasonOf } from './files.js';
import { FolderStore } from './folder-store.js';
import { checkCrs } from './ground.js';
import { noteElsewhere, onOrthophoto, ORTHOPHOTO_OPTIONS, orthophotoOf } from './on-orthophoto.js';
import { BLOCK_NAMES, DEFAULT_WORKERS, JSON_FLAG, LANGUAGE, languageOf, list, optionsOf, path, settingsOf, word, WORKERS } from './options.js';
import { ThreadPool } from './pool.js';
import { Progress } from './progress.js';
import { truthFile } from './truth.js';

/**
 * @typedef {import('./args.js').Call} Call
 * @typedef {import('../block/index.js').Source & { file: string }} Source
 */

const OPTIONS = optionsOf(block_parameters(), block_settings({}), BLOCK_NAMES);

/** @type {import('./args.js').Command} */
export const block = {
  name: 'block',
  summary: 'Matches and orients a block of images: pairs, tie points and their selection, bundle block adjustment, files for other programs.',
  positionals: [],
  rest: 'FOLDER|IMAGE…',
  options: [
    path('out', 'DIR', 'Folder that receives the files; required. Its folder work/ keeps intermediate results, from which a repeated call continues.'),
    path(
      'cameras',
      'cameras.json',
      'Cameras in place of those of EXIF: {"cameras": [{"images": "DJI_*.JPG", "focal_px", "principal_point_px": [x, y], "radial": [k1, k2, k3], "tangential": [p1, p2], "pixel_mm", "fixed"}]}, all but focal_px optional.',
    ),
    word('gps', ['use', 'ignore'], 'Whether the GNSS positions of the images choose near images and georeference the block.', 'use'),
    path(
      'control',
      'points.csv',
      'Ground control points that georeference the block, in place of GNSS positions or, with --crs, beside them: name,x,y,z and perhaps standard errors, in m; a column use makes each control, check or off; needs --marks.',
    ),
    path(
      'positions',
      'positions.csv',
      'GNSS positions of images, in place of those that their files record: image,longitude,latitude,height above the ellipsoid or, with --crs, image,x,y,height, and perhaps standard errors of place and height, in m. A first line names the columns, as Metashape, Pix4D, Emlid and ExifTool write them.',
    ),
    path('marks', 'marks.csv', 'Image measurements of the ground control and check points: image,point,x,y in px.'),
    path(
      'geoid',
      'FILE',
      'The geoid from which the heights of --crs count, in place of --geoid-m: a GeoTIFF of longitudes and latitudes, GTX, or PGM of GeographicLib. It may cover the earth: the part about the block is kept.',
    ),
    path(
      'masks',
      'DIR',
      'Masks: images in which no features are wanted where they are 0 (black), as large as the images whose names they have: IMG_1.png, IMG_1_mask.png or IMG_1.jpg.png for IMG_1.jpg.',
    ),
    path(
      'truth',
      'FILE',
      'truth.json of a simulated flight, or its folder: the block is scored by it, after a similarity of the whole block onto it: where and how large it is as a whole does not count.',
    ),
    list('export', export_formats(), 'Formats for other programs, with commas between; each in a folder of its name.'),
    LANGUAGE,
    WORKERS,
    JSON_FLAG,
    ...ORTHOPHOTO_OPTIONS,
    ...OPTIONS,
  ],
  details:
    'Files: project.tiepoint, images.csv, pairs.csv (with the reason of each pair), points.csv, surveyed.csv (ground control and check points with their discrepancies), rays.csv, orientation.json (the adjustment in full), report.html (a page with figures and drawings), summary.json. Images of one make, model, focal length and size share a ' +
    'camera. Images that cannot be read are skipped and listed. Files of an earlier run that this one does not write are removed unless they were changed; other files in DIR stay. ' +
    'A file that would be written over and that no run wrote, or that was changed since, is refused before anything is computed. The exit code is that of the verdict: 0 oriented, 3 weak, 4 where no image could be oriented; the files are written in any case. ' +
    'Models count from 1; files for other programs hold the first of them. JSON: what summary.json holds.',
  run,
};

/** @param {Call} call @returns {Promise<import('./errors.js').ExitCode>} */
async function run(call) {
  const { values } = call;
  const out = values.get('out');
  if (typeof out !== 'string') throw new UsageError('--out is missing: name the folder that receives the files');
  const sources = sourcesOf(call.positionals);
  checkCrs(values);
  const settings = settingsOf(OPTIONS, values, block_settings({}));
  noteNotActing(OPTIONS, values, acting_block_parameters(settings));
  const formats = formatsOf(values);
  const cameras = values.get('cameras');
  const options = {
    settings,
    gps: /** @type {'use' | 'ignore'} */ (values.get('gps') ?? 'use'),
    ...(typeof cameras === 'string' && { cameras: camerasOf(cameras) }),
    ...controlOf(values),
    ...masksOf(values),
    ...geoidOf(values, settings),
    ...positionsOf(values),
    onOrthophoto: values.has('orthophoto'),
  };
  const simulated = values.get('truth');
  const truth = typeof simulated === 'string' ? truthFile(simulated) : null;
  const known = truth === null ? null : truthOf(truth);
  // What can be refused before anything is computed.
  const names = sources.map(({ name }) => name);
  if (known) about(String(truth), () => check_block_truth(known, names));
  const { positions } = options;
  const given = positions === undefined ? [] : about(String(values.get('positions')), () => positions_of_images(positions, names, settings.placing));
  const reference = orthophotoOf(values);
  const folder = new BlockFolder(out, names, formats);
  const pool = new ThreadPool(Number(values.get('workers') ?? DEFAULT_WORKERS));
  const shown = new Progress({ quiet: values.has('json') });
  try {
    if (reference && options.gps === 'use')
      noteElsewhere(
        reference,
        sources.map(({ file }) => file),
        given,
      );
    const found = await runBlock(sources, options, { pool, store: new FolderStore(join(out, 'work')), progress: (step) => shown.stage(step) });
    shown.end();
    const finished = reference ? await onOrthophoto(found, sources, reference) : found;
    const score = known && about(String(truth), () => finished.score(known));
    return folder.tell(folder.write(finished, score, languageOf(values)), values.has('json'));
  } finally {
    shown.end();
    await pool.close();
    folder.release();
    reference?.free();
  }
}

/** @param {string} file */
function camerasOf(file) {
  const text = readText(file);
  about(file, () => parse_camera_rules(text));
  return { name: file, text };
}

/** The block of a truth, as simulate --block writes it.  @param {string} file @returns {import('../node.js').BlockModel} */
function truthOf(file) {
  try {
    const { block: known } = JSON.parse(readText(file));
    if (known) return known;
  } catch (error) {
    if (!(error instanceof SyntaxError)) throw error;
  }
  throw new DataError(`${file}: it is no truth of a block, as simulate --block writes it`);
}

/** @param {Call['values']} values */
function controlOf(values) {
  const [control, marks] = [values.get('control'), values.get('marks')];
  if (typeof control !== 'string' && typeof marks !== 'string') return {};
  if (typeof control !== 'string') throw new UsageError('--marks needs --control beside it');
  if (typeof marks !== 'string') throw new UsageError('--control needs --marks beside it');
  const texts = { points: readText(control), marks: readText(marks) };
  about(control, () => parse_ground_control_points(texts.points));
  about(marks, () => parse_image_measurements(texts.marks));
  return { control: texts };
}

/** @param {Call['values']} values */
function positionsOf(values) {
  const file = values.get('positions');
  return typeof file === 'string' ? { positions: readText(file) } : {};
}

/** @param {Call['values']} values */
function masksOf(values) {
  const folder = values.get('masks');
  if (typeof folder !== 'string') return {};
  if (!isFolder(folder)) throw new UsageError(`--masks is ${folder}, which is no folder; name a folder of masks`);
  return { masks: imagesIn(folder).map(sourceOf), strayMasks: /** @type {const} */ ('list') };
}

/** @param {Call['values']} values @param {import('../node.js').BlockSettings} settings */
function geoidOf(values, { placing }) {
  const file = values.get('geoid');
  if (typeof file !== 'string') return {};
  if (!exists(file) || isFolder(file)) throw new DataError(`${file}: there is no such file`);
  check_geoid(basename(file), placing);
  return { geoid: sourceOf(file) };
}

/** The images of folders, by name, and single images, in the order in which they were given.  @param {string[]} given @returns {Source[]} */
function sourcesOf(given) {
  if (given.length === 0) throw new UsageError('FOLDER or IMAGE is missing: tiepoint block FOLDER --out DIR');
  for (const one of given) if (!exists(one)) throw new DataError(`${one}: there is no such file or folder`);
  /** @type {Map<string, string>} */
  const seen = new Map();
  return imagesOf(given).map((file) => {
    const name = basename(file);
    const other = seen.get(name);
    if (other !== undefined) throw new UsageError(`${other} and ${file} have the same name; allowed: each name once`);
    seen.set(name, file);
    return sourceOf(file);
  });
}

/** @param {string} file @returns {Source} */
const sourceOf = (file) => ({
  name: basename(file),
  file,
  bytes: async () => {
    // Reading a pipe would wait for whoever writes into it.
    if (!isFile(file)) throw new Error('it is no file, but a pipe, a socket or a device');
    return readFile(file).catch((error) => Promise.reject(new Error(reasonOf(error))));
  },
});
