// @ts-check
/** Finds the command that was called, runs it, and turns errors into one line and an exit code. */

import { version } from '../node.js';
import { nearest, parse } from './args.js';
import { accuracy } from './accuracy.js';
import { block } from './block.js';
import { covariances } from './covariances.js';
import { explain, oneLine, UsageError } from './errors.js';
import { film } from './film.js';
import { helpOf, overview } from './help.js';
import { interior } from './interior.js';
import { match } from './match.js';
import { moments } from './moments.js';
import { edit } from './edit.js';
import { epipolar } from './epipolar.js';
import { mosaic } from './mosaic.js';
import { HELP_FLAG, withOptionNames } from './options.js';
import { orient } from './orient.js';
import { print } from './output.js';
import { place } from './place.js';
import { points } from './points.js';
import { report } from './report.js';
import { sample, simulate } from './simulate.js';

/** @typedef {import('./args.js').Command} Command */

/** @type {Command[]} */
export const COMMANDS = [
  points,
  match,
  interior,
  orient,
  moments,
  report,
  film,
  block,
  edit,
  covariances,
  accuracy,
  mosaic,
  epipolar,
  place,
  sample,
  simulate,
].map(withHelp);

/** @param {Command} command @returns {Command} */
function withHelp(command) {
  return { ...command, options: [...command.options, HELP_FLAG], ...(command.variant && { variant: withHelp(command.variant) }) };
}

/** @param {string[]} args what follows the program's name @returns {Promise<import('./errors.js').ExitCode>} the exit code */
export async function main(args) {
  const [name, ...rest] = args;
  const named = COMMANDS.find((c) => c.name === name);
  const command = named?.variant && rest.includes(flagOf(named.variant)) ? named.variant : named;
  try {
    if (!command) general(name, rest);
    else if (rest.includes('--help') || rest.includes('-h')) print(helpOf(command));
    else return (await command.run(parse(command, rest))) ?? 0;
    return 0;
  } catch (error) {
    const { line, code } = explain(error, (message) => withOptionNames(command?.options ?? [], message));
    process.stderr.write(`tiepoint: ${oneLine(line)}\n`);
    return code;
  }
}

/** The flag that stands at the end of a variant's name.  @param {Command} variant */
const flagOf = ({ name }) => name.split(' ').at(-1) ?? '';

/** Everything that is not a command's own.  @param {string | undefined} name @param {string[]} rest */
function general(name, rest) {
  if (name === '--version' || name === '-V') print(version());
  else if (name === 'help' && rest[0] !== undefined) print(helpOf(COMMANDS.find((c) => c.name === rest[0]) ?? unknown(rest[0])));
  else if (name === 'help' || name === '--help' || name === '-h') print(overview(COMMANDS));
  else if (name === undefined) throw new UsageError(`name a command: ${COMMANDS.map((c) => c.name).join(', ')}; tiepoint help lists what they do`);
  else unknown(name);
}

/** @param {string} name @returns {never} */
function unknown(name) {
  const near = nearest(
    name,
    COMMANDS.map((c) => c.name),
  );
  throw new UsageError(`there is no command ${name}; ${near ? `did you mean ${near}?` : `allowed: ${COMMANDS.map((c) => c.name).join(', ')}, help`}`);
}
