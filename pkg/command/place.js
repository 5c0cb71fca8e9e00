// @ts-check
import { basename, extname } from 'node:path';
import { withText } from '../messages.js';
import { check_cameras, message, parse_camera, placed_tables, placing_defaults, placing_parameters } from '../node.js';
import { about, DataError, UsageError, VERDICT_CODES } from './errors.js';
import { imagesOf, makeFolder, readBytes, readText, writeInto } from './files.js';
import { checkTogether, flag, JSON_FLAG, optionsOf, pair, path } from './options.js';
import { note, print, printJson } from './output.js';
import { marksOf } from './pair.js';
import { Progress } from './progress.js';
import { fixed, table } from './text.js';
import { checkCrs, elsewhereOf, GROUND_OPTIONS, groundOf, NO_HEIGHTS, openReference, ORTHOPHOTO_HELP, placingOf, positionsIn } from './ground.js';

/** @typedef {import('../node.js').PlacedImage} PlacedImage */

const OPTIONS = optionsOf(placing_parameters(), placing_defaults());

/** @type {import('./args.js').Command} */
export const place = {
  name: 'place',
  summary: 'Places images on an orthophoto: their exterior orientation in its system, without any control point.',
  positionals: [],
  rest: 'FOLDER|IMAGE…',
  options: [
    path('orthophoto', 'FILE', `${ORTHOPHOTO_HELP} required.`),
    ...GROUND_OPTIONS,
    path('cameras', 'cameras.json', 'Cameras in place of those of EXIF, as `tiepoint block` takes them; one with "fixed": true is calibrated.'),
    path(
      'positions',
      'positions.csv',
      'GNSS positions of the images, in place of those that their files record, as `tiepoint block` takes them: image,longitude,latitude or, in a plane, image,x,y, and perhaps standard errors. Heights place nothing; precise ones check those of the ground.',
    ),
    path('crs', 'CRS', 'The coordinate system of positions in a plane: an EPSG code, PROJ text or WKT; that of the orthophoto where it has a code.'),
    path(
      'fiducials',
      'F.csv',
      'Fiducial marks measured in the scan of a photo on film: col,row,x_mm,y_mm. The image is oriented by them within the film, and only what lies within them is matched. Needs --camera; of one image.',
    ),
    path('camera', 'camera.json', 'The calibrated camera of that film: {"focal_mm", "principal_point_mm": [x, y]}.'),
    pair('origin', 'COL,ROW', "Place of the image's top-left pixel in the scan whose fiducials were measured."),
    path('out', 'DIR', 'Folder that receives placed.csv, links.csv and result.json.'),
    flag('rectified', 'Writes each placed image resampled to the ground, too: NAME-rectified.tif, a GeoTIFF to lay over the orthophoto.'),
    JSON_FLAG,
    ...OPTIONS,
  ],
  details:
    'Points of the image are found on the orthophoto, first about its GNSS position where it has one and the orthophoto says its system, the image is oriented by them, resampled to the ground and matched again, then adjusted; a part of the links takes no part and checks the result. Lengths are those of the ' +
    'map. An error that all places of the orthophoto share shows nowhere; that all heights are wrong together by what is stated of them is part of the standard errors. JSON: orthophoto, remarks, images [{name, verdict, placement or null, search (how the GNSS position of the image led to it, absent where it was not sought by one)}, …] with camera, pose, standard errors, footprint, links, of scanned film also film with its interior orientation. ' +
    'The exit code is that of the worst verdict: 0 placed, 3 weak, 4 not placed.',
  run,
};

/** @param {import('./args.js').Call} call @returns {Promise<import('./errors.js').ExitCode>} */
async function run({ positionals, values }) {
  const [file, out] = ['orthophoto', 'out'].map((name) => values.get(name));
  if (typeof file !== 'string') throw new UsageError('--orthophoto is missing: name the picture on which the images are placed');
  if (positionals.length === 0) throw new UsageError('name the images that are to be placed, or their folder');
  if (values.has('rectified') && typeof out !== 'string') throw new UsageError('--rectified needs --out, the folder that receives the pictures');
  const photos = imagesOf(positionals);
  refuseTwice(photos, values.has('rectified') ? stemOf : basename);
  const placing = placingOf(OPTIONS, values);
  const film = filmOf(values, photos);
  const cameras = camerasOf(values.get('cameras'), photos);
  const ground = groundOf(values);
  checkTogether(values, [['crs', 'positions']]);
  checkCrs(values);
  if (typeof out === 'string') makeFolder(out);
  const shown = new Progress({ steps: photos.length + 3 });
  const reference = shown.step(`reading ${file}`, () => openReference(file, ground, placing));
  try {
    const table = tableOf(values, photos, reference);
    const doubt = shown.step('reading positions', () => elsewhereOf(reference, photos, table.given));
    const remarks = [...table.remarks, ...(doubt ? [doubt] : [])].map((remark) => withText('remark', remark));
    shown.end();
    for (const { text } of remarks) note(text);
    /** @type {Result['images']} */
    const images = [];
    /** @type {string[]} */
    const pictures = [];
    /** @type {string[]} */
    const failed = [];
    for (const [index, image] of photos.entries()) {
      const name = basename(image);
      try {
        const bytes = readBytes(image);
        const placed = shown.step(`placing ${name}`, () => about(image, () => reference.place(name, bytes, cameras, film, table.given[index])));
        images.push({ name, ...placed });
        if (values.has('rectified') && placed.placement)
          pictures.push(writeInto(String(out), `${stemOf(image)}-rectified.tif`, reference.rectified(bytes, placed.placement)));
      } catch (error) {
        // What is wrong with one image is told at the end: the others have their places.
        if (!(error instanceof DataError)) throw error;
        failed.push(error.message);
      }
    }
    const result = { orthophoto: { name: basename(file), ...reference.info() }, remarks, images };
    const written = shown.step('writing', () => (typeof out === 'string' && images.length > 0 ? [...write(out, result), ...pictures] : []));
    shown.end();
    if (placing.check_share === 0) note('--check-share is 0: no link checks the result');
    if (!ground) note(NO_HEIGHTS);
    const { heights_from: from, heights_given_in: unit } = result.orthophoto;
    if (unit) note(`heights are in ${unit}, as their file says, and were converted to the unit of the orthophoto`);
    if (from) note(`heights count from ${from}, as their file says`);
    if (failed.length < photos.length) {
      if (values.has('json')) printJson(result);
      else print(...describe(result), ...(written.length > 0 ? ['', `written: ${written.join(', ')}`] : []));
    }
    if (failed.length > 0) throw new DataError(failed.join('; '));
    return /** @type {import('./errors.js').ExitCode} */ (Math.max(...images.map(({ verdict }) => VERDICT_CODES[verdict.kind])));
  } finally {
    shown.end();
    reference.free();
  }
}

/** The name of an image without its end.  @param {string} image */
const stemOf = (image) => basename(image, extname(image));

/** Tables and pictures tell images apart by their names.  @param {readonly string[]} images @param {(image: string) => string} named */
function refuseTwice(images, named) {
  const twice = images.find((image, index) => images.findIndex((other) => named(other) === named(image)) !== index);
  if (twice !== undefined) throw new UsageError(`two images are named ${named(twice)}: place them one after the other, into two folders`);
}

/**
 * What is known of the scan of a photo on film; null where the images are of cameras without film.
 * @param {import('./args.js').Call['values']} values @param {readonly string[]} images @returns {import('../node.js').Given<import('../node.js').FilmInput> | null}
 */
function filmOf(values, images) {
  checkTogether(values, [
    ['fiducials', 'camera'],
    ['camera', 'fiducials'],
    ['origin', 'fiducials'],
  ]);
  const [fiducials, camera] = [values.get('fiducials'), values.get('camera')];
  if (typeof fiducials !== 'string' || typeof camera !== 'string') return null;
  if (images.length > 1) throw new UsageError('--fiducials are of one image: place scans one after the other');
  if (values.has('cameras')) throw new UsageError('--camera and --cameras both give a camera; give one of them');
  const text = readText(camera);
  return { camera: about(camera, () => parse_camera(text)), scan: marksOf(fiducials, values.get('origin')) };
}

/** @param {import('./args.js').Call['values']} values @param {readonly string[]} images @param {import('../node.js').OrthophotoReference} reference */
function tableOf(values, images, reference) {
  const [file, crs] = [values.get('positions'), values.get('crs')];
  return typeof file === 'string' ? positionsIn(file, typeof crs === 'string' ? crs : undefined, images, reference) : { given: [], remarks: [] };
}

/** @param {unknown} cameras @param {readonly string[]} images */
function camerasOf(cameras, images) {
  if (typeof cameras !== 'string') return undefined;
  const text = readText(cameras);
  about(cameras, () =>
    check_cameras(
      text,
      images.map((image) => basename(image)),
    ),
  );
  return text;
}

/** @typedef {{ orthophoto: import('../node.js').OrthophotoInfo & { name: string }, remarks: readonly object[], images: (PlacedImage & { name: string })[] }} Result */

/** @param {string} out @param {Result} result */
function write(out, result) {
  const tables = placed_tables(
    result.images.map(({ name }) => name),
    result.images,
  );
  return [
    writeInto(out, 'placed.csv', tables.placed),
    writeInto(out, 'links.csv', tables.links),
    writeInto(out, 'result.json', `${JSON.stringify(result, null, 1)}\n`),
  ];
}

/** The interior orientation of a scan.  @param {string} name @param {import('../node.js').FiducialOrientation} marks */
function describeMarks(name, { residuals_mm: residuals, sigma0_mm: sigma0 }) {
  const largest = Math.max(...residuals.map(([x, y]) => Math.hypot(x, y)));
  return `${name}: interior orientation by ${residuals.length} fiducial marks, sigma0 ${fixed(sigma0, 4)} mm, largest residual ${fixed(largest, 4)} mm`;
}

/** What the links that took no part say.  @param {string} name @param {import('../node.js').LinkChecks} checks */
function describeChecks(name, { number, beyond, rmse_px: px, rmse_m: m }) {
  const by = `${name}: checked by ${number} ${number === 1 ? 'link' : 'links'}`;
  if (beyond === number) return `${by}, ${number === 1 ? 'a gross error' : 'all of them gross errors'}`;
  const without = beyond === 0 ? '' : `, without ${beyond} gross ${beyond === 1 ? 'error' : 'errors'}`;
  return `${by}: RMSE ${fixed(px, 2)} px = ${fixed(m, 3)} m on the ground${without}`;
}

/** Values with their standard errors.  @param {readonly number[]} values @param {readonly number[] | null} errors @param {number} digits @param {number} [more] of the errors */
const withErrors = (values, errors, digits, more = digits) =>
  values.map((value, k) => `${fixed(value, digits)} ± ${errors ? fixed(errors[k] ?? 0, more) : '?'}`);

/** @param {Result} result @returns {string[]} */
function describe({ images }) {
  const rows = images.flatMap(({ name, placement }) => {
    if (!placement) return [];
    const { pose, angles_deg, angle_errors_deg, position_errors_m } = placement;
    return [[name, ...withErrors(pose.position, position_errors_m, 2), ...withErrors(angles_deg, angle_errors_deg, 3, 4), fixed(placement.gsd_m, 3)]];
  });
  return [
    ...images.map(
      ({ name, verdict, search }) => `${name}: ${[message('placing_verdict', verdict), ...(search ? [message('place_search', search)] : [])].join(' ')}`,
    ),
    ...images.flatMap(({ name, placement }) => (placement?.checks ? [describeChecks(name, placement.checks)] : [])),
    ...images.flatMap(({ name, placement }) => (placement?.film ? [describeMarks(name, placement.film.marks)] : [])),
    ...(rows.length > 0 ? ['', 'Orientation ± standard errors', table([['image', 'X', 'Y', 'Z', 'ω °', 'φ °', 'κ °', 'pixel on the ground'], ...rows])] : []),
  ];
}
