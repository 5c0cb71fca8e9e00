/** Tables that are given with a block: only those that can be read as what they are for take the place of what is there. Without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { block_settings } from '../pkg/node.js';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(
    page,
    await pageModules(['block/files/files', 'block/files/tables', 'block/state/given', 'block/state/reducer', 'block/state/state', 'shared/state/store']),
  );
});

const POINTS = 'a,0,0,0\nb,100,0,0\nc,0,100,0\n';
const MARKS = 'one.jpg,a,1,2\ntwo.jpg,a,3,4\n';
const IMAGES = 'image,name,camera,x,y,z\n0,one.jpg,0,1,2,3\n1,two.jpg,0,4,5,6\n';
const TIE_POINTS = 'point,x,y,z,red,green,blue,rays,confidence,rmse_px\n0,1,2,3,0,0,0,2,0.9,0.2\n';
const PAIRS = 'first,second,first_name,second_name,matches\n0,1,one.jpg,two.jpg,70\n';

test('a table is what its rows are', () => {
  const kind = (/** @type {string} */ text, /** @type {string[]} */ ...images) => page.tables.kindOfTable(text, new Set(images));
  assert.deepEqual(kind(POINTS), { kind: 'control' });
  assert.deepEqual(kind('point,x,y,z\n1,2,3,4\n'), { kind: 'control' });
  assert.deepEqual(kind(MARKS), { kind: 'marks' });
  assert.deepEqual(kind('# of a scan\ny_mm;x_mm;row;col;name\n1;2;3;4;a\n'), { kind: 'fiducials' });
  assert.equal(kind('Label,Image,x_px,y_px\nP1,DSC_0001.JPG,100,200\n').kind, 'marks');
  assert.deepEqual(kind('Punkt;Rechtswert;Hochwert;Höhe\nP1;4500000,5;5300000,5;300\n'), { kind: 'control' });
  // Between blanks, with names in a comment, and fiducial marks in other words.
  assert.deepEqual(kind('101 428374.069 5316020.123 104.5\n102 428375.069 5316020.123 104.5\n'), { kind: 'control' });
  assert.equal(kind('a.jpg 101 10.5 20\n').kind, 'marks');
  assert.deepEqual(kind('#Label,Enable,X/Easting,Y/Northing,Z/Altitude\nP1,1,412630,5316020,104\n'), { kind: 'control' });
  assert.deepEqual(kind('Spalte;Zeile;x (mm);y (mm)\n1,5;2;-103,9;4\n'), { kind: 'fiducials' });
  for (const positions of [
    'image,latitude,longitude,altitude,acc horz,acc vert\none.jpg,50.5,8.25,171.5,0.02,0.04\n',
    '# CoordinateSystem: none\n#Label,X/Longitude,Y/Latitude,Z/Altitude\none.jpg,8.25,50.5,171.5\n',
    'Name,Easting,Northing,Elevation\none.jpg,446833,5594521,171\n',
    'Bild;Rechtswert;Hochwert;Höhe\none.jpg;446833,25;5594521,5;171,5\n',
    'one.jpg,446833.25,5594521.5,171.5\n',
    'image,x,y,z\none.jpg,446833,5594521,171\n',
    'Bild;Öst;Norr;Höjd\none.jpg;446833;5594521;171\n',
    'Bild;UTM-Ost;UTM-Nord;NHN-Höhe\none.jpg;446833;5594521;171\n',
    'image,gps_lat,gps_lon,gps_alt\none.jpg,50.5,8.25,171\n',
  ])
    assert.deepEqual(kind(positions), { kind: 'positions' }, positions);
  assert.deepEqual(kind('Label,Longitude,Latitude\na,8.25,50.5\n', 'A.JPG'), { kind: 'positions' });
  // Points of which the first letter is that of a height.
  assert.equal(kind('one.jpg,H1,1.5,2.5\ntwo.jpg,H1,1.5,2.5\n').kind, 'marks');
  // Names without an ending are those of the block.
  assert.equal(kind('A1,a,1,2\n', 'A1').kind, 'marks');
  assert.equal(kind('photo_1,7,1,2\n', 'Photo_1.JPG').kind, 'marks');
  assert.equal(kind('photo_2,7,1,2\n', 'Photo_1.JPG').kind, 'control');
  for (const [text, why] of /** @type {[string, RegExp][]} */ ([
    [IMAGES, /rows are images of a result/],
    [TIE_POINTS, /rows are tie points/],
    [PAIRS, /neither a column 'name' .*nor a point/],
    ['name,x,y,z\nA,1,two,3\n', /'two' for y in line 2/],
    ['name,x,y,z\n', /no rows/],
    ['', /no rows/],
    // Positions with what is wrong with them.
    ['one.jpg,50.5,8.25,171.5\n', /may be latitude and longitude or longitude and latitude/],
    ['image,lat,lon,height\none.jpg,50.5,8.25,171\ntwo.jpg,50.5,x,171\n', /'x' for lon in line 3/],
    ['image,lat,lon,height\none.jpg,50.5,8,25,171\n', /with more fields than the 4 columns that are named/],
    ['image,lat,lon,height\none,50.5,8.25,171.5\n', /rows name no images: \u2068?one\u2069? is none/],
    // Image measurements with what is wrong with them, not with control points.
    ['Bild;Punkt;x;y\nDSC_0001;P1;100.5;200\n', /first column has to name images .*, and \u2068?DSC_0001\u2069? is none/],
    ['DSC_0001,P1,100.5,200\n', /first column has to name images/],
    ['P1,DSC_0001.JPG,100,200\n', /, and \u2068?P1\u2069? is none\. The columns .* are image, point, x and y/],
    ['image,point,x,y\none.jpg,P1,1,2\none.jpg,P2,1O0,2\n', /line 3/],
    // Control points with a slip stay control points.
    ['Punkt;Rechtswert;Hochwert;Höhe\nP1;4500000,5;zwei;300\n', /control points/],
    ['P1,4500000.5,two,300\n', /control points/],
    // As OpenDroneMap has them.
    ['EPSG:32632\n449000.1 5300000.2 300.5 100 200 DSC_0001.JPG P1\n449100.1 5300000.2 300.5 300 200 DSC_0001.JPG P2\n', /values stand between spaces/],
  ])) {
    const found = kind(text);
    assert.equal(found.kind, 'neither', text);
    assert.match(found.why, why);
  }
});

/** What takes files in, beside an empty block. */
function taking() {
  const store = new page.store.Holder(page.state.BLOCK_INITIAL, page.reducer.reduceBlock);
  store.dispatch({ type: 'options', options: { settings: block_settings({}) } });
  const runs = { run: () => Promise.resolve(), placeImages: () => Promise.resolve() };
  const files = new page.files.BlockFiles(
    store,
    {},
    {},
    runs,
    () => Promise.resolve(),
    () => Promise.resolve(true),
    () => Promise.resolve(() => {}),
  );
  const take = (/** @type {Record<string, string>} */ given) =>
    files.take(Object.entries(given).map(([name, text]) => ({ file: new File([text], name), path: '' })));
  return { store, take };
}

test('tables of results are put aside, each with what it is, and the control points stay', async () => {
  const { store, take } = taking();
  await take({ 'points.csv': POINTS });
  const { control } = store.state.options;
  assert.equal(control.name, 'points.csv');
  store.dispatch({ type: 'notice', notice: null });
  await take({ 'images.csv': IMAGES, 'pairs.csv': PAIRS });
  assert.equal(store.state.options.control, control);
  const { notice } = store.state;
  assert.equal(notice.kind, 'info');
  assert.match(
    notice.text,
    /^images\.csv is put aside, neither control points nor image measurements, GNSS positions or fiducial marks: its rows are images of a result, neither surveyed points nor GNSS positions\. pairs\.csv is put aside, /,
  );
  // It does not take the place of what is said of the block.
  assert.equal(notice.beside, true);
});

test('what is taken beside a table that is put aside is said first; notes are no tables', async () => {
  const { store, take } = taking();
  await take({ 'images.csv': IMAGES, 'points.csv': POINTS });
  assert.match(store.state.notice.text, /^Ground control points from points\.csv\. .*images\.csv is put aside, /);
  assert.equal(store.state.options.control.name, 'points.csv');
  const former = store.state.options;
  await take({ 'notes.txt': 'Weather: clear\n' });
  assert.equal(store.state.options, former);
  assert.equal(store.state.notice.text.includes('put aside'), false);
  assert.match(store.state.notice.text, /1 file skipped/);
  // A table is one whatever its ending.
  await take({ 'gcp_list.txt': 'EPSG:32632\n449000.1 5300000.2 300.5 100 200 one.jpg P1\n449100.1 5300000.2 300.5 300 200 one.jpg P2\n' });
  assert.equal(store.state.options, former);
  assert.match(store.state.notice.text, /gcp_list\.txt is put aside, .*: its values stand between spaces/);
  assert.equal(store.state.notice.text.includes('skipped'), false);
});

test('GNSS positions are taken beside the images that they name, without their endings too', async () => {
  const { store, take } = taking();
  await take({ 'flight.csv': 'Label,Longitude,Latitude,Altitude\none,8.25,50.5,171.5\n', 'one.jpg': '', 'two.jpg': '' });
  assert.equal(store.state.options.positions.name, 'flight.csv');
  assert.equal(page.given.problemsOf(store.state).positions, undefined);
  const key = page.state.wantedKey(store.state);
  await take({ 'flight.csv': 'Label,Easting,Northing,Altitude\none.jpg,446833.2,5594521.7,124.5\n' });
  assert.notEqual(page.state.wantedKey(store.state), key);
  assert.match(page.given.problemsOf(store.state).positions, /^flight\.csv: .*without a coordinate system/);
  // A key of an earlier release has none.
  store.dispatch({ type: 'options', options: { positions: null } });
  assert.equal(page.state.wantedKey(store.state).includes('positions'), false);
});

test('a table that is given after a run is said beside what is to be done, not in place of it', async () => {
  const { store, take } = taking();
  const images = ['one.jpg', 'two.jpg'].map((name, id) => ({ id, name, file: new Blob([]) }));
  store.dispatch({ type: 'files', files: images, truth: null });
  // Before a run it is the answer.
  await take({ 'flight.csv': 'image,lat,lon,height\none.jpg,50.5,8.25,171.5\n' });
  assert.deepEqual(store.state.notice, { kind: 'info', text: 'GNSS positions of images from flight.csv.', beside: false });
  const points = { count: 0, taking: 0, sources: new Float64Array(), rays: new Uint16Array() };
  const view = {
    partial: false,
    oriented: 2,
    images,
    points,
    connections: [],
    surveyed: [],
    givenControl: 0,
    orthophoto: null,
    crs: null,
    components: [],
    checks: null,
    origin: null,
  };
  const run = () => {
    const key = page.state.wantedKey(store.state);
    store.dispatch({ type: 'started', key });
    store.dispatch({ type: 'done', key, view, files: images, seconds: 1 });
  };
  run();
  assert.ok(!page.state.isOutdated(store.state));
  await take({ 'other.csv': 'image,lat,lon,height\none.jpg,50.5,8.25,171.6\n' });
  assert.ok(page.state.isOutdated(store.state));
  assert.deepEqual(store.state.notice, { kind: 'info', text: 'GNSS positions of images from other.csv.', beside: true });
  // Points that wait for their measurements change nothing of the run: the verdict stays, with what was taken.
  run();
  await take({ 'points.csv': POINTS });
  assert.ok(!page.state.isOutdated(store.state));
  assert.equal(store.state.notice.beside, false);
  const marks = ['one', 'two'].flatMap((image) => [1, 2, 3, 4].map((point) => `${image}.jpg,P${point},${100 * point},${70 * point}\n`)).join('');
  await take({ 'marks.csv': marks });
  assert.ok(page.state.isOutdated(store.state) || store.state.notice.kind === 'problem', store.state.notice.text);
  assert.match(store.state.notice.text, /marks\.csv/);
  run();
  store.dispatch({ type: 'options', options: { settings: block_settings({ placing: { crs: 'EPSG:5555' } }) } });
  run();
  await take({ 'geoid.gtx': 'x' });
  assert.deepEqual(store.state.notice, { kind: 'info', text: 'Geoid from geoid.gtx.', beside: true });
});
