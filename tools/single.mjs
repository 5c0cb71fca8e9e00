#!/usr/bin/env node
/** `npm run single -- FILE`: writes the page in one file, dist/tiepoint.html where none is named. Node alone is enough. */

import { join } from 'node:path';
import { writeSingle } from './lib/compose.mjs';
import { DIST } from './lib/paths.mjs';
import { namedOrUsage } from './lib/usage.mjs';

const USAGE = `npm run single -- [FILE]
node tools/single.mjs [FILE]

Writes the page in one file, as for a memory stick: dist/tiepoint.html where no FILE is named.

  -h, --help  prints this`;

const file = namedOrUsage(USAGE) ?? join(DIST, 'tiepoint.html');
writeSingle(file);
console.log(`The page in one file is ${file}`);
