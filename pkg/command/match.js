// @ts-check
import { match_pair, matches_csv, parse_camera, parse_fiducials, points_csv } from '../node.js';
import { about, UsageError } from './errors.js';
import { makeFolder, readPhoto, readText, writeInto } from './files.js';
import { BASE, JSON_FLAG, MATCH_OPTIONS, pair, path, POINT_OPTIONS, settingsOf } from './options.js';
import { describeOrientation } from './orient.js';
import { print, printJson, rows } from './output.js';
import { countTable } from './points.js';
import { Progress } from './progress.js';
import { fixed, table } from './text.js';

/**
 * @typedef {import('../node.js').PairOutput} PairOutput
 * @typedef {import('../node.js').Given<import('../node.js').PairInput>} GivenInput
 * @typedef {import('./args.js').Call} Call
 */

const OPTIONS = [
  path('camera', 'camera.json', 'Focal length, principal point and, where there are no fiducials, pixel size: {"focal_mm", "principal_point_mm": [x, y], "pixel_mm"}.'),
  path('left-fiducials', 'F.csv', 'Fiducial marks measured in the scan of the left photo: col,row,x_mm,y_mm.'),
  path('right-fiducials', 'F.csv', 'The same of the right photo.'),
  pair('left-origin', 'COL,ROW', 'Place of the left image\'s top-left pixel in the scan whose fiducials were measured.'),
  pair('right-origin', 'COL,ROW', 'The same of the right image.'),
  pair('offset', 'DX,DY', 'Position of a point in the right image minus that in the left, in px; estimated when not given.'),
  ...MATCH_OPTIONS,
  BASE,
  path('out', 'DIR', 'Folder that receives matches.csv, left-points.csv, right-points.csv and result.json.'),
  ...POINT_OPTIONS,
  JSON_FLAG,
];

/** @type {import('./args.js').Command} */
export const match = {
  name: 'match',
  summary: 'Matches two overlapping photos by moments and orients them relative to each other.',
  positionals: ['LEFT', 'RIGHT'],
  options: OPTIONS,
  details: 'Without --camera the focal length comes from the images\' EXIF data; without either the matches are given and the orientation is null, with the '
    + 'reason. JSON: counts (left, right, matches, refused by rule), matches [[x_left, y_left, x_right, y_right, measure], …], orientation as `tiepoint orient` '
    + 'prints it, or null with orientation_reason; rejected indices count matches from 0.',
  run(call) {
    const { positionals: [leftPath = '', rightPath = ''], values } = call;
    checkTogether(call);
    const settings = settingsOf(OPTIONS, values);
    const input = inputOf(call);
    const out = values.get('out');
    if (typeof out === 'string') makeFolder(out);
    const progress = new Progress(4);
    const left = progress.step(`reading ${leftPath}`, () => readPhoto(leftPath));
    const right = progress.step(`reading ${rightPath}`, () => readPhoto(rightPath));
    const output = progress.step('matching', () => match_pair(left, right, input, settings));
    const result = resultOf(output, settings);
    const written = progress.step('writing', () => (typeof out === 'string' ? write(out, output, result) : []));
    progress.end();
    if (values.has('json')) printJson(result);
    else print(...describe(output), ...(written.length > 0 ? ['', `written: ${written.join(', ')}`] : []));
  },
};

/** Options that only make sense beside another.  @param {Call} call */
function checkTogether({ values }) {
  for (const [one, other] of [['left-fiducials', 'right-fiducials'], ['right-fiducials', 'left-fiducials'], ['left-origin', 'left-fiducials'], ['right-origin', 'right-fiducials']]) {
    if (one && other && values.has(one) && !values.has(other)) throw new UsageError(`--${one} needs --${other} beside it`);
  }
}

/** @param {Call} call @returns {GivenInput} */
function inputOf({ values }) {
  /** @type {GivenInput} */
  const input = {};
  const camera = values.get('camera');
  if (typeof camera === 'string') {
    const text = readText(camera);
    input.camera = about(camera, () => parse_camera(text));
  }
  for (const side of /** @type {const} */ (['left', 'right'])) {
    const file = values.get(`${side}-fiducials`);
    const origin = values.get(`${side}-origin`);
    if (typeof file !== 'string') continue;
    const text = readText(file);
    const fiducials = about(file, () => parse_fiducials(text));
    input[side] = Array.isArray(origin) ? { fiducials, origin } : { fiducials };
  }
  const offset = values.get('offset');
  if (Array.isArray(offset)) input.offset = offset;
  return input;
}

/** The JSON form.  @param {PairOutput} output @param {import('../node.js').PairSettings} settings */
function resultOf(output, settings) {
  const { matches, ...refused } = output.match.counts;
  return {
    counts: { left: output.left.counts, right: output.right.counts, matches, refused },
    matches: rows(output.match.matches, 5),
    orientation: output.orientation,
    orientation_reason: output.orientation_reason,
    offset_px: output.offset.median_px,
    interior: output.interior,
    pixel_mm: output.pixel_mm,
    settings,
  };
}

/** @param {string} folder @param {PairOutput} output @param {object} result @returns {string[]} the files */
function write(folder, output, result) {
  return [
    writeInto(folder, 'matches.csv', matches_csv(output.match.matches)),
    writeInto(folder, 'left-points.csv', points_csv(output.left.points)),
    writeInto(folder, 'right-points.csv', points_csv(output.right.points)),
    writeInto(folder, 'result.json', `${JSON.stringify(result)}\n`),
  ];
}

/** @param {PairOutput} output @returns {string[]} */
function describe(output) {
  const { matches, ...refused } = output.match.counts;
  return [
    countTable([['left', output.left], ['right', output.right]]),
    '',
    table([['matches', matches], ...Object.entries(refused).map(([rule, count]) => [`refused: ${rule.replaceAll('_', ' ')}`, count])]),
    `offset ${output.offset.median_px.map((v) => fixed(v, 1)).join(', ')} px`,
    '',
    ...(output.orientation ? describeOrientation(output.orientation, output.pixel_mm) : [`no orientation: ${output.orientation_reason}`]),
  ];
}
