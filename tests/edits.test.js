/** Edits of the matches of a pair by hand, as the page's own code applies them: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { defaults, match_pair, open_pair_project, orient_matches, Photo, simulate, version, write_pair_project } from '../pkg/node.js';
import { pageModules } from './www.js';

const MODULES = [
  'pair/engine/inspect',
  'pair/state/choice',
  'pair/state/codes',
  'pair/state/compared',
  'pair/state/display',
  'pair/state/draft',
  'pair/state/edited',
  'pair/state/editing',
  'pair/state/edits',
  'pair/state/kept',
  'pair/state/keys',
  'pair/state/listed',
  'pair/state/project',
  'pair/state/reducer',
  'pair/state/savable',
  'pair/state/select',
  'pair/state/state',
  'pair/state/statistics',
  'pair/files/journal',
  'pair/files/open',
  'pair/view/scene',
  'shared/state/history',
  'shared/state/neighbours',
];

/** The modules of the page's state.  @type {Record<string, any>} */
const page = {};

/** Rules as the page has them. */
const MATCHED = 0;

before(async () => {
  Object.assign(page, await pageModules(MODULES));
});

/** A simulated pair, the sample without another flight, as the page opens it of its project file.  @param {object} [flight] */
function simulatedProject(flight = {}) {
  const pair = simulate(flight);
  const [left, right] = [pair.left, pair.right].map(({ width, height, grey }) => Photo.from_grey(width, height, grey));
  if (left === undefined || right === undefined) throw new Error('a pair has two photos');
  const settings = defaults();
  const input = {
    camera: pair.camera,
    left: { fiducials: pair.left_fiducials, origin: pair.left_origin },
    right: { fiducials: pair.right_fiducials, origin: pair.right_origin },
  };
  const output = match_pair(left, right, input, settings);
  const photo = (/** @type {string} */ name, /** @type {{ width: number, height: number }} */ { width, height }) => ({
    name,
    content: null,
    width_px: width,
    height_px: height,
    format: 'PNG',
    bits_per_sample: 8,
    mask: null,
    camera: null,
  });
  return write_pair_project({ images: [photo('left', left), photo('right', right)], input, settings, output, truth: null });
}

const TEXT = simulatedProject();

/** Many edits are of a small pair: each costs by the matches there are. */
const SMALL = { width_px: 270, height_px: 400 };
/** `npm run bench -- edit` makes thousands. */
const STEPS = process.env.TIEPOINT_STATISTICS === 'full' ? 5000 : 800;

/** The state of the page that shows a pair, the sample without another. */
function opened(text = TEXT) {
  const project = open_pair_project(new TextEncoder().encode(text));
  const image = (/** @type {number} */ id) => ({ id, name: id === 1 ? 'left' : 'right', source: { kind: 'project', content: null } });
  const catalogue = { version: version(), defaults: defaults(), flights: [], rules: [] };
  const ready = page.reducer.reduce(page.state.INITIAL, { type: 'ready', catalogue });
  return page.reducer.reduce(ready, {
    type: 'opened',
    opened: {
      project,
      estimated: null,
      images: { left: image(1), right: image(2) },
      overviews: { left: null, right: null },
      masks: { left: null, right: null },
    },
  });
}

/** The project file of a state.  @param {any} state */
const written = (state) => write_pair_project(page.project.projectOf(state, { left: null, right: null }));

/** Random numbers by a seed.  @param {number} seed */
function dice(seed) {
  let x = seed;
  return (/** @type {number} */ below) => {
    x = (Math.imul(x, 1664525) + 1013904223) >>> 0;
    return Math.floor((x / 2 ** 32) * below);
  };
}

/** An edit of some matches of a state.  @param {any} state @param {(below: number) => number} roll */
function randomEdit(state, roll) {
  const edited = page.edited.editedPair(state);
  const anyLeft = () => roll(edited.match.rules.length);
  const target = (/** @type {number} */ wanted) => {
    for (let i = 0; i < 40; i++) {
      const left = anyLeft();
      if (edited.match.rules[left] === wanted) return page.edited.targetOfLeft(edited, left);
    }
    return null;
  };
  const targets = (/** @type {number} */ rule) => Array.from({ length: 1 + roll(20) }, () => target(rule)).filter((one) => one !== null);
  const { width_px: width, height_px: height } = SMALL;
  const place = () => [width, height, width, height].map((side) => roll(100 * side) / 100);
  switch (roll(5)) {
    case 0:
    case 1:
      return { kind: 'reject', of: targets(MATCHED) };
    case 2:
      return { kind: 'restore', of: targets(page.codes.BY_HAND) };
    case 3:
      return { kind: 'add', id: page.edits.freshNumber(state.history), at: place() };
    default: {
      const of = target(MATCHED);
      if (of === null) return null;
      const own = typeof of === 'number' ? place() : of;
      return { kind: 'move', of, to: roll(2) === 0 ? [own[0], own[1], own[2] + 0.1, own[3]] : place() };
    }
  }
}

/** What must hold of any state.  @param {any} state */
function check(state) {
  const { match, left, found } = page.edited.editedPair(state);
  const counted = match.rules.reduce((/** @type {number} */ sum, /** @type {number} */ rule) => sum + Number(rule === MATCHED), 0);
  assert.equal(match.matches.length, 5 * counted);
  assert.equal(match.counts.matches, counted);
  assert.equal(left.length, 3 * match.rules.length);
  const seen = new Set();
  for (let row = 0; row < counted; row++) {
    const index = match.indices[2 * row];
    assert.equal(match.rules[index], MATCHED);
    assert.equal(left[3 * index], match.matches[5 * row]);
    assert.equal(left[3 * index + 1], match.matches[5 * row + 1]);
    assert.ok(!seen.has(index));
    seen.add(index);
  }
  assert.equal(found, state.results.match.value);
  // The file can be written and read, and has as many matches.
  const text = written(state);
  const back = open_pair_project(new TextEncoder().encode(text));
  assert.equal(back.output.match.counts.matches, counted);
  // Opened elsewhere the edits do what they did, and can be undone one by one.
  const elsewhere = opened(text);
  assert.deepEqual(page.edited.editedPair(elsewhere).match, match);
  assert.deepEqual(elsewhere.history.edits, state.history.edits.slice(0, state.history.done));
  assert.ok(written(elsewhere) === text, 'opened elsewhere the project file has other bytes');
  // A file of a former version has none of them.
  const former = open_pair_project(new TextEncoder().encode(write_pair_project({ ...back, edited: null })));
  assert.deepEqual(page.project.editsOfFile(former), page.edited.countsByHand(match));
}

test('after hundreds of random edits, undone, the pair is what it was: the same objects, and the same bytes of its project file', () => {
  const roll = dice(15);
  const start = opened(simulatedProject(SMALL));
  const text = written(start);
  assert.ok(open_pair_project(new TextEncoder().encode(text)).output.orientation);
  let state = start;
  let edits = 0;
  for (let i = 0; i < STEPS; i++) {
    const what = roll(10);
    const { done } = state.history;
    const edit = what < 7 ? randomEdit(state, roll) : null;
    const action = edit === null ? { type: 'goto', done: what === 9 ? done + 1 : done - 1 } : { type: 'edit', edit };
    state = page.reducer.reduce(state, action);
    edits += Number(edit !== null);
    if (i % 200 === 199) check(state);
  }
  assert.ok(edits > STEPS / 2, `only ${edits} edits`);
  assert.ok(page.edited.editedPair(state).match !== start.results.match.value);
  const end = state.history.done;
  const last = written(state);
  while (state.history.done > 0) state = page.reducer.reduce(state, { type: 'goto', done: state.history.done - 1 });
  assert.equal(page.edited.editedPair(state).match, start.results.match.value);
  assert.equal(page.edited.editedPair(state).left, start.results.pointsLeft.value.points);
  assert.ok(written(state) === text, 'the project file has other bytes');
  // All is done again in one go, and any state is reached.
  state = page.reducer.reduce(state, { type: 'goto', done: end });
  assert.ok(written(state) === last, 'the project file of the edits has other bytes');
});

test('what stands after some edits is the same object, whatever is asked between', () => {
  const edits = [{ kind: 'add', id: 1, at: [1, 2, 3, 4] }];
  const standing = page.edits.standingOf(edits, 1);
  assert.ok(page.edits.isNothing(page.edits.standingOf(edits, 0)) && page.edits.isNothing(page.edits.standingOf([], 0)));
  assert.equal(page.edits.standingOf([...edits], 1).placed.size, 1);
  assert.equal(page.edits.standingOf(edits, 1), standing);
});

test('a new edit gives up what was undone, and names say what is done', () => {
  let state = opened();
  const edited = page.edited.editedPair(state);
  const targets = [...edited.match.indices.filter((/** @type {number} */ _, /** @type {number} */ i) => i % 2 === 0)]
    .slice(0, 14)
    .map((left) => page.edited.targetOfLeft(edited, left));
  state = page.reducer.reduce(state, { type: 'edit', edit: { kind: 'reject', of: targets } });
  assert.equal(page.edits.nameOfEdit(state.history.edits[0]), 'reject 14 matches');
  state = page.reducer.reduce(state, { type: 'goto', done: 0 });
  state = page.reducer.reduce(state, { type: 'edit', edit: { kind: 'reject', of: targets.slice(0, 1) } });
  assert.deepEqual(state.history.edits.map(page.edits.nameOfEdit), ['reject 1 match']);
  assert.deepEqual(page.edited.countsByHand(page.edited.editedPair(state).match), { rejected: 1, manual: 0 });
});

test('rejections and measured matches hold for a new run of the matching where it finds the same place', () => {
  const state = opened();
  const edited = page.edited.editedPair(state);
  const { match } = edited;
  const target = (/** @type {number} */ row) => page.edited.targetOfLeft(edited, match.indices[2 * row]);
  const edits = [
    { kind: 'reject', of: [target(10), target(500)] },
    { kind: 'add', id: 1, at: [33.25, 44.5, 60.5, 47.75] },
    { kind: 'move', of: target(700), to: [target(700)[0], target(700)[1], target(700)[2] + 3, target(700)[3]] },
  ];
  const standing = page.edits.standingOf(edits, edits.length);
  // The left points of the new run lie somewhat elsewhere; one match is not found any more.
  const shift = (/** @type {Float64Array} */ values, /** @type {number} */ stride, /** @type {number} */ by) =>
    values.map((value, i) => (i % stride === 0 ? value + by : value));
  const gone = match.indices[1000];
  const near = page.edited.applied(shift(edited.left, 3, 0.3), { ...match, matches: shift(match.matches, 5, 0.3) }, standing);
  assert.deepEqual(page.edited.countsByHand(near.match), { rejected: 2, manual: 2 });
  assert.equal(near.lost, 0);
  assert.match(page.edited.keptText(near), /^Kept: 2 matches rejected by hand, 2 matches measured by hand\.$/);
  assert.equal(near.match.counts.matches, match.counts.matches - 2 + 1);
  const far = page.edited.applied(shift(edited.left, 3, 40), { ...match, matches: shift(match.matches, 5, 40) }, standing);
  assert.equal(page.edited.countsByHand(far.match).manual, 2);
  assert.ok(gone !== undefined && far.lost > 0);
  assert.match(page.edited.keptText(far), /there is no match at the same place/);
});

test('the orientation of the matches that are left is that of these matches alone', () => {
  const project = open_pair_project(new TextEncoder().encode(TEXT));
  let state = opened();
  const edited = page.edited.editedPair(state);
  const keys = page.choice.keysWithin(edited, 'left', [0, 0, 200, 200], () => true);
  assert.ok(keys.length > 100);
  state = page.reducer.reduce(state, { type: 'choose', chosen: keys });
  const edit = page.choice.editOfChoice(state, 'reject');
  assert.equal(edit.of.length, keys.length);
  assert.equal(page.choice.editOfChoice(state, 'restore'), null);
  state = page.reducer.reduce(state, { type: 'edit', edit });
  const { match } = page.edited.editedPair(state);
  // What is shown until the new orientation is there has a row for each match that is left.
  const shown = page.select.shownPair(state);
  assert.equal(shown.orientation.residuals_mm.length, 4 * match.counts.matches);
  // These are of the same matches as before.
  const { indices } = state.results.match.value;
  const rowThen = new Map(Array.from({ length: indices.length / 2 }, (_, row) => [indices[2 * row], row]));
  for (const row of [0, 1, match.counts.matches - 1]) {
    const then = rowThen.get(match.indices[2 * row]) ?? -1;
    const { residuals_mm: residuals, points } = state.results.orientation.value;
    assert.deepEqual(shown.orientation.residuals_mm.slice(4 * row, 4 * row + 4), residuals.slice(4 * then, 4 * then + 4));
    assert.deepEqual(shown.orientation.points.slice(9 * row, 9 * row + 9), points.slice(9 * then, 9 * then + 9));
  }
  const { interior } = project.output;
  assert.ok(interior);
  const orientation = orient_matches(match.matches, match.fits, interior, project.settings.orientation ?? {}, [1, 1]);
  assert.equal(orientation.residuals_mm.length, 4 * match.counts.matches);
  const back = page.reducer.reduce(state, { type: 'edit', edit: page.choice.editOfChoice(state, 'restore') });
  assert.equal(page.edited.editedPair(back).match, state.results.match.value);
});

test('codes are the same array for as long as the same matches are rejected', () => {
  const { match, orientation } = page.select.shownPair(opened());
  const codes = page.select.matchCodes(match, orientation);
  assert.equal(page.select.matchCodes(match, { ...orientation }), codes);
  const other = page.select.matchCodes(match, { ...orientation, rejected: [...orientation.rejected, orientation.rejected.includes(0) ? 1 : 0] });
  assert.notEqual(other, codes);
});

test('exchanged images exchange the edits', () => {
  const history = {
    edits: [
      { kind: 'reject', of: [[1, 2, 3, 4], 7] },
      { kind: 'add', id: 7, at: [5, 6, 7, 8] },
    ],
    done: 1,
  };
  const other = page.edits.exchanged(history);
  assert.deepEqual(other, {
    edits: [
      { kind: 'reject', of: [[3, 4, 1, 2], 7] },
      { kind: 'add', id: 7, at: [7, 8, 5, 6] },
    ],
    done: 1,
  });
  assert.deepEqual(page.edits.exchanged(other), history);
});

test('a point is expected where the matches around it lie, on its epipolar line', () => {
  const state = opened();
  const edited = page.edited.editedPair(state);
  const { matches } = edited.match;
  // The median of what the neighbours of known matches say of them.
  const errors = Array.from({ length: 200 }, (_, i) => {
    const [x, y, u, v] = matches.subarray(5 * 10 * i, 5 * 10 * i + 4);
    const [px, py] = page.draft.byNeighbours(edited, 'left', [x, y]);
    return Math.hypot(px - u, py - v);
  }).sort((a, b) => a - b);
  assert.ok((errors[100] ?? NaN) < 1, `median ${errors[100]} px`);
  const line = { side: 'right', positions: Float64Array.of(0, 10, 100, 10, 200, 110) };
  assert.deepEqual(page.neighbours.onLine(line.positions, [40, 30]), [40, 10]);
  assert.deepEqual(page.neighbours.onLine(line.positions, [150, 60]), [150, 60]);
  assert.deepEqual(page.neighbours.onLine(line.positions, [-5, 0]), [0, 10]);
  // A new match waits for its second point, a moved one keeps what was not moved.
  let measuring = page.reducer.reduce(state, { type: 'draft', draft: page.draft.begun(state, 'left', [100.123, 200]) });
  // Where its other point is expected nobody has measured it: it is no match of its own, whichever point is placed next.
  assert.ok(page.draft.isPredicted(measuring));
  assert.equal(page.draft.editOfDraft(measuring), null);
  const editing = new page.editing.Editing({ state: measuring, dispatch: (/** @type {any} */ action) => (measuring = page.reducer.reduce(measuring, action)) });
  editing.exchange();
  assert.equal(measuring.draft.side, 'left');
  assert.equal(page.draft.editOfDraft(measuring), null);
  measuring = page.reducer.reduce(measuring, { type: 'draft', draft: page.draft.placed(measuring, { ...measuring.draft, side: 'right' }, 'right', [90, 190]) });
  assert.equal(page.draft.isPredicted(measuring), false);
  const edit = page.draft.editOfDraft(measuring);
  assert.deepEqual([edit.kind, edit.id, edit.at.slice(0, 2)], ['add', 1, [100.12, 200]]);
  const left = edited.match.indices[20];
  measuring = page.reducer.reduce(state, { type: 'select', selection: { side: 'left', index: left } });
  measuring = page.reducer.reduce(measuring, { type: 'draft', draft: page.draft.moving(measuring) });
  assert.deepEqual(page.draft.editOfDraft(measuring).to, [...matches.subarray(50, 54)]);
});

test('a pair that is opened again has its edits again', () => {
  const image = (/** @type {string} */ name, /** @type {number} */ id) => ({
    id,
    name,
    source: { kind: 'file', file: new File([name], name, { lastModified: 1 }) },
  });
  const show = (/** @type {any} */ state, /** @type {string} */ left, /** @type {string} */ right) =>
    page.reducer.reduce(state, { type: 'images', images: { left: image(left, 1), right: image(right, 2) } });
  let state = show(opened(), 'a.jpg', 'b.jpg');
  assert.equal(state.history, page.history.NO_HISTORY);
  state = page.reducer.reduce(state, { type: 'edit', edit: { kind: 'reject', of: [[1, 2, 3, 4]] } });
  const { history } = state;
  state = show(state, 'c.jpg', 'd.jpg');
  assert.equal(state.history.edits.length, 0);
  // The other order is another pair.
  assert.equal(show(state, 'b.jpg', 'a.jpg').history.edits.length, 0);
  state = show(state, 'a.jpg', 'b.jpg');
  assert.deepEqual(state.history, history);
  assert.equal(state.shelf.size, 0);
});

test('a match that is being measured is measured on when its pair is opened again, edited or not', () => {
  const show = (/** @type {any} */ state, /** @type {string} */ left, /** @type {string} */ right) => {
    const image = (/** @type {string} */ name, /** @type {number} */ id) => ({
      id,
      name,
      source: { kind: 'file', file: new File([name], name, { lastModified: 1 }) },
    });
    return page.reducer.reduce(state, { type: 'images', images: { left: image(left, 1), right: image(right, 2) } });
  };
  const draft = { of: null, places: { left: [1.5, 2], right: null }, side: 'right' };
  let state = page.reducer.reduce(show(opened(), 'a.jpg', 'b.jpg'), { type: 'tool', tool: 'measure' });
  state = page.reducer.reduce(page.reducer.reduce(state, { type: 'draft', draft }), { type: 'notice', notice: null });
  const other = page.reducer.reduce(show(state, 'c.jpg', 'd.jpg'), { type: 'tool', tool: 'look' });
  assert.deepEqual([other.draft, other.history], [null, page.history.NO_HISTORY]);
  const again = show(other, 'a.jpg', 'b.jpg');
  assert.deepEqual([again.draft, again.tool, again.shelf.size], [draft, 'measure', 0]);
  // One that was accepted or given up comes no more.
  assert.equal(show(show(page.reducer.reduce(again, { type: 'draft', draft: null }), 'c.jpg', 'd.jpg'), 'a.jpg', 'b.jpg').draft, null);
});

test('a pair that was kept shows the match that was being measured, with its tool', () => {
  const { settings, camera, photos, fiducialModel, offset, display, flight, images, masks } = opened();
  const given = { typed: { settings, camera, photos, fiducialModel, offset }, display, flight, paused: false, images, masks, truth: null };
  const kept = (/** @type {any} */ draft) =>
    page.kept.withKept(page.state.INITIAL, { ...given, history: page.history.NO_HISTORY, shelf: new Map(), opened: {}, result: null, draft });
  const draft = { of: [1, 2, 3, 4], places: { left: [1, 2], right: [5, 4] }, side: 'left' };
  assert.deepEqual([kept(draft).draft, kept(draft).tool], [draft, 'measure']);
  assert.deepEqual([kept(null).draft, kept(null).tool], [null, 'look']);
});

test('a match that is being measured stays with its images where they are swapped', () => {
  const swapped = (/** @type {any} */ state) => page.reducer.reduce(state, { type: 'swap' });
  const measured = (/** @type {any} */ draft) => page.reducer.reduce({ ...page.state.INITIAL, tool: 'measure' }, { type: 'draft', draft });
  const moved = measured({ of: [1, 2, 3, 4], places: { left: [1, 2], right: [5, 4] }, side: 'left' });
  const { draft, tool } = swapped(moved);
  assert.deepEqual([draft, tool], [{ of: [3, 4, 1, 2], places: { left: [5, 4], right: [1, 2] }, side: 'right' }, 'measure']);
  assert.deepEqual(swapped(swapped(moved)).draft, moved.draft);
  // One that was added by hand has a number; one of which a single point is placed goes on in the same photograph.
  assert.equal(swapped(measured({ of: 7, places: { left: [1, 2], right: [5, 4] }, side: 'left' })).draft.of, 7);
  const begun = swapped(measured({ of: null, places: { left: [1.5, 2], right: null }, side: 'right' }));
  assert.deepEqual(begun.draft, { of: null, places: { left: null, right: [1.5, 2] }, side: 'left' });
  assert.equal(swapped(page.reducer.reduce(moved, { type: 'draft', draft: null })).draft, null);
});

test('what an edit did is compared within one run: not with the orientation of other settings, and not waited for where none will come', () => {
  const opens = opened();
  const orient = (/** @type {any} */ state, /** @type {object} */ value) => {
    const result = { key: page.keys.wantedKeys(state).orientation, value, milliseconds: 0 };
    return page.reducer.reduce(state, { type: 'stageDone', stage: 'orientation', result });
  };
  const named = (/** @type {string} */ name) => ({ name, residuals_mm: new Float64Array(), rejected: new Uint32Array() });
  const [whole, without, other] = [named('all'), named('without one'), named('by other settings')];
  const state = orient(opens, whole);
  const of = page.edited.targetOfLeft(page.edited.editedPair(state), state.results.match.value.rules.indexOf(MATCHED));
  const edited = page.reducer.reduce(state, { type: 'edit', edit: { kind: 'reject', of: [of] } });
  assert.deepEqual(page.compared.comparedEdit(edited), { before: whole, now: null, comes: true });
  const done = orient(edited, without);
  assert.deepEqual(page.compared.comparedEdit(done), { before: whole, now: without, comes: false });
  // One that fails does not come.
  const failure = { key: page.keys.wantedKeys(edited).orientation, message: 'too few', ended: false, error: { kind: 'too_few' } };
  const failed = page.reducer.reduce(edited, { type: 'stageFailed', stage: 'orientation', failure });
  assert.deepEqual(page.compared.comparedEdit(failed), { before: whole, now: null, comes: false });
  // Other settings of the orientation alone, and another matching.
  const { settings } = done;
  for (const wanted of [
    { ...settings, orientation: { ...settings.orientation, base_mm: 12 } },
    { ...settings, matching: { ...settings.matching, strategy: 'moments' } },
  ]) {
    const changed = page.reducer.reduce(done, { type: 'settings', settings: wanted });
    assert.equal(page.compared.comparedEdit(changed), null);
    assert.equal(page.compared.comparedEdit(orient(changed, other)), null);
  }
  // The next edit is compared with the orientation that the run has now.
  const rerun = orient(
    page.reducer.reduce(done, { type: 'settings', settings: { ...settings, orientation: { ...settings.orientation, base_mm: 12 } } }),
    other,
  );
  const next = page.reducer.reduce(rerun, { type: 'goto', done: 0 });
  assert.deepEqual(page.compared.comparedEdit(next), { before: other, now: null, comes: true });
});

/** What is said of where both points of a left point's match lie.  @param {any} state @param {number} left */
async function placesOf(state, left) {
  const worker = { call: () => Promise.resolve(new Uint8Array()) };
  const workers = { withImage: () => Promise.resolve(worker), client: () => worker };
  const { features } = await page.inspect.inspection(page.reducer.reduce(state, { type: 'select', selection: { side: 'left', index: left } }), workers);
  return [features.left.byHand, features.right.byHand];
}

test('of a match that was measured by hand it is not said that least squares placed it, and of one that was rejected by hand it is', async () => {
  const state = opened();
  const does = (/** @type {any} */ before, /** @type {any} */ edit) => page.reducer.reduce(before, { type: 'edit', edit });
  const of = page.edited.targetOfLeft(page.edited.editedPair(state), state.results.match.value.rules.indexOf(MATCHED));
  const found = state.results.match.value.rules.indexOf(MATCHED);
  assert.deepEqual(await placesOf(state, found), [false, false]);
  assert.deepEqual(await placesOf(does(state, { kind: 'reject', of: [of] }), found), [false, false]);
  const moved = does(state, { kind: 'move', of, to: [of[0], of[1], of[2] + 0.5, of[3]] });
  assert.deepEqual(await placesOf(moved, found), [true, true]);
  assert.deepEqual(await placesOf(does(moved, { kind: 'reject', of: [of] }), found), [true, true]);
  const added = does(state, { kind: 'add', id: 1, at: [100, 100, 90, 100] });
  const last = page.edited.editedPair(added).match.rules.length - 1;
  assert.deepEqual(await placesOf(added, last), [true, true]);
  assert.deepEqual(await placesOf(does(added, { kind: 'reject', of: [1] }), last), [true, true]);
});

test('nothing that says matches or settings can be saved while a run goes on, nor JSON where it was cancelled', () => {
  const opens = opened();
  // What needs no image is computed then.
  const stages = ['interiorLeft', 'interiorRight'];
  const interior = { interior: page.project.projectOf(opens, { left: null, right: null }).output.interior, fiducials: null };
  const state = stages.reduce((now, stage) => {
    const key = page.keys.wantedKeys(now)[stage];
    return page.reducer.reduce(now, { type: 'stageDone', stage, result: { key, value: interior, milliseconds: 0 } });
  }, opens);
  const all = { csv: true, json: true, project: true, report: false, epipolar: false, png: true };
  assert.deepEqual(page.savable.savable(state), all);
  const none = { csv: false, json: false, project: false, report: false, epipolar: false, png: true };
  const wanted = page.reducer.reduce(state, {
    type: 'camera',
    camera: { focal_mm: 10, principal_point_mm: [0, 0], pixel_mm: 0.01, radial_distortion: [0, 0, 0] },
  });
  // Before its first stage starts the state is neither of the settings before nor of those now.
  assert.equal(page.savable.savable(wanted).json, false);
  const running = page.reducer.reduce(wanted, { type: 'stageStarted', stage: 'interiorLeft', key: 'k' });
  assert.deepEqual(page.savable.savable(running), none);
  const cancelled = page.reducer.reduce(running, { type: 'cancelled' });
  assert.deepEqual(page.savable.savable(cancelled), { ...none, csv: true });
});

test('epipolar images are offered where the project that they are made of has an orientation', () => {
  const opens = opened();
  const withFile = (/** @type {any} */ image) => ({ ...image, source: { kind: 'file', file: new File([image.name], image.name) } });
  const { left, right } = opens.images;
  const state = { ...opens, images: { left: withFile(left), right: withFile(right) } };
  assert.equal(page.savable.savable(state).epipolar, true);
  // What of a run with other settings is left when it is cancelled: the orientation that is shown is of those before.
  const { settings } = state;
  for (const other of [
    { ...settings, matching: { ...settings.matching, strategy: 'invariants' } },
    { ...settings, orientation: { ...settings.orientation, seed: 7 } },
  ]) {
    const cancelled = page.reducer.reduce(page.reducer.reduce(state, { type: 'settings', settings: other }), { type: 'cancelled' });
    assert.notEqual(page.select.shownPair(cancelled).orientation, null);
    assert.equal(page.savable.savable(cancelled).epipolar, false);
  }
});

test('matched photographs stay in the list of projects when another one takes the place of one of them', async () => {
  const file = (/** @type {string} */ name) => new File([name], name, { lastModified: 1 });
  const store = {
    state: opened(),
    dispatch: (/** @type {any} */ action) => {
      store.state = page.reducer.reduce(store.state, action);
    },
  };
  const { images } = store.state;
  const withFile = (/** @type {any} */ image) => ({ ...image, source: { kind: 'file', file: file(image.name) } });
  store.dispatch({ type: 'found', images: { left: withFile(images.left), right: withFile(images.right) } });
  const before = store.state;
  /** @type {any[]} */
  const aside = [];
  const putAside = () => Promise.resolve(aside.push(store.state) > 0);
  const none = () => Promise.reject(new Error('not asked'));
  const engine = { open: () => Promise.resolve(), client: () => ({ call: async (/** @type {string} */ _, /** @type {{ file: File }} */ of) => of.file.name }) };
  const files = new page.open.Files(store, engine, none, { toBlock: none, toGround: none, left: async () => () => {} }, putAside);
  files.begin();
  await files.take([file('third')], 'right');
  assert.deepEqual(aside, [{ ...before, notice: aside[0]?.notice }]);
  assert.deepEqual([store.state.images.left.name, store.state.images.right.name], ['left', 'third']);
  assert.match(
    store.state.notice.text,
    /^left and right stay under Projects\. The 8 fiducial marks of the right image went with it\. The camera that was given stays in use\.$/,
  );
  // Nothing is matched yet: nothing is kept twice.
  await files.take([file('fourth')], 'right');
  assert.equal(aside.length, 1);
});

test('the journal is read back as it was, an edit writes its last piece alone, and damage is named', () => {
  const roll = dice(3);
  const edits = Array.from({ length: 150 }, (_, i) =>
    i % 3 === 0 ? { kind: 'add', id: i, at: [i, 1, 2, 3] } : { kind: 'reject', of: [[i, roll(100), 5, 6], i] },
  );
  const draft = { of: edits[1]?.of?.[0] ?? null, places: { left: [1.5, 2], right: null }, side: 'right' };
  const shelf = new Map([['other', { edits: edits.slice(0, 2), done: 1, draft: { ...draft, of: 7 } }]]);
  const journal = new page.journal.Journal();
  const none = { maskSteps: page.history.NO_HISTORY, markSteps: page.history.NO_HISTORY };
  const kept = (/** @type {any} */ history) => new Map([...journal.parts({ history, ...none, draft, shelf })].map(([part, { value }]) => [part, value]));
  const before = kept({ edits, done: 149 });
  const stored = structuredClone(before);
  assert.deepEqual(journal.read(stored), { history: { edits, done: 149 }, ...none, draft, shelf });
  const after = kept({ edits: [...edits, { kind: 'move', of: 3, to: [1, 2, 3, 4] }], done: 151 });
  const changed = [...after].filter(([part, value]) => before.get(part) !== value).map(([part]) => part);
  assert.deepEqual(changed.sort(), ['pair/edits', 'pair/edits/2']);
  assert.deepEqual(journal.read(new Map()), { history: { edits: [], done: 0 }, ...none, draft: null, shelf: new Map() });
  // Earlier releases kept no match that was being measured.
  const earlier = new Map([['other', { edits: [], done: 0 }]]);
  assert.equal(journal.read(new Map([['pair/shelf', earlier]])).shelf.get('other').draft, null);
  const damaged = (/** @type {object} */ own) => () => journal.read(new Map([['pair/draft', { ...draft, ...own }]]));
  assert.throws(damaged({ side: 'top' }), /draft\.side is damaged/);
  assert.throws(damaged({ places: { left: [1], right: null } }), /draft\.places\.left is damaged/);
  assert.throws(damaged({ of: [1, 2, 3] }), /draft\.of is damaged/);
  stored.get('pair/edits/1')[0].kind = 'burn';
  assert.throws(() => journal.read(stored), /edits\[1\]\[0\]\.kind is damaged/);
});

test('steps on masks and marks are read back as they were; a file is kept by itself, and the same step is the same value', () => {
  const source = { kind: 'file', file: new Blob(['1']) };
  const corners = [
    [1, 2],
    [3.5, 4],
    [5, 6],
  ];
  const area = { side: 'left', corners, masked: true };
  const maskSteps = { edits: [area, { side: 'right', given: { name: 'sky.png', source } }, { side: 'left', given: null }], done: 2 };
  const mark = { col: 1, row: 2, x_mm: NaN, y_mm: 4 };
  const markSteps = { edits: [{ side: 'right', deed: 'measured', at: 0, out: [], put: [mark] }], done: 0 };
  const none = { history: page.history.NO_HISTORY, draft: null, shelf: new Map() };
  const journal = new page.journal.Journal();
  const kept = (/** @type {any} */ steps) => new Map([...journal.parts({ ...none, ...steps })].map(([part, { value }]) => [part, value]));
  const parts = kept({ maskSteps, markSteps });
  const { file } = parts.get('pair/masks/0')[1].given;
  const stored = new Map([...structuredClone(parts), [`pair/file/${file}`, source]]);
  const back = new page.journal.Journal();
  const read = back.read(stored);
  assert.deepEqual([read.maskSteps, read.markSteps], [maskSteps, markSteps]);
  // What was read is what is kept; another step writes the last piece alone.
  const again = new Map([...back.parts(read)].map(([part, { value }]) => [part, value]));
  assert.deepEqual(again, parts);
  const more = kept({ maskSteps: { edits: [...maskSteps.edits, area], done: 4 }, markSteps });
  assert.deepEqual(
    [...more].filter(([part, value]) => parts.get(part) !== value).map(([part]) => part),
    ['pair/masks', 'pair/masks/0'],
  );
  assert.throws(() => back.read(new Map(structuredClone(parts))), /damaged/);
  stored.get('pair/masks/0')[0].corners[1] = [1];
  assert.throws(() => back.read(stored), /\.corners\[1\] is damaged/);
  stored.set('pair/masks/0', []);
  stored.get('pair/marks/0')[0].side = 'top';
  assert.throws(() => back.read(stored), /\.side is damaged/);
});

test('what the filter of the matches leaves out is in no picture, and what it keeps is', () => {
  const { LEFT_OUT, GROSS_ERROR, UNDECIDED, MATCHED: MATCHED_CODE, BY_HAND } = page.codes;
  const plain = opened();
  const left = plain.results.match.value.indices[0];
  const edited = page.edited.editedPair(plain);
  const state = page.reducer.reduce(plain, { type: 'edit', edit: { kind: 'reject', of: [page.edited.targetOfLeft(edited, left)] } });
  const filtered = (/** @type {object} */ filter) => page.reducer.reduce(state, { type: 'filter', filter: { ...page.state.ALL_MATCHES, ...filter } });
  const all = page.scene.marksOf(state);
  const { lefts, columns, codes, count } = page.statistics.statisticsOfState(state);
  assert.equal(codes[count - 1], BY_HAND);
  const w = columns.find((/** @type {{ key: string }} */ { key }) => key === 'w').value;

  // Whatever is listed, each match is shown in all pictures or in none; points that are no matches stay as they are.
  const compare = (/** @type {object} */ filter, /** @type {(row: number) => boolean} */ keeps) => {
    const marks = page.scene.marksOf(filtered(filter));
    const kept = new Set();
    const [wanted, matches] = [all.codes.left.slice(), all.matchCodes.slice()];
    for (let row = 0; row < count; row++) {
      if (keeps(row)) kept.add(row);
      else wanted[lefts[row]] = LEFT_OUT;
      if (row < matches.length && !keeps(row)) matches[row] = LEFT_OUT;
    }
    assert.ok(kept.size > 0 && kept.size < count, `${kept.size} of ${count}`);
    assert.deepEqual(marks.codes.left, wanted);
    assert.deepEqual(marks.matchCodes, matches);
    const { indices } = page.edited.editedPair(state).match;
    for (let row = 0; row < matches.length; row++)
      if (indices[2 * row + 1] < marks.codes.right.length)
        assert.equal(marks.codes.right[indices[2 * row + 1]] === LEFT_OUT, !kept.has(row), `right point of ${row}`);
    assert.equal(
      marks.places.codes.filter((/** @type {number} */ code) => code === LEFT_OUT).length,
      [...marks.places.lefts].filter((one) => wanted[one] === LEFT_OUT).length,
    );
    // Gross errors stand in the table, and are shown for it; other points that were rejected are not.
    const isShown = (/** @type {number} */ code) => page.display.isCodeShown(marks.shown, code);
    assert.deepEqual([MATCHED_CODE, GROSS_ERROR, BY_HAND, UNDECIDED, LEFT_OUT].map(isShown), [true, true, true, false, false]);
  };
  compare({ conditions: { w: { kind: 'range', from: 1.5, to: null } } }, (row) => w(row) >= 1.5);
  compare({ conditions: { state: { kind: 'contains', text: 'rejected by' } } }, (row) => row === count - 1);
  compare({ kind: 'rejected' }, (row) => codes[row] === GROSS_ERROR);
  compare({ kind: 'used', conditions: { w: { kind: 'range', from: null, to: 0 } } }, (row) => codes[row] === MATCHED_CODE && w(row) <= 0);

  // Where nothing is filtered nothing is, nor by a truth that is not known.
  assert.equal(page.display.isCodeShown(all.shown, GROSS_ERROR), false);
  for (const nothing of [state, filtered({ kind: 'wrong' }), filtered({ conditions: { gone: { kind: 'range', from: 1, to: 2 } } })])
    assert.equal(page.listed.leftOut(nothing), null);
  // A filter goes with its images.
  assert.equal(page.reducer.reduce(filtered({ kind: 'used' }), { type: 'swap' }).filter, page.state.ALL_MATCHES);
});
