#!/usr/bin/env node
/** `npm start`: serves the built page and prints its address. A plain checkout needs Node alone; what is missing is built. */

import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { DIST } from './lib/paths.mjs';
import { servePage } from './lib/page-server.mjs';

const USAGE = `npm start -- [--port PORT]
node tools/serve.mjs [--port PORT]

Serves the page on this machine and prints its address.

  --port PORT  0 to 65535 (default 8080); 0 takes any free port
  -h, --help   prints this`;

/** What is typed; what is no option of this ends it. */
function read() {
  try {
    return parseArgs({ options: { port: { type: 'string', default: '8080' }, help: { type: 'boolean', short: 'h' } } }).values;
  } catch (error) {
    console.error(`${error instanceof Error ? error.message : String(error)}\n\n${USAGE}`);
    process.exit(2);
  }
}

const values = read();
if (values.help === true) {
  console.log(USAGE);
  process.exit(0);
}
const port = Number(values.port);
if (!Number.isInteger(port) || port < 0 || port > 65535) {
  console.error(`--port is ${values.port}; allowed: 0 to 65535 (0 takes any free port)`);
  process.exit(2);
}

try {
  if (!existsSync(join(DIST, 'index.html'))) {
    console.log('dist/ is missing: building it');
    const { buildMissing } = await import('./build.mjs');
    await buildMissing();
  }
  const { url } = await servePage({ port });
  console.log(`Tiepoint is at ${url} (Ctrl+C ends it)`);
} catch (error) {
  console.error(error instanceof Error ? error.message : String(error));
  process.exitCode = 1;
}
