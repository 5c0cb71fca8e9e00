/** What the module refuses of values of JavaScript, which would else arrive as others. */

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import test from 'node:test';
import vm from 'node:vm';
import {
  BlockScene,
  connected_groups,
  FinishedBlock,
  grey_png,
  match_pair,
  message,
  OrthophotoReference,
  Photo,
  placed_tables,
  resolved,
  scaled_interior,
  sha256,
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
  refused(() => FinishedBlock.open(any('project.tiepoint')), /^file of the project: got string; allowed/);
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
      new RegExp(`^longest side: got ${String(side).replace('Infinity', 'inf')}; allowed: whole numbers from 0 to 4294967295$`),
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
  json({ points: { threshold: NaN } }, /^settings: points\.threshold: invalid type: string "NaN", expected f64$/);
  json({ points: { threshold: -Infinity } }, /^settings: points\.threshold: invalid type: string "-Infinity", expected f64$/);
  json({ points: { suppression_window: -1 } }, /^settings: points\.suppression_window: invalid value: integer `-1`, expected usize$/);
  json({ points: 'all' }, /^settings: points: invalid type: string "all", expected struct /);
  json('all', /^settings: invalid type: string "all", expected struct /);
  const photo = Photo.decode(PNG);
  refused(() => photo.detect({ points: { fraction: 1e300 } }), /^points\.fraction is 1e300; allowed/, 'invalid-option');
});

test('a call before the module is loaded, and of an object that was freed, says what to do', () => {
  const photo = Photo.decode(PNG);
  photo.free();
  assert.throws(() => photo.width, /^Error: the object was freed, or moved into another one: make a new one$/);
  const browser = new URL('../../pkg/browser.js', import.meta.url).href;
  const program = `import { Photo } from '${browser}'; try { Photo.decode(new Uint8Array(1)); } catch ({ message }) { console.log(message); }`;
  const { stdout } = spawnSync(process.execPath, ['--input-type=module', '--eval', program], { encoding: 'utf8' });
  assert.equal(stdout, 'the module is not loaded: call the default export of tiepoint and wait for it first\n');
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
