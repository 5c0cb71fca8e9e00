#!/usr/bin/env node
/** `npm run site -- FOLDER`: writes the page for a static host, and the page in one file beside it. Node alone is enough. */

import { join } from 'node:path';
import { writeSite } from './lib/compose.mjs';
import { TARGET } from './lib/paths.mjs';
import { namedOrUsage } from './lib/usage.mjs';

const USAGE = `npm run site -- [FOLDER]
node tools/site.mjs [FOLDER]

Writes the page for a static host, and the page in one file beside it: into target/site where no FOLDER is named.

  -h, --help  prints this`;

const folder = namedOrUsage(USAGE) ?? join(TARGET, 'site');
writeSite(folder);
console.log(`The page for a static host is in ${folder}`);
