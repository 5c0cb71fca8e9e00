// @ts-check
/** Splits a call into its positional arguments and its options, each checked against what the command takes. */

import { parseArgs } from 'node:util';
import { UsageError } from './errors.js';

/**
 * @typedef {import('./options.js').Option} Option
 * @typedef {import('./options.js').Value} Value
 * @typedef {import('./errors.js').ExitCode} ExitCode
 * @typedef {object} Command
 * @property {string} name
 * @property {string} summary one line
 * @property {string[]} positionals their names, all required
 * @property {string} [rest] what may follow them any number of times
 * @property {Command} [variant] what the command is when the flag of the variant's name is given
 * @property {Option[]} options
 * @property {string} details what `--help` says below the options
 * @property {(call: Call) => void | ExitCode | Promise<void | ExitCode>} run gives an exit code where all went well and there is more to tell
 * @typedef {{ positionals: string[], values: Map<string, Value> }} Call values: by option name, those that were given
 */

/** @param {Command} command @param {string[]} args @returns {Call} */
export function parse(command, args) {
  const options = Object.fromEntries(
    command.options.map((o) => [o.name, { type: /** @type {'string' | 'boolean'} */ (o.placeholder ? 'string' : 'boolean') }]),
  );
  const { tokens, positionals } = parseArgs({ args, options, strict: false, allowPositionals: true, tokens: true });
  /** @type {Call['values']} */
  const values = new Map();
  for (const token of tokens) {
    if (token.kind !== 'option') continue;
    const option = find(command, token.rawName);
    if (values.has(option.name)) throw new UsageError(`--${option.name} is given twice; give it once`);
    values.set(option.name, option.read(option.placeholder ? argumentOf(option, token) : flag(option, token)));
  }
  checkPositionals(command, positionals);
  return { positionals, values };
}

/** @param {Command} command @param {string} name @returns {Option} */
function find(command, name) {
  const option = command.options.find((o) => `--${o.name}` === name);
  if (option) return option;
  const near = nearest(
    name,
    command.options.map((o) => `--${o.name}`),
  );
  throw new UsageError(`tiepoint ${command.name} has no option ${name}; ${near ? `did you mean ${near}?` : `see tiepoint ${command.name} --help`}`);
}

/** @typedef {{ value?: string | undefined, inlineValue?: boolean | undefined }} Token */

/** What follows the option, unless it is an option itself.  @param {Option} option @param {Token} token @returns {string} */
function argumentOf(option, { value, inlineValue }) {
  if (value === undefined || (!inlineValue && /^--[a-z]/i.test(value)))
    throw new UsageError(`--${option.name} needs a value: --${option.name} ${option.placeholder}`);
  return value;
}

/** @param {Option} option @param {Token} token */
function flag(option, { value }) {
  if (value !== undefined) throw new UsageError(`--${option.name} takes no value; give --${option.name} alone`);
  return '';
}

/** @param {Command} command @param {string[]} given */
function checkPositionals(command, given) {
  if (command.rest) return;
  const wanted = command.positionals;
  const missing = wanted[given.length];
  if (missing) throw new UsageError(`${missing} is missing: tiepoint ${command.name} ${wanted.join(' ')}`);
  const extra = given[wanted.length];
  if (extra !== undefined) throw new UsageError(`${extra} is one argument too many: tiepoint ${command.name} ${wanted.join(' ')}`.trimEnd());
}

/**
 * The known word nearest to one that is not known, if it is near.
 * @param {string} word @param {readonly string[]} known @returns {string | undefined}
 */
export function nearest(word, known) {
  const ranked = known.map((k) => ({ k, d: editDistance(word, k) })).sort((a, b) => a.d - b.d);
  const best = ranked[0];
  return best && best.d <= Math.max(2, Math.floor(word.length / 3)) ? best.k : undefined;
}

/** The number of letters to insert, delete or replace.  @param {string} a @param {string} b @returns {number} */
function editDistance(a, b) {
  let row = Array.from({ length: b.length + 1 }, (_, j) => j);
  for (let i = 1; i <= a.length; i++) {
    const next = [i];
    for (let j = 1; j <= b.length; j++) {
      const replace = (row[j - 1] ?? 0) + (a[i - 1] === b[j - 1] ? 0 : 1);
      next.push(Math.min((row[j] ?? 0) + 1, (next[j - 1] ?? 0) + 1, replace));
    }
    row = next;
  }
  return row[b.length] ?? 0;
}
