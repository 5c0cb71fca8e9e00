#!/usr/bin/env node
/** `npm run single -- FILE`: writes the page in one file, dist/tiepoint.html where none is named. Node alone is enough. */

import { join } from 'node:path';
import { writeSingle } from './lib/compose.mjs';
import { DIST } from './lib/paths.mjs';

const file = process.argv[2] ?? join(DIST, 'tiepoint.html');
writeSingle(file);
console.log(`The page in one file is ${file}`);
