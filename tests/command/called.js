/**
 * The command without a process of its own: a thread of the tests that takes the arguments of one call after the other, and gives what the process would
 * have ended with. The module is read and compiled once for a file of tests, not at each of its calls.
 */

import { isMainThread, parentPort, receiveMessageOnPort, MessageChannel, Worker, workerData } from 'node:worker_threads';

/** @typedef {import('./command.js').Ended} Ended */

/** Longer than any call of the tests takes: one that never ends fails, as a thread that broke down does. */
const PATIENCE_MS = 600_000;

/**
 * Starts the thread; gives what calls it.
 * @param {string} program what the command is told that it was started as @param {string} command the address of its `main` @returns {(args: string[]) => Ended}
 */
export function caller(program, command = new URL('../../pkg/command/main.js', import.meta.url).href) {
  const { port1: here, port2: there } = new MessageChannel();
  const answered = new Int32Array(new SharedArrayBuffer(4));
  const worker = new Worker(new URL(import.meta.url), { workerData: { program, command, answered, port: there }, transferList: [there] });
  // It waits for calls as long as the tests run.
  worker.unref();
  return (args) => {
    Atomics.store(answered, 0, 0);
    here.postMessage(args);
    // The tests call the command as they would start a process and wait for it.
    Atomics.wait(answered, 0, 0, PATIENCE_MS);
    const message = receiveMessageOnPort(here)?.message;
    if (message === undefined) throw new Error(`tiepoint ${args.join(' ')} did not end`);
    return message;
  };
}

async function serve() {
  const { program, command, answered, port } = workerData;
  process.argv[1] = program;
  const written = { stdout: '', stderr: '' };
  for (const stream of /** @type {const} */ (['stdout', 'stderr'])) {
    process[stream].write = (/** @type {string | Uint8Array} */ text) => {
      written[stream] += text;
      return true;
    };
  }
  const { main } = await import(command);
  let calls = 0;
  let isAnswered = true;
  /** What broke after its call was answered. */
  let late = '';
  const answer = (/** @type {number} */ code) => {
    isAnswered = true;
    port.postMessage({ code, ...written });
    Atomics.store(answered, 0, 1);
    Atomics.notify(answered, 0);
  };
  // As a process that ends by what nothing caught.
  for (const event of ['uncaughtException', 'unhandledRejection'])
    process.on(event, (/** @type {Error} */ error) => {
      const text = error?.stack ?? String(error);
      if (isAnswered) late += text;
      else {
        written.stderr += text;
        answer(1);
      }
    });
  port.on('message', async (/** @type {string[]} */ args) => {
    calls += 1;
    isAnswered = false;
    const call = calls;
    Object.assign(written, { stdout: '', stderr: late });
    // The call before it is answered already: this one fails in its place.
    if (late !== '') {
      late = '';
      answer(1);
      return;
    }
    const code = await main(args);
    // What the call left to break breaks first.
    await new Promise((resolve) => setImmediate(resolve));
    if (call === calls && !isAnswered) answer(code);
  });
}

if (!isMainThread && parentPort && workerData?.answered) await serve();
