/** Values of another type than the module takes: each is refused by the name of its parameter, and none is read as something else. */

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import * as tiepoint from '../../pkg/node.js';

const { BlockScene, FinishedBlock, grey_png, match_pair, message, OrthophotoReference, Photo, points_csv, resolved, system_positions } = tiepoint;

/** @type {any} */
const any = (/** @type {unknown} */ value) => value;

/** @param {() => unknown} call @param {RegExp} pattern of the message @param {string} [code] */
const refused = (call, pattern, code = 'invalid-input') =>
  assert.throws(call, (/** @type {any} */ error) => {
    assert.match(error.message, pattern);
    assert.deepEqual([error.name, error.code, error.message], ['TiepointError', code, message('error', error.error)]);
    return true;
  });

const GREY = Uint8Array.from({ length: 64 * 48 }, (_, i) => (i * 7919) % 251);
const PNG = grey_png(64, 48, GREY);

test('a text is a string, and a list of texts an array of strings', () => {
  const { parse_camera, parse_ground_control_points, parse_image_measurements, refused_kind, execute_job, check_cameras, masks_of_images } = tiepoint;
  for (const [given, kind] of /** @type {const} */ ([
    [32632, 'number'],
    [{ focal_mm: 5 }, 'object'],
    [[], 'Array'],
    [Buffer.from('{}'), 'Uint8Array'],
    [null, 'null'],
    [undefined, 'undefined'],
    [Symbol('text'), 'symbol'],
  ])) {
    const told = (/** @type {string} */ name) => new RegExp(`^${name}: got ${kind}; allowed: a string$`);
    refused(() => system_positions(any(given), [500000, 5600000, 0]), told('crs'));
    refused(() => parse_camera(any(given)), told('json'));
    refused(() => parse_ground_control_points(any(given)), told('text'));
    refused(() => check_cameras(any(given), []), told('text'));
    refused(() => refused_kind(any(given), PNG), told('name'));
    refused(() => execute_job(any(given), []), told('task'));
    refused(() => message(any(given), any({})), told('family'));
  }
  refused(() => message('failure', { kind: 'unreadable', message: 'gone' }, any(5)), /^attribute: got number; allowed: a string$/);
  refused(() => message('failure', { kind: 'unreadable', message: 'gone' }, null, any({})), /^language: got object; allowed: a string$/);
  refused(() => check_cameras('{"cameras": []}', any('a.png')), /^names: got string; allowed: an array of strings$/);
  refused(() => check_cameras('{"cameras": []}', any(['a.png', 5])), /^names: got number as item 1; allowed: an array of strings$/);
  refused(() => masks_of_images(['a.png'], any(undefined)), /^masks: got undefined; allowed: an array of strings$/);
  refused(() => parse_image_measurements('a.png,1,2,3', any({ 0: 'a.png', length: 1 })), /^images: got object; allowed: an array of strings$/);
  refused(() => execute_job('{"kind": "likeness", "key": "a", "counts": [0]}', any(5)), /^inputs: got number; allowed: an array of Uint8Array$/);
  const scene = new BlockScene({ strips: 1, exposures: 2 });
  const reference = OrthophotoReference.open(scene.orthophoto(4).picture);
  refused(() => reference.place(any(5), PNG, null), /^name: got number; allowed: a string$/);
  refused(() => reference.place('a.png', PNG, any({ cameras: [] })), /^cameras: got object; allowed: a string$/);
  reference.free();
  scene.free();
  assert.equal(message('failure', { kind: 'unreadable', message: 'größer ⌀ 𝄞' }).includes('größer ⌀ 𝄞'), true);
});

test('many numbers are an array of them, and no text of digits', () => {
  for (const [given, kind] of /** @type {const} */ ([
    ['123456789', 'string'],
    [{}, 'object'],
    [{ length: 3 }, 'object'],
    [undefined, 'undefined'],
    [null, 'null'],
    [12, 'number'],
    [['1', 2, 3], 'string as item 0'],
    [[1, null, 3], 'null as item 1'],
    [new DataView(new ArrayBuffer(24)), 'DataView'],
    [new ArrayBuffer(24), 'ArrayBuffer'],
    [BigInt64Array.of(1n, 2n, 3n), 'BigInt64Array'],
  ]))
    refused(() => points_csv(any(given)), new RegExp(`^points: got ${kind}; allowed: Float64Array, or another array of numbers$`));
  const csv = points_csv(Float64Array.of(1.5, 2, 3));
  assert.match(csv, /1\.5/);
  const shared = new Float64Array(new SharedArrayBuffer(24));
  shared.set([1.5, 2, 3]);
  for (const given of [[1.5, 2, 3], Float32Array.of(1.5, 2, 3), shared]) assert.equal(points_csv(any(given)), csv);
  assert.equal(points_csv(any(Int8Array.of(-1, 2, 3))), points_csv([-1, 2, 3]));
  const { model_points, orient_relative } = any(tiepoint);
  refused(() => orient_relative(new Float64Array(24), 5, {}, '111111'), /^weights: got string; allowed/);
  refused(() => model_points('11', 5, {}, 1), /^observations: got string; allowed/);
});

test('options that JSON does not have are refused in place of defaults', () => {
  const photo = Photo.decode(PNG);
  const circle = { points: {} };
  Object.assign(circle.points, { circle });
  const throws = {
    toJSON() {
      throw new RangeError('no JSON today');
    },
  };
  const json = (/** @type {unknown} */ settings, /** @type {RegExp} */ pattern) => {
    refused(() => match_pair(photo, photo, {}, any(settings)), pattern, 'invalid-json');
    refused(() => resolved(any(settings)), pattern, 'invalid-json');
  };
  json({ multiscale: { number: 10n } }, /^settings: number: got bigint, which JSON does not have$/);
  json({ multiscale: { number: () => 10 } }, /^settings: number: got function, which JSON does not have$/);
  json({ matching: { strategy: Symbol('gradient') } }, /^settings: strategy: got symbol, which JSON does not have$/);
  json({ multiscale: new Map([['number', 10]]) }, /^settings: multiscale: got Map, which JSON does not have$/);
  json(new Map([['multiscale', {}]]), /^settings: got Map, which JSON does not have$/);
  json(new Set(), /^settings: got Set, which JSON does not have$/);
  json(Promise.resolve({}), /^settings: got Promise, which JSON does not have$/);
  json(() => ({}), /^settings: got function, which JSON does not have$/);
  json(circle, /^settings: \S.*circular [^\n]*$/i);
  json(throws, /^settings: no JSON today$/);
  assert.deepEqual(resolved(any({ toJSON: () => ({ multiscale: { number: 10 } }) })), resolved({ multiscale: { number: 10 } }));
  assert.deepEqual(resolved({ points: undefined }), resolved({}));
  photo.free();
});

test('an object of another class is refused, and one that gives no points', () => {
  const photo = Photo.decode(PNG);
  for (const [given, kind] of /** @type {const} */ ([
    [PNG, 'Uint8Array'],
    [{}, 'Object'],
    [Object.create(null), 'object'],
    [null, 'null'],
    [undefined, 'undefined'],
    [5, 'Number'],
  ]))
    refused(() => match_pair(photo, any(given), {}, {}), new RegExp(`^argument: got ${kind}; allowed: Photo$`));
  const scene = new BlockScene({ strips: 1, exposures: 2 });
  refused(() => new tiepoint.Report(photo, any(scene), ['a', 'b'], {}, {}, null), /^argument: got BlockScene; allowed: Photo$/);
  scene.free();
  const { match_photos, constant_offset, match_described_pair, join_nearest } = tiepoint;
  refused(() => match_photos(photo, photo, any(null), any({}), constant_offset(0, 0), null, {}), /^points: got undefined; allowed/);
  refused(() => match_described_pair(photo, photo, any({ points: '123' }), any({}), {}, {}), /^points: got string; allowed/);
  refused(() => join_nearest(any(5), {}), /^pieces of nearest neighbours: got number; allowed: an array of them$/);
  refused(() => any(FinishedBlock).open(photo), /^file of the project: got object; allowed/);
  photo.free();
});

test('a focal length that no camera has makes no camera', () => {
  const { camera_of_focal_px } = tiepoint;
  refused(() => camera_of_focal_px(any('x')), /^focal_px: got string; allowed: a number$/);
  refused(() => camera_of_focal_px(NaN), /^focal_px is NaN; allowed: 1 to 10000000$/, 'invalid-option');
  refused(() => camera_of_focal_px(0.2), /^focal_px is 0\.2; allowed/, 'invalid-option');
  assert.equal(camera_of_focal_px(1200).focal_mm, 1.2);
});

/** The functions of the module with the number of their parameters, as its types have them. */
const FUNCTIONS = [...readFileSync(new URL('../../pkg/wasm/tiepoint.d.ts', import.meta.url), 'utf8').matchAll(/^export function (\w+)\(([^)]+)\)/gm)].map(
  ([, name = '', parameters = '']) => ({ name, count: parameters.split(/, (?=\w+\??:)/).length }),
);

test('no function ends in anything but a refusal, whatever it is given', () => {
  assert.ok(FUNCTIONS.length > 80, `${FUNCTIONS.length}`);
  const wrong = FUNCTIONS.filter(({ name }) => name !== 'initSync').flatMap(({ name, count }) =>
    [5, NaN, null, undefined, 'text', '', [], ['text', 5], {}, { length: 4 }, new Map(), PNG, new Float64Array(7), () => 5].flatMap((value) => {
      try {
        any(tiepoint)[name](...Array(count).fill(value));
      } catch (error) {
        const { name: kind, message: words } = any(error);
        if (kind !== 'TiepointError') return [`${name}(${String(value)}, …): ${kind}: ${words}`];
      }
      return [];
    }),
  );
  assert.deepEqual(wrong, []);
});
