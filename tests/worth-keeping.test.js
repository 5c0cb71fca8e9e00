/** Which pair stays under Projects when another one takes its place: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { defaults, match_pair, open_pair_project, Photo, simulate, version, write_pair_project } from '../pkg/node.js';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(page, await pageModules(['pair/files/open', 'pair/state/kept', 'pair/state/keys', 'pair/state/reducer', 'pair/state/state']));
});

/** The sample pair as a project file. */
const TEXT = (() => {
  const pair = simulate({});
  const [left, right] = [pair.left, pair.right].map(({ width, height, grey }) => Photo.from_grey(width, height, grey));
  if (left === undefined || right === undefined) throw new Error('a pair has two photos');
  const settings = defaults();
  const input = { camera: { focal_mm: 10, pixel_mm: 0.01 } };
  const output = match_pair(left, right, input, settings);
  const photo = (/** @type {string} */ name, /** @type {{ width: number, height: number }} */ { width, height }) => ({
    ...{ name, content: null, width_px: width, height_px: height },
    ...{ format: 'PNG', bits_per_sample: 8, mask: null, camera: null },
  });
  return write_pair_project({ images: [photo('left', left), photo('right', right)], input, settings, output, truth: null });
})();

const FILE = { kind: 'file', file: new Blob([]) };
const PROJECT = { kind: 'project', content: null };
const GREY = { kind: 'grey', width: 1, height: 1, grey: new Uint8Array(1) };

/** The pair as the page shows it once it is matched, its images from such sources.  @param {any} left @param {any} right @returns {any} */
function matched(left, right) {
  const project = open_pair_project(new TextEncoder().encode(TEXT));
  const image = (/** @type {number} */ id, /** @type {any} */ source) => ({ id, name: `${id}`, source });
  const catalogue = { version: version(), defaults: defaults(), flights: [], rules: [] };
  const ready = page.reducer.reduce(page.state.INITIAL, { type: 'ready', catalogue });
  const none = { left: null, right: null };
  const images = { left: image(1, left), right: image(2, right) };
  return page.reducer.reduce(ready, { type: 'opened', opened: { project, images, overviews: none, masks: none } });
}

const reduce = (/** @type {any} */ state, /** @type {any} */ action) => page.reducer.reduce(state, action);

/** Its first match is rejected by hand.  @param {any} state */
function edited(state) {
  return reduce(state, { type: 'edit', edit: { kind: 'reject', of: [[...state.results.match.value.matches.subarray(0, 4)]] } });
}

/** Another strategy is at work.  @param {any} state */
function matching(state) {
  const wanted = reduce(state, { type: 'settings', settings: { ...state.settings, matching: { ...state.settings.matching, strategy: 'correlation' } } });
  return reduce(wanted, { type: 'stageStarted', stage: 'match', key: page.keys.wantedKeys(wanted).match });
}

test('matched photographs stay while a run goes on, edited or not', () => {
  const running = matching(edited(matched(FILE, FILE)));
  assert.equal(page.keys.isCurrent(running, 'match'), false);
  assert.equal(page.kept.isWorthKeeping(running), true);
  assert.equal(page.kept.isWorthKeeping(matching(matched(FILE, FILE))), true);
});

test('a pair of a project file stays without its images, and with one of them', () => {
  for (const [left, right] of [
    [PROJECT, PROJECT],
    [FILE, PROJECT],
    [PROJECT, FILE],
  ]) {
    assert.equal(page.kept.isWorthKeeping(matched(left, right)), true);
    assert.equal(page.kept.isWorthKeeping(edited(matched(left, right))), true);
  }
});

test('a simulated pair stays where something was done to it by hand alone', () => {
  const state = matched(GREY, GREY);
  assert.equal(page.kept.isWorthKeeping(state), false);
  assert.equal(page.kept.isWorthKeeping(edited(state)), true);
  const undone = reduce(edited(state), { type: 'goto', done: 0 });
  assert.equal(page.kept.isWorthKeeping(undone), false);
  const mask = { id: 1, name: 'mask.png', source: FILE, width: 1, height: 1, grey: new Uint8Array(1), leftOut: 1, overlay: null };
  assert.equal(page.kept.isWorthKeeping(reduce(state, { type: 'mask', side: 'left', mask })), true);
});

test('photographs that were not matched yet do not stay, whatever was matched before them', () => {
  const image = (/** @type {number} */ id) => ({ id, name: `${id}`, source: FILE });
  const others = reduce(matched(FILE, FILE), { type: 'images', images: { left: image(3), right: image(4) } });
  assert.notEqual(others.results.match, undefined);
  assert.equal(page.kept.isWorthKeeping(others), false);
});

/**
 * What the list of projects gets when files are taken while a state is shown, as names of images, and what is said of it.
 * @param {any} state @param {(files: any) => Promise<void>} take
 */
async function asideOf(state, take) {
  const store = {
    state,
    dispatch: (/** @type {any} */ action) => {
      store.state = reduce(store.state, action);
    },
  };
  /** @type {any[]} */
  const aside = [];
  const putAside = () => Promise.resolve(aside.push([store.state.images.left?.name, store.state.images.right?.name]) > 0);
  const none = () => Promise.reject(new Error('not asked'));
  const engine = { open: () => Promise.resolve(), client: () => ({ call: async (/** @type {string} */ _, /** @type {{ file: File }} */ of) => of.file.name }) };
  const files = new page.open.Files(store, engine, none, { toBlock: none, toGround: none, left: async () => () => {} }, putAside);
  files.begin();
  await take(files);
  return { aside, said: store.state.notice?.text };
}

const file = (/** @type {string} */ name) => new File([name], name, { lastModified: 1 });

test('other photographs that are opened during a run leave the edited pair in the list', async () => {
  const running = matching(edited(matched(FILE, FILE)));
  const { aside, said } = await asideOf(running, (files) => files.take([file('a.jpg'), file('b.jpg')], null));
  assert.deepEqual(aside, [['1', '2']]);
  assert.match(said, /1 and 2 stay under Projects\./);
});

test('marks of one image and what was given with it stay when its other image joins it', async () => {
  const image = { id: 1, name: 'left.jpg', source: FILE };
  const alone = reduce(reduce(page.state.INITIAL, { type: 'ready', catalogue: { version: version(), defaults: defaults(), flights: [], rules: [] } }), {
    type: 'images',
    images: { left: image },
  });
  const mask = { id: 1, name: 'mask.png', source: FILE, width: 1, height: 1, grey: new Uint8Array(1), leftOut: 1, overlay: null };
  const marked = reduce(reduce(alone, { type: 'photo', side: 'left', photo: { origin: [1, 2] } }), { type: 'mask', side: 'left', mask });
  assert.equal(page.kept.hasMarks(marked), true);
  const { aside } = await asideOf(marked, (files) => files.take([file('b.jpg')], 'right'));
  assert.deepEqual(aside, []);
  assert.equal(page.kept.hasMarks({ ...marked, truth: {} }), false);
});
