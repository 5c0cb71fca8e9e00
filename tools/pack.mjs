#!/usr/bin/env node
/** What `npm pack` asks before it packs pkg/: the documents for those who use the package, which are tracked in docs/ alone, and the links to them. */

import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { ROOT } from './lib/paths.mjs';

const USAGE = `node tools/pack.mjs [--remove]

Writes the documents of the package into pkg/docs, and has its README lead there, before it is packed.

  --remove    takes both back, after it was packed
  -h, --help  prints this`;

/** The document for JavaScript, and those to which it leads. */
const DOCUMENTS = ['javascript.md', 'command.md', 'options.md', 'conventions.md', 'blocks.md', 'placing.md', 'epipolar.md', 'project.md'];

const FOLDER = join(ROOT, 'pkg', 'docs');
const README = join(ROOT, 'pkg', 'README.md');

/** Where the links of the README lead, in the checkout and in the package. */
const LINKS = ['](../docs/', '](docs/'];

/** The command as the documents call it, and as it is called where the package is installed. */
const [COMMAND, INSTALLED] = ['node pkg/bin/tiepoint.js', 'npx tiepoint'];

/** What stands below the title of documents with such commands. */
const NOTE = "Commands that begin with `npm run` or `cargo run` need the project's own repository.";

/** A link to what is not packed becomes its text, and commands are those of the installed package.  @param {string} text */
const within = (text) =>
  (/`(?:npm|cargo) run /.test(text) ? text.replace('\n', `\n\n${NOTE}\n`) : text)
    .replace(/\[([^\]]+)\]\(([^)#\s]+\.(?:md|html|png))(?:#[^)]*)?\)/g, (link, words, file) => (DOCUMENTS.includes(file) ? link : words))
    .replaceAll(COMMAND, INSTALLED);

const { values } = parseArgs({ options: { remove: { type: 'boolean' }, help: { type: 'boolean', short: 'h' } } });
if (values.help) console.log(USAGE);
else {
  const [from = '', to = ''] = values.remove ? LINKS.toReversed() : LINKS;
  writeFileSync(README, readFileSync(README, 'utf8').replaceAll(from, to));
  rmSync(FOLDER, { recursive: true, force: true });
  if (!values.remove) {
    mkdirSync(FOLDER, { recursive: true });
    for (const name of DOCUMENTS) writeFileSync(join(FOLDER, name), within(readFileSync(join(ROOT, 'docs', name), 'utf8')));
  }
}
