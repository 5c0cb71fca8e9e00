/** Running other programs. */

import { spawn } from 'node:child_process';
import { ROOT } from './paths.mjs';

/**
 * @typedef {object} RunOptions
 * @property {Record<string, string>} [env] added to this process's environment
 * @property {string} [cwd] the project's root unless told
 * @property {boolean} [quiet] only collect the output; otherwise show it as it comes, too
 * @typedef {{ code: number, output: string, answer: string }} RunResult output: stdout and stderr in the order they came; answer: stdout alone
 */

/**
 * Runs a program to its end; a program that is not there gives code 127.
 * @param {string} command @param {string[]} args @param {RunOptions} [options] @returns {Promise<RunResult>}
 */
export function run(command, args, { env = {}, cwd = ROOT, quiet = false } = {}) {
  return new Promise((resolve) => {
    const child = spawn(command, args, { cwd, env: { ...process.env, ...env }, stdio: ['ignore', 'pipe', 'pipe'] });
    let [output, answer] = ['', ''];
    /** @param {NodeJS.WriteStream} to */
    const collect = (to) => (/** @type {string} */ chunk) => {
      output += chunk;
      if (to === process.stdout) answer += chunk;
      if (!quiet) to.write(chunk);
    };
    // A character may come in two pieces.
    child.stdout.setEncoding('utf8').on('data', collect(process.stdout));
    child.stderr.setEncoding('utf8').on('data', collect(process.stderr));
    child.on('error', (error) => resolve({ code: 127, output: `${command}: ${error.message}`, answer: '' }));
    child.on('close', (code) => resolve({ code: code ?? 1, output, answer }));
  });
}

/**
 * Runs a program that must succeed; the error carries the end of what it wrote.
 * @param {string} command @param {string[]} args @param {RunOptions} [options] @returns {Promise<string>} its output
 */
export async function must(command, args, options = {}) {
  return (await succeeded(command, args, options)).output;
}

/**
 * Asks a program that must succeed: what it answers, without what it says beside that, such as that it waits or downloads.
 * @param {string} command @param {string[]} args @returns {Promise<string>}
 */
export async function asked(command, args) {
  return (await succeeded(command, args, { quiet: true })).answer;
}

/** @param {string} command @param {string[]} args @param {RunOptions} options @returns {Promise<RunResult>} */
async function succeeded(command, args, options) {
  const result = await run(command, args, options);
  const { code, output } = result;
  if (code === 0) return result;
  const tail = options.quiet ? `\n${output.trimEnd().split('\n').slice(-100).join('\n')}` : '';
  throw new Error(`${command} ${args.join(' ')} ended with ${code}${tail}`);
}
