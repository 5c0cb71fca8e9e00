/** Blocks in the system of an orthophoto of which much has changed, beside their truth; photos of other towns, none of which may be placed. */

import { example } from './example.mjs';
import { numberOption } from './options.mjs';

export async function orthophoto() {
  console.log('Simulated blocks on an orthophoto years later (native, two threads)');
  await example('orthophoto_block', '1', String(numberOption('seeds', 3)));
}
