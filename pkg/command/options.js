// @ts-check
/** The options of all commands. Those that stand for a setting take kind, range, help and default from the crate. */

import { availableParallelism } from 'node:os';
import { defaults, parameters } from '../node.js';
import { nearest } from './args.js';
import { UsageError } from './errors.js';

/**
 * @typedef {number | string | boolean | [number, number]} Value
 * @typedef {object} Option
 * @property {string} name without the dashes
 * @property {string} placeholder of its value; empty for a flag
 * @property {string} help
 * @property {string} [key] what it stands for, as messages of the crate name it: `group.field` of a setting or a flight, or an argument
 * @property {string} [range] what is allowed, in words, where no setting tells it
 * @property {number | string} [fallback] its default, where that of the setting does not hold
 * @property {boolean} [negates] the flag switches the setting off
 * @property {Readonly<Record<string, string>>} [words] other words for some values of the setting
 * @property {(text: string) => Value} read checks and converts what was given
 * @typedef {import('../node.js').Parameter} Parameter
 * @typedef {import('../node.js').PairSettings} PairSettings
 */

/** @type {Map<string, Parameter>} */
const PARAMETERS = new Map(parameters().map((p) => [p.key, p]));

/** @param {string} key @returns {Parameter} */
function parameterOf(key) {
  const parameter = PARAMETERS.get(key);
  if (!parameter) throw new Error(`the crate has no setting ${key}`);
  return parameter;
}

/** @param {string} name @param {string} text @returns {number} */
function number(name, text) {
  const value = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text) ? Number(text) : NaN;
  if (!Number.isFinite(value)) throw new UsageError(`--${name} is ${text || 'empty'}; allowed: a number`);
  return value;
}

/** What a parameter allows, in words.  @param {Parameter} p @returns {string} */
export function allowed(p) {
  switch (p.kind) {
    case 'integer': return `${p.odd ? 'odd ' : ''}whole numbers from ${p.min} to ${p.max}`;
    case 'real': return `${p.min} to ${p.max}`;
    case 'choice': return p.values.join(', ');
    default: return 'yes or no';
  }
}

/** @param {string} name @param {Parameter} p @param {string} text @returns {Value} */
function read(name, p, text) {
  if (p.kind === 'choice') {
    if (p.values.includes(text)) return text;
    const near = nearest(text, p.values);
    throw new UsageError(`--${name} is ${text || 'empty'}; allowed: ${allowed(p)}${near ? ` (did you mean ${near}?)` : ''}`);
  }
  const value = number(name, text);
  const { min, max } = p.kind === 'integer' || p.kind === 'real' ? p : { min: -Infinity, max: Infinity };
  const whole = p.kind !== 'integer' || (Number.isInteger(value) && (!p.odd || value % 2 !== 0));
  if (!whole || value < min || value > max) throw new UsageError(`--${name} is ${text}; allowed: ${allowed(p)}`);
  return value;
}

/** An option that stands for a parameter which is no setting of a pair.  @param {string} name @param {Parameter} p @returns {Option} */
export function parameterOption(name, p) {
  const placeholder = PLACEHOLDERS[p.unit];
  const help = placeholder ? p.help : `${p.help} Its unit is ${p.unit}.`;
  return { name, placeholder: placeholder ?? 'N', key: p.key, range: allowed(p), help, read: (text) => read(name, p, text) };
}

/** Units that stand for a value in a call.  @type {Readonly<Record<string, string>>} */
const PLACEHOLDERS = { '': 'N', mm: 'MM', m: 'M', px: 'PX', '°': 'DEG', 'grey values': 'GREY' };

/** One of some words.  @param {string} name @param {readonly string[]} words @param {string} help @returns {Option} */
export const word = (name, words, help) => ({
  name, placeholder: 'NAME', range: words.join(', '), help,
  read: (text) => {
    if (words.includes(text)) return text;
    throw new UsageError(`--${name} is ${text || 'empty'}; allowed: ${words.join(', ')}`);
  },
});

/** Some of some words, with commas between.  @param {string} name @param {readonly string[]} words @param {string} help @returns {Option} */
export const list = (name, words, help) => ({
  name, placeholder: 'NAME,…', range: words.join(', '), help,
  read: (text) => {
    const given = text.split(',').map((one) => one.trim());
    const wrong = given.find((one, i) => !words.includes(one) || given.indexOf(one) !== i);
    if (wrong !== undefined) throw new UsageError(`--${name} has ${wrong || 'an empty name'}${words.includes(wrong) ? ' twice' : ''}; allowed, with commas between: ${words.join(', ')}`);
    return given.join(',');
  },
});

/** An option that stands for a setting.  @param {string} name @param {string} placeholder @param {string} key @returns {Option} */
function setting(name, placeholder, key) {
  const p = parameterOf(key);
  return { name, placeholder, key, help: p.help, read: (text) => read(name, p, text) };
}

/** @param {string} name @param {string} help @returns {Option} */
export const flag = (name, help) => ({ name, placeholder: '', help, read: () => true });

/** A flag that switches a setting on.  @param {string} name @param {string} key @returns {Option} */
const switchOn = (name, key) => ({ ...flag(name, parameterOf(key).help), key });

/** A flag that switches a setting off.  @param {string} name @param {string} key @param {string} help @returns {Option} */
const switchOff = (name, key, help) => ({ ...flag(name, help), key, negates: true });

/**
 * Another way to give some values of a setting.
 * @param {string} name @param {string} key @param {Readonly<Record<string, string>>} words @param {string} help @returns {Option}
 */
const otherWords = (name, key, words, help) => ({
  name, placeholder: 'NAME', key, words, help,
  read: (text) => {
    const value = words[text];
    if (value === undefined) throw new UsageError(`--${name} is ${text || 'empty'}; allowed: ${Object.keys(words).join(', ')}`);
    return value;
  },
});

/** @param {string} name @param {string} placeholder @param {string} help @returns {Option} */
export const path = (name, placeholder, help) => ({
  name, placeholder, help,
  read: (text) => {
    if (text === '') throw new UsageError(`--${name} is empty; allowed: the path of a file or folder`);
    return text;
  },
});

/** A number that is no setting.  @param {string} name @param {string} key @param {string} help @param {(value: number) => boolean} valid @param {string} range in words @returns {Option} */
export const real = (name, key, help, valid, range) => ({
  name, placeholder: 'N', key, range, help,
  read: (text) => {
    const value = number(name, text);
    if (!valid(value)) throw new UsageError(`--${name} is ${text}; allowed: ${range}`);
    return value;
  },
});

/** Two numbers with a comma between.  @param {string} name @param {string} placeholder @param {string} help @returns {Option} */
export const pair = (name, placeholder, help) => ({
  name, placeholder, help,
  read: (text) => {
    const parts = text.split(',').map((part) => part.trim());
    if (parts.length !== 2) throw new UsageError(`--${name} is ${text || 'empty'}; allowed: two numbers with a comma between, ${placeholder}`);
    return [number(name, parts[0] ?? ''), number(name, parts[1] ?? '')];
  },
});

/** Threads that are used unless told. */
export const DEFAULT_WORKERS = Math.min(availableParallelism(), 16);

/** @param {string} same what does not depend on it, with its verb @returns {Option} */
export const workersOption = (same) => ({
  ...parameterOption('workers', { key: 'workers', label: 'Workers', unit: '', kind: 'integer', min: 1, max: 256, odd: false, help: `Threads; ${same} the same for any number.` }),
  fallback: DEFAULT_WORKERS,
});

/** What a mask is. */
export const MASK = 'Grey image as large as the image itself: where it is 0 (black), no points are wanted';

export const JSON_FLAG = flag('json', 'Prints one JSON object in full precision in place of a table.');
export const HELP_FLAG = flag('help', 'Prints this text.');

export const POINT_OPTIONS = [
  setting('operator', 'NAME', 'points.operator'),
  setting('threshold', 'T', 'points.threshold'),
  setting('fraction', 'F', 'points.fraction'),
  setting('roundness', 'Q', 'points.roundness'),
  setting('suppress', 'N', 'points.suppression_window'),
  setting('ties', 'RULE', 'points.ties'),
  setting('number', 'N', 'multiscale.number'),
  setting('contrast', 'G', 'multiscale.contrast'),
  setting('position', 'NAME', 'multiscale.position'),
];

export const WINDOW = setting('window', 'N', 'window.side');
export const BRIGHTNESS = setting('brightness', 'NAME', 'window.brightness');

export const MATCH_OPTIONS = [
  setting('strategy', 'NAME', 'matching.strategy'),
  otherWords('measure', 'matching.strategy', { dm: 'moments', di: 'invariants' }, 'The paper\'s names of the strategies that compare moments: dm and di.'),
  setting('refine', 'NAME', 'matching.refine'),
  switchOn('epipolar', 'matching.epipolar'),
  setting('search', 'N', 'matching.search'),
  WINDOW,
  setting('denominator', 'NAME', 'matching.denominator'),
  setting('max-measure', 'T', 'matching.max_measure'),
  setting('ambiguity', 'R', 'matching.ambiguity'),
  setting('template', 'N', 'matching.template'),
  setting('min-correlation', 'R', 'matching.min_correlation'),
  switchOff('no-left-right', 'matching.left_right', 'Correlation: without the check that the window found correlates best with the left point it came from.'),
  setting('max-standard-error', 'PX', 'matching.max_standard_error'),
  switchOff('keep-frame', 'matching.without_frame', 'Gradient: keeps what lies at the same place of both frames, as film borders and fiducial marks, which is left out else.'),
  switchOn('upright', 'gradient.upright'),
  setting('threshold-px', 'PX', 'geometry.threshold_px'),
  setting('largest-threshold-px', 'PX', 'geometry.largest_threshold_px'),
];

/** Tests and weights of the orientation. */
export const STATISTICS_OPTIONS = [
  setting('alpha0', 'P', 'orientation.alpha0'),
  setting('beta0', 'P', 'orientation.beta0'),
  setting('weighting', 'NAME', 'orientation.weighting'),
  setting('sigma0-mm', 'MM', 'orientation.sigma0_mm'),
];

export const BASE = setting('base-mm', 'B', 'orientation.base_mm');

/** Settings that act only where there is an interior orientation of both photos.  @type {Option[]} */
export const ORIENTING_OPTIONS = [...MATCH_OPTIONS.filter(({ name }) => name === 'epipolar'), BASE, ...STATISTICS_OPTIONS];

/** @type {Option[]} */
export const ORIENTATION_OPTIONS = [
  setting('method', 'NAME', 'orientation.method'),
  switchOff('no-robust', 'orientation.robust', 'Plain least squares from all observations: no consensus, no rejection.'),
  ...STATISTICS_OPTIONS,
];

/**
 * The crate's defaults with what was given in their place.
 * @param {Option[]} options @param {Map<string, Value>} values @returns {PairSettings}
 */
export function settingsOf(options, values) {
  const settings = defaults();
  /** @type {Record<string, Record<string, unknown>>} */
  const groups = Object.fromEntries(Object.entries(settings));
  /** @type {Map<string, string>} */
  const givenBy = new Map();
  for (const { name, key, negates } of options) {
    const given = values.get(name);
    if (!key || given === undefined) continue;
    const other = givenBy.get(key);
    if (other !== undefined) throw new UsageError(`--${other} and --${name} set the same; give one of them`);
    givenBy.set(key, name);
    const [group = '', field = ''] = key.split('.');
    Object.assign(groups[group] ?? {}, { [field]: negates ? !given : given });
  }
  // Gradients are made for points of many scales; those of another operator are described where they are asked for.
  if (settings.matching.strategy === 'gradient' && !givenBy.has('points.operator')) settings.points.operator = 'multiscale';
  return settings;
}

/** Gives settings the names of their options in a message of the crate.  @param {Option[]} options @param {string} message */
export function withOptionNames(options, message) {
  return options.reduce((text, { key, name }) => (key ? text.replaceAll(key, `--${name}`) : text), message);
}

/** The default of an option, as `--help` shows it; empty where there is none.  @param {Option} option @returns {string} */
export function defaultText({ key, placeholder, words, fallback }) {
  if (fallback !== undefined) return String(fallback);
  if (!key || !placeholder || words) return '';
  const [group = '', field = ''] = key.split('.');
  /** @type {Record<string, Record<string, unknown>>} */
  const groups = Object.fromEntries(Object.entries(defaults()));
  const value = groups[group]?.[field];
  return value === undefined || value === null ? '' : String(value);
}

/** @param {Option} option @returns {string} what its setting allows; empty for the others */
export const allowedText = ({ key, placeholder, words, range }) => {
  if (range) return range;
  if (words) return Object.keys(words).join(', ');
  return key && placeholder ? allowed(parameterOf(key)) : '';
};
