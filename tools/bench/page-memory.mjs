/** What a page takes: memory of its wasm modules and heaps, as its own debugger sees them; memory and processor time of its process. */

import { existsSync, readFileSync } from 'node:fs';

/** @typedef {import('playwright-core').Page} Page @typedef {import('playwright-core').Browser} Browser */

const MEBIBYTE = 2 ** 20;

/** Wasm memory never shrinks, so that what it takes at the end is its peak. */
const WASM_BYTES = 'function () { return this.reduce((sum, memory) => sum + memory.buffer.byteLength, 0); }';

/**
 * Watches a page and its workers from now on.
 * @param {Page} page
 * @returns {Promise<() => Promise<{ wasm: number, heaps: number }>>} tells the MiB of all wasm memories, and of all heaps with the buffers they hold
 */
export async function watchMemory(page) {
  const session = await page.context().newCDPSession(page);
  /** @type {Set<string>} */
  const workers = new Set();
  /** @type {Map<number, (message: any) => void>} */
  const waiting = new Map();
  let last = 0;
  session.on('Target.attachedToTarget', ({ sessionId }) => workers.add(sessionId));
  session.on('Target.detachedFromTarget', ({ sessionId }) => workers.delete(sessionId));
  session.on('Target.receivedMessageFromTarget', ({ message }) => {
    const answer = JSON.parse(message);
    waiting.get(answer.id)?.(answer);
  });
  await session.send('Target.setAutoAttach', { autoAttach: true, waitForDebuggerOnStart: false, flatten: false });
  /** @type {(sessionId: string) => (method: string, params?: object) => Promise<any>} */
  const worker =
    (sessionId) =>
    (method, params = {}) =>
      new Promise((resolve, reject) => {
        const id = ++last;
        waiting.set(id, ({ result, error }) => {
          waiting.delete(id);
          if (error) reject(new Error(`${method}: ${error.message}`));
          else resolve(result);
        });
        session.send('Target.sendMessageToTarget', { sessionId, message: JSON.stringify({ id, method, params }) }).catch(reject);
      });
  const own = (/** @type {string} */ method, params = {}) => session.send(/** @type {any} */ (method), params);
  return async () => {
    /** @type {{ wasm: number, heaps: number }[]} */
    const parts = [];
    for (const send of [own, ...[...workers].map(worker)]) parts.push(await memoryOf(send));
    const sum = (/** @type {'wasm' | 'heaps'} */ key) => parts.reduce((total, part) => total + part[key], 0) / MEBIBYTE;
    return { wasm: sum('wasm'), heaps: sum('heaps') };
  };
}

/** @param {(method: string, params?: object) => Promise<any>} send */
async function memoryOf(send) {
  const { result: prototype } = await send('Runtime.evaluate', { expression: 'WebAssembly.Memory.prototype' });
  const { objects } = await send('Runtime.queryObjects', { prototypeObjectId: prototype.objectId });
  const { result: bytes } = await send('Runtime.callFunctionOn', { objectId: objects.objectId, functionDeclaration: WASM_BYTES, returnByValue: true });
  const { usedSize, backingStorageSize = 0 } = await send('Runtime.getHeapUsage');
  return { wasm: Number(bytes.value), heaps: usedSize + backingStorageSize };
}

/**
 * The process that holds the page, in which its workers run too: seconds of processor time so far, and the most MiB that it has ever held,
 * NaN where the system does not tell.
 * @param {Browser} browser @returns {Promise<{ seconds: number, peak: number }>}
 */
export async function processOfPage(browser) {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  await session.detach();
  const found = processInfo.filter(({ type }) => type === 'renderer').map(({ id, cpuTime }) => ({ seconds: cpuTime, peak: peakOf(id) }));
  // The browser keeps a spare one or two, which do and hold little.
  return found.reduce((most, one) => (one.seconds > most.seconds ? one : most), { seconds: 0, peak: NaN });
}

/** @param {number} process @returns {number} MiB */
function peakOf(process) {
  const file = `/proc/${process}/status`;
  return existsSync(file) ? Number(/VmHWM:\s+(\d+) kB/.exec(readFileSync(file, 'utf8'))?.[1] ?? NaN) / 1024 : NaN;
}
