// @ts-check
import { sample as renderSample, sample_seed } from '../node.js';
import { UsageError } from './errors.js';
import { makeFolder, writeInto } from './files.js';
import { JSON_FLAG, path, real } from './options.js';
import { print, printJson } from './output.js';
import { greyPng } from './png.js';
import { Progress } from './progress.js';
import { shellWord } from './text.js';

/** @typedef {import('../node.js').SamplePair} SamplePair */

/** @type {import('./args.js').Command} */
export const sample = {
  name: 'sample',
  summary: 'Writes a made pair of photos with its camera, its fiducial marks and the truth to compare with.',
  positionals: [],
  options: [
    path('out', 'DIR', 'Folder that receives the files; required.'),
    real('seed', `Start of the random numbers that make the terrain (default: ${sample_seed()}).`, (s) => Number.isInteger(s) && s >= 0 && s <= 0xffffffff, 'whole numbers from 0 to 4294967295'),
    JSON_FLAG,
  ],
  details: 'JSON: files, and match, the command to try next as a list of words.',
  run({ values }) {
    const out = values.get('out');
    if (typeof out !== 'string') throw new UsageError('--out is missing: name the folder that receives the files');
    const seed = Number(values.get('seed') ?? sample_seed());
    makeFolder(out);
    const progress = new Progress(2);
    const made = progress.step('rendering', () => renderSample(seed));
    const files = progress.step('writing', () => write(out, made, seed));
    progress.end();
    const words = matchCommand(files, made);
    if (values.has('json')) printJson({ files, match: words });
    else print(`written to ${out}: ${Object.keys(FILES).map((key) => FILES[key]).join(', ')}`, '', 'Try:', words.map(shellWord).join(' '));
  },
};

/** @type {Record<string, string>} */
const FILES = {
  left: 'left.png',
  right: 'right.png',
  left_fiducials: 'left-fiducials.csv',
  right_fiducials: 'right-fiducials.csv',
  camera: 'camera.json',
  truth: 'truth.json',
};

/** @param {string} folder @param {SamplePair} made @param {number} seed @returns {Record<string, string>} paths by what they hold */
function write(folder, made, seed) {
  const { truth, base_mm, left_origin, right_origin } = made;
  /** @type {Record<string, string | Uint8Array>} */
  const contents = {
    left: greyPng(made.left.width, made.left.height, made.left.grey),
    right: greyPng(made.right.width, made.right.height, made.right.grey),
    left_fiducials: fiducialCsv(made.left_fiducials),
    right_fiducials: fiducialCsv(made.right_fiducials),
    camera: `${JSON.stringify(made.camera, null, 2)}\n`,
    truth: `${JSON.stringify({ seed, relative_orientation: truth, base_mm, left_origin, right_origin }, null, 2)}\n`,
  };
  return Object.fromEntries(Object.entries(contents).map(([key, content]) => [key, writeInto(folder, FILES[key] ?? key, content)]));
}

/** @param {SamplePair['left_fiducials']} fiducials */
const fiducialCsv = (fiducials) => ['col,row,x_mm,y_mm', ...fiducials.map((f) => [f.col, f.row, f.x_mm, f.y_mm].join(','))].join('\n') + '\n';

/** @param {Record<string, string>} files @param {SamplePair} made @returns {string[]} */
function matchCommand(files, made) {
  const file = (/** @type {string} */ key) => files[key] ?? '';
  return [
    'tiepoint', 'match', file('left'), file('right'), '--camera', file('camera'),
    '--left-fiducials', file('left_fiducials'), '--right-fiducials', file('right_fiducials'),
    '--left-origin', made.left_origin.join(','), '--right-origin', made.right_origin.join(','), '--base-mm', String(made.base_mm),
  ];
}
