// @ts-check
import { withText } from '../messages.js';
import { cameraWanted } from '../pair/camera-wanted.js';
import {
  acting_parameters,
  defaults,
  matches_csv,
  message,
  pair_hint,
  pair_preset,
  pair_presets,
  photo_difference,
  points_csv,
  resolved,
  write_pair_project,
} from '../node.js';
import { noteNotActing } from './acting.js';
import { checkSize } from './block-camera.js';
import { VERDICT_CODES } from './errors.js';
import { describeFileCameras, fileCamerasOf } from './file-cameras.js';
import { makeFolder, readPhoto, writeInto } from './files.js';
import { DEFAULT_WORKERS, JSON_FLAG, ORIENTING_OPTIONS, path, SETTING_OPTIONS, settingsOf, word, WORKERS } from './options.js';
import { describeOrientation, orientationOf, UNKNOWNS } from './orient.js';
import { note, print, printJson, rows } from './output.js';
import { inputOf, MASK_OPTIONS, maskPaths, masksOf, PAIR_OPTIONS } from './pair.js';
import { projectOf } from './pair-project.js';
import { countTable } from './points.js';
import { Progress } from './progress.js';
import { matchPair } from './split-pair.js';
import { fixed, table } from './text.js';
import { checkPair, matchScoreOf, readTruth, scoreOf } from './truth.js';

/** @typedef {import('../node.js').PairOutput} PairOutput */

const OPTIONS = [
  ...PAIR_OPTIONS,
  ...MASK_OPTIONS,
  path('truth', 'FILE', 'truth.json of a simulated pair, or its folder: the matches and the orientation are scored by it.'),
  path(
    'out',
    'DIR',
    'Folder that receives project.tiepoint (all of the pair, which the page opens), matches.csv (each match with its state, used or rejected), left-points.csv, right-points.csv and result.json.',
  ),
  word(
    'preset',
    pair_presets(),
    'Ready-made settings, of which other options change some: many-points has twice as many points, little-in-common larger windows for least squares matching (long bases, ' +
      "other scales), zahran-2007 the paper's method with its values.",
    'the defaults',
  ),
  WORKERS,
  JSON_FLAG,
  ...SETTING_OPTIONS,
];

/** @type {import('./args.js').Command} */
export const match = {
  name: 'match',
  summary: 'Matches two overlapping photos and orients them relative to each other.',
  positionals: ['LEFT', 'RIGHT'],
  options: OPTIONS,
  details:
    "Without --camera the focal length comes from the images' XMP and EXIF data (file_cameras, each with its origin and cautions); without either the matches are given and the orientation is null, with the " +
    'reason. JSON: verdict (oriented, weak or not_oriented, with what decided), hint (what else would do, with by how much the photos are turned, scaled or displaced, or null), counts (left, right, matches, rejected by rule), matches [[x_left, y_left, x_right, y_right, measure], …], fits (of each match correlation, covariance xx, xy, yy of the right position in px² and iterations of least squares matching, null of one that was not matched so and where none was), offset_px (median right minus left position, or null), orientation as `tiepoint orient` ' +
    'prints it, or null with no_orientation, which says why; rejected indices count matches from 0. With gradients also geometry (model, threshold_px, sigma_px, ' +
    'degenerate, focal) or null with no_geometry; where no camera is known, one is assumed. interior is the interior orientation of both photos, pixel_mm the size of a left pixel at photo scale (both null where there is none), settings all settings with what follows from them, score with --truth how near matches and orientation are to it. orientation.cameras says what is known of each camera, but for those known without error: with an uncertainty of zeros, or with none and fiducial marks.',
  async run(call) {
    const {
      positionals: [leftPath = '', rightPath = ''],
      values,
    } = call;
    const { input, ofBlock } = inputOf(call);
    const settings = settingsOf(OPTIONS, values, presetOf(values.get('preset')));
    noteNotActing(SETTING_OPTIONS, values, acting_parameters(settings), `strategy ${resolved(settings).matching.strategy}`);
    const [out, truthPath] = [values.get('out'), values.get('truth')];
    const truth = typeof truthPath === 'string' ? readTruth(truthPath) : null;
    if (typeof out === 'string') makeFolder(out);
    const progress = new Progress({ steps: 4 });
    const left = progress.step(`reading ${leftPath}`, () => readPhoto(leftPath));
    const right = progress.step(`reading ${rightPath}`, () => readPhoto(rightPath));
    checkSize(ofBlock, [left, right]);
    if (truth) checkPair(truth, left, right);
    const pair = { left, right, input, settings, masks: masksOf(call, left, right) };
    const output = await progress.step('matching', () => matchPair(pair, Number(values.get('workers') ?? DEFAULT_WORKERS)));
    const known = truth && { truth, score: matchScoreOf(output, truth, right) };
    const score = known && scoreOf(output, known.truth, known.score);
    const [names, cameras] = [[leftPath, rightPath], [left, right].map((photo) => photo.info().camera)];
    const hint = hintOf(output, pair);
    const result = { ...resultOf(output, settings, cameras, hint), ...(score ? { score } : {}) };
    const written = progress.step('writing', () =>
      typeof out === 'string' ? write(out, projectOf({ images: [leftPath, rightPath], masks: maskPaths(call) }, pair, output, known), result) : [],
    );
    progress.end();
    if (!output.interior) noteWithoutEffect(values);
    if (values.has('json')) printJson(result);
    else
      print(
        ...describe(output, hint, input, { names, cameras }),
        ...(input.camera ? [] : describeFileCameras(names, cameras)),
        ...(score ? ['', ...describeScore(score, output)] : []),
        ...(written.length > 0 ? ['', `written: ${written.join(', ')}`] : []),
      );
    return VERDICT_CODES[output.verdict.kind];
  },
};

/** The settings that a preset starts from.  @param {import('./options.js').Value | undefined} name */
const presetOf = (name) => (name === undefined ? defaults() : pair_preset(/** @type {import('../node.js').PairPreset} */ (name)));

/** Says which options did nothing for want of an interior orientation.  @param {import('./args.js').Call['values']} values */
function noteWithoutEffect(values) {
  const given = ORIENTING_OPTIONS.filter(({ name }) => values.has(name)).map(({ name }) => `--${name}`);
  if (given.length > 0) note(`without effect, since the camera is not known: ${given.join(', ')}`);
}

/**
 * What else would do for a pair, by how its photos lie to each other; null where nothing is known to.
 * @param {PairOutput} output @param {{ left: import('../node.js').Photo, right: import('../node.js').Photo, settings: import('../node.js').Given<import('../node.js').PairSettings> }} pair
 * @returns {import('../node.js').PairHint | null}
 */
function hintOf({ verdict, offset }, { left, right, settings }) {
  const hint = pair_hint(verdict, settings);
  // How the photos lie to each other takes a second and more to find: without a camera the matches may well be right.
  return hint?.kind === 'other_strategy' ? pair_hint(verdict, settings, photo_difference(left, right), offset) : hint;
}

/** The JSON form.  @param {PairOutput} output @param {import('../node.js').Given<import('../node.js').PairSettings>} settings @param {readonly import('./file-cameras.js').FileCamera[]} cameras of the files @param {import('../node.js').PairHint | null} hint */
export function resultOf(output, settings, cameras, hint) {
  const { matches, ...rejected } = output.match.counts;
  return {
    verdict: withText('pair_verdict', output.verdict),
    hint: hint && withText('pair_hint', hint),
    counts: { left: output.left.counts, right: output.right.counts, matches, rejected },
    matches: rows(output.match.matches, 5),
    fits: output.match.fits.every(Number.isNaN) ? null : rows(output.match.fits, 5).map((fit) => (fit.every(Number.isNaN) ? null : fit)),
    orientation: output.orientation && orientationOf(output.orientation),
    no_orientation: output.no_orientation && withText('no_orientation', output.no_orientation),
    offset_px: output.offset?.median_px ?? null,
    geometry: output.match.geometry,
    no_geometry: output.match.no_geometry && withText('no_geometry', output.match.no_geometry),
    interior: output.interior,
    pixel_mm: output.pixel_mm,
    file_cameras: fileCamerasOf(cameras),
    settings: resolved(settings),
  };
}

/** @param {string} folder @param {import('../node.js').PairProject} project @param {object} result @returns {string[]} the files */
function write(folder, project, result) {
  const { output } = project;
  return [
    writeInto(folder, 'project.tiepoint', write_pair_project(project)),
    writeInto(folder, 'matches.csv', matches_csv(output.match.matches, output.orientation?.rejected)),
    writeInto(folder, 'left-points.csv', points_csv(output.left.points)),
    writeInto(folder, 'right-points.csv', points_csv(output.right.points)),
    writeInto(folder, 'result.json', `${JSON.stringify(result)}\n`),
  ];
}

/** @param {ReturnType<typeof scoreOf>} score @param {PairOutput} output @returns {string[]} */
function describeScore(score, output) {
  const part = (/** @type {number} */ count, /** @type {number | null} */ of) => `${count}${of === null ? '' : ` (${fixed(100 * of, 1)} %)`}`;
  const o = output.orientation;
  const { errors } = score;
  const standard = o?.total_standard_errors ?? o?.standard_errors;
  const lines = errors
    ? [
        table([
          ['', 'true error', 'in std. errors'],
          ...UNKNOWNS.map(({ name, unit, field }) => [
            `${name} [${unit}]`,
            fixed(errors[field], 4),
            fixed((errors[field] ?? NaN) / (standard?.[field] ?? NaN), 1),
          ]),
        ]),
      ]
    : [];
  return [
    'by the truth',
    table([
      ['right matches, at edges too', part(score.right, score.right_share)],
      ['strictly right', part(score.strict, score.strict_share)],
      ['points missed', score.missed],
    ]),
    ...lines,
  ];
}

/** Reasons of the verdict beside which a rotation that fits as well says nothing, or contradicts. */
const SAYS_THAT_THERE_IS_NO_BASE = ['pure_rotation', 'one_photo', 'parts_of_one_image'];

/** @param {PairOutput} output @returns {string[]} */
function describeGeometry({ match: { geometry, no_geometry: none }, no_orientation: reason }) {
  if (!geometry) return none ? [`no geometry of the two views: ${message('no_geometry', none)}`] : [];
  const {
    model: { kind },
    threshold_px: threshold,
    sigma_px: sigma,
    degenerate,
    focal,
  } = geometry;
  return [
    `geometry of the two views: ${message('two_view_model', { kind }, kind === 'calibrated' && focal ? 'estimated' : null)}, standard error ${fixed(sigma, 2)} px, threshold ${fixed(threshold, 2)} px`,
    ...(degenerate && !SAYS_THAT_THERE_IS_NO_BASE.includes(reason?.kind ?? '') ? [message('degeneracy', degenerate)] : []),
    ...(focal ? [`focal length by the matches ${fixed(focal.focal_px, 0)} ± ${fixed(focal.standard_error_px, 0)} px`] : []),
  ];
}

/** @typedef {{ names: readonly string[], cameras: readonly import('./file-cameras.js').FileCamera[] }} Files  of a pair, with the cameras that they name */

/** What the command takes that a verdict asks for.  @param {import('../node.js').PairVerdict} verdict @param {import('../node.js').Given<import('../node.js').PairInput>} input @param {Files} files @returns {string[]} */
function cameraHint(verdict, input, { names, cameras }) {
  if (cameraWanted(verdict) !== 'given') return [];
  // Of a scan the marks tell how large its pixels are on the film.
  if (input.camera) return ['hint: give the fiducial marks of scans with --left-fiducials and --right-fiducials, or pixel_mm in the camera'];
  const known = cameras.findIndex((camera) => camera?.pixel_mm != null && camera.origin !== 'panorama');
  const [camera, other] = [cameras[known], 1 - known];
  if (camera?.pixel_mm != null && cameras[other] === null) {
    const focal = fixed(camera.focal_mm / camera.pixel_mm, 1);
    return [`hint: ${names[other]} names no camera; if it is that of ${names[known]}, give --focal-px ${focal}, or the camera with --camera FILE`];
  }
  return ['hint: give the camera with --camera FILE, or its focal length alone with --focal-px F'];
}

/**
 * The outcome in text.
 * @param {PairOutput} output @param {import('../node.js').PairHint | null} hint @param {import('../node.js').Given<import('../node.js').PairInput>} input @param {Files} files @returns {string[]}
 */
export function describe(output, hint, input, files) {
  const { matches, ...rejected } = output.match.counts;
  return [
    message('pair_verdict', output.verdict),
    ...(hint ? [`hint: ${message('pair_hint', hint)}`] : []),
    ...cameraHint(output.verdict, input, files),
    '',
    countTable([
      ['left', output.left],
      ['right', output.right],
    ]),
    '',
    table([
      ['matches', matches],
      ...Object.entries(rejected).map(([rule, count]) => [`rejected: ${message('verdict', /** @type {import('../node.js').Rule} */ (rule), 'label')}`, count]),
    ]),
    ...(output.offset ? [`offset ${output.offset.median_px.map((v) => fixed(v, 1)).join(', ')} px`] : []),
    ...describeGeometry(output),
    ...(output.orientation ? ['', ...describeOrientation(output.orientation, output.pixel_mm)] : []),
  ];
}
