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
import { BLOCK_NAMES, optionsOf } from '../pkg/command/options.js';
import { ROOT } from './lib/paths.mjs';
import { namedOrUsage } from './lib/usage.mjs';

export const OPTIONS_FILE = join(ROOT, 'docs', 'options.md');

/** @typedef {import('../pkg/node.js').Parameter} Parameter */

/** @param {string} text */
const cell = (text) => text.replaceAll('|', '\\|');

/**
 * A table for each section.
 * @param {string} title @param {string} about @param {Parameter[]} all @param {object} standard @param {Readonly<Record<string, string>>} [called]
 */
function chapter(title, about, all, standard, called) {
  const options = optionsOf(all, standard, called);
  const rows = all.map((p, i) => ({ p, option: options[i] })).filter(({ option }) => option !== undefined);
  const row = (/** @type {typeof rows[number]} */ { p, option }) => {
    const range = p.kind === 'flag' ? 'yes or no' : `${option?.range}${p.unit ? ` ${p.unit}` : ''}`;
    const standing = p.kind === 'flag' ? (option?.negates ? 'yes' : 'no') : String(option?.fallback ?? '');
    const acts = p.acts ? ` Acts where ${p.acts}.` : '';
    return `| ${[`\`--${option?.name}\``, `\`${p.key}\``, p.label, range, standing, `${p.help}${acts}`].map(cell).join(' | ')} |`;
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

export function optionsPage() {
  return `${[
    '# Options',
    '',
    'Every option of the command, the package, the page and the crate. They are declared once, in the crate; `npm run docs` writes this page.',
    '',
    ...chapter(
      'Pairs',
      '`tiepoint match` and `tiepoint report` take all of these; `points`, `moments` and `orient` those of their stage. In the package and the crate: `PairSettings`. ' +
        'The strategy `auto` counts as `gradient` where an option says when it acts, with the refinement `where-possible`.',
      parameters(),
      defaults(),
    ),
    ...chapter(
      'Blocks',
      '`tiepoint block`; in the package and the crate: `BlockSettings`, where `multiscale` and `gradient` stand in `features`.',
      block_parameters(),
      block_settings({}),
      BLOCK_NAMES,
    ),
    ...chapter(
      'Placing on an orthophoto',
      '`tiepoint place`, and `tiepoint block` beside `--orthophoto`, where `--points` and `--seed` are `--orthophoto-points` and `--orthophoto-seed`; in the package and the crate: `PlacingOptions`. Lengths are in the unit of the map.',
      placing_parameters(),
      { placing: placing_defaults() },
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
