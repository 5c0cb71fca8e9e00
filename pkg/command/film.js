// @ts-check
import { basename, dirname, extname, join } from 'node:path';
import { film_frame, parse_camera } from '../node.js';
import { about, DataError, UsageError } from './errors.js';
import { exists, isFolder, makeFolder, readBytes, readText, writeInto } from './files.js';
import { JSON_FLAG, path } from './options.js';
import { print, printJson } from './output.js';
import { marksOf } from './pair.js';
import { Progress } from './progress.js';
import { fixed, table } from './text.js';

/** @typedef {import('../node.js').FiducialOrientation} FiducialOrientation @typedef {import('../node.js').CameraRule} CameraRule */

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
    path('out', 'DIR', 'Folder that receives images/, masks/, cameras.json and film.csv; required.'),
    JSON_FLAG,
  ],
  details:
    'All images have the pixel of the first scan, no distortion and the principal point at one place, whatever the scanner did: they are images of one camera. They end within the marks; masks/ leave out what is hidden by marks. cameras.json takes the camera as calibrated, unless camera.json has "uncertainty". ' +
    'Then: tiepoint block DIR/images --cameras DIR/cameras.json --masks DIR/masks --out block. film.csv: image, number of marks, sigma0_mm, rmse_mm. JSON: scans [{name, image, marks}, …], cameras.',
  run,
};

/** @param {import('./args.js').Call} call @returns {Promise<import('./errors.js').ExitCode>} */
async function run({ positionals, values }) {
  const [camera, out] = ['camera', 'out'].map((name) => values.get(name));
  if (typeof camera !== 'string') throw new UsageError('--camera is missing: name the file of the calibrated camera of the film');
  if (typeof out !== 'string') throw new UsageError('--out is missing: name the folder that receives the images');
  if (positionals.length === 0) throw new UsageError('name the scans of the film');
  const text = readText(camera);
  const known = about(camera, () => parse_camera(text));
  const scans = scansOf(positionals, values.get('fiducials'));
  for (const name of ['images', 'masks']) makeFolder(join(out, name));
  const shown = new Progress({ steps: scans.length });
  /** @type {{ name: string, image: string, marks: FiducialOrientation }[]} */
  const made = [];
  /** @type {CameraRule[]} */
  const cameras = [];
  /** @type {number | undefined} */
  let pixel;
  try {
    for (const { file, marks, image } of scans) {
      const scan = marksOf(marks, undefined);
      const frame = shown.step(basename(file), () => about(file, () => film_frame(readBytes(file), { camera: known, scan }, image, pixel)));
      pixel ??= frame.camera.pixel_mm ?? undefined;
      writeInto(join(out, 'images'), image, frame.image);
      writeInto(join(out, 'masks'), image, frame.mask);
      addCamera(cameras, frame.camera);
      made.push({ name: basename(file), image, marks: frame.marks });
    }
  } finally {
    shown.end();
  }
  writeInto(out, 'cameras.json', `${JSON.stringify({ cameras }, null, 1)}\n`);
  const rows = made.map(({ name, marks }) => [name, String(marks.residuals_mm.length), fixed(marks.sigma0_mm, 4), fixed(rms(marks), 4)]);
  writeInto(out, 'film.csv', [['image', 'marks', 'sigma0_mm', 'rmse_mm'], ...rows].map((row) => `${row.join(',')}\n`).join(''));
  if (values.has('json')) printJson({ scans: made, cameras });
  else
    print(
      table([['scan', 'marks', 'sigma0 [mm]', 'RMSE [mm]'], ...rows]),
      '',
      `written: ${made.length} images in ${join(out, 'images')}, their masks, ${join(out, 'cameras.json')} and ${join(out, 'film.csv')}`,
    );
  return 0;
}

/** The scans with the files of their marks, and what their images are called.  @param {readonly string[]} files @param {unknown} folder */
function scansOf(files, folder) {
  if (typeof folder === 'string' && !isFolder(folder)) throw new DataError(`--fiducials is ${folder}, which is no folder; name that of the marks`);
  /** @type {Map<string, string>} */
  const seen = new Map();
  return files.map((file) => {
    const stem = basename(file, extname(file));
    const marks = join(typeof folder === 'string' ? folder : dirname(file), `${stem}.csv`);
    if (!exists(file)) throw new DataError(`${file}: there is no such file`);
    if (!exists(marks)) throw new DataError(`${file}: its fiducial marks are missing: there is no ${marks}`);
    const other = seen.get(stem);
    if (other !== undefined) throw new UsageError(`${other} and ${file} give images of the same name; allowed: each name once`);
    seen.set(stem, file);
    return { file, marks, image: `${stem}.png` };
  });
}

/** One camera for all images that it is alike of: scans of one film have one.  @param {CameraRule[]} cameras @param {CameraRule} camera */
function addCamera(cameras, camera) {
  const like = (/** @type {CameraRule} */ { images: _, ...others }) => JSON.stringify(others);
  const common = cameras.at(-1);
  if (common === undefined) cameras.push({ ...camera, images: '*' });
  else if (like(common) !== like(camera)) cameras.unshift(camera);
}

/** The root mean square length of residuals.  @param {FiducialOrientation} marks */
function rms({ residuals_mm: residuals }) {
  return Math.sqrt(residuals.reduce((sum, [x, y]) => sum + x * x + y * y, 0) / Math.max(residuals.length, 1));
}
