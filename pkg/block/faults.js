// @ts-check
/** What a call of the module ended with, where it was no refusal: memory that ran out, or a fault of the program. */

/**
 * Of an error by its name and message, which pass between workers. A module that gets no memory ends in `unreachable`, and a host that has
 * none throws a RangeError. Any other trap is a fault, as are panics, stacks that overflow and workers that end; null for other errors.
 * @param {unknown} error @returns {'memory' | 'fault' | null}
 */
export function breakdownOf(error) {
  const { name, message } = error instanceof Error ? error : { name: '', message: '' };
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
