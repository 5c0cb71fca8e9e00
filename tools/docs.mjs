#!/usr/bin/env node
/** `npm run docs`: writes docs/options.md, the table of all options, from the crate's catalogue. */

import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import {
  block_flight_parameters,
  block_flight_preset,
  block_parameters,
  block_settings,
  call_parameters,
  defaults,
  flight_parameters,
  flight_preset,
  parameters,
  placing_defaults,
  placing_parameters,
} from '../pkg/node.js';
import { COMMANDS } from '../pkg/command/main.js';
import { BLOCK_NAMES, optionsOf } from '../pkg/command/options.js';
import { ROOT } from './lib/paths.mjs';
import { namedOrUsage } from './lib/usage.mjs';

export const OPTIONS_FILE = join(ROOT, 'docs', 'options.md');

/** @typedef {import('../pkg/node.js').Parameter} Parameter */

/** @typedef {import('../pkg/command/args.js').Command} Command */

/** @param {string} text */
const cell = (text) => text.replaceAll('|', '\\|');

/** @param {string[]} cells */
const rowOf = (cells) => `| ${cells.map(cell).join(' | ')} |`;

/**
 * When an option acts, as far as the options beside it decide that, by their places.
 * @param {Parameter} p @param {ReadonlyMap<string, string>} places by key
 */
function actsOf({ acts }, places) {
  const keyOf = (/** @type {string} */ one) => one.split(' is ')[0] ?? '';
  const cases = acts.split(' or ').map((all) => all.split(' and ').filter((one) => places.has(keyOf(one))));
  if (cases.some((all) => all.length === 0)) return '';
  const written = cases.map((all) => all.map((one) => one.replace(keyOf(one), places.get(keyOf(one)) ?? '')).join(' and '));
  return ` Acts where ${written.join(' or ')}.`;
}

/**
 * A table for each section.
 * @param {string} title @param {string} about @param {Parameter[]} all @param {object} standard @param {Readonly<Record<string, string>>} [called]
 */
function chapter(title, about, all, standard, called) {
  const options = optionsOf(all, standard, called);
  const places = new Map(all.map(({ key, path }) => [key, path]));
  const rows = all.map((p, i) => ({ p, option: options[i] })).filter(({ option }) => option !== undefined);
  const row = (/** @type {typeof rows[number]} */ { p, option }) => {
    const range = p.kind === 'flag' ? 'yes or no' : `${option?.range}${p.unit ? ` ${p.unit}` : ''}`;
    const standing = p.kind === 'flag' ? (option?.negates ? 'yes' : 'no') : String(option?.fallback ?? '');
    return rowOf([`\`--${option?.name}\``, `\`${p.path}\``, p.label, range, standing, `${p.help}${actsOf(p, places)}`]);
  };
  const sections = [...new Set(all.map(({ section }) => section))].flatMap((section) => [
    `### ${section}`,
    '',
    '| command | setting | label | allowed | default | what it does |',
    '|---|---|---|---|---|---|',
    ...rows.filter(({ p }) => p.section === section).map(row),
    '',
  ]);
  return [`## ${title}`, '', about, '', ...sections];
}

/** What a command is given beside what the crate declares: files, folders, choices of the command.  @param {Command} command @returns {string[]} */
function givenTo(command) {
  const own = command.options.filter(({ name, key }) => key === undefined && name !== 'json' && name !== 'help');
  const rows = own.map(({ name, placeholder, range = '', fallback = '', help }) =>
    rowOf([`\`${`--${name} ${placeholder}`.trim()}\``, range, String(fallback), help]),
  );
  const table = [`### tiepoint ${command.name}`, '', '| option | allowed | default | what it does |', '|---|---|---|---|', ...rows, ''];
  return [...(own.length > 0 ? table : []), ...(command.variant ? givenTo(command.variant) : [])];
}

export function optionsPage() {
  return `${[
    '# Options',
    '',
    'Every option of the command, the package, the page and the crate. `npm run docs` writes this page: settings and values are declared once, in the crate, files and folders where the command takes them. ' +
      '*Setting* is where an option stands in the object that the chapter names.',
    '',
    ...chapter(
      'Pairs',
      '`tiepoint match` and `tiepoint report` take all of these; `points`, `moments` and `orient` those of their stage. In the package and the crate: `PairSettings`. ' +
        'The strategy `auto` counts as `gradient` where an option says when it acts, with the refinement `where-possible`.',
      parameters(),
      defaults(),
    ),
    ...chapter('Blocks', '`tiepoint block`; in the package and the crate: `BlockSettings`.', block_parameters(), block_settings({}), BLOCK_NAMES),
    ...chapter(
      'Placing on an orthophoto',
      '`tiepoint place`, and `tiepoint block` beside `--orthophoto`, where `--points` and `--seed` are `--orthophoto-points` and `--orthophoto-seed`; in the package and the crate: `PlacingOptions`. Lengths are in the unit of the map.',
      placing_parameters(),
      placing_defaults(),
    ),
    ...chapter(
      'Simulated pairs',
      '`tiepoint simulate`; in the package and the crate: `Flight`. The defaults are those of the sample.',
      flight_parameters(),
      flight_preset('sample'),
    ),
    ...chapter(
      'Simulated blocks',
      '`tiepoint simulate --block`; in the package and the crate: `BlockFlight`. The command has other defaults for the size of the photos.',
      block_flight_parameters(),
      block_flight_preset('features'),
    ),
    ...chapter(
      'Values of calls',
      'What commands are given beside settings, where their help lists it; in the package and the crate: arguments of these names, `CALL_PARAMETERS`.',
      call_parameters(),
      {},
    ),
    '## Files of calls',
    '',
    'What each command is given beside settings and values; each also has `--help`, and those that print a result `--json`.',
    '',
    ...COMMANDS.flatMap(givenTo),
  ]
    .join('\n')
    .trimEnd()}\n`;
}

const USAGE = `npm run docs
node tools/docs.mjs

Writes docs/options.md, the table of all options.

  -h, --help  prints this`;

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  namedOrUsage(USAGE, 0);
  writeFileSync(OPTIONS_FILE, optionsPage());
}
