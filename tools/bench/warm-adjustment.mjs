/** A program of its own: milliseconds that a relative orientation takes once its code is compiled, by the package of a checkout. Arguments: the checkout, a table of observations. */

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { median } from './median.mjs';

/** Of these the first half compiles it. */
const RUNS = 60;

const [checkout = '', table = ''] = process.argv.slice(2);
const { orient_relative, parse_observations } = await import(pathToFileURL(join(checkout, 'pkg', 'node.js')).href);
const observations = parse_observations(readFileSync(table, 'utf8'));
const times = Array.from({ length: RUNS }, () => {
  const start = performance.now();
  orient_relative(observations, 153, {});
  return performance.now() - start;
});
console.log(median(times.slice(RUNS / 2)));
