// @ts-check
/** What a call of the module ended with, where it was no refusal: memory that ran out, or a fault of the program. */

import { plainError } from './wire.js';

/**
 * Of an error, or its plain form, by its name and message. A module that gets no memory ends in `unreachable`, and a host that has
 * none throws a RangeError. Any other trap is a fault, as are panics, stacks that overflow and workers that end; null for other errors.
 * @param {unknown} error @returns {'memory' | 'fault' | null}
 */
export function breakdownOf(error) {
  const { name, message } = plainError(error);
  switch (name) {
    case 'RuntimeError':
      return /unreachable/i.test(message) ? 'memory' : 'fault';
    case 'RangeError':
      return /call stack/i.test(message) ? 'fault' : 'memory';
    case 'WorkerError':
      return /memory/i.test(message) ? 'memory' : 'fault';
    case 'Panic':
      return 'fault';
    default:
      return null;
  }
}
