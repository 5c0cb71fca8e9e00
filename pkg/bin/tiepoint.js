#!/usr/bin/env node
// @ts-check
/** The `tiepoint` command. Exit codes: 0 done, 1 bad data, 2 a usage error; of match, orient, report, block, edit and place also 3 weak, 4 not oriented. */

import { reasonOf } from '../command/files.js';
import { main } from '../command/main.js';

process.stdout.on('error', (/** @type {NodeJS.ErrnoException} */ error) => {
  // A reader that has seen enough (`| head`) is no error.
  if (error.code === 'EPIPE') process.exit(0);
  process.stderr.write(`tiepoint: cannot write the output: ${reasonOf(error)}\n`);
  process.exit(1);
});

process.exitCode = await main(process.argv.slice(2));
