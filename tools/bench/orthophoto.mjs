/** Blocks in the system of an orthophoto of which much has changed, beside their truth, and photos of other towns, none of which may be placed; blocks on heights that are off; single photos of several kinds. */

import { example } from './example.mjs';
import { numberOption } from './options.mjs';

export async function orthophoto() {
  console.log('Simulated blocks on an orthophoto years later (native, two threads)');
  await example('orthophoto_block', '1', String(numberOption('seeds', 3)));
  console.log('Simulated blocks with precise GNSS positions, on heights that are off (native, two threads)');
  await example('orthophoto_heights', '1', String(numberOption('seeds', 3)));
  console.log('Single photos, vertical, oblique and on film, on an orthophoto years later (native, one thread)');
  // Seeds 1 and 2 set what standard errors hold of heights.
  await example('placing_kinds', '3', String(numberOption('seeds', 3)));
}
