#!/usr/bin/env node
/** `npm run site -- FOLDER`: writes the page for a static host, and the page in one file beside it. Node alone is enough. */

import { join } from 'node:path';
import { writeSite } from './lib/compose.mjs';
import { TARGET } from './lib/paths.mjs';

const folder = process.argv[2] ?? join(TARGET, 'site');
writeSite(folder);
console.log(`The page for a static host is in ${folder}`);
