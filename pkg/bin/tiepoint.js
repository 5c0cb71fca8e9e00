#!/usr/bin/env node
// @ts-check
/** The `tiepoint` command. Exit codes: 0 done, 1 bad data, 2 a bad call. */

import { main } from '../command/main.js';

// A reader that has seen enough (`| head`) is no error.
process.stdout.on('error', (/** @type {NodeJS.ErrnoException} */ error) => {
  if (error.code !== 'EPIPE') throw error;
  process.exit(0);
});

process.exitCode = main(process.argv.slice(2));
