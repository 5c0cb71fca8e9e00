/** Edits of a finished block by hand, as the page's own code keeps and names them: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(
    page,
    await pageModules([
      'block/state/carrying',
      'block/state/draft',
      'block/state/edited',
      'block/state/editing',
      'block/state/edits',
      'block/state/joining',
      'block/state/naming',
      'block/state/reducer',
      'block/state/state',
      'block/state/timeline',
      'block/files/edit',
      'block/files/keep-former',
      'shared/files/journal',
      'shared/state/history',
    ]),
  );
});

/** A block of four images and points of these numbers of tie points.  @param {number[]} points */
const viewOf = (points, sigma0Px = 0.5) => ({
  partial: false,
  images: ['a', 'b', 'c', 'd'].map((name) => ({ name, rays: points.length })),
  connections: [],
  oriented: 4,
  surveyed: [],
  givenControl: 0,
  crs: null,
  sigma0Px,
  rmsePx: 0.3,
  components: [],
  checks: null,
  points: {
    count: points.length,
    taking: points.length,
    sources: Float64Array.from(points, (point) => page.edits.codeOfSource({ tie_point: point })),
    rays: Uint16Array.from(points, () => 2),
  },
});

/** The state after actions on a block that was run.  @param {any[]} actions */
function after(...actions) {
  const { BLOCK_INITIAL } = page.state;
  const run = { type: 'done', key: 'k', view: viewOf([10, 11, 12]), files: [], seconds: 1 };
  return [run, ...actions].reduce((state, action) => page.reducer.reduceBlock(state, action), BLOCK_INITIAL);
}

const reject = { kind: 'reject_points', points: [{ tie_point: 11 }] };

test('of thousands of edits those about the present state are listed, and more on demand', () => {
  const { inSight } = page.history;
  const edits = Array.from({ length: 10_000 }, (_, i) => i);
  assert.deepEqual(inSight({ edits, done: 10_000 }, 50), { from: 9950, to: 10_000 });
  assert.deepEqual(inSight({ edits, done: 5000 }, 50), { from: 4950, to: 5050 });
  assert.deepEqual(inSight({ edits, done: 0 }, 50), { from: 0, to: 50 });
  assert.deepEqual(inSight({ edits, done: 5000 }, 10_000), { from: 0, to: 10_000 });
});

test('edits are named by what they did', () => {
  const { nameOfEdit } = page.naming;
  const observations = Array.from({ length: 14 }, (_, image) => ({ point: { tie_point: 1 }, image }));
  assert.equal(nameOfEdit({ kind: 'reject_observations', observations }), 'reject 14 observations');
  assert.equal(nameOfEdit(reject), 'reject 1 point');
  assert.equal(nameOfEdit({ kind: 'restore_images', images: [1, 2] }), 'restore 2 images');
  assert.equal(nameOfEdit({ kind: 'measure', point: { manual: 0 }, image: 0, x_px: 1, y_px: 2, by: 'hand' }), 'measure 1 observation');
  assert.equal(nameOfEdit({ kind: 'add_point', observations: observations.slice(0, 3) }), 'add 1 point in 3 images');
  // By the names of images and surveyed points, where these are known.
  const names = page.naming.namesOf({ images: [{ name: 'a.jpg' }, { name: 'b.jpg' }], connections: [], surveyed: [{ name: 'G7', control: 3 }] });
  assert.equal(nameOfEdit({ kind: 'reject_images', images: [1] }, names), 'reject b.jpg');
  assert.equal(nameOfEdit({ kind: 'reject_observations', observations: observations.slice(0, 1) }, names), 'reject 1 observation in a.jpg');
  assert.equal(nameOfEdit({ kind: 'set_use', point: 3, use: 'check' }, names), 'use G7 as check point');
  assert.equal(nameOfEdit({ kind: 'set_use', point: 3 }, names), 'leave G7 out');
  const measure = (/** @type {number} */ image) => ({ kind: 'measure', point: { ground_control: 3 }, image, x_px: 1, y_px: 2, by: 'hand' });
  assert.equal(page.naming.nameOfStep([measure(0)], names), 'measure G7 in a.jpg');
  assert.equal(page.naming.nameOfStep([measure(0), measure(1)], names), 'measure G7 in 2 images');
});

test('points keep what they are through an edit, and what is chosen stays chosen', () => {
  const { sourceOf, indexOfSource, codeOfSource } = page.edits;
  for (const source of [{ tie_point: 4_000_000_000 }, { ground_control: 3 }, { manual: 0 }]) {
    const view = { points: { sources: Float64Array.of(codeOfSource({ tie_point: 0 }), codeOfSource(source)) } };
    assert.deepEqual(sourceOf(view, 1), source);
    assert.equal(indexOfSource(view, source), 1);
  }
  const chosen = after({ type: 'choose', choice: { kind: 'observation', point: 2, image: 1 } }, { type: 'edit', edits: [reject] });
  assert.equal(chosen.shown.edits.length, 0);
  const edited = page.reducer.reduceBlock(chosen, { type: 'edited', view: viewOf([10, 12], 0.4), edits: [reject] });
  assert.deepEqual(edited.selection.chosen, { kind: 'observation', point: 1, image: 1 });
  assert.equal(edited.before.sigma0Px, 0.5);
  assert.equal(edited.shown.found, chosen.shown.view);
  // A point that was added is chosen.
  const added = { kind: 'add_point', observations: [] };
  const manual = { ...viewOf([10, 11, 12]), points: { count: 1, sources: Float64Array.of(page.edits.codeOfSource({ manual: 0 })) } };
  assert.deepEqual(page.reducer.reduceBlock(chosen, { type: 'edited', view: manual, edits: [added] }).selection.chosen, { kind: 'point', point: 0 });
  // What is no longer there is no longer chosen.
  const gone = after({ type: 'choose', choice: { kind: 'point', point: 1 } }, { type: 'edited', view: viewOf([10, 12]), edits: [reject] });
  assert.equal(gone.selection.chosen, null);
});

test('a refused edit leaves block and history as they are; undo and redo go through all others', () => {
  let state = after({ type: 'edit', edits: [reject] }, { type: 'edited', view: viewOf([10, 12]), edits: [reject] });
  const { shown } = state;
  state = page.reducer.reduceBlock(state, { type: 'edit', edits: [{ kind: 'reject_images', images: [0, 1, 2] }] });
  assert.equal(state.history.done, 2);
  state = page.reducer.reduceBlock(state, { type: 'editRefused', reason: 'the block falls apart.' });
  assert.deepEqual([state.history.edits, state.history.done, state.shown], [[[reject]], 1, shown]);
  assert.match(state.notice.text, /not made: the block falls apart\. The block is unchanged\./);
  state = page.reducer.reduceBlock(state, { type: 'goto', done: 0 });
  assert.deepEqual([state.history.edits.length, state.history.done], [1, 0]);
  state = page.reducer.reduceBlock(state, { type: 'goto', done: 5 });
  assert.equal(state.history.done, 1);
  // While a run goes on nothing is edited.
  state = page.reducer.reduceBlock(state, { type: 'started', key: 'k' });
  assert.equal(page.reducer.reduceBlock(state, { type: 'edit', edits: [reject] }), state);
});

test('observations that were measured together are one step; steps are tried one by one where all together are refused', () => {
  const { nameOfStep } = page.naming;
  const { nextEdits } = page.editing;
  const measure = (/** @type {number} */ image, by = 'least_squares') => ({ kind: 'measure', point: { tie_point: 1 }, image, x_px: 1, y_px: 1, by });
  const step = [measure(0), measure(1)];
  assert.equal(nameOfStep(step), 'match 2 observations');
  assert.equal(nameOfStep([...step, measure(2, 'hand')]), 'measure 3 observations');
  const history = { edits: [step, [reject], [reject]], done: 3 };
  assert.deepEqual(nextEdits(history, [], false), { edits: [...step, reject, reject], several: true });
  assert.deepEqual(nextEdits(history, [], true), { edits: step, several: true });
  assert.deepEqual(nextEdits(history, step, true), { edits: [...step, reject], several: true });
  assert.deepEqual(nextEdits(history, [...step, reject], true), { edits: [...step, reject, reject], several: false });
  assert.deepEqual(nextEdits({ ...history, done: 1 }, [...step, reject], true), { edits: step, several: false });
});

test('what is chosen is rejected once and restored once', () => {
  const { editOfChoice, standingOf } = page.edits;
  const view = viewOf([10, 11, 12]);
  const none = standingOf([]);
  const observation = { kind: 'observation', point: 1, image: 2 };
  const off = editOfChoice('reject', observation, view, none);
  assert.deepEqual(off, { kind: 'reject_observations', observations: [{ point: { tie_point: 11 }, image: 2 }] });
  assert.equal(editOfChoice('restore', observation, view, none), null);
  assert.deepEqual(editOfChoice('reject', observation, view, none, true), reject);
  const standing = standingOf([off, reject, { kind: 'reject_images', images: [3] }]);
  assert.equal(editOfChoice('reject', observation, view, standing), null);
  // Of what is out with its point the point comes back first.
  assert.deepEqual(editOfChoice('restore', observation, view, standing), { ...reject, kind: 'restore_points' });
  const alone = standingOf([off]);
  assert.deepEqual(editOfChoice('restore', observation, view, alone), { ...off, kind: 'restore_observations' });
  // A point of which observations alone are out gets these back.
  assert.deepEqual(editOfChoice('restore', { kind: 'point', point: 1 }, view, alone), { ...off, kind: 'restore_observations' });
  // Of several points those that stand already are left aside.
  assert.deepEqual(editOfChoice('reject', { kind: 'points', points: Uint32Array.of(0, 1, 2) }, view, standing), {
    kind: 'reject_points',
    points: [{ tie_point: 10 }, { tie_point: 12 }],
  });
  assert.deepEqual(editOfChoice('restore', { kind: 'image', image: 3 }, view, standing), { kind: 'restore_images', images: [3] });
  assert.equal(editOfChoice('reject', { kind: 'pair', images: [0, 1] }, view, standing), null);
  assert.deepEqual(
    [
      ...standingOf([
        { kind: 'set_use', point: 1 },
        { kind: 'set_use', point: 2 },
        { kind: 'set_use', point: 1, use: 'check' },
      ]).unused,
    ],
    [2],
  );
  // An observation that is measured takes part again.
  const again = standingOf([off, { kind: 'measure', point: { tie_point: 11 }, image: 2, x_px: 1, y_px: 1, by: 'hand' }]);
  assert.equal(again.observations.size, 0);
  assert.deepEqual([...(again.measured.get(2) ?? [])], [page.edits.codeOfSource({ tie_point: 11 })]);
});

test('a draft is rounded, held within its image, and becomes edits once enough of it is placed', () => {
  const { begun, placed, editsOfDraft } = page.draft;
  const size = { width: 100, height: 80 };
  let draft = placed(begun(null), 2, [10.1234, -5], size);
  assert.equal(editsOfDraft(draft), null);
  draft = placed(draft, 0, [200, 33.339], size, 'least_squares');
  assert.deepEqual(editsOfDraft(draft), [
    {
      kind: 'add_point',
      observations: [
        { image: 2, x_px: 10.12, y_px: 0, by: 'hand' },
        { image: 0, x_px: 100, y_px: 33.34, by: 'least_squares' },
      ],
    },
  ]);
  assert.equal(editsOfDraft(begun({ tie_point: 1 })), null);
  assert.deepEqual(editsOfDraft(placed(begun({ tie_point: 1 }), 3, [1, 2], size)), [
    { kind: 'measure', point: { tie_point: 1 }, image: 3, x_px: 1, y_px: 2, by: 'hand' },
  ]);
});

test('after a new run what was measured by hand stays, by the names of the images, and it is said what does not', () => {
  const place = (/** @type {number} */ image) => ({ image, x_px: 1, y_px: 2, by: 'hand' });
  const edits = [
    reject,
    { kind: 'add_point', observations: [place(2), place(3)] },
    { kind: 'add_point', observations: [place(0), place(1)] },
    { kind: 'measure', point: { manual: 1 }, ...place(3) },
    { kind: 'measure', point: { tie_point: 7 }, ...place(3) },
    { kind: 'reject_images', images: [2] },
  ];
  const before = after(...edits.map((edit) => ({ type: 'edit', edits: [edit] })));
  // The third image is no longer there.
  const view = { ...viewOf([5]), images: ['x', 'a', 'b', 'd'].map((name) => ({ name, rays: 1 })) };
  const state = page.reducer.reduceBlock(before, { type: 'done', key: 'k', view, files: [], seconds: 1 });
  assert.deepEqual(state.history.edits, [
    [{ kind: 'add_point', observations: [place(1), place(2)] }],
    [{ kind: 'measure', point: { manual: 0 }, ...place(3) }],
  ]);
  assert.match(state.notice.text, /^2 edits by hand were kept\. 4 edits/);
});

/** A block without the image c, as it is found anew. */
const withoutC = () => ({ ...viewOf([5]), images: ['a', 'b', 'd'].map((name) => ({ name, rays: 1 })) });

const anew = (/** @type {any} */ state, view = withoutC()) => page.reducer.reduceBlock(state, { type: 'done', key: 'k', view, files: [], seconds: 1 });

test('after a new run steps stay steps, and those that were undone are done again where they still apply', () => {
  const place = (/** @type {number} */ image) => ({ image, x_px: 1, y_px: 2, by: 'hand' });
  const measure = (/** @type {number} */ point, /** @type {number} */ image) => ({ kind: 'measure', point: { manual: point }, ...place(image) });
  const add = (/** @type {number[]} */ ...images) => ({ kind: 'add_point', observations: images.map(place) });
  const steps = [
    [add(0, 1)],
    [measure(0, 2), measure(0, 3)],
    [reject, { kind: 'reject_images', images: [0] }],
    // From here on undone.
    [reject],
    [{ kind: 'reject_points', points: [{ tie_point: 10 }, { tie_point: 12 }] }, add(0, 1)],
    [add(1, 3)],
    [measure(1, 3)],
    [measure(2, 0)],
  ];
  const state = anew(after(...steps.map((edits) => ({ type: 'edit', edits })), { type: 'goto', done: 3 }));
  // One of both that were measured together is in the image that is gone. The point that was not added has no number.
  const left = [[add(0, 1)], [measure(0, 2)], [{ kind: 'reject_images', images: [0] }], [add(1, 2)], [measure(1, 0)]];
  assert.deepEqual(state.history, { edits: left, done: 3 });
  assert.equal(
    state.notice.text,
    '3 edits by hand were kept. 2 edits of points of the former block do not apply to the new one. ' +
      '3 undone edits of points of the former block cannot be redone in the new one: reject 1 point, join 2 points, measure 1 observation in d.',
  );
  const redone = page.reducer.reduceBlock(state, { type: 'goto', done: 5 });
  assert.equal(page.editing.editsInForce(redone.history).length, 5);
  // Where all were undone they are kept as well, and nothing is said where none is lost.
  const undone = anew(after({ type: 'edit', edits: [add(0, 1)] }, { type: 'goto', done: 0 }));
  assert.deepEqual([undone.history, undone.notice], [{ edits: [[add(0, 1)]], done: 0 }, null]);
});

test('a block that is found as it was keeps all its edits, and one that is so again has them back', () => {
  const image = { kind: 'reject_images', images: [0] };
  const other = { kind: 'reject_points', points: [{ tie_point: 12 }] };
  const mark = { type: 'mark', step: { kind: 'measure', marks: [{ image: 'a', point: 'A', x_px: 1, y_px: 2 }], after: 2 } };
  const edited = after(...[reject, image].map((edit) => ({ type: 'edit', edits: [edit] })), mark, { type: 'edit', edits: [other] }, { type: 'goto', done: 2 });
  const again = anew(edited, viewOf([10, 11, 12]));
  assert.deepEqual(again.history, { edits: [[reject], [image], [other]], done: 2 });
  assert.equal(again.notice.text, '2 edits by hand were kept.');
  // Points of other rays are others.
  const rays = (/** @type {any} */ view) => ({ ...view, points: { ...view.points, rays: Uint16Array.of(2, 3, 2) } });
  assert.deepEqual(anew(edited, rays(viewOf([10, 11, 12]))).history.edits, [[image]]);
  // An image is taken out, and comes back.
  const without = anew(again);
  assert.deepEqual(without.history, { edits: [[image]], done: 1 });
  assert.equal(without.marks.edits[0].after, 1);
  const back = anew(without, viewOf([10, 11, 12]));
  assert.deepEqual(back.history, again.history);
  assert.deepEqual(back.marks, again.marks);
  assert.equal(back.notice.text, '2 edits by hand were kept.');
  // Another one is taken out after a run that changed nothing, and both come back at once.
  const two = anew(anew(without), { ...viewOf([6]), images: ['a', 'b'].map((name) => ({ name, rays: 1 })) });
  assert.deepEqual([anew(two, viewOf([10, 11, 12])).history, anew(two, viewOf([10, 11, 12])).marks], [again.history, again.marks]);
  // Which tie points a block has that was opened or restored is not known.
  const restored = { ...edited, shown: { ...edited.shown, tiePoints: '' } };
  assert.deepEqual(anew(restored, viewOf([10, 11, 12])).history.edits, [[image]]);
  // What was edited meanwhile is not lost for it.
  const added = page.reducer.reduceBlock(without, { type: 'edit', edits: [{ kind: 'reject_images', images: [1] }] });
  assert.deepEqual(anew(added, viewOf([10, 11, 12])).history.edits, [[image], [{ kind: 'reject_images', images: [1] }]]);
});

test('edits that wait for their block to be found again wait for it after the page was loaded anew too', () => {
  const { formerParts, formerFrom } = page.keep_former;
  const image = { kind: 'reject_images', images: [0] };
  const edited = after(...[reject, image].map((edit) => ({ type: 'edit', edits: [edit] })));
  const without = anew(edited);
  const two = anew(without, { ...viewOf([6]), images: ['a', 'b'].map((name) => ({ name, rays: 1 })) });
  const emptied = anew(after({ type: 'edit', edits: [reject] }));
  /** What the browser has of it, and the page makes of that.  @param {any} state */
  const loadedAnew = (state) => {
    const journal = () => new page.journal.Journal('block/edits', page.edit.stepFrom, page.edit.bytesOfStep);
    const kept = new Map([...journal().parts(state.history), ...formerParts(state.former, state.history)]);
    assert.ok((kept.get('block/former')?.bytes ?? 0) > 0);
    // What has not changed is not written again.
    assert.equal(formerParts(state.former, state.history).get('block/former').value, kept.get('block/former').value);
    const parts = structuredClone(new Map([...kept].map(([name, { value }]) => [name, value])));
    const history = journal().read(parts);
    return { ...state, history, former: formerFrom(parts, history) };
  };
  for (const state of [without, two, emptied, loadedAnew(two)]) {
    const loaded = loadedAnew(state);
    assert.deepEqual(loaded.former, state.former);
    const [back, wanted] = [loaded, state].map((one) => anew(one, viewOf([10, 11, 12])));
    assert.ok(wanted.history.edits.length > state.history.edits.length);
    assert.deepEqual([back.history, back.notice.text], [wanted.history, wanted.notice.text]);
  }
  // What was edited since is no way back, loaded anew or not.
  const loaded = loadedAnew(without);
  const added = page.reducer.reduceBlock(loaded, { type: 'edit', edits: [{ kind: 'reject_images', images: [1] }] });
  for (const state of [added, loadedAnew(added)])
    assert.deepEqual(anew(state, viewOf([10, 11, 12])).history.edits, [[image], [{ kind: 'reject_images', images: [1] }]]);
  // Edits since are written without what waits.
  const later = page.reducer.reduceBlock(added, { type: 'edit', edits: [{ kind: 'reject_images', images: [2] }] });
  const [one, other] = [added, later].map((state) => formerParts(state.former, state.history).get('block/former'));
  assert.ok(one.bytes > 0 && one.value.now === '');
  assert.equal(other.value, formerParts(added.former, added.history).get('block/former').value);
  // Where places of an orthophoto lay is kept, too.
  const spots = { images: ['a'], tie_points: [2, 4], given: 1, places: [{ seen: [{ image: 0, at_px: [1, 2], side_px: 9 }] }] };
  const placed = { ...without, former: without.former.map((/** @type {object} */ one) => ({ ...one, spots })) };
  assert.deepEqual(loadedAnew(placed).former, placed.former);
  const spoilt = formerParts([{ ...placed.former[0], spots: { ...spots, given: 'x' } }], without.history);
  assert.throws(() => formerFrom(new Map([...spoilt].map(([name, { value }]) => [name, value])), without.history), /former\[0\]\.spots\.given/);
  // Earlier releases kept none; what is damaged is named.
  assert.deepEqual(formerFrom(new Map(), without.history), []);
  const damaged = new Map([['block/former', { now: 'a', former: [{ tiePoints: 1 }] }]]);
  assert.throws(() => formerFrom(damaged, without.history), /former\[0\]\.tiePoints/);
});

test('steps beside the edits keep their places among them through a new run, a refusal, and a new edit after others were undone', () => {
  const image = (/** @type {number} */ one) => ({ type: 'edit', edits: [{ kind: 'reject_images', images: [one] }] });
  const mark = (/** @type {number} */ past) => ({
    type: 'mark',
    step: { kind: 'measure', marks: [{ image: 'a', point: 'A', x_px: 1, y_px: past }], after: past },
  });
  const order = (/** @type {any} */ state) =>
    page.timeline
      .timelineOf(state)
      .edits.map((/** @type {any} */ { of, at }) => `${of.charAt(0)}${at}`)
      .join(' ');
  // The second edit is of the image that is gone.
  assert.equal(order(after(image(0), image(2), mark(2), image(3))), 'e0 e1 m0 e2');
  assert.equal(order(anew(after(image(0), image(2), mark(2), image(3)))), 'e0 m0 e1');
  // Two that were measured at once are one step.
  const both = { type: 'edit', edits: [...image(0).edits, ...image(1).edits] };
  assert.equal(order(anew(after(both, mark(1), image(3)))), 'e0 m0 e1');
  // The second edit is refused: one that is made then comes last.
  const [first] = image(0).edits;
  const refused = after(image(0), { type: 'edited', view: viewOf([10]), edits: [first] }, image(1), mark(2), { type: 'editRefused', reason: 'no' }, image(3));
  assert.equal(order(refused), 'e0 m0 e1');
  // What redo made last undo takes back first.
  const redone = after(mark(0), image(0), { type: 'goto', done: 0 }, { type: 'gotoMark', done: 0 }, image(1), { type: 'gotoMark', done: 1 });
  assert.equal(order(redone), 'e0 m0');
});

test('points that are one are joined, one that is two is split, as one step with a name', () => {
  const { joined, split } = page.joining;
  const { nameOfStep } = page.naming;
  const place = (/** @type {number} */ image, part = 'accepted', by_hand = false) => ({ image, x_px: 10 * image, y_px: 5, part, by_hand });
  const first = { id: { tie_point: 3 }, observations: [place(0), place(1)] };
  const second = { id: { manual: 0 }, observations: [place(1, 'accepted', true), place(2, 'gross_error'), place(3), place(4, 'rejected_by_hand')] };
  const of = (/** @type {number} */ image, by = 'least_squares') => ({ image, x_px: 10 * image, y_px: 5, by });
  const step = joined([first, second]);
  assert.deepEqual(step, [
    { kind: 'reject_points', points: [{ manual: 0 }, { tie_point: 3 }] },
    { kind: 'add_point', observations: [of(1, 'hand'), of(2), of(3), of(0)] },
  ]);
  assert.equal(nameOfStep(step), 'join 2 points');
  // A surveyed point gets the observations of the other; two of them are never one.
  const surveyed = { id: { ground_control: 7 }, observations: [place(0)] };
  const measured = joined([first, surveyed]);
  assert.deepEqual(measured, [
    { kind: 'reject_points', points: [{ tie_point: 3 }] },
    { kind: 'measure', point: { ground_control: 7 }, ...of(1) },
  ]);
  assert.equal(nameOfStep(measured), 'join 2 points');
  assert.equal(joined([surveyed, { ...surveyed, id: { ground_control: 8 } }]), null);
  assert.equal(joined([first]), null);

  // A point has one place in an image.
  const { apart } = page.joining;
  assert.equal(apart([first, second]), null);
  const beside = (/** @type {number} */ px) => ({ id: { tie_point: 5 }, observations: [place(0), { ...place(1), x_px: 10 + px }] });
  assert.equal(apart([first, beside(4)]), null);
  assert.deepEqual(apart([first, beside(6), beside(-7)]), { image: 1, px: 13 });
  // What is rejected is no place of it.
  const rejected = { id: { tie_point: 6 }, observations: [place(0), { ...place(1, 'rejected_by_hand'), x_px: 300 }, place(2)] };
  assert.equal(apart([first, rejected]), null);

  const four = { id: { tie_point: 9 }, observations: [0, 1, 2, 3].map((image) => place(image)) };
  const parts = split(four, [1, 3, 5]);
  assert.deepEqual(parts, [
    { kind: 'reject_points', points: [{ tie_point: 9 }] },
    { kind: 'add_point', observations: [of(0), of(2)] },
    { kind: 'add_point', observations: [of(1), of(3)] },
  ]);
  assert.equal(nameOfStep(parts), 'split 1 point into 2');
  assert.equal(split(four, [0, 1, 2]), null);
  assert.equal(split({ ...four, id: { ground_control: 1 } }, [1, 3]), null);
});

test('the journal reads edits of all kinds as they were, and names damage', () => {
  const { stepFrom, bytesOfStep } = page.edit;
  const edits = [
    reject,
    { kind: 'restore_observations', observations: [{ point: { ground_control: 0 }, image: 3 }] },
    { kind: 'reject_images', images: [1] },
    {
      kind: 'restore_pairs',
      pairs: [
        [1, 0],
        [2, 3],
      ],
    },
    { kind: 'measure', point: { manual: 2 }, image: 1, x_px: 1.5, y_px: 2.5, by: 'least_squares' },
    { kind: 'add_point', observations: [{ image: 0, x_px: 1, y_px: 2, by: 'hand' }] },
    { kind: 'set_use', point: 3, use: 'check' },
    { kind: 'set_use', point: 3 },
  ].map((edit, i, all) => (i === 0 ? [edit, all[2]] : [edit]));
  const journal = new page.journal.Journal('block/edits', stepFrom, bytesOfStep);
  const kept = new Map([...journal.parts({ edits, done: 4 })].map(([name, { value }]) => [name, structuredClone(value)]));
  assert.deepEqual(journal.read(kept), { edits, done: 4 });
  const read = kept.get('block/edits/0');
  read[4][0].point = {};
  assert.throws(() => journal.read(kept), /edits\[0\]\[4\]\[0\]\.point is damaged/);
  read[3][0].pairs[1] = [2];
  assert.throws(() => journal.read(kept), /edits\[0\]\[3\]\[0\]\.pairs\[1\] is damaged/);
});

test('of many edits only the one that is refused goes; those that were to follow it are still tried', () => {
  const { withoutRefused } = page.editing;
  const steps = [0, 1, 2, 3].map((image) => [{ kind: 'reject_images', images: [image] }]);
  const history = { edits: steps, done: 3 };
  const [first = [], second = [], third = [], undone = []] = steps;
  // What was undone can still be done again.
  assert.deepEqual(withoutRefused(history, []), { edits: [second, third, undone], done: 2 });
  assert.deepEqual(withoutRefused(history, first), { edits: [first, third, undone], done: 2 });
  assert.deepEqual(withoutRefused(history, [...first, ...second]), { edits: [first, second, undone], done: 2 });
  // To go back was refused.
  assert.deepEqual(withoutRefused({ ...history, done: 1 }, [...first, ...second]), { edits: steps, done: 2 });
  // The block has what the history does not.
  assert.deepEqual(withoutRefused({ edits: [second], done: 1 }, first), { edits: [first], done: 1 });
});

test('a new run keeps points by hand as they stand, rejected or not', () => {
  const { carriedOver } = page.carrying;
  const names = (/** @type {string[]} */ images, /** @type {[number, string][]} */ surveyed) => ({
    images,
    surveyed: new Map(surveyed),
    connected: new Set(),
    givenControl: 5,
    system: null,
  });
  const place = (/** @type {number} */ image) => ({ image, x_px: 1, y_px: 2, by: 'hand' });
  const edits = [
    { kind: 'add_point', observations: [place(0), place(2)] },
    { kind: 'add_point', observations: [place(0), place(1)] },
    { kind: 'reject_points', points: [{ manual: 1 }, { tie_point: 7 }] },
    { kind: 'reject_observations', observations: [{ point: { manual: 1 }, image: 1 }] },
    { kind: 'restore_points', points: [{ manual: 0 }] },
    // Surveyed points by their names: one is gone.
    { kind: 'set_use', point: 0, use: 'check' },
    { kind: 'set_use', point: 1 },
    { kind: 'measure', point: { ground_control: 0 }, ...place(1) },
  ];
  const before = names(
    ['a', 'b', 'c'],
    [
      [0, 'north'],
      [1, 'south'],
    ],
  );
  // The third image is gone, and with it the first point.
  const all = { edits: edits.map((edit) => [edit]), done: edits.length };
  const { history, lost } = carriedOver(all, before, names(['b', 'a'], [[4, 'north']]));
  assert.equal(lost, 3);
  assert.deepEqual(history.edits.flat(), [
    { kind: 'add_point', observations: [place(1), place(0)] },
    { kind: 'reject_points', points: [{ manual: 0 }] },
    { kind: 'reject_observations', observations: [{ point: { manual: 0 }, image: 0 }] },
    { kind: 'set_use', point: 4, use: 'check' },
    { kind: 'measure', point: { ground_control: 4 }, ...place(0) },
  ]);
});

test('places of the orthophoto are counted once, and edits that are lost for them apart', () => {
  const before = { images: ['a', 'b'], surveyed: new Map([0, 1, 2].map((i) => [i, `orthophoto_${i}`])), connected: new Set(), givenControl: 3 };
  const rejected = (/** @type {number[]} */ places) => ({ kind: 'reject_points', points: places.map((place) => ({ ground_control: place })) });
  const measured = { kind: 'measure', point: { ground_control: 0 }, image: 1, x_px: 1, y_px: 2, by: 'hand' };
  const edits = [
    rejected([0]),
    { ...rejected([0, 2]), kind: 'restore_points' },
    measured,
    rejected([1]),
    rejected([1]),
    { kind: 'reject_points', points: [{ tie_point: 1 }] },
  ];
  const again = [0, 2].map((place) => ({ before: place, now: place + 5, is_same_spot: false, images: [] }));
  const { lost, places } = page.carrying.carriedOver({ edits: edits.map((edit) => [edit]), done: edits.length }, before, before, false, again);
  // Of place 0 all but the measurement holds, of place 2 all, of place 1 nothing.
  assert.deepEqual([lost, places], [4, { held: 2, lost: 2, edits: 3 }]);
});

test('differences of other check points than before are said to be of others', () => {
  const { comparedText, figuresOf } = page.edited;
  const checks = (/** @type {number} */ points, /** @type {number} */ off) => ({ ...viewOf([10]), checks: { points, rmse_m: [off, 0, 0] } });
  const text = (/** @type {any} */ before, /** @type {any} */ now) => comparedText(figuresOf(before), figuresOf(now));
  assert.match(text(checks(2, 0.212), checks(1, 0.216)), / · check points 0\.212 → 0\.216 m \(2 → 1 point\)$/);
  assert.match(text(checks(2, 0.212), checks(2, 0.216)), / · check points 0\.212 → 0\.216 m$/);
  assert.match(text(checks(1, 0.2), viewOf([10])), / · check points 0\.200 → – m \(1 → 0 points\)$/);
  assert.equal(text(viewOf([10]), viewOf([10])), 'σ₀ 0.500 → 0.500 px · RMSE 0.300 → 0.300 px');
});

test('a surveyed point that was left out comes back with its use', () => {
  const { standingOf } = page.edits;
  const off = { kind: 'set_use', point: 2, use: null };
  assert.deepEqual([...standingOf([off]).unused], [2]);
  assert.deepEqual([...standingOf([off, { kind: 'restore_points', points: [{ ground_control: 2 }] }]).unused], []);
});

test('an image that is removed stays beside the block, is named, kept, and comes back where it was', () => {
  const { reduceBlock } = page.reducer;
  const files = ['a', 'b', 'c', 'd'].map((name, i) => ({ id: i + 1, name, file: new Blob([name]) }));
  const found = after({ type: 'files', files, truth: null });
  const step = { kind: 'remove_images', files: [2], after: 0 };
  const removed = reduceBlock(found, { type: 'mark', step });
  const names = (/** @type {any} */ state) => state.files.map((/** @type {any} */ { name }) => name).join('');
  assert.equal(names(removed), 'acd');
  assert.deepEqual(removed.removed, [files[1]]);
  assert.equal(page.naming.nameOfMarks(step), 'remove 1 image');
  assert.equal(page.naming.nameOfMarks({ ...step, files: [1, 2] }), 'remove 2 images');
  const back = reduceBlock(removed, { type: 'gotoMark', done: 0 });
  assert.deepEqual([names(back), back.removed], ['abcd', []]);
  assert.equal(page.state.wantedKey(back), page.state.wantedKey(found));
  assert.equal(names(reduceBlock(back, { type: 'gotoMark', done: 1 })), 'acd');
  // An image of its name that was given meanwhile stays.
  const other = { id: 9, name: 'b', file: new Blob(['other']) };
  const given = reduceBlock(removed, { type: 'files', files: [...removed.files, other], truth: null });
  assert.ok(reduceBlock(given, { type: 'gotoMark', done: 0 }).files.includes(other));
  assert.equal(names(reduceBlock(given, { type: 'gotoMark', done: 0 })).length, 4);
  const { markStepFrom } = page.edit;
  assert.deepEqual(markStepFrom(structuredClone(step), 'marks[0]'), step);
  assert.throws(() => markStepFrom({ ...step, files: ['b'] }, 'marks[0]'), /marks\[0\]\.files\[0\] is damaged/);
});
