/** Blocks of rendered photos beside their truth: whether standard errors hold the errors that matches share. */

import { join } from 'node:path';
import { ROOT } from '../lib/paths.mjs';
import { example } from './example.mjs';
import { numberOption } from './options.mjs';

/** Photos and rays are kept there: an adjustment that was changed is judged without rendering and matching anew. */
const KEPT = join(ROOT, 'target', 'rendered-blocks');

export async function rendered() {
  const [seeds, from] = [String(numberOption('seeds', 3)), String(numberOption('from', 4))];
  for (const shared of [['--shared', '0'], []]) {
    console.log(`Blocks of rendered photos beside their truth (native), ${shared.length > 0 ? 'independent errors' : 'with shared errors'}`);
    await example('rendered_blocks', KEPT, seeds, '--from', from, ...shared);
  }
}
