/** Variance components: blocks whose standard errors are stated right and wrong, with stated weights and with weights by the residuals. */

import { example } from './example.mjs';
import { numberOption } from './options.mjs';

export async function components() {
  console.log('Variance components of simulated blocks (native)');
  await example('variance_components', String(numberOption('seeds', 50)));
}
