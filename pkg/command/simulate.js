// @ts-check
import { flight_parameters, flight_preset, flight_presets, grey_png, simulate as fly } from '../node.js';
import { UsageError } from './errors.js';
import { makeFolder, writeInto } from './files.js';
import { flag, JSON_FLAG, optionsOf, path, settingsOf, word } from './options.js';
import { print, printJson } from './output.js';
import { Progress } from './progress.js';
import { simulateBlock } from './simulate-block.js';
import { shellCommand } from './text.js';
import { denseMap, greyDigest } from './truth.js';

/**
 * @typedef {import('../node.js').SamplePair} SamplePair
 * @typedef {import('../node.js').Flight} Flight
 * @typedef {import('../node.js').Preset} Preset
 * @typedef {import('./args.js').Command} Command
 */

const OUT = path('out', 'DIR', 'Folder that receives the files; required.');
const OPTIONS = optionsOf(flight_parameters(), flight_preset('sample'));
const SEED = OPTIONS.filter(({ name }) => name === 'seed');

/** @type {Command} */
export const simulate = {
  name: 'simulate',
  summary: 'Flies over a synthetic scene and writes the pair of photos with its camera, its fiducial marks and the truth to compare with.',
  variant: simulateBlock,
  positionals: [],
  options: [
    flag('block', 'A block of photos in place of a pair; simulate --block --help lists its options.'),
    OUT,
    word('preset', flight_presets(), 'The flight that the other options change; their defaults are those of the sample.', 'sample'),
    JSON_FLAG,
    ...OPTIONS,
  ],
  details:
    'truth.json holds the relative orientation, the flight, and digests that name both images; map_row_col.f32 the row and column, 32-bit little-endian floats with the centre of the ' +
    'top-left pixel at 0, at which each left pixel is seen in the right image (NaN: nowhere); visible.png is 255 where it is seen. JSON: files, and match, the ' +
    'command to try next as a list of words.',
  run: ({ values }) => {
    make(values, /** @type {Preset} */ (values.get('preset') ?? 'sample'));
  },
};

/** @type {Command} */
export const sample = {
  name: 'sample',
  summary: 'Writes the built-in pair: as simulate with no other option than the seed.',
  positionals: [],
  options: [OUT, ...SEED, JSON_FLAG],
  details: 'JSON: files, and match, the command to try next as a list of words.',
  run: ({ values }) => {
    make(values, 'sample');
  },
};

/** @param {import('./args.js').Call['values']} values @param {Preset} preset */
function make(values, preset) {
  const out = values.get('out');
  if (typeof out !== 'string') throw new UsageError('--out is missing: name the folder that receives the files');
  const flight = settingsOf(OPTIONS, values, flight_preset(preset));
  makeFolder(out);
  const progress = new Progress({ steps: 2 });
  const made = progress.step('rendering', () => fly(flight));
  const files = progress.step('writing', () => write(out, made, flight));
  progress.end();
  const words = matchCommand(files, made);
  if (values.has('json')) printJson({ files, match: words });
  else print(`written to ${out}: ${Object.values(FILES).join(', ')}`, '', 'Try:', shellCommand(words));
}

/** @type {Record<string, string>} */
const FILES = {
  left: 'left.png',
  right: 'right.png',
  left_fiducials: 'left-fiducials.csv',
  right_fiducials: 'right-fiducials.csv',
  camera: 'camera.json',
  truth: 'truth.json',
  map: 'map_row_col.f32',
  visible: 'visible.png',
};

/** @param {string} folder @param {SamplePair} made @param {Flight} flight @returns {Record<string, string>} paths by what they hold */
function write(folder, made, flight) {
  const { map, visible } = denseMap(made.right_position, made.right.width, made.right.height);
  /** @type {Record<string, string | Uint8Array>} */
  const contents = {
    left: grey_png(made.left.width, made.left.height, made.left.grey),
    right: grey_png(made.right.width, made.right.height, made.right.grey),
    left_fiducials: fiducialCsv(made.left_fiducials),
    right_fiducials: fiducialCsv(made.right_fiducials),
    camera: `${JSON.stringify(made.camera, null, 2)}\n`,
    truth: `${JSON.stringify(truthOf(made, flight), null, 2)}\n`,
    map,
    visible: grey_png(made.left.width, made.left.height, visible),
  };
  return Object.fromEntries(Object.entries(contents).map(([key, content]) => [key, writeInto(folder, FILES[key] ?? key, content)]));
}

/** @param {SamplePair} made @param {Flight} flight */
const truthOf = (made, flight) => ({
  convention:
    'map_row_col.f32 counts from the centre of the top-left pixel; fiducials and origins are px of the scans, the centre of the top-left pixel at (0.5, 0.5)',
  relative_orientation: made.truth,
  b_mm: made.base_mm,
  f_mm: made.camera.focal_mm,
  patch_size: [made.left.width, made.left.height],
  right_patch_size: [made.right.width, made.right.height],
  left: { patch_origin_col_row: made.left_origin, grey_sha256: greyDigest(made.left.grey) },
  right: { patch_origin_col_row: made.right_origin, grey_sha256: greyDigest(made.right.grey) },
  flight,
});

/** @param {SamplePair['left_fiducials']} fiducials */
const fiducialCsv = (fiducials) => `${['col,row,x_mm,y_mm', ...fiducials.map((f) => [f.col, f.row, f.x_mm, f.y_mm].join(','))].join('\n')}\n`;

/** @param {Record<string, string>} files @param {SamplePair} made @returns {string[]} */
function matchCommand(files, made) {
  const file = (/** @type {string} */ key) => files[key] ?? '';
  return [
    'tiepoint',
    'match',
    file('left'),
    file('right'),
    '--camera',
    file('camera'),
    '--left-fiducials',
    file('left_fiducials'),
    '--right-fiducials',
    file('right_fiducials'),
    '--left-origin',
    made.left_origin.join(','),
    '--right-origin',
    made.right_origin.join(','),
    // Photos from one place have no base that could give by and bz their scale.
    ...(made.base_mm === 0 ? [] : ['--base-mm', String(made.base_mm)]),
    '--truth',
    file('truth'),
  ];
}
