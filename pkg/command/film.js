// @ts-check
import { basename, dirname, extname, join } from 'node:path';
import { film_frame, film_pixel_mm, parse_camera } from '../node.js';
import { about, DataError, UsageError } from './errors.js';
import { exists, isFolder, makeFolder, readBytes, readText, writeInto } from './files.js';
import { JSON_FLAG, path } from './options.js';
import { print, printJson } from './output.js';
import { marksOf } from './pair.js';
import { Progress } from './progress.js';
import { fixed, table } from './text.js';

/** @typedef {import('../node.js').FiducialOrientation} FiducialOrientation @typedef {import('../node.js').CameraRule} CameraRule */

/** What its images are called beside their scans, and the pattern of these names. */
const END = '-film.png';
const ALL = `*${END}`;

/** @type {import('./args.js').Command} */
export const film = {
  name: 'film',
  summary: 'Scans of film as images of one ideal camera, of which a block is made: each is resampled by its fiducial marks.',
  positionals: [],
  rest: 'SCAN…',
  options: [
    path(
      'camera',
      'camera.json',
      'The calibrated camera of the film: {"focal_mm", "principal_point_mm": [x, y]}, with its distortion where that is known; required.',
    ),
    path('fiducials', 'DIR', 'Folder with the fiducial marks of each scan, a.csv for a.tif: col,row,x_mm,y_mm. By default they stand beside the scans.'),
    path('out', 'DIR', 'Folder that receives images/, masks/, cameras.json and film.csv, none of which is there; required.'),
    JSON_FLAG,
  ],
  details:
    'All images have one pixel size, the largest of the scans, no distortion, and the principal point in one place, however the film lay in the scanner: they are images of one camera. They end within the outermost marks of all tables; masks/ leave out what marks hide. cameras.json states the camera as calibrated ("fixed"), unless camera.json has "uncertainty". ' +
    `Then: tiepoint block DIR/images --cameras DIR/cameras.json --masks DIR/masks --out block. The image of a.tif is a${END}. film.csv: scan, image, number of marks, sigma0_mm, rmse_mm. JSON: scans [{name, image, marks}, …], cameras.`,
  run,
};

/** @param {import('./args.js').Call} call @returns {Promise<import('./errors.js').ExitCode>} */
async function run({ positionals, values }) {
  const [cameraFile, out] = ['camera', 'out'].map((name) => values.get(name));
  if (typeof cameraFile !== 'string') throw new UsageError('--camera is missing: name the file of the calibrated camera of the film');
  if (typeof out !== 'string') throw new UsageError('--out is missing: name the folder that receives the images');
  if (positionals.length === 0) throw new UsageError('name the scans of the film');
  const text = readText(cameraFile);
  const camera = about(cameraFile, () => parse_camera(text));
  // All tables come first: a mark that one scan lacks is of the film all the same, and a slip in the last one costs no work.
  const scans = scansOf(positionals, values.get('fiducials')).map((scan) => ({ ...scan, marks: marksOf(scan.table, undefined) }));
  const marks_mm = calibrated(scans.flatMap(({ marks }) => marks.fiducials));
  const pixel = Math.max(...scans.map(({ marks, table: file }) => about(file, () => film_pixel_mm({ camera, scan: marks, marks_mm }))));
  refuseExisting(out);
  for (const name of ['images', 'masks']) makeFolder(join(out, name));
  const shown = new Progress({ steps: scans.length });
  /** @type {{ name: string, image: string, marks: FiducialOrientation }[]} */
  const made = [];
  /** @type {CameraRule[]} */
  const cameras = [];
  /** @type {string[]} */
  const failed = [];
  for (const { file, marks, image } of scans) {
    try {
      const frame = shown.step(basename(file), () => about(file, () => film_frame(readBytes(file), { camera, scan: marks, marks_mm }, ALL, pixel)));
      writeInto(join(out, 'images'), image, frame.image);
      writeInto(join(out, 'masks'), image, frame.mask);
      addCamera(cameras, frame.camera, image);
      made.push({ name: basename(file), image, marks: frame.marks });
    } catch (error) {
      // What is wrong with one scan is told at the end: the others have their images.
      if (!(error instanceof DataError)) throw error;
      failed.push(error.message);
    }
  }
  shown.end();
  if (made.length > 0) {
    writeInto(out, 'cameras.json', `${JSON.stringify({ cameras }, null, 1)}\n`);
    const rows = made.map(({ name, image, marks }) => [name, image, marks.residuals_mm.length, marks.sigma0_mm ?? '', rms(marks)]);
    writeInto(out, 'film.csv', [['scan', 'image', 'marks', 'sigma0_mm', 'rmse_mm'], ...rows].map((row) => `${row.map(cell).join(',')}\n`).join(''));
    if (values.has('json')) printJson({ scans: made, cameras });
    else
      print(
        table([
          ['scan', 'marks', 'sigma0 [mm]', 'RMSE [mm]'],
          ...made.map(({ name, marks }) => [name, marks.residuals_mm.length, fixed(marks.sigma0_mm, 4), fixed(rms(marks), 4)]),
        ]),
        '',
        `written: ${join(out, 'images')}, ${join(out, 'masks')}, ${join(out, 'cameras.json')}, ${join(out, 'film.csv')}`,
      );
  }
  if (failed.length > 0) throw new DataError(failed.join('; '));
  return 0;
}

/** The scans with the files of their marks, and what their images are called.  @param {readonly string[]} files @param {unknown} folder */
function scansOf(files, folder) {
  if (typeof folder === 'string' && !isFolder(folder)) throw new DataError(`--fiducials is ${folder}, which is no folder; name that of the marks`);
  /** @type {Map<string, string>} */
  const seen = new Map();
  return files.map((file) => {
    const stem = basename(file, extname(file));
    const table = join(typeof folder === 'string' ? folder : dirname(file), `${stem}.csv`);
    if (!exists(file)) throw new DataError(`${file}: there is no such file`);
    if (!exists(table)) throw new DataError(`${file}: its fiducial marks are missing: there is no ${table}`);
    const other = seen.get(stem.toLowerCase());
    if (other !== undefined) throw new UsageError(`${other} and ${file} give images of the same name; allowed: each name once`);
    seen.set(stem.toLowerCase(), file);
    return { file, table, image: `${stem}${END}` };
  });
}

/** Images of another call would be taken for some of this one.  @param {string} out */
function refuseExisting(out) {
  const there = ['images', 'masks', 'cameras.json', 'film.csv'].map((name) => join(out, name)).find((place) => exists(place));
  if (there !== undefined) throw new DataError(`${there} is there already; name another folder`);
}

/** The marks of a film by their calibrated places, each once.  @param {import('../node.js').Fiducial[]} marks @returns {[number, number][]} */
function calibrated(marks) {
  return [...new Map(marks.map(({ x_mm, y_mm }) => [`${x_mm},${y_mm}`, /** @type {[number, number]} */ ([x_mm, y_mm])])).values()];
}

/** One camera for all images that it is alike of.  @param {CameraRule[]} cameras @param {CameraRule} camera @param {string} image */
function addCamera(cameras, camera, image) {
  const common = cameras.at(-1);
  if (common === undefined) cameras.push(camera);
  else if (JSON.stringify(common) !== JSON.stringify(camera)) cameras.unshift({ ...camera, images: image });
}

/** The root mean square length of residuals.  @param {FiducialOrientation} marks */
function rms({ residuals_mm: residuals }) {
  return Math.sqrt(residuals.reduce((sum, [x, y]) => sum + x * x + y * y, 0) / Math.max(residuals.length, 1));
}

/** @param {string | number} value */
const cell = (value) => (typeof value === 'string' && /[",\n]/.test(value) ? `"${value.replaceAll('"', '""')}"` : String(value));
