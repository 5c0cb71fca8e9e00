/** What the page does with an orthophoto, and what becomes of edits in its system: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(
    page,
    await pageModules([
      'block/state/state',
      'block/state/reducer',
      'block/state/purpose',
      'block/state/doubt',
      'block/state/showing',
      'block/state/added',
      'block/state/places',
      'block/state/draft',
      'block/state/editing',
      'block/state/naming',
      'block/state/words',
      'block/state/former',
      'block/files/edit',
      'block/view/orthophoto/block',
    ]),
  );
});

const file = (/** @type {number} */ id) => ({ id, name: `photo_${id}.png`, file: new Blob([]) });
const raster = (/** @type {number} */ id) => ({ ...file(id), world: null, projection: null });
const orthophoto = (/** @type {number} */ id, /** @type {string | null} */ ofBlock = null) => ({ raster: raster(id), info: {}, ofBlock });
const view = (/** @type {string[]} */ surveyed = [], more = {}) => ({
  partial: false,
  oriented: 2,
  images: [1, 2].map((id) => ({ name: `photo_${id}.png`, rays: 0 })),
  points: { count: 0, taking: 0, sources: new Float64Array(), rays: new Uint16Array() },
  connections: [],
  surveyed: surveyed.map((name, control) => ({ name, control })),
  // None of them is one that edits added.
  givenControl: 9,
  orthophoto: null,
  crs: null,
  origin: null,
  geoidM: null,
  components: [],
  checks: null,
  ...more,
});

/** A state after actions, with two photographs. @param {object[]} actions */
const after = (...actions) =>
  [{ type: 'files', files: [file(1), file(2)], truth: null }, ...actions].reduce(
    (state, action) => page.reducer.reduceBlock(state, action),
    page.state.BLOCK_INITIAL,
  );

const model = (/** @type {number} */ id) => ({ type: 'heights', heights: { kind: 'model', model: raster(id) }, info: {} });
const given = [{ type: 'orthophoto', orthophoto: orthophoto(7) }, model(8)];
const run = (/** @type {any} */ state, found = view()) => [
  { type: 'started', key: page.state.wantedKey(state) },
  { type: 'done', key: page.state.wantedKey(state), view: found, files: state.files, seconds: 1 },
];

test('photographs with an orthophoto are a block where it has heights, else each is placed by itself; a finished block is asked about', () => {
  const { purposeOf, asksPurpose } = page.purpose;
  assert.equal(purposeOf(after()), null);
  assert.equal(purposeOf(after(given[0])), 'images');
  assert.equal(purposeOf(after(...given)), 'block');
  assert.equal(purposeOf(after({ type: 'files', files: [file(1)], truth: null }, ...given)), 'images');
  const finished = after(...run(after()));
  assert.ok(!asksPurpose(finished));
  const asked = given.reduce(page.reducer.reduceBlock, finished);
  assert.ok(asksPurpose(asked) && purposeOf(asked) === null);
  assert.equal(purposeOf(page.reducer.reduceBlock(asked, { type: 'purpose', purpose: 'map' })), 'map');
  // One that was made of the block, and a block that came in the system of an orthophoto, ask nothing.
  assert.equal(purposeOf(page.reducer.reduceBlock(finished, { type: 'orthophoto', orthophoto: orthophoto(9, 'key') })), 'images');
  const opened = after(
    { type: 'openedFile', view: view([], { orthophoto: { kind: 'linked', text: '' } }), steps: [], options: page.state.BLOCK_INITIAL.options },
    ...given,
  );
  assert.equal(purposeOf(opened), 'map');
  assert.ok(!page.purpose.lacksPlaceAlone(page.reducer.reduceBlock(opened, { type: 'purpose', purpose: 'block' })));
  // What could not be oriented as a block.
  assert.equal(purposeOf(after(...run(after(), view([], { oriented: 0 })), ...given)), 'images');
});

test('a block is off its ground until it is placed, and again after other heights or options', () => {
  const { isOffGround, lacksPlaceAlone, groundKey } = page.purpose;
  const reduce = page.reducer.reduceBlock;
  const wanted = [...given, { type: 'purpose', purpose: 'block' }].reduce(reduce, after(...run(after())));
  assert.ok(isOffGround(wanted) && lacksPlaceAlone(wanted));
  const ground = { key: groundKey(wanted), before: new Blob([]) };
  const placed = reduce(wanted, { type: 'onGround', view: view(['orthophoto_1']), edits: [], ground });
  assert.ok(!isOffGround(placed) && placed.shown.found.surveyed.length === 1);
  assert.ok(lacksPlaceAlone(reduce(placed, model(10))));
  assert.ok(!isOffGround(reduce(reduce(placed, model(10)), { type: 'purpose', purpose: 'map' })));
  // Other images: all of it is run.
  const more = reduce(placed, { type: 'files', files: [...placed.files, file(3)], truth: null });
  assert.ok(!lacksPlaceAlone(more) && page.purpose.isStale(more));
});

test('that images record positions elsewhere is said until they, or their block, are on the orthophoto', () => {
  const { doubtOf } = page.doubt;
  const reduce = page.reducer.reduceBlock;
  const said = { type: 'elsewhere', text: 'elsewhere' };
  // Each image by itself: one without a place leaves the doubt.
  const images = after(given[0], said);
  const result = (/** @type {object | null} */ placement) => ({
    type: 'placed',
    image: images.files[0],
    placed: { key: '', result: { placement }, problem: '', steps: [], done: 0 },
  });
  assert.deepEqual([doubtOf(after(given[0])), doubtOf(images)], ['', 'elsewhere']);
  assert.deepEqual([doubtOf(reduce(images, result(null))), doubtOf(reduce(images, result({})))], ['elsewhere', '']);
  // A block: it is placed, not linked, and wanted on other heights.
  const wanted = [...given, said, { type: 'purpose', purpose: 'block' }].reduce(reduce, after(...run(after())));
  const ground = { key: page.purpose.groundKey(wanted), before: new Blob([]) };
  const on = (/** @type {string} */ kind) => reduce(wanted, { type: 'onGround', view: view([], { orthophoto: { kind, text: '' } }), edits: [], ground });
  assert.deepEqual([doubtOf(wanted), doubtOf(on('failed')), doubtOf(on('linked'))], ['elsewhere', 'elsewhere', '']);
  assert.equal(doubtOf(reduce(on('linked'), model(10))), 'elsewhere');
  assert.equal(doubtOf(reduce(wanted, { type: 'options', options: { gps: 'ignore' } })), '');
  assert.equal(doubtOf(reduce(wanted, { type: 'purpose', purpose: 'map' })), '');
});

test('edits hold in the system of an orthophoto, but for those of places of another one', () => {
  const reduce = page.reducer.reduceBlock;
  const edits = [
    { kind: 'reject_points', points: [{ tie_point: 5 }] },
    { kind: 'set_use', point: 0, use: 'check' },
  ];
  const before = edits.reduce((state, edit) => reduce(state, { type: 'edit', edits: [edit] }), after(...run(after(), view(['G1']))));
  const ground = { key: '', before: new Blob([]) };
  const placed = reduce(before, { type: 'onGround', view: view(['G1', 'orthophoto_1']), edits: [], ground });
  assert.equal(placed.history, before.history);
  const rejected = reduce(placed, { type: 'edit', edits: [{ kind: 'reject_points', points: [{ ground_control: 1 }, { ground_control: 0 }] }] });
  const again = reduce(rejected, { type: 'onGround', view: view(['G1', 'orthophoto_1']), edits: [], ground });
  assert.deepEqual(again.history.edits.flat().slice(2), [{ kind: 'reject_points', points: [{ ground_control: 0 }] }]);
  const other = reduce(placed, { type: 'edit', edits: [{ kind: 'reject_points', points: [{ ground_control: 1 }] }] });
  assert.equal(reduce(other, { type: 'onGround', view: view(['G1']), edits: [], ground: null }).history.edits.length, 2);
});

test('edits of places hold of those that lie where they lay, whatever their names, and what does not hold is said', () => {
  const reduce = page.reducer.reduceBlock;
  const ground = { key: '', before: new Blob([]) };
  const names = ['G1', 'orthophoto_1', 'orthophoto_2', 'orthophoto_3'];
  const placed = reduce(after(...run(after(), view(['G1'], { givenControl: 1 }))), {
    type: 'onGround',
    view: view(names, { givenControl: 4 }),
    edits: [],
    ground,
  });
  const point = (/** @type {number} */ control) => ({ ground_control: control });
  const out = (/** @type {number} */ control, /** @type {number} */ image) => ({
    kind: 'reject_observations',
    observations: [{ point: point(control), image }],
  });
  const steps = [
    [{ kind: 'reject_points', points: [point(0), point(1), point(3)] }],
    [out(1, 0)],
    [out(1, 1)],
    // What is measured of the same spot holds, with what is done to it; of another spot it does not.
    [measure(2, 1), out(2, 1)],
    [measure(1, 1)],
    [{ kind: 'set_use', point: 2, use: 'check' }],
    [place(1)],
    [measure(4, 0)],
  ];
  const edited = steps.reduce((state, edits) => reduce(state, { type: 'edit', edits }), placed);
  const again = [
    { before: 1, now: 2, is_same_spot: false, images: [0] },
    { before: 2, now: 1, is_same_spot: true, images: [0] },
  ];
  const now = reduce(reduce(edited, { type: 'goto', done: 7 }), {
    type: 'onGround',
    view: view(['G1', 'orthophoto_1', 'orthophoto_2'], { givenControl: 3 }),
    edits: [],
    ground,
    again,
  });
  assert.deepEqual(now.history, {
    edits: [
      [{ kind: 'reject_points', points: [point(0), point(2)] }],
      [out(2, 0)],
      [measure(1, 1), out(1, 1)],
      [{ kind: 'set_use', point: 1, use: 'check' }],
      [place(1)],
      [measure(3, 0)],
    ],
    done: 5,
  });
  assert.match(now.notice.text, /holds for 2 that lie there again, and not for 2: nothing was found there/);
  // Off the orthophoto nothing can lie again.
  const off = reduce(edited, { type: 'onGround', view: view(['G1'], { givenControl: 1 }), edits: [], ground: null });
  assert.ok(/not apply to the new one/.test(off.notice.text) && !/lie there again/.test(off.notice.text), off.notice.text);
  // Where all hold nothing else is said.
  const all = reduce(reduce(placed, { type: 'edit', edits: [out(2, 0)] }), {
    type: 'onGround',
    view: view(names.slice(0, 3), { givenControl: 3 }),
    edits: [],
    ground,
    again,
  });
  assert.equal(all.notice.text, '1 edit by hand was kept. What was done to 1 place of the orthophoto holds where it lies again.');
});

/** A place that was measured by hand.  @param {number} number */
const place = (number, position = [530, 880, 12]) => ({
  kind: 'add_control',
  name: `orthophoto_hand_${number}`,
  position,
  standard_errors: [0.3, 0.5],
  sigma_px: 1,
  use: 'control',
  epsg: 25832,
});
const measure = (/** @type {number} */ control, /** @type {number} */ image) => ({
  kind: 'measure',
  point: { ground_control: control },
  image,
  x_px: 10 * image,
  y_px: 5,
  by: 'hand',
});

test('places by hand keep their image measurements on another orthophoto, whatever numbers it gives them, and over a reload', () => {
  const reduce = page.reducer.reduceBlock;
  const own = view(['G1'], { givenControl: 1 });
  const steps = [[place(1)], [measure(1, 0), measure(1, 1)], [place(2)], [measure(2, 1)], [{ kind: 'set_use', point: 2, use: 'check' }]];
  const before = steps.reduce((state, edits) => reduce(state, { type: 'edit', edits }), after(...run(after(), own)));
  const linkedView = view(['G1', 'orthophoto_1', 'orthophoto_2'], { givenControl: 4 });
  const placed = reduce(before, { type: 'onGround', view: linkedView, edits: [], ground: { key: '', before: new Blob([]) } });
  const there = [[place(1)], [measure(4, 0), measure(4, 1)], [place(2)], [measure(5, 1)], [{ kind: 'set_use', point: 5, use: 'check' }]];
  assert.deepEqual(placed.history, { edits: there, done: 5 });
  // Steps that were undone too, and what is read of the browser's storage.
  const elsewhere = { type: 'onGround', view: linkedView, edits: [], ground: { key: '', before: new Blob([]) } };
  const undone = reduce(reduce(before, { type: 'goto', done: 2 }), elsewhere);
  assert.deepEqual(undone.history, { edits: there, done: 2 });
  assert.deepEqual(page.edit.stepFrom(structuredClone(steps[0]), 'step'), steps[0]);
  const heights = { kind: 'orthophoto_heights', heights: 'EGM96', from_ellipsoid: false, crs: 'EPSG:4979', above_m: null };
  assert.deepEqual(page.edit.stepFrom([{ ...place(1), remarks: [heights] }], 'step'), [{ ...place(1), remarks: [heights] }]);
  assert.throws(() => page.edit.stepFrom([{ ...place(1), name: 7 }], 'step'), /step\[0\]\.name is damaged/);
  assert.equal(page.naming.nameOfStep(steps[0]), 'add the place orthophoto_hand_1');
  assert.equal(page.added.nextPlace(undone.history), 3);
  assert.equal(page.added.nextPlace({ edits: [], done: 0 }), 1);
});

test('a block that is taken off the orthophoto leaves the places by hand that would bring it back, and redo makes them again', () => {
  const reduce = page.reducer.reduceBlock;
  const own = view(['G1'], { givenControl: 1 });
  const onGround = { type: 'onGround', view: view(['G1', 'orthophoto_1'], { givenControl: 2 }), edits: [], ground: { key: '', before: new Blob([]) } };
  const off = { type: 'onGround', view: own, edits: [], ground: null };
  const rejects = (/** @type {object[]} */ ...points) => ({ kind: 'reject_points', points });
  const added = { kind: 'add_point', observations: [0, 1].map((image) => ({ image, x_px: 9, y_px: 9, by: 'hand' })) };
  const surveyed = { ...place(1), name: 'manhole' };
  const edited = [
    [place(1)],
    [measure(2, 0), measure(2, 1)],
    [rejects({ tie_point: 5 })],
    [surveyed],
    [measure(3, 0)],
    // A place is split into points: these stay, so that later ones have their numbers.
    [rejects({ ground_control: 2 }), added],
    [rejects({ manual: 0 }, { ground_control: 3 })],
    [{ kind: 'set_use', point: 2, use: 'check' }],
    [place(2)],
  ].reduce((state, edits) => reduce(state, { type: 'edit', edits }), reduce(after(...run(after(), own)), onGround));
  const beside = reduce(reduce(edited, { type: 'mark', step: { kind: 'remove_images', files: [], after: 9 } }), { type: 'goto', done: 8 });
  const back = reduce(beside, off);
  const stay = [[rejects({ tie_point: 5 })], [surveyed], [measure(1, 0)], [added], [rejects({ manual: 0 }, { ground_control: 1 })]];
  const again = [[place(1)], [measure(2, 0), measure(2, 1)], [rejects({ ground_control: 2 })], [{ kind: 'set_use', point: 2, use: 'check' }]];
  assert.deepEqual(back.history, { edits: [...stay, ...again, [place(2)]], done: 5 });
  assert.deepEqual([back.marks.edits[0].after, back.notice.kind, back.notice.beside], [10, 'info', true]);
  assert.match(back.notice.text, /^5 edits by hand were kept\. 4 steps of places by hand were undone, .*: Redo makes them again\.$/);
  assert.equal(back.placing.purpose, 'map');
  // Nothing is left to bring it there, and nothing more is said where no place holds.
  const places = page.added.addedPoints(page.editing.editsInForce(back.history), 1);
  assert.deepEqual([...places.keys()], ['manhole']);
  const none = reduce(reduce(after(...run(after(), own)), { type: 'edit', edits: [rejects({ tie_point: 5 })] }), off);
  assert.deepEqual([none.history, none.notice], [{ edits: [[rejects({ tie_point: 5 })]], done: 1 }, null]);
  // On it again, by redo or by a new place.
  const redone = reduce(reduce(back, { type: 'goto', done: 10 }), onGround);
  assert.deepEqual(redone.history.edits[6], [measure(3, 0), measure(3, 1)]);
  assert.equal(redone.history.done, 10);
});

test('a place by hand has the measurements that hold, whatever was rejected and restored', () => {
  const { addedPoints } = page.added;
  const images = (/** @type {object[]} */ ...edits) => [
    ...addedPoints([place(1), measure(1, 0), measure(1, 1), measure(1, 2), ...edits], 1)
      .get('orthophoto_hand_1')
      .places.keys(),
  ];
  const one = (/** @type {string} */ kind) => ({ kind: `${kind}_observations`, observations: [{ point: { ground_control: 1 }, image: 1 }] });
  assert.deepEqual(images(one('reject')), [0, 2]);
  assert.deepEqual(images(one('reject'), one('restore')), [0, 1, 2]);
  assert.deepEqual(images(one('reject'), measure(1, 1)), [0, 1, 2]);
  assert.deepEqual(images({ kind: 'reject_images', images: [0, 2] }), [1]);
  assert.deepEqual(images({ kind: 'reject_images', images: [0, 2] }, { kind: 'restore_images', images: [2] }), [1, 2]);
  // What was measured by hand does not hang on the matches of a pair.
  assert.deepEqual(images({ kind: 'reject_pairs', pairs: [[0, 1]] }), [0, 1, 2]);
});

test('a block that places by hand hold lies on the orthophoto, and can be placed on it', () => {
  const { isOffGround, isStale, lacksPlaceAlone, liesElsewhere, purposeOf, asksPurpose } = page.purpose;
  const reduce = page.reducer.reduceBlock;
  const held = view(['orthophoto_hand_1'], { orthophoto: { kind: 'by_hand', text: '', inCrs: false } });
  const wanted = reduce(given.reduce(reduce, after(...run(after(), held))), { type: 'purpose', purpose: 'block' });
  assert.deepEqual([isOffGround(wanted), lacksPlaceAlone(wanted), liesElsewhere(wanted), isStale(wanted)], [true, true, false, false]);
  const opened = after({ type: 'openedFile', view: held, steps: [[place(1)]], options: page.state.BLOCK_INITIAL.options }, ...given);
  assert.ok(purposeOf(opened) === null && asksPurpose(opened));
  const elsewhere = reduce(given.reduce(reduce, after(...run(after()))), { type: 'purpose', purpose: 'block' });
  assert.deepEqual([isOffGround(elsewhere), liesElsewhere(elsewhere), isStale(elsewhere)], [true, true, true]);
});

test('a place by hand stands beside the block until it suffices, is measured by edits, and is chosen once it is in the block', () => {
  const reduce = page.reducer.reduceBlock;
  const start = after(...run(after(), view([], { givenControl: 0, orthophoto: { kind: 'not_linked', inCrs: false, text: '' } })));
  const added = reduce(start, { type: 'edit', edits: [place(1)] });
  const [beside] = added.shown.given;
  assert.deepEqual(beside, { name: 'orthophoto_hand_1', position: [530, 880, 12], place: null, role: 'control', images: 0, byHand: true });
  // In the system of the orthophoto its coordinates are those of the block.
  const onIt = reduce(added, { type: 'edited', view: { ...start.shown.view, orthophoto: { kind: 'by_hand', inCrs: false, text: '' } }, edits: [place(1)] });
  assert.deepEqual(onIt.shown.given[0].place, [530, 880, 12]);
  const chosen = reduce(added, { type: 'choose', choice: { kind: 'given', name: 'orthophoto_hand_1' } });
  const draft = { of: { given: 'orthophoto_hand_1' }, places: new Map([[1, { at: [10, 5], by: 'hand' }]]) };
  const points = page.added.addedPoints(page.editing.editsInForce(chosen.history), 0);
  assert.deepEqual(page.draft.stepOfDraft(draft, ['a', 'b'], 1, points), { type: 'edit', edits: [measure(0, 1)] });
  const measured = reduce(chosen, { type: 'edit', edits: [measure(0, 1)] });
  assert.equal(measured.shown.given[0].images, 1);
  assert.deepEqual([...page.added.addedPoints(page.editing.editsInForce(measured.history), 0).get('orthophoto_hand_1').places], [[1, [10, 5]]]);
  assert.deepEqual(measured.selection.chosen, { kind: 'given', name: 'orthophoto_hand_1' });
  const inBlock = { ...start.shown.view, surveyed: [{ name: 'orthophoto_hand_1', control: 0, point: 3, byHand: true }] };
  const taken = reduce(measured, { type: 'edited', view: inBlock, edits: page.editing.editsInForce(measured.history) });
  assert.deepEqual([taken.shown.given, taken.selection.chosen], [[], { kind: 'point', point: 3 }]);
  // Undone, it is gone, and what is left out says so.
  assert.deepEqual(reduce(measured, { type: 'goto', done: 0 }).shown.given, []);
  const out = reduce(measured, { type: 'edit', edits: [{ kind: 'set_use', point: 0, use: null }] });
  assert.equal(out.shown.given[0].role, null);
});

test('places are added to a block that lies on the orthophoto or is to lie there, and to no other', () => {
  const reduce = page.reducer.reduceBlock;
  const { takesPlaces } = page.places;
  const finished = after(...run(after()));
  assert.ok(!takesPlaces(finished));
  const asked = given.reduce(reduce, finished);
  assert.ok(!takesPlaces(asked));
  assert.ok(takesPlaces(reduce(asked, { type: 'purpose', purpose: 'block' })));
  assert.ok(!takesPlaces(reduce(asked, { type: 'purpose', purpose: 'images' })));
  const adding = reduce(reduce(asked, { type: 'purpose', purpose: 'block' }), { type: 'addsPlace', adds: true });
  assert.ok(adding.placing.adds);
  assert.ok(!reduce(adding, { type: 'purpose', purpose: 'map' }).placing.adds);
  assert.ok(!reduce(adding, { type: 'picksPlace', picks: true }).placing.adds);
});

test('edits of tie points that a block without an image lost come back with it, on an orthophoto as elsewhere', () => {
  const reduce = page.reducer.reduceBlock;
  const points = (/** @type {number} */ count) => ({ count, taking: count, sources: new Float64Array(count), rays: new Uint16Array(count) });
  const whole = view([], { givenControl: 0, points: points(3) });
  const fewer = { ...view([], { givenControl: 0, points: points(2) }), images: [{ name: 'photo_1.png', rays: 0 }] };
  const ground = { key: '', before: new Blob([]) };
  const onGround = (/** @type {any} */ state) =>
    reduce(state, { type: 'onGround', view: { ...state.shown.view, surveyed: [{ name: 'orthophoto_1', control: 0 }], givenControl: 1 }, edits: [], ground });
  const anew = (/** @type {any} */ state, /** @type {any} */ found) => onGround(reduce(state, { type: 'done', key: 'k', view: found, files: [], seconds: 1 }));
  const edits = [
    [{ kind: 'reject_points', points: [{ tie_point: 5 }] }],
    [{ kind: 'reject_points', points: [{ ground_control: 0 }] }],
    [place(1)],
    [measure(1, 0)],
  ];
  const edited = edits.reduce((state, step) => reduce(state, { type: 'edit', edits: step }), onGround(after(...run(after(), whole))));
  const without = anew(edited, fewer);
  // Of the other block neither the tie point nor its place of the orthophoto is known.
  assert.deepEqual(without.history.edits, [[place(1)], [measure(1, 0)]]);
  const back = anew(without, whole);
  assert.deepEqual(back.history.edits, [edits[0], edits[2], edits[3]]);
});

test('edits of places wait through a run until the block lies on the orthophoto again, where it is said what of all edits is lost', () => {
  const reduce = page.reducer.reduceBlock;
  const { awaitedOf } = page.former;
  const points = (/** @type {number} */ count) => ({ count, taking: count, sources: new Float64Array(count), rays: new Uint16Array(count) });
  const whole = view([], { givenControl: 0, points: points(3) });
  const fewer = { ...view([], { givenControl: 0, points: points(2) }), images: [{ name: 'photo_1.png', rays: 0 }] };
  const spots = (/** @type {string[]} */ images) => ({ images, tie_points: null, given: 0, places: [] });
  const names = ['orthophoto_1', 'orthophoto_2', 'orthophoto_3'];
  const onGround = (/** @type {any} */ state, /** @type {any[]} */ again = [], places = names) =>
    reduce(state, {
      type: 'onGround',
      view: { ...state.shown.view, surveyed: places.map((name, control) => ({ name, control })), givenControl: places.length },
      edits: [],
      ground: { key: '', before: new Blob([]), places: spots(state.shown.view.images.map((/** @type {any} */ { name }) => name)) },
      again,
    });
  const found = (/** @type {any} */ state, /** @type {any} */ block) => reduce(state, { type: 'done', key: 'k', view: block, files: [], seconds: 1 });
  const reject = (/** @type {number} */ control) => [{ kind: 'reject_points', points: [{ ground_control: control }] }];
  const tie = [{ kind: 'reject_points', points: [{ tie_point: 5 }] }];
  const image = [{ kind: 'reject_images', images: [0] }];
  const edited = [tie, reject(1), image, reject(2)].reduce(
    (state, edits) => reduce(state, { type: 'edit', edits }),
    onGround(found(after(...run(after(), whole)), whole)),
  );
  const marked = reduce(reduce(edited, { type: 'goto', done: 3 }), {
    type: 'mark',
    step: { kind: 'measure', marks: [{ image: 'photo_1.png', point: 'G1', x_px: 1, y_px: 2 }], after: 3 },
  });
  // Found anew without an image: while it is off the orthophoto nothing of a place can hold.
  const off = found(marked, fewer);
  assert.deepEqual([off.history.edits, off.history.done], [[image], 1]);
  assert.deepEqual(awaitedOf(off).spots.images, ['photo_1.png', 'photo_2.png']);
  // What waits is not said to be lost.
  assert.match(off.notice.text, /1 edit of points of the former block does not apply.*1 edit of places of the orthophoto waits until/);
  const again = [{ before: 1, now: 0, is_same_spot: true, images: [0] }];
  const on = onGround(off, again, names.slice(0, 2));
  assert.deepEqual([on.history.edits, on.history.done, on.marks.edits[0].after], [[reject(0), image], 2, 2]);
  assert.equal(
    on.notice.text,
    '2 edits by hand were kept. 1 edit of points of the former block does not apply to the new one. ' +
      'What was done to 1 place of the orthophoto holds where it lies again. ' +
      '1 undone edit of points of the former block cannot be redone in the new one: reject orthophoto_3.',
  );
  // It is said until something is done.
  assert.ok(on.notice.beside);
  assert.equal(on.awaiting, null);
  // Found with the image again, edits of tie points and of places have what they are about.
  const back = found(on, whole);
  assert.ok(!back.history.edits.flat().some((/** @type {any} */ edit) => edit.points?.some((/** @type {object} */ point) => 'ground_control' in point)));
  assert.deepEqual(awaitedOf(back).spots.images, ['photo_1.png', 'photo_2.png']);
  const there = onGround(back, [
    { before: 1, now: 2, is_same_spot: true, images: [0, 1] },
    { before: 2, now: 0, is_same_spot: true, images: [0, 1] },
  ]);
  assert.deepEqual([there.history.edits, there.history.done, there.marks.edits[0].after], [[tie, reject(2), image, reject(0)], 3, 3]);
  // What is edited before it lies there is not overwritten.
  const meanwhile = reduce(off, { type: 'edit', edits: [{ kind: 'restore_images', images: [0] }] });
  assert.equal(awaitedOf(meanwhile), null);
  const late = onGround(meanwhile, again);
  assert.deepEqual(late.history.edits, [image, [{ kind: 'restore_images', images: [0] }]]);
  assert.match(late.notice.text, /1 edit of points of the former block does not apply/);
  // Another run before the block lies there, of the same block or another one, and a reload: they wait on.
  const other = { ...fewer, points: points(1) };
  const reloaded = reduce(after(), { type: 'restored', restored: off });
  for (const state of [found(off, fewer), found(found(off, other), fewer), reloaded]) {
    const lies = onGround(state, again, names.slice(0, 2));
    assert.deepEqual([lies.history.edits, lies.history.done, lies.marks.edits[0].after], [[reject(0), image], 2, 2]);
  }
  // What lies there waits for nothing after a reload.
  assert.equal(reduce(after(), { type: 'restored', restored: on }).awaiting, null);
});

/** A block that lies on an orthophoto of 100 by 80 m, whose origin is (500, 900): two images and three of its places, one of them rejected by hand, beside a ground control point. */
const georeference = { origin: [500, 900], by_column: [1, 0], by_row: [0, -1] };
const onIt = (/** @type {number} */ x, /** @type {number} */ y) => ({ position: [x, y, 10], difference_m: [0, 0, 0], standard_errors_m: [null, null, null] });
const linked = view([], {
  orthophoto: { kind: 'linked', text: '' },
  images: [1, 2].map((id) => ({ name: `photo_${id}.png`, rays: 0, position: [500 + 20 * id, 850, 100] })),
  surveyed: [
    { name: 'orthophoto_1', control: 0, point: 7, role: 'control', isUsed: true, ...onIt(530, 880) },
    { name: 'orthophoto_2', control: 1, point: 8, role: 'check', isUsed: true, ...onIt(560, 880) },
    { name: 'orthophoto_3', control: 2, point: 9, role: 'control', isUsed: false, ...onIt(590, 880) },
    { name: 'GCP', control: 3, point: 10, role: 'control', isUsed: true, ...onIt(590, 830) },
  ],
});

test('the orthophoto shows the block that lies on its ground, unless each image is placed by itself', () => {
  const { blockOnOrthophoto, chosenPlaced } = page.showing;
  const reduce = page.reducer.reduceBlock;
  const of = (/** @type {object} */ info) => ({ ...orthophoto(7), info });
  const here = of({ width: 100, height: 80, georeference });
  const elsewhere = of({ width: 100, height: 80, georeference: { ...georeference, origin: [9000, 900] } });
  const opened = { type: 'openedFile', view: linked, steps: [], options: page.state.BLOCK_INITIAL.options };
  const given = reduce(after(opened), { type: 'orthophoto', orthophoto: here });
  assert.equal(blockOnOrthophoto(given), given.shown);
  assert.equal(blockOnOrthophoto(after(opened)), null);
  assert.equal(blockOnOrthophoto(reduce(after(opened), { type: 'orthophoto', orthophoto: elsewhere })), null);
  assert.equal(blockOnOrthophoto(reduce(given, { type: 'purpose', purpose: 'images' })), null);
  // Nothing leads from the coordinate reference system of the block to that of an orthophoto which says none.
  const inCrs = { ...linked, orthophoto: { ...linked.orthophoto, inCrs: true } };
  assert.equal(blockOnOrthophoto(reduce(after({ ...opened, view: inCrs }), { type: 'orthophoto', orthophoto: here })), null);
  // What was measured of an image is over then.
  const drafting = [
    { type: 'purpose', purpose: 'images' },
    { type: 'linkDraft', draft: { at: [1, 2], place: null } },
  ].reduce(reduce, given);
  const { draft, picks } = reduce(drafting, { type: 'purpose', purpose: 'block' }).placing;
  assert.deepEqual([drafting.placing.draft, draft, picks], [{ at: [1, 2], place: null }, null, false]);
  // An image that was placed by itself is not what is looked at then.
  const placed = { key: '', result: null, problem: '', found: null, steps: [], done: 0 };
  const both = [
    { type: 'placed', image: given.files[0], placed },
    { type: 'choosePlaced', looked: { image: 1, link: null } },
  ].reduce(reduce, reduce(given, { type: 'purpose', purpose: 'block' }));
  assert.equal(chosenPlaced(both), null);
  assert.equal(chosenPlaced(reduce(both, { type: 'purpose', purpose: 'images' })).file.id, 1);
});

test('a press on the orthophoto chooses what lies there of the block, and keys go through it', () => {
  const { onOrthophoto, choiceAt, stepped, placeOfChoice } = page.block;
  const footprints = new Float64Array([505, 890, 540, 890, 540, 810, 505, 810, 535, 890, 570, 890, 570, 810, 535, 810]);
  const all = () => true;
  const of = onOrthophoto(linked, { footprints }, false, all, all);
  // Five CSS px to the metre.
  const t = { scale: 5, x: -2500, y: 4500 };
  const at = (/** @type {number} */ x, /** @type {number} */ y, uses = new Set(['used', 'check', 'rejected'])) =>
    choiceAt(of, uses, t, 5 * x - 2500, 4500 - 5 * y);
  assert.deepEqual(at(531, 880), { kind: 'point', point: 7 });
  assert.deepEqual(at(590, 879), { kind: 'point', point: 9 });
  assert.deepEqual(at(590, 831), { kind: 'point', point: 10 });
  assert.deepEqual(at(521, 850), { kind: 'image', image: 0 });
  assert.deepEqual(at(560, 815), { kind: 'image', image: 1 });
  assert.equal(at(598, 850), null);
  // Places that are not drawn are not pressed.
  assert.deepEqual(at(560, 880, new Set(['used'])), { kind: 'image', image: 1 });
  const uses = new Set(['used', 'check', 'rejected']);
  assert.deepEqual(stepped(of, uses, 'place', null, 1), { kind: 'point', point: 7 });
  assert.deepEqual(stepped(of, uses, 'place', { kind: 'point', point: 7 }, -1), { kind: 'point', point: 9 });
  // Neither are they gone to, nor those that are no points of the block.
  assert.deepEqual(stepped(of, new Set(['check', 'rejected']), 'place', null, 1), { kind: 'point', point: 8 });
  assert.deepEqual(stepped(of, new Set(['used']), 'place', { kind: 'point', point: 7 }, 1), { kind: 'point', point: 7 });
  assert.equal(stepped(of, new Set(), 'place', null, 1), null);
  const lost = {
    ...linked,
    surveyed: linked.surveyed.map((/** @type {object} */ one, /** @type {number} */ row) => (row === 1 ? { ...one, point: -1 } : one)),
  };
  assert.deepEqual(stepped(onOrthophoto(lost, { footprints }, false, all, all), uses, 'place', { kind: 'point', point: 7 }, 1), { kind: 'point', point: 9 });
  assert.deepEqual(stepped(of, uses, 'image', { kind: 'image', image: 0 }, 1), { kind: 'image', image: 1 });
  assert.deepEqual(placeOfChoice(of, { kind: 'point', point: 8 }), [560, 880]);
  // What filters leave out is not there.
  const some = onOrthophoto(
    linked,
    { footprints },
    false,
    (/** @type {number} */ image) => image === 1,
    (/** @type {number} */ row) => row === 3,
  );
  assert.deepEqual([some.images.map(({ name }) => name), some.places.rows, some.surveyed.rows], [['photo_2.png'], [], [3]]);
});
