// @ts-check
import { basename, extname } from 'node:path';
import { message, OrthophotoReference, parse_camera_rules, placed_tables, placing_defaults, placing_parameters } from '../node.js';
import { about, UsageError, VERDICT_CODES } from './errors.js';
import { makeFolder, readBytes, textOf, writeInto } from './files.js';
import { flag, JSON_FLAG, optionsOf, path, settingsOf } from './options.js';
import { note, print, printJson } from './output.js';
import { Progress } from './progress.js';
import { fixed, table } from './text.js';
import { GROUND_OPTIONS, groundOf, worldOf } from './ground.js';

/** @typedef {import('../node.js').PlacedImage} PlacedImage */

const OPTIONS = optionsOf(placing_parameters(), { placing: placing_defaults() });

/** @type {import('./args.js').Command} */
export const place = {
  name: 'place',
  summary: 'Places images on an orthophoto: their exterior orientation in its system, without any control point.',
  positionals: [],
  rest: 'IMAGE…',
  options: [
    path('orthophoto', 'FILE', 'The reference: a GeoTIFF in a projected system, or an image with a world file beside it (.tfw, .jgw, .pgw, .wld); required.'),
    ...GROUND_OPTIONS,
    path('cameras', 'cameras.json', 'Cameras in place of those of EXIF, as `tiepoint block` takes them; one with "fixed": true is calibrated.'),
    path('out', 'DIR', 'Folder that receives placed.csv, links.csv and result.json.'),
    flag('rectified', 'Writes each placed image resampled to the ground, too: NAME.tif, a GeoTIFF to lay over the orthophoto.'),
    JSON_FLAG,
    ...OPTIONS,
  ],
  details:
    'Points of the image are found on the orthophoto, the image is oriented by them, resampled to the ground and matched again, then adjusted; a part of the links takes no part and checks the result. Lengths are those of the ' +
    'map. An error that all places of the orthophoto or all heights share shows nowhere. JSON: orthophoto, images [{name, verdict, placement or null}, …] with camera, pose, standard errors, footprint, links. ' +
    'The exit code is that of the worst verdict: 0 placed, 3 weak, 4 not placed.',
  run,
};

/** @param {import('./args.js').Call} call @returns {Promise<import('./errors.js').ExitCode>} */
async function run({ positionals, values }) {
  const [file, out] = ['orthophoto', 'out'].map((name) => values.get(name));
  if (typeof file !== 'string') throw new UsageError('--orthophoto is missing: name the picture on which the images are placed');
  if (positionals.length === 0) throw new UsageError('name the images that are to be placed');
  if (values.has('rectified') && typeof out !== 'string') throw new UsageError('--rectified needs --out, the folder that receives the pictures');
  const { placing } = settingsOf(OPTIONS, values, { placing: placing_defaults() });
  const cameras = camerasOf(values.get('cameras'));
  if (typeof out === 'string') makeFolder(out);
  const shown = new Progress({ steps: positionals.length + 2 });
  const ground = groundOf(values);
  const reference = shown.step(`reading ${file}`, () => open(file, ground, placing));
  try {
    /** @type {(PlacedImage & { name: string })[]} */
    const images = [];
    /** @type {string[]} */
    const pictures = [];
    for (const image of positionals) {
      const name = basename(image);
      const bytes = readBytes(image);
      const placed = shown.step(`placing ${name}`, () => about(image, () => reference.place(name, bytes, cameras)));
      if (values.has('rectified') && placed.placement) pictures.push(writeInto(String(out), pictureOf(name), reference.rectified(bytes, placed.placement)));
      images.push({ name, ...placed });
    }
    const info = reference.info();
    const result = { orthophoto: { name: basename(file), ...info }, images };
    const written = shown.step('writing', () => (typeof out === 'string' ? [...write(out, result), ...pictures] : []));
    shown.end();
    if (!ground) note('no heights are given: the ground is taken as level at 0; positions are above it');
    if (values.has('json')) printJson(result);
    else print(...describe(result), ...(written.length > 0 ? ['', `written: ${written.join(', ')}`] : []));
    return /** @type {import('./errors.js').ExitCode} */ (Math.max(...images.map(({ verdict }) => VERDICT_CODES[verdict.kind])));
  } finally {
    shown.end();
    reference.free();
  }
}

/** @param {string} file @param {import('./ground.js').Ground | null} ground @param {import('../node.js').PlacingOptions} placing */
function open(file, ground, placing) {
  const bytes = readBytes(file);
  return about(ground?.file ?? file, () => OrthophotoReference.open(bytes, worldOf(file), ground?.heights ?? 0, ground?.world, placing));
}

/** @param {unknown} cameras */
function camerasOf(cameras) {
  if (typeof cameras !== 'string') return undefined;
  const text = textOf(readBytes(cameras));
  about(cameras, () => parse_camera_rules(text));
  return text;
}

/** @param {string} name */
const pictureOf = (name) => {
  const picture = `${basename(name, extname(name))}.tif`;
  if (picture.toLowerCase() === name.toLowerCase()) return `${basename(name, extname(name))}-rectified.tif`;
  return picture;
};

/** @typedef {{ orthophoto: object, images: (PlacedImage & { name: string })[] }} Result */

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

/** @param {Result} result @returns {string[]} */
function describe({ images }) {
  const rows = images.flatMap(({ name, placement }) => {
    if (!placement) return [];
    const { pose, angles_deg, position_errors_m } = placement;
    const place = pose.position.map((v, k) => `${fixed(v, 2)} ± ${position_errors_m ? fixed(position_errors_m[k] ?? 0, 2) : '?'}`);
    return [[name, ...place, ...angles_deg.map((v) => fixed(v, 3)), fixed(placement.gsd_m, 3)]];
  });
  return [
    ...images.map(({ name, verdict }) => `${name}: ${message('placing_verdict', verdict)}`),
    ...(rows.length > 0 ? ['', table([['image', 'X', 'Y', 'Z', 'ω °', 'φ °', 'κ °', 'pixel on the ground'], ...rows])] : []),
  ];
}
