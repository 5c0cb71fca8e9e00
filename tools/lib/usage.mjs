/** What is typed behind a program that takes a path, or nothing, and no options but `--help`. */

import { parseArgs } from 'node:util';

/**
 * The path that is named; null where none is. Prints `usage` and ends where it is asked for; ends with 2 and both where there is something else.
 * @param {string} usage @param {number} most as many paths are allowed
 */
export function namedOrUsage(usage, most = 1) {
  const { help, path } = read(usage, most);
  if (!help) return path;
  console.log(usage);
  process.exit(0);
}

/** @param {string} usage @param {number} most */
function read(usage, most) {
  try {
    const { values, positionals } = parseArgs({ options: { help: { type: 'boolean', short: 'h' } }, allowPositionals: true });
    if (positionals.length > most) throw new Error(`got ${positionals.join(' ')}; allowed: ${most === 0 ? 'nothing' : 'one path'}`);
    return { help: values.help === true, path: positionals[0] ?? null };
  } catch (error) {
    console.error(`${error instanceof Error ? error.message : String(error)}\n\n${usage}`);
    process.exit(2);
  }
}
