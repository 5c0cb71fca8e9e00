/** A project is left for another one while files are read, beside a banner about another project, or twice at once: nothing is lost, and nothing lands in the wrong one. Without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

/** What was asked of the user. @type {string[]} */
const asked = [];

before(async () => {
  const listen = () => undefined;
  const confirm = (/** @type {string} */ text) => asked.push(text) === 0;
  Object.assign(globalThis, {
    BroadcastChannel: undefined,
    document: { addEventListener: listen },
    window: { addEventListener: listen, confirm, setTimeout, clearTimeout },
  });
  Object.defineProperty(globalThis, 'navigator', { value: { languages: ['en'] }, configurable: true });
  Object.assign(
    page,
    await pageModules(['shared/files/keeper', 'shared/files/leaving', 'pair/files/open', 'pair/state/reducer', 'pair/state/state', 'block/files/files']),
  );
});

/** A promise that ends when it is told to. */
function gate() {
  let open = () => {};
  const opened = new Promise((resolve) => {
    open = () => resolve(undefined);
  });
  return { open, opened };
}

/** A page of one part, which shows a text, with the projects that it keeps. `slow`: reading waits for it. */
async function keeping(slow = Promise.resolve()) {
  /** @type {Map<string, { row: any, parts: Map<string, any> }>} */
  const kept = new Map();
  const database = {
    projects: async () => [...kept.values()].map(({ row }) => row),
    project: async (/** @type {string} */ id) => kept.get(id)?.row,
    parts: async (/** @type {string} */ id) => new Map(kept.get(id)?.parts),
    watch: () => undefined,
    claim: async (/** @type {string} */ id, /** @type {string} */ writer) => Object.assign(kept.get(id)?.row, { writer }),
    write: async (/** @type {any} */ row, /** @type {any} */ { put, drop }) => {
      const parts = kept.get(row.id)?.parts ?? new Map();
      for (const [part, { value }] of put) parts.set(part, value);
      for (const part of drop) parts.delete(part);
      kept.set(row.id, { row, parts });
    },
  };
  /** @type {{ text: string } | null} */
  let shown = null;
  const keepable = {
    mode: 'pair',
    watch: () => undefined,
    images: () => (shown === null ? [] : [shown.text]),
    parts: () => new Map(shown === null ? [] : [['pair', { value: shown, bytes: 1 }]]),
    read: async (/** @type {Map<string, any>} */ parts) => {
      await slow;
      return () => {
        shown = parts.get('pair') ?? null;
      };
    },
    clear: () => {
      shown = null;
    },
  };
  const keeper = new page.keeper.Keeper([keepable], { now: () => 'pair', show: () => undefined, watch: () => undefined });
  await keeper.start(Promise.resolve(database), async () => {});
  const show = (/** @type {string} */ text) => {
    shown = { text };
  };
  const texts = () => [...kept.values()].map(({ parts }) => parts.get('pair')?.text);
  return { keeper, keepable, show, shown: () => shown?.text, texts };
}

test('a part stays under Projects beside what is said of another project, and not where it is not kept itself', async () => {
  for (const [kind, stays] of Object.entries({
    elsewhere: true,
    unreadable: true,
    'broke-off': true,
    absent: false,
    full: false,
    failed: false,
    reading: false,
    taken: false,
  })) {
    const { keeper, keepable, show, texts } = await keeping();
    show('first');
    await keeper.flush();
    keeper.keeping.dispatch({ trouble: { kind, reason: '', project: { id: 'another', title: 'another' } } });
    assert.equal(await keeper.putAside(keepable), stays, kind);
    if (!stays) continue;
    show('second');
    await keeper.flush();
    assert.deepEqual(texts(), ['first', 'second'], kind);
  }
});

test('New while a kept project is being opened waits for it, and shows nothing of it', async () => {
  const reading = gate();
  const { keeper, show, shown, texts } = await keeping(reading.opened);
  show('first');
  await keeper.flush();
  const { project } = keeper.keeping.state;
  await keeper.anew();
  show('second');
  const opened = keeper.open(project);
  const begun = keeper.anew();
  reading.open();
  await Promise.all([opened, begun]);
  assert.equal(shown(), undefined);
  assert.notEqual(keeper.keeping.state.project, project);
  show('third');
  await keeper.flush();
  assert.deepEqual(texts(), ['first', 'second', 'third']);
});

test('what was given before New, or before another project is opened, comes too late; not where that cannot be opened', async () => {
  const { keeper, show } = await keeping();
  show('first');
  await keeper.flush();
  const { project } = keeper.keeping.state;
  const given = await keeper.left();
  await keeper.open('none');
  given();
  const begun = keeper.anew();
  const next = keeper.left();
  await begun;
  assert.throws(given, page.leaving.ProjectLeft);
  const later = await next;
  later();
  await keeper.open(project);
  assert.throws(later, page.leaving.ProjectLeft);
});

test('who waits until one way of leaving has ended goes on before the next one begins', async () => {
  const leaving = new page.leaving.Leaving();
  /** @type {string[]} */
  const order = [];
  const through = async (/** @type {number} */ deep) => {
    if (deep > 0) await through(deep - 1);
    else await leaving.inTurn(async () => order.push('put aside'));
  };
  const first = through(10).then(() => order.push('went on'));
  await Promise.all([first, leaving.inTurn(async () => order.push('left'))]);
  assert.deepEqual(order, ['put aside', 'went on', 'left']);
});

test('what is to be done with a project that is being left is nothing for the next one, and goes on where that cannot be opened', async () => {
  const { keeper, show } = await keeping();
  show('first');
  await keeper.flush();
  const begun = keeper.anew();
  await assert.rejects(keeper.stays(), page.leaving.ProjectLeft);
  await begun;
  const opened = keeper.open('none');
  const here = await keeper.stays();
  await opened;
  here();
  void keeper.anew();
  /** @type {string[]} */
  const done = [];
  await page.leaving.doHere(
    () => keeper.stays(),
    async () => done.push('not here'),
  );
  assert.deepEqual(done, []);
});

/**
 * The files of a pair, beside a blank one, whose images and masks are read when `reading` is over. `stays`: whether a pair can stay in the list.
 * @param {Promise<unknown>} reading
 */
function pairFiles(reading, stays = true) {
  const leaving = new page.leaving.Leaving();
  const store = {
    state: page.reducer.reduce(page.state.INITIAL, { type: 'ready', catalogue: { version: '', defaults: {}, flights: [], rules: [] } }),
    dispatch: (/** @type {any} */ action) => {
      store.state = page.reducer.reduce(store.state, action);
    },
  };
  /** @type {string[]} */
  const calls = [];
  const called = async (/** @type {string} */ call) => {
    calls.push(call);
    await reading;
    return call === 'parseFiducials' ? [] : { width: 1, height: 1, leftOut: 0, left: {}, right: {} };
  };
  const engine = { open: () => called('open').then(() => ({ info: { width: 1, height: 1 } })), client: () => ({ call: called }) };
  const none = () => Promise.reject(new Error('not asked'));
  const files = new page.open.Files(store, engine, none, { toBlock: none, toGround: none, left: () => leaving.left() }, async () => stays);
  /** As New does it. */
  const anew = () =>
    leaving.inTurn(async () => {
      leaving.leave();
      store.dispatch({ type: 'cleared' });
    });
  return { files, store, leaving, anew, calls };
}

const file = (/** @type {string} */ name) => new File([name], name, { lastModified: 1 });
const MASK = { id: 9, name: 'mask.png', source: { kind: 'file', file: new Blob([]) }, width: 1, height: 1, grey: new Uint8Array(1), leftOut: 1, overlay: null };

/** Two images, with a mask: worth keeping.  @param {any} store */
function open(store) {
  const image = (/** @type {number} */ id) => ({ id, name: `${id}.jpg`, source: { kind: 'file', file: file(`${id}.jpg`) } });
  store.dispatch({ type: 'images', images: { left: image(1), right: image(2) } });
  store.dispatch({ type: 'mask', side: 'left', mask: MASK });
}

const namesIn = (/** @type {any} */ { state }) => [state.images.left?.name, state.images.right?.name];

test('files that are still being read when New is pressed are not of the new project, which says so', async () => {
  for (const [give, said] of /** @type {[(files: any) => Promise<void>, RegExp][]} */ ([
    [(files) => files.take([file('a.jpg'), file('b.jpg')], null), /^a\.jpg, b\.jpg were not taken: the project was left before they were read\.$/],
    [(files) => files.takeMask(file('mask.png'), 'left'), /^mask\.png was not taken: /],
    [(files) => files.takeFlight('sample', {}), /^sample left, sample right were not taken: /],
  ])) {
    const reading = gate();
    const { files, store, anew, calls } = pairFiles(reading.opened);
    open(store);
    const given = give(files);
    while (calls.length === 0) await new Promise((resolve) => setTimeout(resolve));
    const begun = anew();
    reading.open();
    await Promise.all([given, begun]);
    assert.deepEqual(namesIn(store), [undefined, undefined]);
    assert.equal(store.state.masks.left, null);
    assert.match(store.state.notice.text, said);
  }
});

test('what is asked for while a project is being left waits for the next one', async () => {
  const { files, store, leaving, calls } = pairFiles(Promise.resolve());
  const leave = gate();
  void leaving.inTurn(async () => {
    await leave.opened;
    leaving.leave();
    store.dispatch({ type: 'cleared' });
  });
  const given = files.takeFlight('sample', {});
  await new Promise((resolve) => setTimeout(resolve, 5));
  assert.deepEqual(calls, []);
  leave.open();
  await given;
  assert.deepEqual(namesIn(store), ['sample left', 'sample right']);
});

test('where a pair cannot stay under Projects the user is asked before another one takes its place', async () => {
  for (const give of /** @type {((files: any) => Promise<void>)[]} */ ([
    (files) => files.take([file('a.jpg'), file('b.jpg')], null),
    (files) => files.takeFlight('sample', {}),
  ])) {
    const { files, store } = pairFiles(Promise.resolve(), false);
    open(store);
    asked.length = 0;
    await give(files);
    assert.deepEqual(asked, [
      'The pair on the page, with its matches, marks, masks and camera, cannot be kept in this browser. Open the other pair without it?',
    ]);
    assert.deepEqual(namesIn(store), ['1.jpg', '2.jpg']);
    assert.match(store.state.notice.text, /^Cancelled\. Nothing was changed\.$/);
  }
});

test('a block that is opened or photographed while the project is left waits, and one that comes too late is not taken', async () => {
  for (const give of /** @type {((files: any) => Promise<void>)[]} */ ([(files) => files.open(file('a.tiepoint')), (files) => files.simulated.sample({})])) {
    const leaving = new page.leaving.Leaving();
    const reading = gate();
    /** @type {any[]} */
    const done = [];
    const store = { state: { notice: null, flight: {} }, watch: () => undefined, dispatch: (/** @type {any} */ action) => done.push(action) };
    const read = () => reading.opened.then(() => assert.fail('read'));
    const files = new page.files.BlockFiles(
      store,
      { read, photograph: read },
      {},
      {},
      () => Promise.resolve(),
      () => Promise.resolve(true),
      () => leaving.left(),
      () => leaving.stays(),
    );
    const leave = gate();
    void leaving.inTurn(() => leave.opened);
    const given = give(files);
    await new Promise((resolve) => setTimeout(resolve, 5));
    assert.deepEqual(done, []);
    leave.open();
    while (done.length === 0) await new Promise((resolve) => setTimeout(resolve));
    leaving.leave();
    reading.open();
    await given;
    assert.match(done.at(-1).notice.text, / was not taken: the project was left before it was read\.$/);
  }
});
