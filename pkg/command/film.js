// @ts-check
import { basename, dirname, extname, join } from 'node:path';
import { pixelOfFilm } from '../block/film.js';
import {
  film_cameras,
  film_frame,
  film_measurements,
  film_pattern,
  film_pixel_mm,
  film_warning,
  image_measurement_table,
  masks_of_images,
  message,
  parse_camera,
  parse_camera_rules,
  parse_image_measurements,
} from '../node.js';
import { about, DataError, UsageError } from './errors.js';
import { exists, imagesIn, isFolder, makeFolder, readBytes, readText, replaceInto, writeInto } from './files.js';
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
    'All images have one pixel size, the largest of the scans or that of images of the same film that are there, no distortion, and the principal point in one place, however the film lay in the scanner: they are images of one camera. They end within the outermost marks of all tables; masks/ leave out what fiducial marks hide. cameras.json has the camera with what the errors of the fiducial marks and "uncertainty" of camera.json leave open; without either it is "fixed". A GNSS position in the metadata of a scan is that of its image. ' +
    `Then: tiepoint block DIR/images --cameras DIR/cameras.json --masks DIR/masks --out block. The image of a.tif is a-film.png, of a second film in the same folder, whose camera is another one, a-film2.png: each has its camera. film.csv: scan, image, number of marks, sigma0_mm, rmse_mm. JSON: scans [{name, image, marks, rmse_mm}, …], camera (the pattern of the names of their images), cameras, with --marks measurements {moved, beside}.`,
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
  const outputs = OUTPUTS.filter((name) => name !== MARKS || typeof marksFile === 'string');
  const there = earlier(out, outputs);
  const measured = typeof marksFile === 'string' ? measurementsOf(marksFile, scans, there) : null;
  const marks_mm = calibrated(scans.flatMap(({ marks }) => marks.fiducials));
  const largest = Math.max(...scans.map(({ marks, table: file }) => about(file, () => film_pixel_mm({ camera, scan: marks, marks_mm }))));
  const warning = scans.map(({ marks }) => film_warning({ camera, scan: marks, marks_mm })).find((found) => found !== null);
  if (warning) note(`${cameraFile}: ${message('warning', warning)}`);
  const pixel = pixelOfFilm(camera.focal_mm, largest, there.cameras);
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
      pattern = film_pattern(frame.camera, there.cameras);
      refuseFinished(out, there.rows, pattern, scans);
      // What breaks off leaves no image without a camera, and can be done again.
      replaceInto(out, TABLE, there.table);
      writeCameras(out, film_cameras(pattern, [{ ...frame.camera, images: imageName(pattern, stem) }], there.cameras));
      for (const name of ['images', 'masks']) makeFolder(join(out, name));
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
    writeCameras(out, cameras);
    const measurements = measured && writeMeasurements(out, measured, made, scans, there);
    // Last: by their rows images are finished.
    const rows = made.map(({ name, image, film: { marks }, rmse_mm }) => [name, image, marks.residuals_mm.length, marks.sigma0_mm ?? '', rmse_mm]);
    replaceInto(out, TABLE, `${there.table}${rows.map((row) => `${row.map(cell).join(',')}\n`).join('')}`);
    if (values.has('json')) {
      const own = made.map(({ name, image, film: { marks }, rmse_mm }) => ({ name, image, marks, rmse_mm }));
      printJson({ scans: own, camera: pattern, cameras, ...(measurements && { measurements }) });
    } else
      print(
        table([
          ['scan', 'marks', 'sigma0 [mm]', 'RMSE [mm]'],
          ...made.map(({ name, film: { marks }, rmse_mm }) => [name, marks.residuals_mm.length, fixed(marks.sigma0_mm, 4), fixed(rmse_mm, 4)]),
        ]),
        '',
        `camera: ${pattern} in ${join(out, CAMERAS)}${there.cameras.some(({ images }) => images === pattern) ? ', that of images that were there' : ''}`,
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
 * @typedef {{ cameras: CameraRule[], table: string, rows: Finished[], measured: import('../node.js').ImageMeasurementRow[] }} Earlier
 * @typedef {{ scan: string, image: string }} Finished
 * @param {string} out @param {readonly string[]} outputs @returns {Earlier}
 */
function earlier(out, outputs) {
  const head = `${COLUMNS.join(',')}\n`;
  const file = join(out, TABLE);
  if (!exists(file)) {
    refuseExisting(out, outputs);
    return { cameras: [], table: head, rows: [], measured: [] };
  }
  // Spreadsheets end lines in their own way, and the last one not at all.
  const table = `${readText(file).replaceAll(/\r\n?/g, '\n').trimEnd()}\n`;
  if (!table.startsWith(head)) {
    const [line = ''] = table.split('\n');
    throw new DataError(`${file}: its first line is "${line}"; allowed: "${head.trimEnd()}", as tiepoint film writes it, or another folder`);
  }
  /** @template T @param {string} name @param {(text: string) => T} parse @param {T} without the file */
  const read = (name, parse, without) => {
    const place = join(out, name);
    if (!exists(place)) return without;
    const text = readText(place);
    return about(place, () => parse(text));
  };
  const rows = rowsOf(table.slice(head.length));
  const cameras = read(CAMERAS, parse_camera_rules, []);
  if (rows.length > 0 && cameras.length === 0)
    throw new DataError(`${join(out, CAMERAS)} is missing, with the cameras of the images that are there; name another folder`);
  return { cameras, table, rows, measured: read(MARKS, (text) => parse_image_measurements(text), []) };
}

/** The rows of film.csv.  @param {string} text without its head @returns {Finished[]} */
function rowsOf(text) {
  const value = (/** @type {string | undefined} */ own = '') => (own.startsWith('"') ? own.slice(1, -1).replaceAll('""', '"') : own);
  const rows = text.matchAll(/^("(?:[^"]|"")*"|[^",\n]*),("(?:[^"]|"")*"|[^",\n]*)(?:,|$).*$/gm);
  return [...rows].map(([, scan, image]) => ({ scan: value(scan), image: value(image) }));
}

/** Images of another call would be taken for some of this one.  @param {string} out @param {readonly string[]} outputs */
function refuseExisting(out, outputs) {
  const there = outputs.map((name) => join(out, name)).find((place) => exists(place));
  if (there !== undefined) throw new DataError(`${there} is there already; name another folder`);
}

/**
 * Images that a call before finished stay; what one that broke off left is written again.
 * @param {string} out @param {readonly Finished[]} rows @param {string} pattern @param {readonly { stem: string }[]} scans
 */
function refuseFinished(out, rows, pattern, scans) {
  const finished = new Set(rows.map(({ image }) => image));
  const own = scans.map(({ stem }) => imageName(pattern, stem)).filter((image) => finished.has(image));
  refuseExisting(
    out,
    own.flatMap((image) => ['images', 'masks'].map((name) => join(name, image))),
  );
}

/** @param {string} out @param {readonly CameraRule[]} cameras */
const writeCameras = (out, cameras) => replaceInto(out, CAMERAS, `${JSON.stringify({ cameras }, null, 1)}\n`);

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

/** What was measured, some of it in these scans.  @param {string} file @param {readonly { file: string }[]} scans @param {Earlier} there of films before */
function measurementsOf(file, scans, there) {
  const text = readText(file);
  const names = scans.map((scan) => basename(scan.file));
  const all = new Set([...names, ...there.rows.map(({ scan }) => scan)]);
  const measured = about(file, () => parse_image_measurements(text, [...all]));
  if (!measured.some(({ image }) => names.includes(image)))
    throw new DataError(`${file}: no measurement is of a scan; give each the name of its scan, as ${names[0]}, in the column image`);
  return measured;
}

/**
 * Writes measurements in px of the images, and says which have none there. Those of scans that became no image are left out.
 * @param {string} out @param {import('../node.js').ImageMeasurementRow[]} measured
 * @param {readonly { name: string, image: string, film: FilmScan }[]} made @param {readonly { file: string }[]} scans
 * @param {Earlier} there of films before: their measurements stay, but for those of the scans of this one
 */
function writeMeasurements(out, measured, made, scans, there) {
  const lost = new Set(scans.map(({ file }) => basename(file)).filter((name) => !made.some((frame) => frame.name === name)));
  const frames = made.map(({ name, image, film: own }) => ({ scan: name, image, film: own }));
  // One table of all scans, given with each film: scans before have become images, in px of which it is not.
  const before = new Set(there.rows.map(({ scan }) => scan).filter((scan) => !frames.some((frame) => frame.scan === scan)));
  const given = new Set(measured.map(({ image }) => image));
  const late = there.rows.filter(({ scan, image }) => before.has(scan) && given.has(scan) && !there.measured.some((row) => row.image === image));
  if (late.length > 0) note(`measurements in scans of calls before, whose images have none in ${MARKS}, are skipped: ${listed(late.map(({ scan }) => scan))}`);
  const { measurements, moved, beside } = film_measurements(
    measured.filter(({ image }) => !lost.has(image) && !before.has(image)),
    frames,
  );
  const own = new Set([...made.map(({ name }) => name), ...measurements.map(({ image, point }) => JSON.stringify([image, point]))]);
  const others = there.measured.filter(({ image, point }) => !own.has(image) && !before.has(image) && !own.has(JSON.stringify([image, point])));
  writeInto(out, MARKS, image_measurement_table([...others, ...measurements]));
  const names = beside.map(({ image, point }) => `${point} in ${image}`);
  if (names.length > 0) note(`measurements that lie beside the image of their scan, which ends within the fiducial marks, are skipped: ${listed(names)}`);
  return { moved, beside };
}

/** @param {string | number} value */
const cell = (value) => (typeof value === 'string' && /[",\n]/.test(value) ? `"${value.replaceAll('"', '""')}"` : String(value));
