// @ts-check
import { basename, dirname, extname, join } from 'node:path';
import {
  film_cameras,
  film_frame,
  film_measurements,
  film_pattern,
  film_pixel_mm,
  image_measurement_table,
  masks_of_images,
  parse_camera,
  parse_camera_rules,
  parse_image_measurements,
} from '../node.js';
import { about, DataError, UsageError } from './errors.js';
import { exists, imagesIn, isFolder, makeFolder, readBytes, readText, writeInto } from './files.js';
import { JSON_FLAG, path } from './options.js';
import { note, print, printJson } from './output.js';
import { marksOf } from './pair.js';
import { Progress } from './progress.js';
import { fixed, listed, table } from './text.js';

/** @typedef {import('../node.js').FilmScan} FilmScan @typedef {import('../node.js').CameraRule} CameraRule */

const [CAMERAS, TABLE, MARKS] = ['cameras.json', 'film.csv', 'marks.csv'];
const OUTPUTS = ['images', 'masks', CAMERAS, TABLE, MARKS];
const COLUMNS = ['scan', 'image', 'marks', 'sigma0_mm', 'rmse_mm'];

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
    path('masks', 'DIR', 'Masks of the scans, named and as large as these: what is 0 (black) in one is 0 in the mask of its image, too.'),
    path(
      'marks',
      'marks.csv',
      'Image measurements of control and check points that were made in the scans: image,point,x,y in px, the image named as the file of its scan. marks.csv in the folder of --out has them in px of the images.',
    ),
    path(
      'out',
      'DIR',
      'Folder that receives images/, masks/, cameras.json and film.csv, with --marks also marks.csv; those of another film that a call before wrote there stay, and others are not there; required.',
    ),
    JSON_FLAG,
  ],
  details:
    'All images have one pixel size, the largest of the scans, no distortion, and the principal point in one place, however the film lay in the scanner: they are images of one camera. They end within the outermost marks of all tables; masks/ leave out what fiducial marks hide. cameras.json has the camera with what the errors of the fiducial marks and "uncertainty" of camera.json leave open; without either it is "fixed". A GNSS position in the metadata of a scan is that of its image. ' +
    `Then: tiepoint block DIR/images --cameras DIR/cameras.json --masks DIR/masks --out block. The image of a.tif is a-film.png, of a second film in the same folder, whose camera is another one, a-film2.png: each has its camera. film.csv: scan, image, number of marks, sigma0_mm, rmse_mm. JSON: scans [{name, image, marks, rmse_mm}, …], cameras, with --marks measurements {moved, beside}.`,
  run,
};

/** @param {import('./args.js').Call} call @returns {Promise<import('./errors.js').ExitCode>} */
async function run({ positionals, values }) {
  const [cameraFile, marksFile, out] = ['camera', 'marks', 'out'].map((name) => values.get(name));
  if (typeof cameraFile !== 'string') throw new UsageError('--camera is missing: name the file of the calibrated camera of the film');
  if (typeof out !== 'string') throw new UsageError('--out is missing: name the folder that receives the images');
  if (positionals.length === 0) throw new UsageError('name the scans of the film');
  const text = readText(cameraFile);
  const camera = about(cameraFile, () => parse_camera(text));
  // All tables come first: a mark that one scan lacks is of the film all the same, and a slip in the last one costs no work.
  const scans = withMasks(scansOf(positionals, values.get('fiducials')), values.get('masks')).map((scan) => ({
    ...scan,
    marks: marksOf(scan.table, undefined),
  }));
  const measured = typeof marksFile === 'string' ? measurementsOf(marksFile, scans) : null;
  const marks_mm = calibrated(scans.flatMap(({ marks }) => marks.fiducials));
  const pixel = Math.max(...scans.map(({ marks, table: file }) => about(file, () => film_pixel_mm({ camera, scan: marks, marks_mm }))));
  const outputs = OUTPUTS.filter((name) => name !== MARKS || measured !== null);
  const there = earlier(out, outputs);
  for (const name of ['images', 'masks']) makeFolder(join(out, name));
  const shown = new Progress({ steps: scans.length });
  /** @type {{ name: string, image: string, film: FilmScan, camera: CameraRule, rmse_mm: number }[]} */
  const made = [];
  /** @type {string[]} */
  const failed = [];
  let pattern = '';
  for (const { file, mask, marks, stem } of scans) {
    /** @type {import('../node.js').FilmFiles} */
    let frame;
    try {
      const known = { camera, scan: marks, marks_mm };
      const hidden = mask === null ? null : { name: mask, file: readBytes(mask) };
      frame = shown.step(basename(file), () => about(file, () => film_frame(readBytes(file), known, { image: stem, pixel_mm: pixel, mask: hidden })));
    } catch (error) {
      // What is wrong with one scan is told at the end: the others have their images.
      if (!(error instanceof DataError)) throw error;
      failed.push(error.message);
      continue;
    }
    if (pattern === '') {
      // The first one says of which film they are.
      const own = film_pattern(frame.camera, there.cameras);
      pattern = own;
      refuseExisting(
        out,
        scans.flatMap((scan) => ['images', 'masks'].map((name) => join(name, imageName(own, scan.stem)))),
      );
    }
    const image = imageName(pattern, stem);
    writeInto(join(out, 'images'), image, frame.image);
    writeInto(join(out, 'masks'), image, frame.mask);
    made.push({ name: basename(file), image, film: frame.scan, camera: { ...frame.camera, images: image }, rmse_mm: frame.rmse_mm });
  }
  shown.end();
  if (made.length > 0) {
    const cameras = film_cameras(
      pattern,
      made.map((frame) => frame.camera),
      there.cameras,
    );
    writeInto(out, CAMERAS, `${JSON.stringify({ cameras }, null, 1)}\n`);
    const rows = made.map(({ name, image, film: { marks }, rmse_mm }) => [name, image, marks.residuals_mm.length, marks.sigma0_mm ?? '', rmse_mm]);
    writeInto(out, TABLE, `${there.table}${rows.map((row) => `${row.map(cell).join(',')}\n`).join('')}`);
    const measurements = measured && writeMeasurements(out, measured, made, scans, there.measured);
    if (values.has('json')) {
      const own = made.map(({ name, image, film: { marks }, rmse_mm }) => ({ name, image, marks, rmse_mm }));
      printJson({ scans: own, cameras, ...(measurements && { measurements }) });
    } else
      print(
        table([
          ['scan', 'marks', 'sigma0 [mm]', 'RMSE [mm]'],
          ...made.map(({ name, film: { marks }, rmse_mm }) => [name, marks.residuals_mm.length, fixed(marks.sigma0_mm, 4), fixed(rmse_mm, 4)]),
        ]),
        '',
        `written: ${outputs.map((name) => join(out, name)).join(', ')}`,
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
    return { file, table, stem };
  });
}

/** What the image of a scan is called.  @param {string} pattern of the film @param {string} stem */
const imageName = (pattern, stem) => pattern.replace('*', () => stem);

/**
 * What a call before wrote in the folder, of another film or of other scans of this one; what else is there is refused.
 * @param {string} out @param {readonly string[]} outputs
 * @returns {{ cameras: CameraRule[], table: string, measured: import('../node.js').ImageMeasurementRow[] }}
 */
function earlier(out, outputs) {
  const head = `${COLUMNS.join(',')}\n`;
  const file = join(out, TABLE);
  const table = exists(file) ? readText(file) : '';
  if (!table.startsWith(head) || !exists(join(out, CAMERAS))) {
    refuseExisting(out, outputs);
    return { cameras: [], table: head, measured: [] };
  }
  /** @template T @param {string} name @param {(text: string) => T} parse */
  const read = (name, parse) => {
    const [place, text] = [join(out, name), readText(join(out, name))];
    return about(place, () => parse(text));
  };
  return { cameras: read(CAMERAS, parse_camera_rules), table, measured: exists(join(out, MARKS)) ? read(MARKS, parse_image_measurements) : [] };
}

/** Images of another call would be taken for some of this one.  @param {string} out @param {readonly string[]} outputs */
function refuseExisting(out, outputs) {
  const there = outputs.map((name) => join(out, name)).find((place) => exists(place));
  if (there !== undefined) throw new DataError(`${there} is there already; name another folder`);
}

/** The marks of a film by their calibrated places, each once.  @param {import('../node.js').Fiducial[]} marks @returns {[number, number][]} */
function calibrated(marks) {
  return [...new Map(marks.map(({ x_mm, y_mm }) => [`${x_mm},${y_mm}`, /** @type {[number, number]} */ ([x_mm, y_mm])])).values()];
}

/** The scans with the files of their masks; null without one.  @template {{ file: string }} T @param {T[]} scans @param {unknown} folder */
function withMasks(scans, folder) {
  if (typeof folder !== 'string') return scans.map((scan) => ({ ...scan, mask: null }));
  if (!isFolder(folder)) throw new UsageError(`--masks is ${folder}, which is no folder; name a folder of masks`);
  const files = imagesIn(folder);
  const names = files.map((file) => basename(file));
  const of = masks_of_images(
    scans.map(({ file }) => basename(file)),
    names,
  );
  const unused = names.filter((_, index) => !of.includes(index));
  if (unused.length > 0) note(`masks of no scan: ${listed(unused)}`);
  return scans.map((scan, k) => ({ ...scan, mask: files[of[k] ?? -1] ?? null }));
}

/** What was measured, some of it in these scans.  @param {string} file @param {readonly { file: string }[]} scans */
function measurementsOf(file, scans) {
  const text = readText(file);
  const measured = about(file, () => parse_image_measurements(text));
  const names = new Set(scans.map((scan) => basename(scan.file)));
  if (!measured.some(({ image }) => names.has(image)))
    throw new DataError(`${file}: no measurement is of a scan; give each the name of its scan, as ${[...names][0]}, in the column image`);
  return measured;
}

/**
 * Writes measurements in px of the images, and says which have none there. Those of scans that became no image are left out.
 * @param {string} out @param {import('../node.js').ImageMeasurementRow[]} measured
 * @param {readonly { name: string, image: string, film: FilmScan }[]} made @param {readonly { file: string }[]} scans
 * @param {readonly import('../node.js').ImageMeasurementRow[]} there of films before: they stay, but for those of the scans of this one
 */
function writeMeasurements(out, measured, made, scans, there) {
  const lost = new Set(scans.map(({ file }) => basename(file)).filter((name) => !made.some((frame) => frame.name === name)));
  const frames = made.map(({ name, image, film: own }) => ({ scan: name, image, film: own }));
  const { measurements, moved, beside } = film_measurements(
    measured.filter(({ image }) => !lost.has(image)),
    frames,
  );
  const own = new Set([...made.map(({ name }) => name), ...measurements.map(({ image, point }) => JSON.stringify([image, point]))]);
  const others = there.filter(({ image, point }) => !own.has(image) && !own.has(JSON.stringify([image, point])));
  writeInto(out, MARKS, image_measurement_table([...others, ...measurements]));
  const names = beside.map(({ image, point }) => `${point} in ${image}`);
  if (names.length > 0) note(`measurements that lie beside the image of their scan, which ends within the fiducial marks, are skipped: ${listed(names)}`);
  return { moved, beside };
}

/** @param {string | number} value */
const cell = (value) => (typeof value === 'string' && /[",\n]/.test(value) ? `"${value.replaceAll('"', '""')}"` : String(value));
