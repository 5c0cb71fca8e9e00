/** What the module refuses of values of JavaScript, which would else arrive as others. */

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import test from 'node:test';
import vm from 'node:vm';
import {
  BlockScene,
  block_settings,
  check_control,
  check_geoid,
  connected_groups,
  constant_offset,
  FinishedBlock,
  grey_png,
  match_pair,
  message,
  orient_relative,
  open_pair_project,
  OrthoMosaic,
  OrthophotoReference,
  parse_camera,
  Photo,
  placed_tables,
  positions_of_images,
  project_kind,
  resolved,
  Run,
  scaled_interior,
  sha256,
  simulate,
  system_coordinates,
  system_positions,
  write_pair_project,
} from '../../pkg/node.js';

/** @param {() => unknown} call @param {RegExp} pattern of the message @param {string} [code] */
const refused = (call, pattern, code = 'invalid-input') =>
  assert.throws(call, (/** @type {any} */ error) => {
    assert.match(error.message, pattern);
    assert.deepEqual([error.name, error.code], ['TiepointError', code]);
    assert.equal(error.message, message('error', error.error));
    return true;
  });

const GREY = Uint8Array.from({ length: 64 * 48 }, (_, i) => (i * 7919) % 251);
const PNG = grey_png(64, 48, GREY);
/** @type {any} */
const any = (/** @type {unknown} */ value) => value;

test('bytes are taken as the language has them, of whatever window, and nothing else is', () => {
  const elsewhere = vm.runInNewContext('Uint8Array.from(bytes)', { bytes: PNG });
  assert.equal(elsewhere instanceof Uint8Array, false);
  for (const bytes of [PNG, PNG.slice().buffer, Buffer.from(PNG), new Uint8ClampedArray(PNG), elsewhere]) assert.deepEqual(Photo.decode(bytes).grey(), GREY);
  for (const [given, name] of /** @type {const} */ ([
    [new DataView(PNG.slice().buffer), 'DataView'],
    [new Blob([]), 'Blob'],
    [5, 'number'],
    ['left.jpg', 'string'],
    [null, 'null'],
    [undefined, 'undefined'],
    [[137, 80], 'Array'],
    [{}, 'object'],
  ]))
    refused(() => Photo.decode(any(given)), new RegExp(`^file of the image: got ${name}; allowed: Uint8Array, Uint8ClampedArray or ArrayBuffer$`));
  refused(() => FinishedBlock.open(any(5)), /^file of the project: got number; allowed: string, Uint8Array, Uint8ClampedArray or ArrayBuffer$/);
  refused(() => FinishedBlock.open('project.tiepoint'), /it is no project of Tiepoint: its first line is 'project\.tiepoint'/, 'unreadable-file');
  refused(() => sha256(any([1, 2])), /^bytes: got Array; allowed/);
  refused(
    () => OrthophotoReference.open(any(new DataView(PNG.slice().buffer))),
    /^file: got DataView; allowed: Uint8Array, ArrayBuffer, or an object with size and read$/,
  );
  const photo = Photo.decode(PNG);
  refused(() => match_pair(photo, photo, {}, {}, any('mask.png')), /^mask: got string; allowed/);
});

test('grey values of more than 8 bits are not taken modulo 256', () => {
  refused(() => Photo.from_grey(2, 2, any(new Uint16Array([256, 257, 258, 259]))), /^grey values: got Uint16Array; allowed/);
  refused(() => Photo.from_grey(2, 2, any(new Float32Array([0.5, 1, 2, 3]))), /^grey values: got Float32Array; allowed/);
  assert.deepEqual(Photo.from_grey(2, 2, new Uint8ClampedArray([300, 1, 2, 3])).grey(), Uint8Array.of(255, 1, 2, 3));
});

test('indices and sizes that are no whole numbers are refused, in place of others', () => {
  const photo = Photo.decode(PNG);
  for (const side of [NaN, -1, 1.5, Infinity, 2 ** 32])
    refused(
      () => photo.reduced(side),
      new RegExp(`^longest side: got ${String(side).replace('Infinity', 'inf')}; allowed: whole numbers from 1 to 4294967295$`),
    );
  refused(() => photo.reduced(1e300), /^longest side: got 1e300; allowed/);
  assert.equal(photo.reduced(32).width, 32);
  refused(() => Photo.from_grey(-1, -1, GREY), /^width: got -1; allowed/);
  refused(() => connected_groups(-1, []), /^number of images: got -1; allowed/);
  const scene = new BlockScene({ strips: 1, exposures: 2 });
  refused(() => scene.photo_file(NaN), /^index of the photo: got NaN; allowed/);
  refused(() => scene.photo_file(2), /allowed/);
  const interior = {
    parameters: [
      [0.01, 0, 0],
      [0, -0.01, 0],
    ],
    principal_point_mm: [0, 0],
    radial_distortion: [0, 0, 0],
  };
  for (const factor of [0, -1, NaN, Infinity]) refused(() => scaled_interior(any(interior), factor), /^factor: got .*; allowed: a number above 0$/);
  refused(() => placed_tables(['a.png', 'b.png'], []), /^names: got 2 names for 0 placed images; allowed: one for each placed image$/);
});

test('options of another type are refused by their names', () => {
  const json = (/** @type {unknown} */ settings, /** @type {RegExp} */ pattern) => refused(() => resolved(any(settings)), pattern, 'invalid-json');
  json({ points: 'all' }, /^settings: points: got a text; allowed: an object of options$/);
  json('all', /^settings: got a text; allowed: an object of options$/);
  json([], /^settings: got a list; allowed: an object of options$/);
  json({ multiscale: { number: '200' } }, /^settings: multiscale\.number: got a text; allowed: whole numbers from 1 to 1000000$/);
  json({ multiscale: { number: null } }, /^settings: multiscale\.number: got null; allowed: whole numbers/);
  refused(
    () => block_settings(any({ features: { multiscale: { number: true } } })),
    /^block: features\.multiscale\.number: got true or false; allowed/,
    'invalid-json',
  );
});

test('objects beside options are refused by their fields, in words of JSON', () => {
  const photo = Photo.decode(PNG);
  const known = (/** @type {unknown} */ given, /** @type {RegExp} */ pattern) =>
    refused(() => match_pair(photo, photo, any(given), {}), pattern, 'invalid-json');
  known({ camera: [153, [0, 0]] }, /^input: camera: got a list; allowed: an object$/);
  known({ camera: { focal_mm: '153' } }, /^input: camera\.focal_mm: got "153"; allowed: a number$/);
  known({ camera: { focal_mm: 153, principal_point_mm: [0] } }, /^input: camera\.principal_point_mm: got a list of 1; allowed: a list of 2$/);
  known({ camera: {} }, /^input: camera\.focal_mm: missing$/);
  known({ camera: { focal_mm: 153, focal: 1 } }, /^input: camera\.focal: unknown field; allowed: .*focal_mm/);
});

test('a number outside its range is refused by what its option allows, whatever it is', () => {
  const option = (/** @type {unknown} */ settings, /** @type {RegExp} */ pattern) => refused(() => resolved(any(settings)), pattern, 'invalid-option');
  for (const [number, got] of /** @type {const} */ ([
    [-5, '-5'],
    [1.5, '1.5'],
    [2 ** 33, '8589934592'],
    [NaN, 'NaN'],
    [Infinity, 'Infinity'],
    [1e300, '1e300'],
  ]))
    option({ multiscale: { number } }, new RegExp(`^multiscale\\.number is ${got}; allowed: whole numbers from 1 to 1000000$`));
  option({ points: { threshold: -Infinity } }, /^points\.threshold is -Infinity; allowed: /);
  option({ points: { suppression_window: -1 } }, /^points\.suppression_window is -1; allowed: odd whole numbers/);
  option({ matching: { strategy: 'gradients' } }, /^matching\.strategy is gradients; allowed: auto, moments, /);
  refused(() => simulate({ seed: 2 ** 32 }), /^flight\.seed is 4294967296; allowed: whole numbers from 0 to 4294967295$/, 'invalid-option');
  refused(() => new Run({ images: ['a'], settings: { features: { multiscale: { number: -5 } } } }), /^multiscale\.number is -5; allowed/, 'invalid-option');
  const photo = Photo.decode(PNG);
  refused(() => photo.detect({ points: { fraction: 1e300 } }), /^points\.fraction is 1e300; allowed/, 'invalid-option');
});

test('numbers of calls are numbers, and no text of them', () => {
  refused(() => Photo.from_grey(any('2'), 1, new Uint8Array(2)), /^width: got string; allowed: a number$/);
  refused(() => Photo.from_grey(2, any(null), new Uint8Array(2)), /^height: got null; allowed: a number$/);
  refused(() => orient_relative(new Float64Array(24), any('153'), {}), /^focal_mm: got string; allowed: a number$/);
  refused(() => orient_relative(new Float64Array(24), any(undefined), {}), /^focal_mm: got undefined; allowed: a number$/);
  refused(() => constant_offset(any([5]), 0), /^dx: got Array; allowed: a number$/);
});

test('an object that is freed twice, or was moved into another one, is freed once', () => {
  const photo = Photo.decode(PNG);
  photo.free();
  photo.free();
  if (Symbol.dispose) photo[Symbol.dispose]();
  const run = new Run({ images: ['a.png'] });
  assert.throws(() => run.finish(), { name: 'TiepointError' });
  run.free();
  if (Symbol.dispose) run[Symbol.dispose]();
  refused(() => photo.grey(), /^the object was freed/);
});

test('what a run would refuse of positions and control points is asked with the options that differ from their defaults', () => {
  const names = ['a.jpg', 'b.jpg'];
  const [first, none] = positions_of_images('image,longitude,latitude,height\na.jpg,9,48,300\n', names);
  assert.deepEqual([first?.position.longitude_deg, first?.position.latitude_deg, none], [9, 48, null]);
  assert.deepEqual(positions_of_images('image,longitude,latitude,height\na.jpg,9,48,300\n', names, {}), [first, none]);
  const plane = 'image,x,y,height\na.jpg,500000,5316000,300\n';
  const [placed] = positions_of_images(plane, names, { crs: 'EPSG:25832' });
  assert.ok(Math.abs((placed?.position.longitude_deg ?? 0) - 9) < 1e-9, JSON.stringify(placed));
  refused(() => positions_of_images(plane, names), /without a coordinate system/);
  refused(() => positions_of_images(plane, names, any({ crs: 25832 })), /^placing: crs: got a number; allowed: text$/, 'invalid-json');
  refused(() => check_geoid('geoid.tif'), /geoid\.tif without a coordinate system; .* \(placing\.crs\)$/);
  const [points, marks] = ['name,x,y,z\np,1,2,3\nq,2,2,3\nr,1,5,3\n', 'image,point,x,y\na.jpg,p,1,2\nb.jpg,p,2,2\n'];
  refused(() => check_control(points, marks, names, { geoid_m: 1e9 }), /^placing\.geoid_m is 1000000000; allowed/, 'invalid-option');
});

test('a call before the module is loaded, and of an object that was freed, says what to do', () => {
  const photo = Photo.decode(PNG);
  photo.free();
  const told = /^the object was freed, or moved into another one; allowed: objects that are neither$/;
  refused(() => photo.width, told);
  refused(() => match_pair(photo, photo, {}, {}), told);
  const browser = new URL('../../pkg/browser.js', import.meta.url).href;
  const program = `import { Photo } from '${browser}';
    try { Photo.decode(new Uint8Array(1)); } catch ({ name, code, usage, error, message }) { console.log(JSON.stringify({ name, code, usage, error, message })); }`;
  const { stdout } = spawnSync(process.execPath, ['--input-type=module', '--eval', program], { encoding: 'utf8' });
  const error = { kind: 'not-loaded' };
  // The crate could not be asked for its words.
  assert.deepEqual(JSON.parse(stdout), { name: 'TiepointError', code: 'not-loaded', usage: false, error, message: message('error', any(error)) });
  assert.match(stdout, /call load\(\)/);
});

test('a pair and a block are opened from what was written of them, and from its bytes', () => {
  const photo = Photo.decode(PNG);
  const { width: width_px, height: height_px, format, bits_per_sample, camera } = photo.info();
  /** @returns {import('../../pkg/node.js').PairPhoto} */
  const row = (/** @type {string} */ name) => ({ name, content: '00'.repeat(32), width_px, height_px, format, bits_per_sample, mask: null, camera });
  const output = match_pair(photo, photo, {}, {});
  const text = write_pair_project({ images: [row('a.png'), row('b.png')], input: {}, settings: {}, output, truth: null });
  const bytes = new TextEncoder().encode(text);
  for (const file of [text, bytes, bytes.buffer]) {
    assert.deepEqual([project_kind(file), open_pair_project(file).images.map(({ name }) => name)], ['pair', ['a.png', 'b.png']]);
    for (const open of [FinishedBlock.open, OrthoMosaic.open]) refused(() => open(file, any(null)), /pair/, 'unreadable-file');
  }
});

test('grey values for which there is no memory are refused as images are', () => {
  // None of it is touched: the module has no block of this size.
  const grey = new Uint8Array(2 ** 31);
  refused(() => Photo.from_grey(2 ** 16, 2 ** 15, grey), /^an image of 65536 x 32768 px needs about 2048 MB of memory; allowed: up to/, 'too-much-memory');
});

test('what leaves nothing of an image or a picture, or makes no block, is refused with what is allowed', () => {
  const photo = Photo.decode(PNG);
  refused(() => photo.reduced(0), /^longest side: got 0; allowed: whole numbers from 1 to 4294967295$/);
  const { width, height } = /** @type {{ width: number, height: number }} */ (photo.reduced(1));
  assert.deepEqual([width, height], [1, 1]);
  const scene = new BlockScene({ strips: 1, exposures: 2, width_px: 64, height_px: 48, pixel_mm: 0.5 });
  const reference = OrthophotoReference.open(scene.orthophoto(4).picture);
  refused(() => reference.picture(0, 0, 1, 1, 99), /^halvings: got 99; allowed: whole numbers from 0 to 16$/);
  refused(() => reference.colours(0, 0, 1, 1, 17), /^halvings: got 17; allowed/);
  assert.equal(reference.picture(0, 0, 1, 1, 16).length, 1);
  for (const input of [{}, { images: [] }]) refused(() => new Run(input), /^images of the block: got 0 .*; allowed: two or more$/);
});

test('what is wrong in an object or a text of JSON is said in the language that is asked for', () => {
  /** @param {() => unknown} call */
  const inArabic = (call) => {
    try {
      call();
    } catch (error) {
      return message('error', /** @type {any} */ (error).error, null, 'ar').replaceAll(/[\u2066-\u2069]/gu, '');
    }
    return '';
  };
  assert.match(
    inArabic(() => parse_camera('{"focal_mm" 153}')),
    /لا توجد نقطتان رأسيتان بين اسم الحقل وقيمته/u,
  );
  assert.match(
    inArabic(() => parse_camera('{"focal_mm": 15')),
    /ينتهي النص/u,
  );
  assert.match(
    inArabic(() => resolved(any({ points: new Map() }))),
    /points: أُعطي Map/u,
  );
});

test('a message is of a family, and one that belongs to it', () => {
  assert.equal(message('failure', { kind: 'unreadable', message: 'gone' }).includes('gone'), true);
  refused(() => message(any('foo'), any(1)), /^message: got foo; allowed: a family of messages/);
  refused(() => message('pair_verdict', any({ kind: 'focal_length' })), /^message: got pair-verdict-focal-length; allowed/);
  refused(() => message('failure', { kind: 'unreadable', message: 'gone' }, 'title'), /^message: got failure-unreadable\.title; allowed/);
});

test('a search that is refused leaves the orthophoto as it was', () => {
  const scene = new BlockScene({ strips: 1, exposures: 2 });
  const { picture } = scene.orthophoto(4);
  const reference = OrthophotoReference.open(picture);
  const points = reference.search({});
  refused(() => reference.search({ points: 1 }), /^placing\.points is 1; allowed/, 'invalid-option');
  assert.equal(reference.place('a.png', PNG, null).verdict.kind, 'not_placed');
  assert.equal(reference.search({}), points);
  reference.free();
  scene.free();
});

test('heights of a system count from a number or from the grid of a geoid, which is refused where it is none', () => {
  const geoid = { name: 'small.gtx', south_west_deg: [8, 50], step_deg: [1, 1], columns: 2, heights_m: [40, 50, 40, 50] };
  const place = [8.25, 50.5, 300];
  const height = (/** @type {any} */ ...heights) => system_coordinates('EPSG:32632', place, ...heights)[2];
  assert.deepEqual(
    [height(), height(null), height({}), height({ geoid_m: 46.5 }), height(any({ geoid })), height(any({ geoid_m: 46.5, geoid }))],
    [300, 300, 300, 253.5, 257.5, 257.5],
  );
  const back = system_positions('EPSG:32632', system_coordinates('EPSG:32632', place, any({ geoid })), any({ geoid }));
  assert.ok(Math.abs((back[2] ?? 0) - 300) < 1e-3, `${back}`);
  refused(() => height({ geoid: { ...geoid, heights_m: [40, 50, 40] } }), /^geoid: got small\.gtx; allowed: a grid of two rows/);
  refused(() => height({ geoid: { ...geoid, columns: 0 } }), /^geoid: got small\.gtx/);
  refused(() => height({ geoid_m: NaN }), /^heights: geoid_m/, 'invalid-json');
  refused(() => height({ geoidM: 1 }), /geoidM/, 'invalid-json');
  refused(() => system_coordinates('EPSG:4979', place, { geoid_m: 46.5 }), /46\.5/);
});
