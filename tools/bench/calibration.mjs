/** Whether the statistics of the orientation can be believed: the figures of the studies that the tests hold to their bounds. */

import { must } from '../lib/process.mjs';
import { cargo, ensureToolchain } from '../lib/rust.mjs';

export async function calibration() {
  console.log('Calibration (simulated sets of observations)');
  const toolchain = await ensureToolchain();
  const text = await must(...cargo(toolchain, ['test', '--locked', '--release', '--test', 'orientation', '--', '--nocapture', '--test-threads=1']), { quiet: true });
  for (const line of text.split('\n')) if (/variance of error|w-tests|blunders|global tests/.test(line)) console.log(`  ${line.replace(/^test .* \.\.\. /, '')}`);
}
