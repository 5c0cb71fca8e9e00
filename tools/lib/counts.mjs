/** Reads how many tests passed from what the test programs print. */

/** @typedef {import('./steps.mjs').Outcome} Outcome */

/**
 * Cargo's tests, native or under wasm-bindgen's runner. A test that cannot run prints `skipped: what (why)` and passes; it counts as skipped.
 * @param {string} output @param {number} code of the program @returns {Outcome}
 */
export function cargoCounts(output, code) {
  let [passed, failed, skipped] = [0, 0, 0];
  for (const [, p, f, i] of output.matchAll(/test result: \w+\. (\d+) passed; (\d+) failed; (\d+) ignored/g)) {
    passed += Number(p);
    failed += Number(f);
    skipped += Number(i);
  }
  const skips = [...new Set([...output.matchAll(/^\s*skipped: (.+)$/gm)].map(([, what]) => (what ?? '').trim()))];
  const told = skips.length;
  return finish({ passed: Math.max(0, passed - told), failed, skipped: skipped + told, skips }, code);
}

/**
 * Node's test runner with its TAP reporter.
 * @param {string} output @param {number} code @returns {Outcome}
 */
export function tapCounts(output, code) {
  const count = (/** @type {string} */ name) => Number(new RegExp(`^# ${name} (\\d+)$`, 'm').exec(output)?.[1] ?? 0);
  const skips = [...output.matchAll(/^\s*ok \d+ - (.+?) # SKIP ?(.*)$/gm)].map(([, name, why]) => `${name}${why ? ` (${why})` : ''}`);
  return finish({ passed: count('pass'), failed: count('fail') + count('cancelled'), skipped: count('skipped') + count('todo'), skips }, code);
}

/** A program that failed without a failed test, or that ran none, failed.  @param {Outcome} outcome @param {number} code @returns {Outcome} */
function finish(outcome, code) {
  if (code !== 0 && !outcome.failed) return { ...outcome, failed: 1, note: `the program ended with ${code}` };
  if (code === 0 && !outcome.passed && !outcome.skipped) return { ...outcome, failed: 1, note: 'no test ran' };
  return outcome;
}
