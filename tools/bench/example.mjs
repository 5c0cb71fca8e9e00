/** Examples of the crate, run natively and optimised. */

import { run } from '../lib/process.mjs';
import { cargo, ensureToolchain } from '../lib/rust.mjs';

/** Runs an example and prints what it prints, indented.  @param {string} name @param {string[]} args */
export async function example(name, ...args) {
  const toolchain = await ensureToolchain();
  const { code, output } = await run(...cargo(toolchain, ['run', '--release', '--locked', '--quiet', '--example', name, '--', ...args]), { quiet: true });
  if (code !== 0) throw new Error(`the example ${name} ended with ${code}\n${output.slice(-2000)}`);
  console.log(
    output
      .trimEnd()
      .split('\n')
      .map((line) => `  ${line}`)
      .join('\n'),
  );
}
