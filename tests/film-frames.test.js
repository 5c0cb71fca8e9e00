/** Scans of film on the page: taken by what their files hold, and made images of one camera together with what belongs to them. Without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { block_settings, film_frame, film_positions, grey_png, parse_camera, parse_fiducials, parse_image_measurements, Photo } from '../pkg/node.js';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(
    page,
    await pageModules([
      'block/engine/film',
      'block/files/files',
      'block/files/frames',
      'block/files/keep-steps',
      'block/state/naming',
      'block/state/reducer',
      'block/state/scan-marks',
      'block/state/state',
      'shared/state/store',
    ]),
  );
});

const CAMERA = '{"focal_mm": 152}';
/** A film of 100 x 80 mm on a scan of 240 x 200 px, 2 px a mm. */
const FIDUCIALS = 'col,row,x_mm,y_mm\n20,20,-50,40\n220,20,50,40\n220,180,50,-40\n20,180,-50,-40\n';
const SCAN = grey_png(
  240,
  200,
  Uint8Array.from({ length: 240 * 200 }, (_, i) => i % 251),
);
const POINTS = 'P1,0,0,0\nP2,100,0,0\nP3,0,100,0\n';

/** What takes files in, beside an empty block, and the runs that were started. */
function taking() {
  const store = new page.store.Holder(page.state.BLOCK_INITIAL, page.reducer.reduceBlock);
  store.dispatch({ type: 'options', options: { settings: block_settings({}) } });
  /** @type {string[]} */
  const started = [];
  const runs = { run: async () => void started.push('block'), placeImages: async () => void started.push('images') };
  const files = new page.files.BlockFiles(
    store,
    {},
    {},
    runs,
    async () => {},
    async () => true,
    async () => () => {},
  );
  const take = (/** @type {Record<string, string | Uint8Array>} */ given) =>
    files.take(Object.entries(given).map(([name, content]) => ({ file: new File([/** @type {BlobPart} */ (content)], name), path: '' })));
  return { store, take, started };
}

test('camera and fiducial marks are taken with the scans, which wait for their images', async () => {
  const { store, take, started } = taking();
  await take({ 'a.png': SCAN, 'b.png': SCAN, 'film.json': CAMERA, 'a.csv': FIDUCIALS, 'b.csv': FIDUCIALS.replaceAll(',', ';'), 'c.csv': FIDUCIALS });
  const { film } = store.state.placing;
  assert.equal(film.camera.name, 'film.json');
  assert.deepEqual(
    film.marks.map((/** @type {{ name: string }} */ { name }) => name),
    ['a.csv', 'b.csv', 'c.csv'],
  );
  const { text } = store.state.notice;
  assert.match(
    text,
    /^Film camera from film\.json\. Fiducial marks of scans from a\.csv, b\.csv, c\.csv\. 2 images in the block\. Press Make images of one camera /,
  );
  assert.match(text, /No image has the name of c\.csv: fiducial marks are named as the image of their scan\.$/);
  assert.ok(!/skipped|put aside/.test(text), text);
  assert.deepEqual(started, []);
  // Scans that are given before their marks have been run as they are.
  const other = taking();
  await other.take({ 'a.png': SCAN, 'b.png': SCAN });
  assert.deepEqual(other.started, ['block']);
  await other.take({ 'a.csv': FIDUCIALS });
  assert.deepEqual(other.started, ['block']);
  assert.match(other.store.state.notice.text, /^Fiducial marks of scans from a\.csv\. Fiducial marks need the film camera/);
  await other.take({ 'film.json': CAMERA });
  assert.match(other.store.state.notice.text, /^Film camera from film\.json\. Press Make images of one camera /);
  assert.deepEqual(other.started, ['block']);
});

test('what is wrong with a camera or with marks is said, and the images are taken', async () => {
  const { store, take } = taking();
  await take({ 'a.png': SCAN, 'film.json': '{"focal_mm": 0}', 'a.csv': FIDUCIALS.replace('-50,40', '-50,4O') });
  const { text } = store.state.notice;
  assert.match(text, /film\.json cannot be used: .*focal_mm/);
  assert.match(text, /a\.csv cannot be used: .*4O.*y_mm.*line 2/);
  const { placing, files } = store.state;
  assert.deepEqual([placing.film.camera, placing.film.marks.length, files.length], [null, 0, 1]);
});

/** The frames of scans as a worker makes them. */
const engineOf = (/** @type {number} */ pixel) => ({
  frames: (/** @type {any[]} */ scans) =>
    Promise.all(
      scans.map(async ({ file, film, mask }) => {
        const bytes = async (/** @type {Blob} */ of) => new Uint8Array(await of.arrayBuffer());
        const known = { camera: parse_camera(film.camera), scan: { fiducials: parse_fiducials(film.marks) } };
        const made = film_frame(await bytes(file.file), known, {
          image: `${file.name}-frame`,
          pixel_mm: pixel,
          mask: mask && { name: mask.name, file: await bytes(mask.file) },
        });
        const png = (/** @type {Uint8Array} */ of) => new Blob([/** @type {BlobPart} */ (of)], { type: 'image/png' });
        return { ...made, image: png(made.image), mask: png(made.mask), of: file.id };
      }),
    ),
});
const engine = engineOf(0.5);

test('masks and image measurements of scans become those of their frames, by file and by hand', async () => {
  const { store, take } = taking();
  await take({ 'a.png': SCAN, 'b.png': SCAN, 'IMG_7.jpg': SCAN, 'film.json': CAMERA, 'a.csv': FIDUCIALS, 'b.csv': FIDUCIALS });
  const mask = (/** @type {number} */ column) =>
    grey_png(
      240,
      200,
      Uint8Array.from({ length: 240 * 200 }, (_, i) => (i % 240 < column ? 0 : 255)),
    );
  const masks = ['a_mask.png', 'IMG_7.png'].map((name, k) => ({ id: 900 + k, name, file: new File([/** @type {BlobPart} */ (mask(120))], name) }));
  const marks = { name: 'marks.csv', text: 'image,point,x,y\na.png,P1,100.5,60.25\nIMG_7.jpg,P1,7,8\nb.png,P2,3,4\n' };
  store.dispatch({ type: 'options', options: { masks, marks, control: { name: 'points.csv', text: POINTS } } });
  const row = (/** @type {string} */ image, /** @type {string} */ point, /** @type {number} */ x_px, /** @type {number} */ y_px) => ({
    image,
    point,
    x_px,
    y_px,
  });
  const hand = [row('b.png', 'P1', 90, 70), row('a.png', 'P3', 130, 90)];
  const given = [[row('a.png', 'P2', 1, 1)], hand].map((step) => ({ kind: 'measure', marks: step, after: 0 }));
  store.dispatch({ type: 'restored', restored: { ...store.state, marks: { edits: given, done: 2 }, draft: null } });
  const before = store.state;

  await page.frames.takeFrames(store, engine, () => {});
  const { files, options, marks: steps, notice, placing } = store.state;
  const names = (/** @type {readonly { name: string }[]} */ list) => list.map(({ name }) => name);
  assert.deepEqual(names(files), ['IMG_7.jpg', 'a-film.png', 'b-film.png']);
  assert.deepEqual(names(options.masks), ['IMG_7.png', 'a-film.png', 'b-film.png']);
  assert.deepEqual([placing.film.camera, placing.film.marks.length], [null, 0]);
  const film = film_frame(SCAN, { camera: parse_camera(CAMERA), scan: { fiducials: parse_fiducials(FIDUCIALS) } }, { image: 'a', pixel_mm: 0.5 }).scan;
  const moved = (/** @type {number} */ x, /** @type {number} */ y) => [...film_positions(film, Float64Array.of(x, y), 'frame')];
  const [x = NaN, y = NaN] = moved(100.5, 60.25);
  assert.deepEqual(parse_image_measurements(options.marks.text), [row('a-film.png', 'P1', x, y), row('IMG_7.jpg', 'P1', 7, 8)]);
  const [[bx = NaN, by = NaN], [ax = NaN, ay = NaN]] = [moved(90, 70), moved(130, 90)];
  // The step that measured beside the frame has nothing left.
  const left = [[], [row('b-film.png', 'P1', bx, by), row('a-film.png', 'P3', ax, ay)]];
  assert.deepEqual(
    steps.edits.slice(0, 2),
    left.map((step) => ({ kind: 'measure', marks: step, after: 0 })),
  );
  assert.equal(steps.done, 3);
  assert.deepEqual(steps.edits.map(page.naming.nameOfMarks), [
    'a measurement beside the images of scans',
    'measure P1 in 2 images',
    'make images of one camera of 2 scans',
  ]);
  assert.match(
    notice.text,
    /^2 scans were resampled to images of one camera, which counts as calibrated\. Masks leave out the fiducial marks\. 3 image measurements were carried over\./,
  );
  assert.match(notice.text, /2 image measurements lie beside the images of scans, .*: P2 in b\.png, P2 in a\.png\. Skipped\.$/);
  const hidden = await Promise.all(
    options.masks.slice(1).map(async (/** @type {{ file: Blob }} */ { file }) => {
      const photo = Photo.decode(new Uint8Array(await file.arrayBuffer()));
      const [grey, width] = [photo.grey(), photo.width];
      photo.free();
      const at = (/** @type {number} */ column) => grey[60 * width + column];
      const own = moved(120, 80)[0] ?? NaN;
      return [at(Math.floor(own) - 2), at(Math.ceil(own) + 2)];
    }),
  );
  assert.deepEqual(hidden, [
    [0, 255],
    [255, 255],
  ]);
  // Undone, all of it is what it was, and done again what it became; what was given meanwhile stays.
  const made = store.state;
  const parts = ({ files, removed, options, placing, marks }) => ({ files, removed, options, film: placing.film, marks });
  const same = (/** @type {any} */ now, /** @type {any} */ then) => {
    for (const [name, value] of Object.entries(parts(then))) if (name !== 'marks') assert.deepEqual(parts(now)[name], value, name);
    assert.deepEqual(now.marks.edits.slice(0, 2), then.marks.edits.slice(0, 2));
  };
  store.dispatch({ type: 'gotoMark', done: 2 });
  same(store.state, before);
  store.dispatch({ type: 'gotoMark', done: 3 });
  same(store.state, made);
  assert.deepEqual(store.state.marks, made.marks);
  store.dispatch({ type: 'gotoMark', done: 0 });
  same(store.state, before);
  const late = { id: 990, name: 'z.png', file: new File([/** @type {BlobPart} */ (SCAN)], 'z.png') };
  store.dispatch({ type: 'files', files: [...store.state.files, late], truth: null });
  store.dispatch({ type: 'options', options: { cameras: { name: 'own.json', text: '{"cameras": []}' } } });
  store.dispatch({ type: 'gotoMark', done: 3 });
  assert.deepEqual(names(store.state.files), ['IMG_7.jpg', 'a-film.png', 'b-film.png', 'z.png']);
  assert.equal(store.state.options.cameras.name, 'own.json');
  store.dispatch({ type: 'gotoMark', done: 2 });
  assert.deepEqual(names(store.state.files), ['IMG_7.jpg', 'a.png', 'b.png', 'z.png']);

  // What is kept of the step names its files, and is the step again with them.
  const keptFile = (/** @type {any} */ { id, name }) => ({ id, name, file: `file ${id}` });
  const keep = page.keep_steps.keptMarkSteps(keptFile);
  const kept = keep(made.marks);
  assert.equal(keep({ ...made.marks }).edits[2], kept.edits[2]);
  const files_ = new Map(page.keep_steps.filesOfSteps(made.marks).map((/** @type {any} */ one) => [one.id, one]));
  const read = page.keep_steps.keptStepFrom((/** @type {any} */ value) => value);
  const again_ = { edits: structuredClone(kept.edits).map((/** @type {any} */ step) => read(step, 'step')), done: kept.done };
  assert.deepEqual(
    page.keep_steps.markStepsFrom(again_, (/** @type {any} */ { id }) => files_.get(id)),
    made.marks,
  );

  // Two masks of one scan are refused before anything is made.
  const again = taking();
  await again.take({ 'a.png': SCAN, 'film.json': CAMERA, 'a.csv': FIDUCIALS });
  const twice = ['a_mask.png', 'a.png'].map((name, k) => ({ id: 950 + k, name, file: new File([/** @type {BlobPart} */ (mask(1))], name) }));
  again.store.dispatch({ type: 'options', options: { masks: twice } });
  await page.frames.takeFrames(again.store, engine, () => {});
  assert.match(again.store.state.notice.text, /^No images were made of the scans: .*a_mask\.png and a\.png/);
  assert.deepEqual(names(again.store.state.files), ['a.png']);
});

test('marks far off are named where images are made of their scans', async () => {
  const { store, take } = taking();
  // A small film, 20 px a mm.
  const fine = FIDUCIALS.replaceAll('50', '5').replaceAll('40', '4');
  const off = fine.replace('220,180', '229,172');
  await take({ 'a.png': SCAN, 'b.png': SCAN, 'film.json': CAMERA, 'a.csv': fine, 'b.csv': off });
  const { film } = store.state.placing;
  assert.match(page.scan_marks.marksFarOff(film.marks, store.state.files), /^b\.png: σ₀ of its marks is [\d.]+ px of the scan; /);
  await page.frames.takeFrames(store, engineOf(0.05), () => {});
  assert.match(store.state.notice.text, /^2 scans were resampled .* b\.png: σ₀ of its marks is /);
  const many = Array.from({ length: 6 }, (_, k) => ({ name: `s${k}.png` }));
  const tables = many.map((_, k) => ({ name: `s${k}.csv`, text: off }));
  assert.match(page.scan_marks.marksFarOff(tables, many), /s2\.png.* The marks of 3 more scans lie far off, too\.$/);
});

test('a frame is called by its scan, whatever signs its name has', async () => {
  const { film } = await pageModules(['block/state/film']);
  assert.equal(film.frameName('a$&b$1.tif', '*-film2.png'), 'a$&b$1-film2.png');
});

test('frames of a second film have their own camera beside that of the first, which keeps its rule', async () => {
  const { store, take } = taking();
  await take({ 'a.png': SCAN, 'film.json': CAMERA, 'a.csv': FIDUCIALS });
  await page.frames.takeFrames(store, engine, () => {});
  const other = '{"focal_mm": 304, "uncertainty": {"focal": 0.001, "principal_point": 0, "k1": 0}}';
  await take({ 'c.png': SCAN, 'film.json': other, 'c.csv': FIDUCIALS });
  await page.frames.takeFrames(store, engine, () => {});
  const names = () => store.state.files.map((/** @type {{ name: string }} */ { name }) => name);
  assert.deepEqual(names(), ['a-film.png', 'c-film2.png']);
  const rules = () => JSON.parse(store.state.options.cameras.text).cameras;
  const said = rules().map((/** @type {any} */ { images, focal_px, fixed, uncertainty }) => [images, focal_px, fixed, uncertainty?.focal ?? 0]);
  assert.deepEqual(said, [
    ['*-film2.png', 608, false, 0.001],
    ['*-film.png', 304, true, 0],
  ]);
  assert.deepEqual(
    store.state.options.masks.map((/** @type {{ name: string }} */ { name }) => name),
    ['a-film.png', 'c-film2.png'],
  );
  // More scans of the first film have its camera; of a film of which no image is left the rule is gone.
  await take({ 'b.png': SCAN, 'film.json': CAMERA, 'b.csv': FIDUCIALS });
  await page.frames.takeFrames(store, engine, () => {});
  assert.deepEqual([names(), rules().length], [['a-film.png', 'b-film.png', 'c-film2.png'], 2]);
  store.dispatch({ type: 'files', files: store.state.files.slice(0, 1), truth: null });
  await take({ 'd.png': SCAN, 'film.json': '{"focal_mm": 88}', 'd.csv': FIDUCIALS });
  await page.frames.takeFrames(store, engine, () => {});
  assert.deepEqual(
    rules().map((/** @type {any} */ { images, focal_px }) => [images, focal_px]),
    [
      ['*-film2.png', 176],
      ['*-film.png', 304],
    ],
  );
});

test('images of two films are undone together, and done again, after a reload too', async () => {
  const { store, take } = taking();
  await take({ 'a.png': SCAN, 'film.json': CAMERA, 'a.csv': FIDUCIALS });
  const measured = { kind: 'measure', marks: [{ image: 'a.png', point: 'P1', x_px: 130, y_px: 90 }], after: 0 };
  store.dispatch({ type: 'restored', restored: { ...store.state, marks: { edits: [measured], done: 1 }, draft: null } });
  await page.frames.takeFrames(store, engine, () => {});
  await take({ 'c.png': SCAN, 'film.json': '{"focal_mm": 304}', 'c.csv': FIDUCIALS });
  await page.frames.takeFrames(store, engine, () => {});
  const names = () => store.state.files.map((/** @type {{ name: string }} */ { name }) => name);
  const { marks, options } = store.state;
  const kept = page.keep_steps.keptMarkSteps((/** @type {any} */ { id }) => ({ id }))(marks);
  const files = new Map(page.keep_steps.filesOfSteps(marks).map((/** @type {any} */ one) => [one.id, one]));
  const reloaded = page.keep_steps.markStepsFrom(structuredClone(kept), (/** @type {any} */ { id }) => files.get(id));
  for (const steps of [marks, reloaded]) {
    store.dispatch({ type: 'restored', restored: { ...store.state, marks: steps, draft: null } });
    store.dispatch({ type: 'gotoMark', done: 0 });
    assert.deepEqual(names(), ['a.png', 'c.png']);
    assert.deepEqual(store.state.marks.edits[0], measured);
    assert.deepEqual([store.state.options.cameras, store.state.options.masks], [null, []]);
    store.dispatch({ type: 'gotoMark', done: 3 });
    assert.deepEqual(names(), ['a-film.png', 'c-film2.png']);
    assert.deepEqual(store.state.marks.edits[0], marks.edits[0]);
    assert.deepEqual(store.state.options, options);
  }
});

test('a scan whose image is there is refused before anything is changed', async () => {
  const { store, take } = taking();
  await take({ 'a.png': SCAN, 'film.json': CAMERA, 'a.csv': FIDUCIALS });
  await page.frames.takeFrames(store, engine, () => {});
  await take({ 'A.png': SCAN, 'b.png': SCAN, 'film.json': CAMERA, 'A.csv': FIDUCIALS, 'b.csv': FIDUCIALS });
  const { files, options, placing } = store.state;
  await page.frames.takeFrames(store, engine, () => {});
  assert.match(store.state.notice.text, /^A-film\.png, the image of a scan, is there already\. Nothing was changed/);
  assert.deepEqual([store.state.files, store.state.options, store.state.placing.film], [files, options, placing.film]);
});

test('scans that are added to their film have the pixel of its camera, by which they have that camera', async () => {
  const { store, take } = taking();
  await take({ 'a.png': SCAN, 'film.json': CAMERA, 'a.csv': FIDUCIALS });
  await page.frames.takeFrames(store, engine, () => {});
  /** @type {any[]} */
  const given = [];
  await take({ 'b.png': SCAN, 'film.json': CAMERA, 'b.csv': FIDUCIALS });
  const frames = async (/** @type {any} */ _scans, /** @type {any[]} */ rules) => {
    given.push(...rules);
    return null;
  };
  await page.frames.takeFrames(store, { frames }, () => {});
  assert.deepEqual(
    given.map(({ images, pixel_mm }) => [images, pixel_mm]),
    [['*-film.png', 0.5]],
  );
  // Columns 0.6 px longer make a pixel smaller by 0.15 %, and 6 px longer by 1.5 %.
  const plan = (/** @type {string} */ col, /** @type {any[]} */ rules, camera = CAMERA) =>
    page.film.filmPlan({ films: [{ camera, marks: FIDUCIALS.replaceAll('220,', `${col},`) }], given: rules }).pixelMm;
  const own = plan('220.6', []);
  assert.ok(Math.abs(own / 0.5 - 1) > 1e-3, `${own}`);
  assert.equal(plan('220.6', given), 0.5);
  assert.ok(plan('226', given) < 0.495, `${plan('226', given)}`);
  assert.equal(plan('220.6', given, '{"focal_mm": 153}'), own);
});
