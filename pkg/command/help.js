// @ts-check
/** The help texts, made from the tables the commands work with. */

import { version } from '../node.js';
import { allowedText, defaultText } from './options.js';
import { wrap } from './text.js';

/** @typedef {import('./args.js').Command} Command @typedef {import('./options.js').Option} Option */

const WIDTH = 96;

/** @param {Command[]} commands @returns {string} */
export function overview(commands) {
  return [
    `tiepoint ${version()}: from overlapping photographs to oriented tie points`,
    '',
    'tiepoint COMMAND …; tiepoint COMMAND --help tells the options of one.',
    '',
    ...commands.map((c) => `  ${c.name.padEnd(10)}${c.summary}`),
    '',
    wrap('With --json a command prints one JSON object in full precision. Pixels: the centre of the top-left pixel is at (0.5, 0.5).', WIDTH),
    'Exit codes: 0 done, 1 bad data, 2 a bad call.',
  ].join('\n');
}

/** @param {Command} command @returns {string} */
export function helpOf(command) {
  const usage = ['tiepoint', command.name, ...command.positionals, ...(command.rest ? [command.rest] : []), '[OPTIONS]'].join(' ');
  return [usage, '', wrap(command.summary, WIDTH), '', ...command.options.map(describe), wrap(command.details, WIDTH)].join('\n').trimEnd();
}

/** @param {Option} option @returns {string} */
function describe(option) {
  const facts = [['allowed', allowedText(option)], ['default', defaultText(option)]].filter(([, text]) => text !== '');
  const text = facts.length > 0 ? `${option.help} (${facts.map((fact) => fact.join(': ')).join('; ')})` : option.help;
  return `${`  --${option.name} ${option.placeholder}`.trimEnd()}\n${wrap(text, WIDTH, '      ')}\n`;
}

