// @ts-check
import { defaults } from '../node.js';
import { UsageError } from './errors.js';
import { readPhoto } from './files.js';
import { groupOptions, JSON_FLAG, pair, settingsOf } from './options.js';
import { print, printJson } from './output.js';
import { fixed, table } from './text.js';

const AT = pair('at', 'COL,ROW', 'The pixel at the centre of the window, counted from 0 at the top left; required.');
const OPTIONS = [AT, ...groupOptions('window'), JSON_FLAG];

/** @type {import('./args.js').Command} */
export const moments = {
  name: 'moments',
  summary: 'The moments and the invariants of the grey values around a pixel.',
  positionals: ['IMAGE'],
  options: OPTIONS,
  details:
    'A position inside a pixel, as `tiepoint points` prints it, names that pixel. JSON: central, normalized, invariants, and of the window ' +
    'col, row, side, centroid_px and axis_angle_deg.',
  run({ positionals: [image = ''], values }) {
    const at = values.get('at');
    if (!Array.isArray(at)) throw new UsageError('--at is missing: give the pixel as --at COL,ROW');
    const [col, row] = at.map(Math.floor);
    if (col === undefined || row === undefined || col < 0 || row < 0) throw new UsageError(`--at is ${at.join(',')}; allowed: a column and a row from 0`);
    const settings = settingsOf(OPTIONS, values, defaults());
    const { side, centroid_px, axis_angle_deg, central, normalized, invariants } = readPhoto(image).window_moments(col, row, settings.window);
    if (values.has('json')) printJson({ central, normalized, invariants, col, row, side, centroid_px, axis_angle_deg });
    else {
      print(
        `${image}: window of ${side} x ${side} px at column ${col}, row ${row}`,
        `centroid ${centroid_px.map((v) => fixed(v, 3)).join(', ')} px, axis ${fixed(axis_angle_deg, 3)} deg`,
        '',
        table([
          ['moment', 'central', 'normalised'],
          ...Object.entries(central).map(([name, value]) => [name, short(value), short(normalizedOf(normalized, name))]),
        ]),
        '',
        table([['invariant', 'value'], ...invariants.map((value, i) => [`I${i}`, short(value)])]),
      );
    }
  },
};

/** @param {object} normalized @param {string} name @returns {number | undefined} mu00 has none */
const normalizedOf = (normalized, name) => Object.entries(normalized).find(([n]) => n === name)?.[1];

/** @param {number | undefined} value */
const short = (value) => (value === undefined ? '' : value.toPrecision(8));
