/** Files that are given beside the images of a pair: those of a block and settings are told to be that. Without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { parse_camera, parse_fiducials } from '../pkg/node.js';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
let page = {};

before(async () => {
  page = await pageModules(['pair/files/beside', 'pair/files/told', 'pair/state/reducer', 'pair/state/state', 'shared/state/store']);
});

/** What takes files beside an empty pair, with its state. */
function taking() {
  const store = new page.store.Holder(page.state.INITIAL, page.reducer.reduce);
  /** @type {Record<string, (input: { text: string }) => unknown>} */
  const calls = { parseFiducials: ({ text }) => parse_fiducials(text), parseCamera: ({ text }) => parse_camera(text) };
  const client = { call: async (/** @type {string} */ name, /** @type {{ text: string }} */ input) => calls[name]?.(input) };
  const beside = new page.beside.BesideFiles(store, { client: () => client }, new page.told.Telling(store));
  const here = () => {};
  return {
    store,
    beside,
    table: (/** @type {string} */ text) => beside.fiducials(new File([text], 'table.csv'), 'left', here),
    camera: (/** @type {object} */ content) => beside.camera(new File([JSON.stringify(content)], 'own.json'), here),
  };
}

test('settings that are given as a camera are told to be settings, and of what', async () => {
  const { store, camera } = taking();
  const own = await camera({ tiepoint_settings: 'pair', changed: {} });
  assert.deepEqual(own, { kind: 'info', text: 'own.json holds settings: load it under Settings. It is put aside.' });
  const other = await camera({ tiepoint_settings: 'block', changed: {} });
  assert.deepEqual(other, { kind: 'problem', text: 'own.json: the file holds settings of a block, not of a pair.' });
  assert.equal(store.state.camera, null);
  // Others are what they were.
  assert.match((await camera({ focal: 4 })).text, /^own\.json holds no camera data: /);
  assert.equal((await camera({ focal_mm: 4, pixel_mm: 0.005 })).text, 'Camera data from own.json.');
});

test('tables of a block are told to be that; what is wrong with one of fiducial marks is said of it', async () => {
  const { store, table } = taking();
  for (const text of [
    'a,0,0,0\nb,100,0,0\n',
    'Punkt;Rechtswert;Hochwert;Höhe\nP1;4500000,5;5300000,5;300\n',
    'one.jpg,a,1,2\ntwo.jpg,a,3,4\n',
    'image,latitude,longitude,altitude\none.jpg,50.5,8.25,171.5\n',
  ]) {
    const { kind, text: said } = await table(text);
    assert.equal(kind, 'problem');
    assert.match(
      said,
      /^table\.csv holds no fiducial marks: it can be read as control points, .* which belong to a block\. Give it with the photos under “Block”\.$/,
    );
  }
  for (const [text, why] of /** @type {[string, RegExp][]} */ ([
    ['name,col,row,x_mm,y_mm\na,1,2,x,4\n', /got 'x' for x_mm in line 2/],
    ['col;row;x;y\n1;2;3;4\n', /no column x_mm/],
    ['x_left,y_left,x_right,y_right,measure\n1,2,3,4,5\n', /no column col/],
  ])) {
    const { text: said } = await table(text);
    assert.match(said, /^table\.csv is no photograph and no table that is known here: /);
    assert.match(said, why);
    assert.doesNotMatch(said, /block/);
  }
  // Of a text that is no table at all no columns are said.
  for (const text of ['Weather: clear\n', '']) assert.equal((await table(text)).text, 'table.csv is no photograph and no table that is known here.');
  assert.deepEqual(store.state.photos.left.fiducials, []);
});

test('a file that is gone when it is read is told with the others', async () => {
  const { beside } = taking();
  const gone = (/** @type {string} */ name) => Object.assign(new File([''], name), { arrayBuffer: () => Promise.reject(new Error('it is gone')) });
  const here = () => {};
  for (const [told, text] of [
    [await beside.camera(gone('own.json'), here), 'own.json holds no camera data: it is gone.'],
    [await beside.fiducials(gone('table.csv'), 'left', here), 'table.csv cannot be opened: it is gone.'],
  ])
    assert.deepEqual(told, { kind: 'problem', text });
});
