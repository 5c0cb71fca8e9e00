// @ts-check
/** The options of all commands. Those that stand for a setting come from the crate: name, kind, range, help and default. */

import { availableParallelism } from 'node:os';
import { call_parameters, defaults, message, parameters } from '../node.js';
import { optionName } from '../block/option-name.js';
import { nearest } from './args.js';
import { UsageError } from './errors.js';

/**
 * @typedef {number | string | boolean | [number, number]} Value
 * @typedef {object} Option
 * @property {string} name without the dashes
 * @property {string} placeholder of its value; empty for a flag
 * @property {string} help
 * @property {string} [key] what it stands for, as messages of the crate name it: `group.field` of a setting or a flight, or an argument
 * @property {string} [path] where it stands in the settings; that of no setting stands nowhere
 * @property {string} [section] the heading under which help lists it
 * @property {string} [range] what is allowed, in words
 * @property {number | string} [fallback] its default, or what holds without it
 * @property {boolean} [negates] the flag switches the setting off
 * @property {(text: string) => Value} read checks and converts what was given
 * @typedef {import('../node.js').Parameter} Parameter
 */

/** @param {string} name @param {string} text @returns {number} */
function number(name, text) {
  const value = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text) ? Number(text) : NaN;
  if (!Number.isFinite(value)) throw new UsageError(`--${name} is ${text || 'empty'}; allowed: a number`);
  return value;
}

/** Whether its value is a text, which the check of the settings reads.  @param {{ kind: string }} p */
const isText = ({ kind }) => kind === 'text';

/** What a parameter allows, in words.  @param {Parameter} p @returns {string} */
function allowed(p) {
  if (p.kind === 'flag') return '';
  return p.kind === 'choice' ? p.values.join(', ') : message('allowed', p);
}

/** @param {string} name @param {readonly string[]} words @param {string} text */
function oneOf(name, words, text) {
  if (words.includes(text)) return text;
  const near = nearest(text, words);
  throw new UsageError(`--${name} is ${text || 'empty'}; allowed: ${words.join(', ')}${near ? ` (did you mean ${near}?)` : ''}`);
}

/** @param {string} name @param {Parameter} p @param {string} text @returns {Value} */
function read(name, p, text) {
  if (p.kind === 'choice') return oneOf(name, p.values, text);
  if (isText(p)) {
    if (text.trim() === '') throw new UsageError(`--${name} is empty; allowed: a text`);
    return text.trim();
  }
  const value = number(name, text);
  const { min, max } = 'min' in p ? p : { min: -Infinity, max: Infinity };
  const whole = p.kind !== 'integer' || (Number.isInteger(value) && (!p.odd || value % 2 !== 0));
  if (!whole || value < min || value > max) throw new UsageError(`--${name} is ${text}; allowed: ${allowed(p)}`);
  return value;
}

/** Units that stand for a value in a call.  @type {Readonly<Record<string, string>>} */
const PLACEHOLDERS = { '': 'N', mm: 'MM', m: 'M', px: 'PX', '°': 'DEG', 'grey values': 'GREY' };

/**
 * An option that stands for a parameter; `standard` is its default. A flag that is on by default is one that switches it off.
 * @param {Parameter} p @param {unknown} standard @param {string} [called] in place of its own name @returns {Option}
 */
function parameterOption(p, standard, called) {
  const { key, path, section } = p;
  const negates = standard === true;
  const name = called ?? `${negates && !p.named ? 'no-' : ''}${optionName(p)}`;
  if (p.kind === 'flag') return { ...flag(name, negates ? `Switches this off: ${p.help}` : p.help), key, path, section, negates };
  const placeholder = { choice: 'NAME', text: 'TEXT' }[/** @type {string} */ (p.kind)] ?? PLACEHOLDERS[p.unit];
  const help = placeholder ? p.help : `${p.help} Its unit is ${p.unit}.`;
  const fallback = typeof standard === 'number' || typeof standard === 'string' ? standard : p.absent;
  return {
    name,
    placeholder: placeholder ?? 'N',
    key,
    path,
    section,
    // Written where it is asked for: a command that is called well needs no text of the crate.
    get range() {
      return allowed(p);
    },
    fallback,
    help,
    read: (text) => read(name, p, text),
  };
}

/** The group of settings in which an option stands, and its field there.  @param {object} settings @param {string} path @returns {[Record<string, unknown>, string]} */
function placeOf(settings, path) {
  const groups = path.split('.');
  const field = groups.pop() ?? '';
  return [groups.reduce((within, name) => /** @type {any} */ (within)[name], /** @type {any} */ (settings)), field];
}

/**
 * Options for all parameters, in their order.
 * @param {readonly Parameter[]} all @param {object} standard the settings whose values are the defaults
 * @param {Readonly<Record<string, string>>} [called] names by key, in place of their own @returns {Option[]}
 */
export function optionsOf(all, standard, called = {}) {
  return all.map((p) => {
    const [group, field] = placeOf(standard, p.path);
    return parameterOption(p, group[field], called[p.key]);
  });
}

/** What the command of blocks calls some settings.  @type {Readonly<Record<string, string>>} */
export const BLOCK_NAMES = { 'multiscale.number': 'features' };

/** Some of some words, with commas between.  @param {string} name @param {readonly string[]} words @param {string} help @returns {Option} */
export const list = (name, words, help) => ({
  name,
  placeholder: 'NAME,…',
  range: words.join(', '),
  help,
  read: (text) => {
    const given = text.split(',').map((one) => one.trim());
    const wrong = given.find((one, i) => !words.includes(one) || given.indexOf(one) !== i);
    if (wrong !== undefined)
      throw new UsageError(
        `--${name} has ${wrong || 'an empty name'}${words.includes(wrong) ? ' twice' : ''}; allowed, with commas between: ${words.join(', ')}`,
      );
    return given.join(',');
  },
});

/** One of some words.  @param {string} name @param {readonly string[]} words @param {string} help @param {string} [fallback] @returns {Option} */
export const word = (name, words, help, fallback) => ({
  name,
  placeholder: 'NAME',
  range: words.join(', '),
  help,
  fallback,
  read: (text) => oneOf(name, words, text),
});

/** @param {string} name @param {string} help @returns {Option} */
export const flag = (name, help) => ({ name, placeholder: '', help, read: () => true });

/** @param {string} name @param {string} placeholder @param {string} help @returns {Option} */
export const path = (name, placeholder, help) => ({
  name,
  placeholder,
  help,
  read: (text) => {
    if (text === '') throw new UsageError(`--${name} is empty; allowed: the path of a file or folder`);
    return text;
  },
});

const CALL_PARAMETERS = call_parameters();

/** A value of a call that is no setting, as the crate declares it: it stands in no section of a command's help.  @param {string} key @returns {Option} */
export function valueOption(key) {
  const declared = CALL_PARAMETERS.find((p) => p.key === key);
  if (!declared) throw new Error(`the crate declares no ${key}`);
  const option = parameterOption(declared, undefined);
  delete option.section;
  delete option.path;
  return option;
}

/** Two numbers with a comma between.  @param {string} name @param {string} placeholder @param {string} help @returns {Option} */
export const pair = (name, placeholder, help) => ({
  name,
  placeholder,
  help,
  read: (text) => {
    const parts = text.split(',').map((part) => part.trim());
    if (parts.length !== 2) throw new UsageError(`--${name} is ${text || 'empty'}; allowed: two numbers with a comma between, ${placeholder}`);
    return [number(name, parts[0] ?? ''), number(name, parts[1] ?? '')];
  },
});

/** Threads that are used unless another number is given. */
export const DEFAULT_WORKERS = Math.min(availableParallelism(), 16);

export const WORKERS = valueOption('workers');

/** What a mask is. */
export const MASK = 'Grey image as large as the image itself: where it is 0 (black), no points are wanted';

export const JSON_FLAG = flag('json', 'Prints one JSON object in full precision in place of a table.');
export const LANGUAGE = word('language', ['en', 'ar'], 'Language of report.html; everything else is English.', 'en');
export const HELP_FLAG = flag('help', 'Prints this text.');

/** The language of the report: of {@link LANGUAGE}, or absent.  @param {ReadonlyMap<string, Value>} values @returns {string | undefined} */
export const languageOf = (values) => /** @type {string | undefined} */ (values.get(LANGUAGE.name));

/** The options of a pair, by the groups of their settings. */
const PAIR = optionsOf(parameters(), defaults());

/** @param {string[]} groups of settings @returns {Option[]} */
export const groupOptions = (...groups) => PAIR.filter(({ key = '' }) => groups.includes(key.split('.')[0] ?? ''));

/** All settings of a pair. */
export const SETTING_OPTIONS = PAIR;

/** Settings that act only where there is an interior orientation of both photos. */
export const ORIENTING_OPTIONS = PAIR.filter(({ key = '' }) => key === 'matching.epipolar' || key.startsWith('orientation.'));

/**
 * Settings with what was given in their place.
 * @template {object} T @param {readonly Option[]} options @param {ReadonlyMap<string, Value>} values @param {T} settings the defaults @returns {T}
 */
export function settingsOf(options, values, settings) {
  for (const { name, path, negates } of options) {
    const given = values.get(name);
    if (path === undefined || given === undefined) continue;
    const [group, field] = placeOf(settings, path);
    group[field] = negates ? !given : given;
  }
  return settings;
}

/**
 * Refuses options that only make sense beside another.
 * @param {ReadonlyMap<string, Value>} values @param {readonly (readonly [string, string])[]} beside each with the one that it needs
 */
export function checkTogether(values, beside) {
  const lone = beside.find(([one, other]) => values.has(one) && !values.has(other));
  if (lone !== undefined) throw new UsageError(`--${lone[0]} needs --${lone[1]} beside it`);
}

/** Gives settings the names of their options in a message of the crate.  @param {Option[]} options @param {string} message */
export function withOptionNames(options, message) {
  return options.reduce((text, { key, name }) => {
    if (!key) return text;
    // A key that is a word of the language, as heights, names the option where it is what a message is about.
    return key.includes('.') ? text.replaceAll(key, `--${name}`) : text.replace(new RegExp(`(^|: )${key} is `), `$1--${name} is `);
  }, message);
}
