// @ts-check
/** The exit codes, and the two ways a command fails, each reported in one line. */

import { breakdownOf } from '../block/index.js';

/**
 * 0 done, 1 bad data, 2 a usage error, 3 done with a weak orientation, 4 done without one.
 * @typedef {0 | 1 | 2 | 3 | 4} ExitCode
 */

/**
 * The exit code of each verdict on a pair, a block or a placed image.
 * @type {Record<(import('../node.js').PairVerdict | import('../node.js').BlockVerdict | import('../node.js').PlacingVerdict)['kind'], ExitCode>}
 */
export const VERDICT_CODES = { oriented: 0, placed: 0, weak: 3, not_oriented: 4, not_placed: 4 };

/** A usage error: exit code 2. */
export class UsageError extends Error {}

/** Bad data: exit code 1. */
export class DataError extends Error {}

/**
 * What the crate threw, where it refused something.
 * @typedef {Error & { code: string, usage: boolean, error: { kind: string } }} Refusal
 * @param {unknown} error @returns {error is Refusal}
 */
export const isRefusal = (error) => error instanceof Error && error.name === 'TiepointError';

/**
 * Calls the crate with what a file holds; its refusals then name the file and count as bad data.
 * @template T @param {string} path @param {() => T} call @returns {T}
 */
export function about(path, call) {
  try {
    return call();
  } catch (error) {
    if (isRefusal(error)) throw new DataError(`${path}: ${error.message}`);
    throw error;
  }
}

/**
 * Calls the crate with what an option gives; its refusals then name the option and are usage errors.
 * @template T @param {string} name @param {() => T} call @returns {T}
 */
export function ofOption(name, call) {
  try {
    return call();
  } catch (error) {
    if (isRefusal(error)) throw new UsageError(`--${name}: ${error.message}`);
    throw error;
  }
}

/**
 * The line and the exit code of an error.
 * @param {unknown} error @param {(message: string) => string} rename gives settings their option names
 * @returns {{ line: string, code: 1 | 2 }}
 */
export function explain(error, rename) {
  const message = error instanceof Error ? error.message : String(error);
  if (error instanceof UsageError) return { line: message, code: 2 };
  if (isRefusal(error)) return { line: rename(message), code: error.usage ? 2 : 1 };
  if (error instanceof DataError) return { line: message, code: 1 };
  switch (breakdownOf(error)) {
    case 'memory':
      return { line: `there is not enough memory for this (${message}): reduce the images`, code: 1 };
    case 'fault':
      return { line: `the computation broke off at a fault of the program (${message}): please report it`, code: 1 };
    default:
      return { line: `unexpected: ${message}`, code: 1 };
  }
}

/** One line, whatever the message holds.  @param {string} text */
export const oneLine = (text) => text.replace(/\s*\n\s*/g, ' ').trim();
