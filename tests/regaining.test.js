/** A block that its worker lost, as with a run that was cancelled, is opened again, while other things are asked of the next worker: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { setTimeout as after } from 'node:timers/promises';
import { defaults } from '../pkg/node.js';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

/** What the page asked of workers of blocks, in its order.  @type {{ call: string, answer: (output: object) => void }[]} */
let asked = [];

/** Takes what the page asks, and answers when the test says so. */
class Worker {
  /** @type {(event: { data: object }) => void} */
  onmessage = () => undefined;

  /** @param {any} message */
  postMessage(message) {
    const answer = (/** @type {object} */ data) => setImmediate(() => this.onmessage({ data }));
    if ('compile' in message) answer({ compiled: {} });
    else if ('call' in message) asked.push({ call: message.call, answer: (own) => answer({ id: message.id, ...own }) });
  }

  terminate() {}
}

before(async () => {
  // Newer releases of Node have one that is not written.
  Object.defineProperty(globalThis, 'navigator', { value: { hardwareConcurrency: 2, languages: ['en'] }, configurable: true });
  Object.assign(globalThis, {
    Worker,
    window: globalThis,
    document: { getElementById: () => null, baseURI: 'http://here/', documentElement: { lang: 'en' } },
    location: { href: 'http://here/', origin: 'http://here', protocol: 'http:' },
  });
  Object.assign(page, await pageModules(['block/engine/engine', 'block/state/state', 'shared/engine/client']));
});

/** The page with a finished block that no worker holds. */
function lost() {
  asked = [];
  const shown = { edits: [{ kind: 'reject_images', images: [1] }] };
  const { BLOCK_INITIAL } = page.state;
  /** @type {{ state: any, dispatch: (action: any) => void }} */
  const store = { state: { ...BLOCK_INITIAL, shown, options: { ...BLOCK_INITIAL.options, settings: defaults().block ?? {} } }, dispatch: () => undefined };
  const engine = new page.engine.BlockEngine(store);
  engine.keepSpare(new Blob(['project']));
  return engine;
}

/** Waits until so many calls were made; gives their names.  @param {number} count */
async function calls(count) {
  for (let i = 0; i < 50; i += 1) if (asked.length < count || i < 10) await after(2);
  return asked.map(({ call }) => call);
}

test('it gets the edits that it had, and then the new one', async () => {
  const engine = lost();
  const edited = engine.edited([]);
  assert.deepEqual(await calls(1), ['blockOpen']);
  asked[0]?.answer({ output: {} });
  assert.deepEqual(await calls(2), ['blockOpen', 'blockEdited']);
  asked[1]?.answer({ output: {} });
  assert.deepEqual(await calls(3), ['blockOpen', 'blockEdited', 'blockEdited']);
  asked[2]?.answer({ output: { name: 'view' } });
  assert.deepEqual(await edited, { name: 'view' });
});

test('a run that is started before it is open again finds a block that gets none of its edits', async () => {
  const engine = lost();
  const edited = engine.edited([]).catch((/** @type {unknown} */ error) => error);
  assert.deepEqual(await calls(1), ['blockOpen']);
  const run = engine.run();
  assert.deepEqual(await calls(2), ['blockOpen', 'blockRun']);
  asked[0]?.answer({ output: {} });
  const meanwhile = await calls(2);
  // The run keeps its channel open until it ends.
  asked[1]?.answer({ failure: { kind: 'refused', code: 'c', message: 'no' } });
  await run;
  assert.deepEqual(meanwhile, ['blockOpen', 'blockRun']);
  assert.ok((await edited) instanceof page.client.Cancelled);
  // Where nothing is found the former block is opened once more.
  void engine.edited([]).catch(() => undefined);
  assert.deepEqual(await calls(3), ['blockOpen', 'blockRun', 'blockOpen']);
});
