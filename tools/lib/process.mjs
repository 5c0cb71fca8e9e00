/** Running other programs. */

import { spawn } from 'node:child_process';
import { ROOT } from './paths.mjs';

/**
 * @typedef {object} RunOptions
 * @property {Record<string, string>} [env] added to this process's environment
 * @property {string} [cwd] the project's root unless told
 * @property {boolean} [quiet] only collect the output; otherwise show it as it comes, too
 * @typedef {{ code: number, output: string }} RunResult output: stdout and stderr in the order they came
 */

/**
 * Runs a program to its end; a program that is not there gives code 127.
 * @param {string} command @param {string[]} args @param {RunOptions} [options] @returns {Promise<RunResult>}
 */
export function run(command, args, { env = {}, cwd = ROOT, quiet = false } = {}) {
  return new Promise((resolve) => {
    const child = spawn(command, args, { cwd, env: { ...process.env, ...env }, stdio: ['ignore', 'pipe', 'pipe'] });
    let output = '';
    /** @param {NodeJS.WriteStream} to */
    const collect = (to) => (/** @type {Buffer} */ chunk) => {
      output += chunk;
      if (!quiet) to.write(chunk);
    };
    child.stdout.on('data', collect(process.stdout));
    child.stderr.on('data', collect(process.stderr));
    child.on('error', (error) => resolve({ code: 127, output: `${command}: ${error.message}` }));
    child.on('close', (code) => resolve({ code: code ?? 1, output }));
  });
}

/**
 * Runs a program that must succeed; the error carries the end of what it wrote.
 * @param {string} command @param {string[]} args @param {RunOptions} [options] @returns {Promise<string>} its output
 */
export async function must(command, args, options = {}) {
  const { code, output } = await run(command, args, options);
  if (code === 0) return output;
  const tail = options.quiet ? `\n${output.trimEnd().split('\n').slice(-100).join('\n')}` : '';
  throw new Error(`${command} ${args.join(' ')} ended with ${code}${tail}`);
}
