/** Orthophotos as the page's own code tells them apart and lays them on a map: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import {
  block_settings,
  BlockScene,
  geographic_positions,
  grey_png,
  image_position,
  local_positions,
  OrthophotoReference,
  system_coordinates,
} from '../pkg/node.js';
import { georeferenced, inDegrees } from './page/georeferenced.js';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(
    page,
    await pageModules([
      'block/engine/recorded',
      'block/files/earlier-keys',
      'block/files/rasters',
      'shared/state/plane-map',
      'block/state/under',
      'block/state/cells',
      'block/state/purpose',
      'block/files/degrees',
      'block/state/placing',
      'block/state/film',
      'block/state/given-positions',
      'block/state/placed',
      'block/state/laid',
      'block/state/showing',
      'block/state/ground',
      'block/view/orthophoto/block',
    ]),
  );
});

/** @param {string} name @param {Uint8Array | string} content @param {string} [type] */
const found = (name, content, type = '') => ({ file: new File([/** @type {BlobPart} */ (content)], name, { type }), path: '' });

const scene = () => {
  const made = new BlockScene({ strips: 1, exposures: 2, width_px: 120, height_px: 90, pixel_mm: 0.3 });
  const { picture, heights } = made.orthophoto(4);
  made.free();
  return { picture, heights };
};

test('orthophotos, heights and photographs are told apart by what they hold', async () => {
  const { sortRasters, kindOfTiff } = page.rasters;
  const { picture, heights } = scene();
  const png = grey_png(4, 4, new Uint8Array(16));
  const sorted = await sortRasters([
    found('one.tif', picture),
    found('two.tif', heights),
    found('grid.asc', 'ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n'),
    found('degrees.tif', inDegrees(heights)),
    found('notes.txt', 'no grid'),
    found('photo.png', png, 'image/png'),
    found('map.png', png, 'image/png'),
    found('map.pgw', '1\n0\n0\n-1\n0\n0\n'),
    found('alone.tfw', '1\n0\n0\n-1\n0\n0\n'),
    found('map.prj', 'EPSG:25832'),
    found('grid.prj', 'EPSG:25832'),
    found('alone.prj', 'EPSG:25832'),
    // A TIFF without a place is a photograph, and so is what is damaged: the crate says why.
    found('cut.tif', picture.slice(0, 40)),
  ]);
  const names = (/** @type {{ file: File }[]} */ list) => list.map(({ file }) => file.name);
  assert.deepEqual(names(sorted.orthophotos), ['one.tif', 'map.png']);
  assert.deepEqual([sorted.orthophotos[1].world.name, sorted.orthophotos[1].projection.name], ['map.pgw', 'map.prj']);
  assert.deepEqual([sorted.heights[1].world, sorted.heights[1].projection.name], [null, 'grid.prj']);
  assert.deepEqual(names(sorted.heights), ['two.tif', 'grid.asc']);
  assert.deepEqual([names(sorted.degrees), await page.rasters.hasGround([found('degrees.tif', inDegrees(heights))])], [['degrees.tif'], true]);
  assert.deepEqual(
    sorted.worlds.map((/** @type {File} */ { name }) => name),
    ['alone.tfw'],
  );
  assert.deepEqual(
    sorted.projections.map((/** @type {File} */ { name }) => name),
    ['alone.prj'],
  );
  const { hasGround } = page.rasters;
  const [map, world, system] = [found('map.png', png, 'image/png'), found('map.pgw', '1\n0\n0\n-1\n0\n0\n'), found('map.prj', 'EPSG:25832')];
  assert.deepEqual([await hasGround([map, world, system]), await hasGround([map, world]), await hasGround([found('one.tif', picture)])], [true, true, false]);
  assert.deepEqual(names(sorted.others), ['notes.txt', 'photo.png', 'cut.tif']);

  const placed = [
    [33550, 0],
    [33922, 0],
  ];
  const kind = (/** @type {number[][]} */ ...tags) => kindOfTiff(new Map(/** @type {[number, number][]} */ (tags)), false);
  assert.equal(kind([258, 8], [277, 3], [339, 1], ...placed), 'orthophoto');
  assert.equal(kind([258, 16], ...placed), 'orthophoto');
  assert.equal(kind([258, 16], [339, 2], ...placed), 'heights');
  assert.equal(kind([258, 32], [339, 3], ...placed), 'heights');
  assert.equal(kind([258, 32], [339, 3], [277, 3], ...placed), 'orthophoto');
  assert.equal(kind([258, 32], [339, 3], [1024, 2], ...placed), 'degrees');
  assert.equal(kind([258, 32], [339, 3], [1024, 1], ...placed), 'heights');
  assert.equal(kind([258, 8], [277, 3], [1024, 2], ...placed), 'orthophoto');
  assert.equal(kind([258, 8], [277, 3]), 'photograph');
  assert.equal(kindOfTiff(new Map([[258, 32]]), true), 'heights');
});

test('the GNSS position of a TIFF is read from its directories, wherever they lie, and without it no more', () => {
  // Behind 40 MB of pixels that nobody reads: a directory that points to one of GPS, with the values of that.
  const [main, gps, values, size] = [40_000_000, 40_000_018, 40_000_072, 40_000_120];
  const tail = Buffer.alloc(size - main);
  tail.writeUInt16BE(1, 0);
  const entry = (/** @type {number} */ at, /** @type {number} */ tag, /** @type {number} */ kind, /** @type {number} */ count, /** @type {number} */ value) => {
    tail.writeUInt16BE(tag, at);
    tail.writeUInt16BE(kind, at + 2);
    tail.writeUInt32BE(count, at + 4);
    tail.writeUInt32BE(value, at + 8);
  };
  entry(2, 0x8825, 4, 1, gps);
  tail.writeUInt16BE(4, gps - main);
  const letter = (/** @type {string} */ side) => side.charCodeAt(0) * 2 ** 24;
  entry(gps - main + 2, 1, 2, 2, letter('N'));
  entry(gps - main + 14, 2, 5, 3, values);
  entry(gps - main + 26, 3, 2, 2, letter('W'));
  entry(gps - main + 38, 4, 5, 3, values + 24);
  for (const [k, value] of [30, 1, 15, 1, 0, 1, 98, 1, 30, 1, 0, 1].entries()) tail.writeUInt32BE(value, values - main + 4 * k);
  const head = Buffer.from('MM\0*\0\0\0\0', 'latin1');
  head.writeUInt32BE(main, 4);
  let read = 0;
  const part = (/** @type {number} */ at, /** @type {number} */ length) => {
    read += length;
    const bytes = new Uint8Array(length);
    for (const [from, known] of /** @type {const} */ ([
      [0, head],
      [main, tail],
    ]))
      for (const [k, byte] of known.entries()) if (from + k >= at && from + k < at + length) bytes[from + k - at] = byte;
    return bytes;
  };
  assert.deepEqual(image_position({ size, read: part }), { longitude_deg: -98.5, latitude_deg: 30.25, height_m: null, error_m: null });
  assert.ok(read < 400_000, `${read} of ${size} bytes`);
  // What is no file is refused; what cannot be read has none.
  assert.throws(() => image_position(/** @type {any} */ (null)), /file/);
  const broken = () => {
    throw new Error('gone');
  };
  assert.equal(image_position({ size, read: broken }), null);
});

test('each image is read once for its GNSS position, and no more as soon as it is not wanted', async () => {
  const at = { longitude_deg: 8, latitude_deg: 50, height_m: null, error_m: null };
  /** @type {Blob[]} */
  const asked = [];
  let ended = 0;
  const [one, other, lost] = [new Blob(['1']), new Blob(['2']), new Blob(['3'])];
  const reader = {
    call: (/** @type {string} */ _, /** @type {{ file: Blob }} */ { file }) => {
      asked.push(file);
      return file === lost ? Promise.reject(new Error('gone')) : Promise.resolve(file === one ? at : null);
    },
    cancel: () => {
      ended += 1;
    },
  };
  const recorded = new page.recorded.RecordedPositions(reader);
  const files = [one, other, lost].map((file, id) => ({ id, name: String(id), file }));
  assert.deepEqual(await recorded.of(files, () => true), [at]);
  assert.deepEqual(await recorded.of([...files].reverse(), () => true), [at]);
  assert.deepEqual([asked, ended], [[one, other, lost], 2]);
  // An image that is gone is forgotten; after the first answer the others are not asked for.
  assert.deepEqual(await recorded.of([], () => true), []);
  assert.equal(await recorded.of(files, () => false), null);
  assert.deepEqual([asked.length, ended], [4, 3]);
});

test('a large orthophoto is read in parts, by an object that gives bytes at once', () => {
  const [side, rows, head] = [6_500, 100, 8];
  const value = (/** @type {number} */ x, /** @type {number} */ y) => 20 + (((x >> 4) * 7 + (y >> 4) * 13) % 200);
  // A TIFF in strips, uncompressed: pixels, then the places and lengths of the strips, then the directory.
  const strips = side / rows;
  const pixels = side * side;
  const file = Buffer.alloc(head + pixels + 8 * strips + 2 + 12 * 9 + 4);
  file.write('II*\0', 'latin1');
  for (let y = 0; y < side; y += 1) for (let x = 0; x < side; x += 1) file[head + y * side + x] = value(x, y);
  let at = head + pixels;
  for (let k = 0; k < strips; k += 1) {
    file.writeUInt32LE(head + k * rows * side, at + 4 * k);
    file.writeUInt32LE(rows * side, at + 4 * (strips + k));
  }
  const tags = [
    [256, 1, side],
    [257, 1, side],
    [258, 1, 8],
    [259, 1, 1],
    [262, 1, 1],
    [273, strips, at],
    [277, 1, 1],
    [278, 1, rows],
    [279, strips, at + 4 * strips],
  ];
  at += 8 * strips;
  file.writeUInt32LE(at, 4);
  file.writeUInt16LE(tags.length, at);
  tags.forEach(([tag = 0, count = 0, of = 0], k) => {
    const entry = at + 2 + 12 * k;
    file.writeUInt16LE(tag, entry);
    file.writeUInt16LE(4, entry + 2);
    file.writeUInt32LE(count, entry + 4);
    file.writeUInt32LE(of, entry + 8);
  });

  let read = 0;
  const parts = {
    size: file.length,
    read: (/** @type {number} */ from, /** @type {number} */ length) => {
      read += length;
      return new Uint8Array(file.subarray(from, from + length));
    },
  };
  const reference = OrthophotoReference.open(parts, { world_file: '0.5\n0\n0\n-0.5\n1000\n2000\n', projection: 'EPSG:25832' });
  const { width, height, in_parts: isInParts, epsg, on_earth: isOnEarth } = reference.info();
  assert.deepEqual([width, height, isInParts, epsg, isOnEarth], [side, side, true, 25832, true]);
  const part = reference.picture(3_000, 4_000, 40, 30, 0);
  assert.ok(part.every((grey, k) => grey === value(3_000 + (k % 40), 4_000 + Math.floor(k / 40))));
  assert.ok(read < file.length / 20, `${read} of ${file.length} bytes read`);
  reference.free();
  // What cannot be read is a typed error, in the words of the host.
  const broken = {
    size: file.length,
    read: () => {
      throw new Error('the disk is gone');
    },
  };
  assert.throws(() => OrthophotoReference.open(broken), /TiepointError/);
  assert.throws(() => OrthophotoReference.open(/** @type {any} */ (7)), { code: 'invalid-input' });
  assert.throws(() => OrthophotoReference.open({ size: -1, read: parts.read }), { code: 'invalid-input' });
});

test('a map of the plane is undone by its inverse, and pixels lie where the crate has them', () => {
  const { affineOf, after, scaleOf, similarity } = page.under;
  const { inverse, mapped } = page.plane_map;
  const reference = OrthophotoReference.open(scene().picture);
  const { georeference, gsd } = reference.info();
  reference.free();
  const toGround = affineOf(georeference);
  assert.ok(Math.abs(scaleOf(toGround) - gsd) < 1e-9);
  assert.deepEqual(mapped(toGround, 0, 0), georeference.origin);
  const turned = { a: 0.3, b: 0.4, c: -0.5, d: 0.2, e: 500_000, f: 5_400_000 };
  const same = after(inverse(turned), turned);
  const [x, y] = mapped(same, 7, -3);
  assert.ok(Math.hypot(x - 7, y + 3) < 1e-6, `${x} ${y}`);
  assert.deepEqual(
    mapped(after(turned, toGround), 2, 5).map((v) => v.toFixed(6)),
    mapped(turned, ...mapped(toGround, 2, 5)).map((v) => v.toFixed(6)),
  );

  const from = [
    [500_000, 5_400_000],
    [500_100, 5_400_000],
    [500_050, 5_400_080],
  ];
  const known = { a: 0.8, b: 0.6, c: -0.6, d: 0.8, e: 12, f: -40 };
  const to = from.map(([east = 0, north = 0]) => mapped(known, east, north));
  const again = similarity(from, to);
  for (const [i, [east, north]] of from.entries()) {
    const [u, v] = mapped(again, east, north);
    assert.ok(Math.hypot(u - to[i][0], v - to[i][1]) < 1e-6);
  }
  assert.equal(similarity([[1, 2]], [[3, 4]]), null);
  assert.equal(
    similarity(
      [
        [1, 2],
        [1, 2],
      ],
      [
        [3, 4],
        [5, 6],
      ],
    ),
    null,
  );
});

test('another orthophoto takes what was placed away; other settings mark it as earlier, the same ones again do not', () => {
  const { NO_PLACING, reducePlacing } = page.placing;
  const { placedFiles, placingKey, unplacedFiles } = page.placed;
  const info = { width: 10, height: 10, gsd: 1, georeference: { origin: [0, 0], by_column: [1, 0], by_row: [0, -1] }, epsg: null, heights: [0, 0] };
  const raster = { id: 7, name: 'o.tif', file: new Blob(), world: null, projection: null };
  const options = { near_x: null, near_y: null, within_m: 500 };
  const state = (/** @type {object} */ placing) => ({
    placing,
    options: { cameras: null, positions: null },
    files: [{ id: 1, name: 'a.jpg', file: new Blob() }],
  });
  let placing = reducePlacing({ ...NO_PLACING, options }, { type: 'orthophoto', orthophoto: { raster, info, ofBlock: null } });
  assert.equal(unplacedFiles(state(placing)).length, 1);
  const key = placingKey(state(placing));
  placing = reducePlacing(placing, { type: 'placed', image: { id: 1 }, placed: { key, result: null, problem: 'no image' } });
  assert.deepEqual(
    placedFiles(state(placing)).map((/** @type {{ isStale: boolean }} */ { isStale }) => isStale),
    [false],
  );
  const near = reducePlacing(placing, { type: 'placingOptions', options: { near_x: 3 } });
  assert.equal(placedFiles(state(near))[0].isStale, true);
  assert.equal(unplacedFiles(state(near)).length, 1);
  const back = reducePlacing(near, { type: 'placingOptions', options: { near_x: null } });
  assert.equal(placedFiles(state(back))[0].isStale, false);
  const level = reducePlacing(placing, { type: 'heights', heights: { kind: 'level', height: 20 }, info });
  assert.equal(placedFiles(state(level))[0].isStale, true);
  const other = reducePlacing(placing, { type: 'orthophoto', orthophoto: { raster: { ...raster, id: 8 }, info, ofBlock: null } });
  assert.equal(placedFiles(state(other)).length, 0);
  assert.deepEqual(reducePlacing(placing, { type: 'orthophoto', orthophoto: null }), { ...NO_PLACING, options });
});

test('coordinates of a table have the system of the block: another one has those images placed anew whose positions it moves', () => {
  const { NO_PLACING, reducePlacing } = page.placing;
  const { placedFiles, placingKey, placingKeyOf } = page.placed;
  const files = ['a.jpg', 'b.jpg'].map((name, k) => ({ id: k + 1, name, file: new Blob() }));
  const state = (/** @type {any} */ placing, /** @type {string} */ text, /** @type {string} */ crs) => ({
    placing,
    files,
    options: { cameras: null, positions: { name: 'flight.csv', text }, settings: block_settings({ placing: { crs } }) },
  });
  /** Which of both are to be placed anew with one system after the other. @param {string} text @returns {boolean[][]} */
  const stale = (text) => {
    const before = state(NO_PLACING, text, 'EPSG:32632');
    const positions = page.given_positions.givenPositions(before);
    const placing = files.reduce((now, { id, name }) => {
      const key = placingKeyOf(placingKey(before), { film: now.film, positions }, name);
      return reducePlacing(now, { type: 'placed', image: { id }, placed: { key, result: null, problem: '' } });
    }, NO_PLACING);
    const of = (/** @type {string} */ crs) => placedFiles(state(placing, text, crs)).map((/** @type {{ isStale: boolean }} */ { isStale }) => isStale);
    return ['EPSG:32632', 'EPSG:32633'].map(of);
  };
  assert.deepEqual(stale('image,easting,northing\na.jpg,446833.25,5594521.5\n'), [
    [false, false],
    [true, false],
  ]);
  // Degrees are those of WGS 84 in any system.
  assert.deepEqual(stale('image,lon,lat\na.jpg,8.25,50.5\n'), [
    [false, false],
    [false, false],
  ]);
});

test('keys of places that earlier releases kept are written as they are now: of a table of positions, of film, of both', () => {
  const { NO_PLACING } = page.placing;
  const { placedFiles } = page.placed;
  const files = [{ id: 1, name: 'a.tif', file: new Blob() }];
  const table = { name: 'flight.csv', text: 'image,lon,lat\na.tif,8.25,50.5\n' };
  const film = { camera: { name: 'film.json', text: '{}' }, marks: [{ name: 'a.csv', text: 'one' }] };
  const settings = block_settings({});
  /** Whether a place of such a key is out of date. @param {string} key @param {any} given @param {any} positions */
  const isStale = (key, given, positions) => {
    const placed = new Map([[1, { key, result: null, problem: '' }]]);
    const placing = page.earlier_keys.withPresentKeys({ ...NO_PLACING, film: given, placed }, files, { settings });
    return placedFiles({ placing, files, options: { cameras: null, positions, settings } })[0].isStale;
  };
  const base = (/** @type {unknown[]} */ ...more) => JSON.stringify([null, 0, null, null, ...more]);
  const scan = { camera: '{}', marks: 'one' };
  assert.equal(isStale(base(table), NO_PLACING.film, table), false);
  assert.equal(isStale(JSON.stringify([base(), scan]), film, null), false);
  assert.equal(isStale(JSON.stringify([base(table), scan]), film, table), false);
  assert.equal(isStale(base(), NO_PLACING.film, null), false);
  // Placed without a table, by another one, or by something else.
  assert.equal(isStale(base(), NO_PLACING.film, table), true);
  assert.equal(isStale(base({ ...table, text: table.text.replace('50.5', '50.6') }), NO_PLACING.film, table), true);
  assert.equal(isStale('', NO_PLACING.film, null), true);
});

test('marks of film are of the image of their name, which alone is placed anew with others', () => {
  const { NO_PLACING, reducePlacing } = page.placing;
  const { placedFiles, placingKey, placingKeyOf, unplacedFiles } = page.placed;
  const { filmOf, marksOfNone, NO_FILM, withMarks } = page.film;
  const files = ['1963_017.TIF', 'a.jpg'].map((name, k) => ({ id: k + 1, name, file: new Blob() }));
  const state = (/** @type {any} */ placing) => ({ placing, options: { cameras: null, positions: null }, files });
  const marks = (/** @type {string} */ name, /** @type {string} */ text) => ({ name, text });
  const film = withMarks({ ...NO_FILM, camera: marks('film.json', '{}') }, [marks('1963_017.csv', 'one')]);
  assert.deepEqual([filmOf(film, '1963_017.TIF'), filmOf(film, 'a.jpg')], [{ camera: '{}', marks: 'one' }, null]);
  assert.deepEqual([marksOfNone(film, files), marksOfNone(film, files.slice(1))], [[], ['1963_017.csv']]);
  let placing = reducePlacing(NO_PLACING, { type: 'film', film });
  for (const { id, name } of files) {
    const key = placingKeyOf(placingKey(state(placing)), { film: placing.film, positions: new Map() }, name);
    placing = reducePlacing(placing, { type: 'placed', image: { id }, placed: { key, result: null, problem: '' } });
  }
  const stale = (/** @type {any} */ of) => placedFiles(state(of)).map((/** @type {{ isStale: boolean }} */ { isStale }) => isStale);
  assert.deepEqual(stale(placing), [false, false]);
  const other = reducePlacing(placing, { type: 'film', film: withMarks(film, [marks('1963_017.txt', 'two')]) });
  assert.deepEqual([stale(other), other.film.marks.length], [[true, false], 1]);
  assert.deepEqual(
    unplacedFiles(state(other)).map((/** @type {{ name: string }} */ { name }) => name),
    ['1963_017.TIF'],
  );
  // Another orthophoto shows the same scans.
  assert.equal(reducePlacing(placing, { type: 'orthophoto', orthophoto: null }).film, film);
});

test('an orthophoto lies under a block by the images that are placed on it, by one system, or not at all', () => {
  const { laidUnder } = page.laid;
  const { mapped } = page.plane_map;
  const info = { width: 100, height: 100, gsd: 1, georeference: { origin: [1000, 2100], by_column: [1, 0], by_row: [0, -1] }, epsg: null, heights: [0, 0] };
  const orthophoto = { raster: {}, info, ofBlock: null };
  /** A square of the orthophoto's system, as the block has it: turned by a quarter, half as large, elsewhere. */
  const square = [
    [1010, 2090],
    [1050, 2090],
    [1050, 2060],
    [1010, 2060],
  ];
  const known = { a: 0, b: 0.5, c: -0.5, d: 0, e: 3, f: 4 };
  const own = Float64Array.from(square.flatMap(([x, y]) => mapped(known, x, y)));
  /** As the crate gives it: as many places along each side. */
  const footprint = square.flatMap(([x = 0, y = 0], i) => {
    const [u = 0, v = 0] = square[(i + 1) % 4] ?? [];
    return [0, 0.25, 0.5, 0.75].map((share) => [x + share * (u - x), y + share * (v - y)]);
  });
  const placed = (/** @type {string} */ kind) => new Map([[5, { key: '', problem: '', result: { verdict: { kind }, placement: { footprint } } }]]);
  const files = [{ id: 5, name: 'a.jpg', file: new Blob() }];
  const shown = {
    key: 'run 1',
    view: {
      images: [
        { name: 'b.jpg', position: null },
        { name: 'a.jpg', position: null },
      ],
      layout: { kind: 'oriented' },
      points: { taking: 0, positions: [] },
      origin: null,
      crs: null,
    },
  };
  const ground = { footprints: Float64Array.of(...new Array(8).fill(NaN), ...own) };
  const laid = laidUnder(orthophoto, placed('placed'), files, shown, ground, 'own');
  assert.equal(laid.images, 1);
  for (const [x, y] of square) {
    const [[u, v], [p, q]] = [mapped(laid.toBlock, x, y), mapped(known, x, y)];
    assert.ok(Math.hypot(u - p, v - q) < 1e-6);
  }
  assert.equal(laidUnder(orthophoto, placed('weak'), files, shown, ground, 'own'), null);
  assert.equal(laidUnder(orthophoto, new Map(), files, shown, ground, 'own'), null);
  // Control points of the same system: nothing has to be placed, where it is the same ground.
  const same = { footprints: Float64Array.from(square.flat()) };
  const surveyed = laidUnder(orthophoto, new Map(), files, shown, same, 'surveyed');
  assert.deepEqual([surveyed.toBlock, surveyed.images, surveyed.crs, surveyed.sheet.cells], [page.under.SAME, 0, null, null]);
  assert.deepEqual(surveyed.sheet.whole, page.under.affineOf(info.georeference));
  assert.equal(laidUnder(orthophoto, new Map(), files, shown, ground, 'surveyed'), null);
  // An orthomosaic is of one block alone.
  assert.equal(laidUnder({ ...orthophoto, ofBlock: 'run 1' }, new Map(), files, shown, ground, 'own').images, 0);
  assert.equal(laidUnder({ ...orthophoto, ofBlock: 'run 0' }, new Map(), files, shown, ground, 'own'), null);
});

/** A simulated block as the page has it, its orthophoto in another system, and the pixels of its own one. @param {string} crs */
function onEarth(crs) {
  const scene = new BlockScene({ strips: 2, exposures: 3, width_px: 240, height_px: 180, pixel_mm: 0.3 });
  const { images, origin } = scene.truth();
  const reference = OrthophotoReference.open(scene.orthophoto(2).picture);
  const info = reference.info();
  const positions = images.flatMap((_, index) => [...scene.surface_at(index, Float64Array.of(60, 60, 120, 90, 200, 150))]);
  reference.free();
  scene.free();
  const { affineOf, after } = page.under;
  const { inverse, mapped } = page.plane_map;
  const own = affineOf(info.georeference);
  const at = (/** @type {[number, number]} */ [x, y], height = 0) =>
    system_coordinates(
      crs,
      geographic_positions(Float64Array.of(origin?.longitude_deg ?? NaN, origin?.latitude_deg ?? NaN, origin?.height_m ?? NaN, x, y, height)),
    );
  /** Pixels of the same picture in the other system, by its corner and what the next column and row are. */
  const ground = positions.filter((_, i) => i % 3 === 2).sort((a, b) => a - b)[images.length] ?? NaN;
  const [corner, right, below] = [mapped(own, 0, 0), mapped(own, info.width, 0), mapped(own, 0, info.height)].map((place) => at(place, ground));
  const step = (/** @type {Float64Array} */ to, /** @type {number} */ count) => [0, 1].map((k) => ((to[k] ?? NaN) - (corner?.[k] ?? NaN)) / count);
  const georeference = {
    origin: [corner?.[0], corner?.[1]],
    by_column: step(right ?? new Float64Array(), info.width),
    by_row: step(below ?? new Float64Array(), info.height),
  };
  const view = {
    partial: false,
    images: images.map(({ name, pose }) => ({ name, position: pose?.position ?? null })),
    layout: { kind: 'oriented' },
    points: { count: positions.length / 3, taking: positions.length / 3, positions: Float64Array.from(positions) },
    surveyed: [],
    origin,
    crs: null,
  };
  const orthophoto = { raster: {}, info: { ...info, epsg: Number(/^EPSG:(\d+)$/.exec(crs)?.[1]), georeference }, ofBlock: null };
  return { view, orthophoto, own, toPixels: inverse(affineOf(georeference)), after, inverse, mapped };
}

const under = (/** @type {object} */ orthophoto, /** @type {object} */ view) =>
  page.laid.laidUnder(orthophoto, new Map(), [], { key: 'run', view }, { footprints: new Float64Array() }, 'geographic');

test('an orthophoto of a projected system lies under a block with GNSS positions: its centres are at their true pixels', () => {
  for (const crs of ['EPSG:32632', 'EPSG:25832', 'EPSG:31467']) {
    const { view, orthophoto, own, toPixels, inverse, mapped } = onEarth(crs);
    const laid = under(orthophoto, view);
    assert.equal(laid?.crs, crs, page.laid.whyNotLaid(orthophoto, view));
    for (const { name, position } of view.images) {
      const [x = NaN, y = NaN] = position ?? [];
      const [column, row] = mapped(toPixels, ...mapped(inverse(laid.toBlock), x, y));
      const [known, other] = mapped(inverse(own), x, y);
      assert.ok(Math.hypot(column - known, row - other) < 0.5, `${crs}, ${name}: ${column}, ${row} for ${known}, ${other}`);
    }
    assert.equal(page.laid.whyNotLaid(orthophoto, view), '');
  }
  // Grid north of the zone lies west of true north here, 1° west of the central meridian (Torge & Müller 2012, 6.2).
  const { view, orthophoto } = onEarth('EPSG:32632');
  const { a, b } = under(orthophoto, view).toBlock;
  const convergence = Math.atan(Math.tan(-Math.PI / 180) * Math.sin((50 * Math.PI) / 180));
  assert.ok(Math.abs(Math.atan2(b, a) + convergence) < 2e-4, `${Math.atan2(b, a)}`);
});

test('an affine map is found by its places, whatever it does to angles; by places on a line a similarity is', () => {
  const { affine, departure } = page.under;
  const { mapped } = page.plane_map;
  const known = { a: 0.8, b: 0.1, c: -0.3, d: -1.2, e: 500_000, f: 5_400_000 };
  const from = [0, 1, 2].flatMap((x) => [0, 1, 2].map((y) => [400 * x, 300 * y]));
  const to = from.map(([x = 0, y = 0]) => mapped(known, x, y));
  assert.ok(departure(affine(from, to), from, to) < 1e-6);
  assert.ok(Math.abs(departure({ ...known, e: known.e + 3, f: known.f + 4 }, from, to) - 5) < 1e-6);
  const line = from.map(([x = 0]) => [x, 2 * x]);
  const turned = { a: 0.6, b: 0.8, c: -0.8, d: 0.6, e: 7, f: 8 };
  const [u, v] = mapped(
    affine(
      line,
      line.map(([x = 0, y = 0]) => mapped(turned, x, y)),
    ),
    5,
    -9,
  );
  const [p, q] = mapped(turned, 5, -9);
  assert.ok(Math.hypot(u - p, v - q) < 1e-6);
  assert.equal(affine([[1, 2]], [[3, 4]]), null);
});

test('where an affine map of the whole departs by more than half a pixel, a picture lies in cells; of what is left it is said', () => {
  const { affineOfPart, NEAR_PX, placeIn, sheetOf } = page.cells;
  const size = { width: 4000, height: 3000 };
  /** Bent by so many px of the picture at its edges. @param {number} bend */
  const bent = (bend) => (/** @type {Float64Array} */ pixels) =>
    Array.from({ length: pixels.length / 2 }, (_, i) => {
      const [x, y] = [pixels[2 * i] ?? NaN, pixels[2 * i + 1] ?? NaN];
      return [2 * x + 2 * bend * (y / 1500 - 1) ** 2, -2 * y];
    });
  const flat = sheetOf(bent(0.5), size);
  assert.equal(flat.cells, null);
  assert.ok(flat.departs < NEAR_PX);
  const sheet = sheetOf(bent(40), size);
  assert.ok(sheet.cells.number > 5 && sheet.departs < NEAR_PX, `${sheet.cells.number} cells, ${sheet.departs} px`);
  for (const at of [
    [0, 0],
    [4000, 3000],
    [1234, 2345],
  ]) {
    const [[x, y] = []] = bent(40)(Float64Array.from(at));
    const [u, v] = placeIn(sheet.cells, size, at);
    const [p, q] = page.plane_map.mapped(affineOfPart(sheet, size, [at[0] - 128, at[1] - 128, at[0] + 128, at[1] + 128]), ...at);
    for (const off of [Math.hypot(u - x, v - y), Math.hypot(p - x, q - y)]) assert.ok(off < 2, `${at}: ${off}`);
  }
  const wild = sheetOf(bent(4000), size);
  assert.ok(wild.departs > NEAR_PX && wild.departs < 10, `${wild.departs}`);
  assert.equal(
    sheetOf((/** @type {Float64Array} */ pixels) => bent(1)(pixels).map(([x = NaN, y]) => [x < 4000 ? NaN : x, y]), size),
    null,
  );
});

test('an orthophoto in degrees lies under a block within a pixel, far beyond it too; it is looked at in UTM, and nothing is placed on it', async () => {
  const scene = new BlockScene({ strips: 2, exposures: 3, width_px: 240, height_px: 180, pixel_mm: 0.3 });
  const { picture } = scene.orthophoto(2);
  const { origin } = scene.truth();
  scene.free();
  assert.ok(origin);
  const { view, mapped } = onEarth('EPSG:32632');
  const ground = page.ground.median(view.points.positions.filter((/** @type {number} */ _, /** @type {number} */ i) => i % 3 === 2));
  const made = georeferenced(picture, 4326, origin, ground);
  const given = { id: 1, name: 'degrees.tif', file: new File([/** @type {BlobPart} */ (made.tif)], 'degrees.tif'), world: null, projection: null };
  const raster = await page.degrees.projectedOf(given);
  assert.deepEqual([raster.degrees.crs, raster.degrees.shownIn, raster.file.size], ['EPSG:4326', 'EPSG:32632', given.file.size]);
  assert.ok(raster.degrees.departs < 0.5, `${raster.degrees.departs}`);
  const bytes = new Uint8Array(await raster.file.arrayBuffer());
  const reference = OrthophotoReference.open(bytes, { world_file: raster.degrees.world, projection: raster.degrees.shownIn });
  const info = reference.info();
  reference.free();
  assert.equal(info.epsg, 32632);
  const orthophoto = { raster, info, ofBlock: null };
  const laid = under(orthophoto, view);
  assert.equal(laid?.crs, 'EPSG:4326', page.laid.whyNotLaid(orthophoto, view));
  const own = page.under.affineOf(made.georeference);
  const gsd = page.under.scaleOf(own);
  for (const at of [
    [0, 0],
    [info.width, 0],
    [info.width / 2, info.height / 2],
    [info.width, info.height],
  ]) {
    const [[u, v], [x, y]] = [mapped(laid.sheet.whole, ...at), mapped(own, ...at)];
    assert.ok(Math.hypot(u - x, v - y) < 0.5 * gsd, `${at}: ${u}, ${v} for ${x}, ${y}`);
    // The coordinates that are said are those of its file.
    const [a, b, e, d, f, n] = made.affine;
    const [longitude, latitude] = page.laid.placeUnder(laid, view, [x, y]);
    const off = [longitude - (a * (at[0] ?? 0) + b * (at[1] ?? 0) + e), latitude - (d * (at[0] ?? 0) + f * (at[1] ?? 0) + n)];
    assert.ok(Math.hypot(...off) < 1e-5, `${off}`);
  }
  assert.equal(page.purpose.purposeOf({ placing: { ...page.placing.NO_PLACING, orthophoto, purpose: 'block' } }), 'map');
  // Of 60 km one affine map is not enough.
  const wide = { origin: [origin.longitude_deg - 0.4, origin.latitude_deg + 0.3], by_column: [2e-4, 0], by_row: [0, -1.5e-4] };
  const size = { width: 4000, height: 4000 };
  const far = { ...orthophoto, raster: { ...raster, degrees: { ...raster.degrees, georeference: wide } } };
  far.info = { ...info, ...size, georeference: { origin: [410_000, 5_580_000], by_column: [15, 0], by_row: [0, -15] } };
  const { cells, departs } = under(far, view).sheet;
  assert.ok(cells !== null && departs < 0.5, `${cells?.number} cells, ${departs} px`);
  const [east, north] = page.cells.placeIn(cells, size, [3000, 1000]);
  const known = local_positions([
    origin.longitude_deg,
    origin.latitude_deg,
    origin.height_m,
    wide.origin[0] + 0.6,
    wide.origin[1] - 0.15,
    origin.height_m + ground,
  ]);
  assert.ok(Math.hypot(east - (known[3] ?? NaN), north - (known[4] ?? NaN)) < 8, `${east}, ${north} for ${known}`);

  // In a projected system, and in no place, nothing is done.
  const utm = georeferenced(picture, 32632, origin, ground);
  const refused = async (/** @type {object} */ more) => assert.equal(await page.degrees.projectedOf({ ...given, ...more }), null);
  await refused({ file: new File([/** @type {BlobPart} */ (utm.tif)], 'utm.tif') });
  await refused({ file: new File([/** @type {BlobPart} */ (utm.png)], 'none.png') });
});

test('an orthophoto without a code is taken in the system of the block alone; of elsewhere, of no system and of degrees it is said', () => {
  const { view, orthophoto } = onEarth('EPSG:32632');
  const uncoded = { ...orthophoto, info: { ...orthophoto.info, epsg: null, described: null } };
  assert.equal(under(uncoded, view), null);
  assert.equal(page.laid.whyNotLaid(uncoded, view), '');
  assert.equal(under(uncoded, { ...view, crs: 'EPSG:25832' }).crs, 'EPSG:25832');
  // One that names a system which has no code is not in that of the block, as far as is known.
  assert.equal(under({ ...uncoded, info: { ...uncoded.info, described: 'Town grid' } }, { ...view, crs: 'EPSG:25832' }), null);
  assert.equal(under(orthophoto, { ...view, origin: null }), null);
  const why = (/** @type {number} */ epsg, more = {}) => {
    const other = { ...orthophoto, info: { ...orthophoto.info, ...more, epsg } };
    assert.equal(under(other, view), null);
    return page.laid.whyNotLaid(other, view);
  };
  assert.match(why(32633), /lies elsewhere than the block \(EPSG:32633\)/);
  assert.match(why(9999), /not laid under the block: .*EPSG:9999/);
  // EPSG:3857 has no poles.
  const pole = { ...view, origin: { longitude_deg: 9, latitude_deg: 90, height_m: 0 } };
  assert.equal(under({ ...orthophoto, info: { ...orthophoto.info, epsg: 3857 } }, pole), null);
  assert.match(
    page.laid.whyNotLaid({ ...orthophoto, info: { ...orthophoto.info, epsg: 3857 } }, pole),
    /latitude 89\.99\d*°, which lie outside WGS 84 \/ Pseudo-Mercator/,
  );
  const [x, y] = orthophoto.info.georeference.origin;
  assert.match(why(32632, { georeference: { ...orthophoto.info.georeference, origin: [(x ?? NaN) + 50_000, y] } }), /lies elsewhere/);
});

test('a block in a coordinate reference system is drawn on its orthophoto where that has it', () => {
  const { view, orthophoto, own, toPixels, inverse, mapped } = onEarth('EPSG:32632');
  const positions = view.images.map(({ position }) => position ?? []);
  const surveyed = [
    {
      name: 'orthophoto_1',
      position: [...(positions[0] ?? [])],
      difference_m: [1, 0, 0.5],
      standard_errors_m: [1, 1, 1],
      point: 0,
      role: 'control',
      isUsed: true,
    },
  ];
  const linked = { ...view, surveyed, orthophoto: { kind: 'linked', inCrs: true, text: '' } };
  const to = page.showing.toSystemOf(orthophoto, linked);
  const footprints = Float64Array.from(positions.flatMap(([x = NaN, y = NaN]) => [x, y, x, y, x, y, x, y]));
  const drawn = page.block.inSystem(linked, { footprints, gsd: [], gnss: [], origin: null }, to);
  positions.forEach(([x = NaN, y = NaN, z], i) => {
    const known = mapped(inverse(own), x, y);
    const [u, v, height] = drawn.view.images[i].position;
    for (const [east, north] of [[u, v], drawn.ground.footprints.subarray(8 * i + 4, 8 * i + 6)]) {
      const at = mapped(toPixels, east, north);
      assert.ok(Math.hypot(at[0] - known[0], at[1] - known[1]) < 0.5, `${at} for ${known}`);
    }
    assert.equal(height, z);
  });
  // Differences turn with it: by 0.8° here.
  const [dx, dy, dz] = drawn.view.surveyed[0].difference_m;
  assert.ok(Math.abs(Math.hypot(dx, dy) - 1) < 1e-3 && Math.abs(Math.abs(dy) - 0.0134) < 1e-3 && dz === 0.5, `${dx} ${dy} ${dz}`);
  // In the orthophoto's own system nothing is converted.
  assert.equal(page.showing.toSystemOf(orthophoto, { ...linked, orthophoto: { kind: 'linked', inCrs: false, text: '' } }), page.under.SAME);
  const elsewhere = { ...orthophoto, info: { ...orthophoto.info, epsg: 32633 } };
  assert.equal(page.showing.toSystemOf(elsewhere, linked), null);
});
