// @ts-check
import { acting_parameters, defaults, resolved } from '../node.js';
import { noteNotActing } from './acting.js';
import { readMask, readPhoto } from './files.js';
import { groupOptions, JSON_FLAG, MASK, path, settingsOf } from './options.js';
import { print, printJson, rows } from './output.js';
import { Progress } from './progress.js';
import { fixed, table } from './text.js';

/** @typedef {import('../node.js').DetectedPoints} DetectedPoints */

/** How many points the table shows. */
const SHOWN = 20;

/** The operators of the paper, where none is named; what matching chooses by itself is many scales. */
const STRATEGY = /** @type {const} */ ('moments');
const OPERATOR = String(resolved({ matching: { strategy: STRATEGY } }).points.operator);

const SETTING_OPTIONS = groupOptions('points', 'multiscale').map((option) => (option.key === 'points.operator' ? { ...option, fallback: OPERATOR } : option));
const OPTIONS = [path('mask', 'FILE', `${MASK}.`), ...SETTING_OPTIONS, JSON_FLAG];

/** @type {import('./args.js').Command} */
export const points = {
  name: 'points',
  summary: 'Finds the interest points of an image.',
  positionals: ['IMAGE'],
  options: OPTIONS,
  details:
    'JSON: width, height, threshold, counts (candidates, after_roundness, after_suppression) and points, each [x, y, value] in px; frames, each [scale in px, direction in rad], for points of many scales.',
  run({ positionals: [image = ''], values }) {
    const settings = { ...settingsOf(OPTIONS, values, defaults()), matching: { ...defaults().matching, strategy: STRATEGY } };
    noteNotActing(SETTING_OPTIONS, values, acting_parameters(settings), `operator ${resolved(settings).points.operator}`);
    const progress = new Progress({ steps: 2 });
    const photo = progress.step('reading', () => readPhoto(image));
    const file = values.get('mask');
    const mask = typeof file === 'string' ? readMask(file, photo) : undefined;
    const found = progress.step('finding points', () => photo.detect(settings, mask));
    progress.end();
    const { width, height } = photo;
    if (values.has('json'))
      printJson({ width, height, threshold: found.threshold, counts: found.counts, points: rows(found.points, 3), frames: rows(found.frames, 2) });
    else print(`${image}: ${width} x ${height} px`, '', countTable([['', found]]), '', pointTable(found.points));
  },
};

/** The counts of each phase, a column an image.  @param {[string, DetectedPoints][]} images @returns {string} */
export function countTable(images) {
  return table([
    ['', ...images.map(([name]) => name)],
    ['candidates', ...images.map(([, p]) => p.counts.candidates)],
    ['after roundness', ...images.map(([, p]) => p.counts.after_roundness)],
    ['after suppression', ...images.map(([, p]) => p.counts.after_suppression)],
    ['threshold', ...images.map(([, p]) => fixed(p.threshold, 2))],
  ]).replace(/^\s*\n/, '');
}

/** @param {Float64Array} flat @returns {string} */
function pointTable(flat) {
  const all = rows(flat, 3);
  const shown = all.slice(0, SHOWN).map(([x, y, value]) => [fixed(x, 1), fixed(y, 1), fixed(value, 4)]);
  const rest = all.length - shown.length;
  return table([['x [px]', 'y [px]', 'value'], ...shown]) + (rest > 0 ? `\n… and ${rest} more; --json prints all` : '');
}
