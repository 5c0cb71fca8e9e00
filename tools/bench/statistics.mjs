/** Whether intervals hold the truth and errors of the detectable size are found, for any number of points and kind of gross errors. */

import { must } from '../lib/process.mjs';
import { cargo, ensureToolchain } from '../lib/rust.mjs';

export async function statistics() {
  console.log('Statistics of few and many points (simulated sets of observations)');
  const toolchain = await ensureToolchain();
  const args = ['test', '--locked', '--release', '--test', 'integration', 'orientation::coverage', '--', '--nocapture', '--test-threads=1'];
  const text = await must(...cargo(toolchain, args), { env: { TIEPOINT_STATISTICS: 'full' }, quiet: true });
  for (const line of text.split('\n')) if (/intervals, |power at /.test(line)) console.log(`  ${line.replace(/^test .* \.\.\. /, '')}`);
}
