// @ts-check
/** The help texts, made from the tables the commands work with. */

import { version } from '../node.js';
import { wrap } from './text.js';

/** @typedef {import('./args.js').Command} Command @typedef {import('./options.js').Option} Option */

const WIDTH = 96;

/** @param {Command[]} commands @returns {string} */
export function overview(commands) {
  return [
    `tiepoint ${version()}: from overlapping photographs to oriented tie points`,
    '',
    'tiepoint COMMAND …; tiepoint COMMAND --help lists the options of one.',
    '',
    ...commands.map((c) => `  ${c.name.padEnd(13)}${c.summary}`),
    '',
    wrap('With --json a command prints one JSON object in full precision. Pixels: the centre of the top-left pixel is at (0.5, 0.5).', WIDTH),
    wrap(
      'Exit codes: 0 done, 1 bad data, 2 usage error; of match, orient, report, block, edit and place also 3 done with a weak orientation, 4 done without one.',
      WIDTH,
    ),
  ].join('\n');
}

/** @param {Command} command @returns {string} */
export function helpOf(command) {
  const usage = ['tiepoint', command.name, ...command.positionals, ...(command.rest ? [command.rest] : []), '[OPTIONS]'].join(' ');
  const sections = [...new Set(command.options.map(({ section }) => section))];
  const options = sections.flatMap((title) => [
    ...(title ? [`${title}:`, ''] : []),
    ...command.options.filter(({ section }) => section === title).map(describe),
  ]);
  return [usage, '', wrap(command.summary, WIDTH), '', ...options, wrap(command.details, WIDTH)].join('\n').trimEnd();
}

/** @param {Option} option @returns {string} */
function describe({ name, placeholder, help, range = '', fallback = '' }) {
  const facts = [
    ['allowed', range],
    ['default', String(fallback)],
  ].filter(([, text]) => text !== '');
  const text = facts.length > 0 ? [help, `(${facts.map((fact) => fact.join(': ')).join('; ')})`] : [help];
  return `${`  --${name} ${placeholder}`.trimEnd()}\n${text.map((part) => wrap(part, WIDTH, '      ')).join('\n')}\n`;
}
