/** Whether the statistics of the orientation can be believed: the figures of the studies that the tests hold to their bounds. */

import { flight_preset, match_pair, Photo, simulate } from '../../pkg/node.js';
import { must } from '../lib/process.mjs';
import { cargo, ensureToolchain } from '../lib/rust.mjs';

export async function calibration() {
  console.log('Calibration (simulated sets of observations)');
  const toolchain = await ensureToolchain();
  const tests = [
    '--test',
    'integration',
    '--',
    'orientation::',
    'adjustment::',
    'reconstruction::',
    'confidence::',
    'gnss_errors::',
    'control_errors::',
    'geometry::',
    'scaled_pair::',
  ];
  const env = { TIEPOINT_STATISTICS: 'full' };
  const text = await must(...cargo(toolchain, ['test', '--locked', '--release', ...tests, '--nocapture', '--test-threads=1']), { env, quiet: true });
  for (const line of text.split('\n'))
    if (
      /variance of |w-tests|blunders|global tests|observations, α|positions \d|ellipsoids: |by chance|offsets and drifts|lever arm |offsets beside/.test(line)
    )
      console.log(`  ${line.replace(/^test .* \.\.\. /, '')}`);
  for (const strategy of /** @type {const} */ (['moments', 'correlation', 'least-squares'])) images(strategy);
}

const FLIGHTS = 16;
const NAMES = /** @type {const} */ (['omega_deg', 'phi_deg', 'kappa_deg', 'by_mm', 'bz_mm']);

/** The errors of whole runs over rendered towns, by their standard errors.  @param {import('../../pkg/node.js').Strategy} strategy */
function images(strategy) {
  const sums = { own: [0, 0, 0, 0, 0], total: [0, 0, 0, 0, 0] };
  for (let seed = 41; seed < 41 + FLIGHTS; seed++) {
    const made = simulate({ ...flight_preset('sample'), seed });
    const [left, right] = [made.left, made.right].map((p) => Photo.from_grey(p.width, p.height, p.grey));
    if (!left || !right) throw new Error('a pair has two images');
    const photo = (/** @type {'left' | 'right'} */ side) => ({ fiducials: made[`${side}_fiducials`], origin: made[`${side}_origin`] });
    const input = { camera: made.camera, left: photo('left'), right: photo('right') };
    const { orientation } = match_pair(left, right, input, { matching: { strategy }, orientation: { base_mm: made.base_mm } });
    left.free();
    right.free();
    for (const [k, name] of NAMES.entries()) {
      const error = (orientation?.[name] ?? NaN) - made.truth[name];
      for (const [kind, of] of /** @type {const} */ ([
        ['own', orientation?.standard_errors],
        ['total', orientation?.total_standard_errors],
      ])) {
        sums[kind][k] = (sums[kind][k] ?? NaN) + (error / (of?.[name] ?? NaN)) ** 2 / FLIGHTS;
      }
    }
  }
  const text = (/** @type {number[]} */ v) => v.map((x) => x.toFixed(2)).join(' ');
  console.log(
    `  images, ${strategy}, ${FLIGHTS} towns: mean square of error / standard error of ω φ κ by bz, of the matches alone ${text(sums.own)}, total ${text(sums.total)}`,
  );
}
