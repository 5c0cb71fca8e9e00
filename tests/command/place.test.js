import assert from 'node:assert/strict';
import { readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { grey_png, OrthophotoReference, Photo, read_exif, system_coordinates } from '../../pkg/node.js';
import { georeferenced } from '../page/georeferenced.js';
import { file, folder, json, tiepoint } from './command.js';

const FLIGHT = ['--strips', '1', '--exposures', '2', '--width-px', '480', '--height-px', '360', '--pixel-mm', '0.075', '--relief-m', '40'];

/** @param {string} seed */
function flown(seed) {
  const at = folder();
  const { photos, orthophoto } = json('simulate', '--block', '--out', at, ...FLIGHT, '--seed', seed, '--orthophoto', '0.8');
  assert.deepEqual(orthophoto, [join(at, 'orthophoto.tif'), join(at, 'heights.tif')]);
  return { at, photos, truth: JSON.parse(readFileSync(join(at, 'truth.json'), 'utf8')).block };
}

const OWN = flown('3');
const GROUND = ['--orthophoto', join(OWN.at, 'orthophoto.tif'), '--heights', join(OWN.at, 'heights.tif'), '--points', '3000'];

test('photos are placed on the orthophoto of their scene, and their pictures lie on it', () => {
  const out = folder();
  // The folder of the photos, in place of each.
  const result = json('place', join(OWN.at, 'photos'), ...GROUND, '--out', out, '--rectified');
  assert.equal(result.images.length, 2);
  for (const [index, { name, verdict, placement }] of result.images.entries()) {
    assert.equal(verdict.kind, 'placed', JSON.stringify(verdict));
    const { position } = OWN.truth.images[index].pose;
    assert.equal(name, OWN.truth.images[index].name);
    for (const [axis, value] of position.entries()) {
      const off = placement.pose.position[axis] - value;
      // Cameras of EXIF: the height carries the error of the focal length.
      assert.ok(Math.abs(off) < 4 * placement.position_errors_m[axis] && Math.abs(off) < (axis === 2 ? 20 : 2), `${off} along axis ${axis}`);
    }
    // What was written is an orthophoto itself, on which the photo is placed again.
    const picture = join(out, name.replace('.png', '-rectified.tif'));
    assert.ok(Photo.decode(readFileSync(picture)).width > 300);
    const again = json('place', OWN.photos[index], '--orthophoto', picture, '--heights', join(OWN.at, 'heights.tif'), '--points', '3000');
    assert.equal(again.images[0].verdict.kind, 'placed', JSON.stringify(again.images[0].verdict));
  }
  const [head = '', ...rows] = readFileSync(join(out, 'placed.csv'), 'utf8').trim().split('\n');
  assert.ok(head.startsWith('name,verdict,x,y,z,omega_deg') && rows.length === 2, head);
  const links = readFileSync(join(out, 'links.csv'), 'utf8').trim().split('\n');
  assert.equal(
    links.length - 1,
    result.images.reduce((/** @type {number} */ sum, /** @type {any} */ image) => sum + image.placement.links.length, 0),
  );
  // What the tables say of links that check, and of each link, is that of the result.
  const { placement } = result.images[0];
  const [names, first] = [head, rows[0] ?? ''].map((line) => line.split(','));
  const cell = (/** @type {string} */ name) => Number(first?.[names?.indexOf(name) ?? NaN]);
  assert.deepEqual(['checks', 'checks_beyond', 'checks_rmse_px'].map(cell), [placement.checks.number, placement.checks.beyond, placement.checks.rmse_px]);
  assert.match(links[0] ?? '', /,residual_px,use,sigma_px,by_hand$/);
  assert.ok(links[1]?.endsWith(`,${placement.links[0].role},${placement.links[0].sigma_px},0`) && placement.links[0].sigma_px > 0, links[1]);
  assert.deepEqual(JSON.parse(readFileSync(join(out, 'result.json'), 'utf8')), result);
});

test('a focal length that is held and that the file of the image contradicts leaves its place in doubt, where the links say nothing', () => {
  const at = folder();
  const [photo = ''] = OWN.photos;
  const held = (/** @type {number} */ times) => {
    const focal_px = times * OWN.truth.cameras[0].focal_px;
    const cameras = file(at, 'held.json', JSON.stringify({ cameras: [{ images: '*', focal_px, fixed: true }] }));
    return JSON.parse(tiepoint('place', photo, ...GROUND, '--cameras', cameras, '--json').stdout).images[0];
  };
  assert.equal(held(1).verdict.kind, 'placed');
  const { verdict, placement } = held(1.3);
  assert.deepEqual([verdict.kind, verdict.placing_weakness.kind], ['weak', 'contradicted_focal'], JSON.stringify(verdict));
  // The height is wrong by as much as the focal length.
  assert.ok(placement.pose.position[2] > 1.2 * OWN.truth.images[0].pose.position[2], placement.pose.position.join());
});

test('what check links say of each image, and the standard errors of its angles, are printed', () => {
  const [photo = ''] = OWN.photos;
  const [{ placement }] = json('place', photo, ...GROUND).images;
  const { stdout } = tiepoint('place', photo, ...GROUND);
  const { number, beyond, rmse_px, rmse_m } = placement.checks;
  const [, links, px, m, without = '0'] =
    /^photo_00000\.png: checked by (\d+) links: RMSE ([\d.]+) px = ([\d.]+) m on the ground(?:, without (\d+) gross errors?)?$/mu.exec(stdout) ?? [];
  assert.deepEqual([links, px, m, without], [String(number), rmse_px.toFixed(2), rmse_m.toFixed(3), String(beyond)], stdout);
  const row = stdout.split('\n').at(-2) ?? '';
  const figures = [...row.matchAll(/(-?[\d.]+) ± ([\d.]+)/gu)].map(([, value, error]) => [Number(value), Number(error)]);
  const expected = placement.angles_deg.map((/** @type {number} */ value, /** @type {number} */ k) => [
    Number(value.toFixed(3)),
    Number(placement.angle_errors_deg[k].toFixed(4)),
  ]);
  assert.equal(figures.length, 6, row);
  assert.deepEqual(figures.slice(3), expected);
});

test('without check links images are placed, and the call says that nothing checks them', () => {
  const [photo = ''] = OWN.photos;
  const { code, stdout, stderr } = tiepoint('place', photo, ...GROUND, '--check-share', '0');
  assert.equal(code, 0, stderr);
  assert.match(stdout, /Placed by \d+ points/);
  assert.doesNotMatch(stdout, /checked by/);
  assert.match(stderr, /no link checks the result/);
});

test('a photo of elsewhere is not placed, and the exit code says so', () => {
  const other = flown('4');
  const stranger = file(folder(), 'stranger.png', readFileSync(other.photos[0]));
  const { code, stdout, stderr } = tiepoint('place', stranger, OWN.photos[0], ...GROUND);
  assert.equal(code, 4, stderr);
  assert.match(stdout, /stranger\.png: Not placed: .+/);
  assert.match(stdout, /photo_00000\.png: Placed by \d+ points, σ0 0\.\d+ px; projection centre ± /);
});

test('an image that cannot be read is told, and the others are placed', () => {
  const out = folder();
  const [photo = ''] = OWN.photos;
  const { code, stdout, stderr } = tiepoint('place', photo, file(out, 'broken.png', 'no picture'), ...GROUND, '--out', out);
  assert.equal(code, 1);
  assert.match(stderr, /broken\.png/);
  assert.match(stdout, /photo_00000\.png: Placed by/);
  assert.equal(readFileSync(join(out, 'placed.csv'), 'utf8').trim().split('\n').length, 2);
});

test('an orthophoto without a place, one in degrees and other bad input are refused with what to give', () => {
  const at = folder();
  const [photo = ''] = OWN.photos;
  const refused = (/** @type {string[]} */ ...args) => {
    const { code, stdout, stderr } = tiepoint('place', ...args);
    assert.equal(stdout, '');
    return `${code} ${stderr}`;
  };
  assert.match(refused(photo), /^2 .*--orthophoto is missing/);
  assert.match(refused('--orthophoto', join(OWN.at, 'orthophoto.tif')), /^2 .*name the images/);
  assert.match(refused(photo, '--orthophoto', photo), /^1 .*does not say where it lies.*world file/);
  assert.match(refused(photo, ...GROUND, '--level', '3'), /^2 .*--heights and --level/);
  assert.match(refused(photo, ...GROUND, '--rectified'), /^2 .*--rectified needs --out/);
  assert.match(refused(photo, ...GROUND, '--near-x', '3'), /^2 .*--near-x needs --near-y beside it/);
  assert.match(refused(photo, ...GROUND, '--near-y', '3'), /^2 .*--near-y needs --near-x beside it/);
  const positions = file(at, 'positions.csv', 'image,x,y\n');
  assert.match(refused(photo, ...GROUND, '--positions', positions, '--crs', 'EPSG:99999'), /^2 .*--crs: .*EPSG:99999, a code that is unknown/);
  const grid = file(at, 'heights.asc', 'ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\n1 2 3 4 5 6\n');
  assert.match(refused(photo, '--orthophoto', join(OWN.at, 'orthophoto.tif'), '--heights', grid), /^1 .*heights\.asc.*no cellsize/);
  const bytes = readFileSync(join(OWN.at, 'orthophoto.tif'));
  const cut = join(at, 'cut.tif');
  writeFileSync(cut, bytes.subarray(0, bytes.length / 2));
  assert.match(refused(photo, '--orthophoto', cut), /^1 .*cut\.tif/);
  const degrees = join(at, 'b.png');
  writeFileSync(degrees, readFileSync(photo));
  file(at, 'B.PGW', '0.000008\n0\n0\n-0.000008\n11.5\n51.2\n');
  assert.match(refused(photo, '--orthophoto', degrees), /^1 .*b\.png.*degrees/);
  const elsewhere = file(at, 'elsewhere.asc', 'ncols 2\nnrows 2\nxllcorner 50000\nyllcorner 0\ncellsize 5\n1 2 3 4\n');
  assert.match(refused(photo, ...GROUND.slice(0, 2), '--heights', elsewhere), /^1 .*none under the orthophoto/);
  const holes = file(at, 'holes.asc', 'ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 5\n-9999 -9999 -9999 -9999\n');
  assert.match(refused(photo, ...GROUND.slice(0, 2), '--heights', holes), /^1 .*holes\.asc.*at least one/);
  assert.match(refused(photo, photo, ...GROUND), /^2 .*two images are named/);
  const cameras = file(at, 'cameras.json', '{"cameras": [{"images": "other*", "focal_px": 900}]}');
  assert.match(refused(photo, ...GROUND, '--cameras', cameras), /^1 .*other\*, which fit no image/);
  const north = join(at, 'north.png');
  writeFileSync(north, readFileSync(photo));
  file(at, 'north.pgw', '0.5\n0\n0\n0.5\n430000\n5540000\n');
  assert.match(
    refused(photo, '--orthophoto', north),
    /^1 .*north\.png.*got A = 0\.5, D = 0, B = 0, E = 0\.5.*rows go north \(E above 0\); allowed: rows that go south/,
  );
  const world = file(at, 'a.pgw', '0.5\n0\n0\n');
  writeFileSync(join(at, 'a.png'), readFileSync(photo));
  assert.match(refused(photo, '--orthophoto', join(at, 'a.png')), /^1 .*world file/, world);
});

test('a picture with a world file is in the system of the .prj beside it, and heights of another are refused', () => {
  const at = folder();
  const reference = OrthophotoReference.open(readFileSync(join(OWN.at, 'orthophoto.tif')));
  const { width, height, gsd, georeference } = reference.info();
  writeFileSync(join(at, 'map.png'), grey_png(width, height, reference.picture(0, 0, width, height, 0)));
  reference.free();
  const [x = NaN, y = NaN] = georeference.origin;
  file(at, 'map.pgw', [gsd, 0, 0, -gsd, x + gsd / 2, y - gsd / 2].map((value) => `${value}\n`).join(''));
  file(at, 'map.prj', 'EPSG:25832');
  // It does not lie where the photos record their positions: one without them.
  const photo = Photo.decode(readFileSync(OWN.photos[0] ?? ''));
  writeFileSync(join(at, 'plain.png'), grey_png(photo.width, photo.height, photo.grey()));
  const cameras = file(at, 'cameras.json', JSON.stringify({ cameras: [{ images: '*', focal_px: OWN.truth.cameras[0].focal_px, fixed: true }] }));
  const place = (/** @type {string[]} */ ...args) => [
    ...['place', join(at, 'plain.png'), '--cameras', cameras, '--orthophoto', join(at, 'map.png'), '--points', '3000'],
    ...args,
  ];
  const { orthophoto, images } = json(...place('--heights', join(OWN.at, 'heights.tif')));
  assert.equal(orthophoto.epsg, 25832);
  assert.equal(images[0].verdict.kind, 'placed', JSON.stringify(images[0].verdict));
  const grid = file(at, 'other.asc', `ncols 2\nnrows 2\nxllcorner ${x}\nyllcorner ${y - 2000}\ncellsize 2000\n1 1 1 1\n`);
  file(at, 'OTHER.PRJ', 'EPSG:25833');
  const { code, stderr } = tiepoint(...place('--heights', grid));
  assert.ok(code === 1 && /other\.asc: .*EPSG:25833.*EPSG:25832/.test(stderr), stderr);
  // What is not understood names no system.
  file(at, 'map.prj', 'Projection    UTM\nZone 32\n');
  assert.equal(json(...place('--heights', join(OWN.at, 'heights.tif'))).orthophoto.epsg, null);
});

test('an orthophoto that lies elsewhere than its images is doubted before they are placed, with the zone that fits', () => {
  const at = folder();
  const { png, world, tif } = georeferenced(readFileSync(join(OWN.at, 'orthophoto.tif')), 25832, OWN.truth.origin, 0);
  const [map, right] = [join(at, 'map.png'), join(at, 'right.tif')];
  writeFileSync(map, png);
  file(at, 'map.pgw', world);
  writeFileSync(right, tif);
  file(at, 'map.prj', 'EPSG:25833');
  const place = (/** @type {string} */ orthophoto) => {
    const { stdout, stderr } = tiepoint('place', ...OWN.photos, '--orthophoto', orthophoto, '--level', '0', '--points', '3000', '--json');
    return { stderr, ...JSON.parse(stdout) };
  };
  const doubted = place(map);
  assert.match(doubted.stderr, /no GNSS position of the 2 images lies within 500 m of the orthophoto: as EPSG:25833 has it.* km from it\. In zone 32 of UTM/);
  assert.equal(doubted.remarks.length, 1);
  assert.deepEqual([doubted.remarks[0].kind, doubted.remarks[0].place_slip], ['orthophoto_elsewhere', { kind: 'zone', zone: 32 }]);
  // It is searched all the same.
  assert.ok(
    doubted.images.every((/** @type {any} */ { placement }) => placement !== null),
    JSON.stringify(doubted.images.map((/** @type {any} */ { verdict }) => verdict)),
  );
  const sure = place(right);
  assert.deepEqual([sure.remarks, /GNSS position of/.test(sure.stderr)], [[], false]);
});

test('a block becomes an orthomosaic, on which its photos are placed again', () => {
  const block = folder();
  json('simulate', '--block', '--out', block, '--strips', '1', '--exposures', '3', '--width-px', '480', '--height-px', '360', '--pixel-mm', '0.075');
  const run = json('block', join(block, 'photos'), '--out', join(block, 'out'), '--features', '3000');
  assert.ok(run.orientation.oriented >= 2, JSON.stringify(run.verdict));
  const picture = join(block, 'mosaic.tif');
  const { code, stdout, stderr } = tiepoint('mosaic', join(block, 'out', 'project.tiepoint'), join(block, 'photos'), '--out', picture);
  assert.match(`${code} ${stderr}`, /^0 .*the mosaic's coordinates are metres east and north of latitude 50\.0\d+, longitude 8\.0\d+, .* with --crs [^\n]*\n$/);
  assert.match(stdout, /written: .*mosaic\.tif/);
  // A block that nothing places has no metres.
  const bare = folder();
  json('block', join(block, 'photos'), '--out', bare, '--features', '3000', '--gps', 'ignore');
  const free = tiepoint('mosaic', join(bare, 'project.tiepoint'), join(block, 'photos'), '--out', join(bare, 'mosaic.tif'), '--json');
  const { remark } = JSON.parse(free.stdout);
  assert.deepEqual([remark.kind, /neither GNSS positions nor control points.* lengths are no metres/.test(remark.text)], ['mosaic_without_place', true]);
  assert.match(free.stderr, /lengths are no metres/);
  const placed = json('place', join(block, 'photos', 'photo_00001.png'), '--orthophoto', picture, '--level', '0', '--points', '3000');
  assert.notEqual(placed.images[0].verdict.kind, 'not_placed', JSON.stringify(placed.images[0].verdict));
  // On the heights of the block's own tie points, too.
  const project = join(block, 'out', 'project.tiepoint');
  const onPoints = json('place', join(block, 'photos', 'photo_00001.png'), '--orthophoto', picture, '--heights', project, '--points', '3000');
  assert.notEqual(onPoints.images[0].verdict.kind, 'not_placed', JSON.stringify(onPoints.images[0].verdict));
  assert.ok(onPoints.orthophoto.heights[1] > onPoints.orthophoto.heights[0], JSON.stringify(onPoints.orthophoto));
  assert.match(tiepoint('mosaic', project, folder(), '--out', picture).stderr, /none of the images/);
  // Photos in colours make a mosaic in colours; one that is missing is left out.
  const names = ['photo_00000.png', 'photo_00001.png'];
  const coloured = folder();
  for (const name of names) {
    const photo = Photo.decode(readFileSync(join(block, 'photos', name)));
    const colours = Buffer.from([...photo.grey()].flatMap((grey) => [grey, 255 - grey, 40]));
    writeFileSync(join(coloured, name), Buffer.concat([Buffer.from(`P6\n${photo.width} ${photo.height}\n255\n`), colours]));
  }
  const made = tiepoint('mosaic', project, coloured, '--out', picture, '--json');
  assert.equal(made.code, 0, made.stderr);
  const said = JSON.parse(made.stdout);
  assert.match(made.stderr, /has not photo_00002\.png/);
  const bytes = readFileSync(picture);
  const orthophoto = OrthophotoReference.open(bytes);
  const { width, height } = orthophoto.info();
  assert.deepEqual(
    { ...said, images: said.images.toSorted(), remark: said.remark.kind },
    { file: picture, width_px: width, height_px: height, images: names, missing: ['photo_00002.png'], remark: 'mosaic_without_system' },
  );
  const pixels = orthophoto.colours(0, 0, width, height, 0);
  orthophoto.free();
  const shown = Array.from({ length: width * height }, (_, k) => pixels.subarray(4 * k, 4 * k + 4)).filter(([, , , alpha]) => alpha === 255);
  const right = shown.filter(([red = 0, green = 0, blue = 0]) => Math.abs(red + green - 255) <= 2 && blue === 40);
  assert.ok(shown.length > 100_000 && right.length > 0.99 * shown.length, `${right.length} of ${shown.length}`);
  // Of one image it is that image on the ground, whatever else the folder has.
  const alone = join(block, 'alone.tif');
  const chosen = tiepoint('mosaic', project, coloured, '--out', alone, '--images', 'photo_00001.png');
  assert.match(`${chosen.code} ${chosen.stderr}`, /^0 [^\n]*which its file cannot say[^\n]*\n$/);
  const rectified = OrthophotoReference.open(readFileSync(alone));
  assert.ok(rectified.info().width < width || rectified.info().height < height, JSON.stringify(rectified.info()));
  rectified.free();
  rmSync(alone);
  assert.match(
    tiepoint('mosaic', project, coloured, '--out', alone, '--images', 'other.png').stderr,
    /got other\.png; allowed: .*photo_00000\.png, photo_00001\.png/,
  );
  assert.match(tiepoint('mosaic', project, coloured, '--out', alone, '--images', ',').stderr, /--images names no image/);
  // One that cannot be added ends it: what was there stays, and what a killed run left goes.
  writeFileSync(join(coloured, names[0] ?? ''), 'P6\n2 1\n255\nabcdef');
  writeFileSync(join(block, '1.tiepoint-999999999.part'), 'left');
  assert.match(tiepoint('mosaic', project, coloured, '--out', picture).stderr, /photo_00000\.png: image of a mosaic: got 2 x 1 px/);
  assert.ok(readFileSync(picture).equals(bytes));
  assert.deepEqual(readdirSync(block).sort(), ['mosaic.tif', 'out', 'photos', 'truth.json']);
  assert.match(tiepoint('mosaic', project, coloured, '--out', block).stderr, /it is a folder/);
  const named = tiepoint('mosaic', project, coloured, '--out', join(block, 'mosaic.jpg'));
  assert.match(`${named.code} ${named.stderr}`, /^2 .*mosaic\.jpg: it is no name of a GeoTIFF.* \.tif or \.tiff/);
  // Faults of the project are not those of the heights.
  const heights = join(OWN.at, 'heights.tif');
  assert.match(tiepoint('mosaic', join(OWN.at, 'truth.json'), OWN.at, '--out', picture, '--heights', heights).stderr, /: .*truth\.json: /);
  const broken = file(folder(), 'broken.asc', 'ncols 3');
  assert.match(tiepoint('mosaic', join(block, 'out', 'project.tiepoint'), OWN.at, '--out', picture, '--heights', broken).stderr, /broken\.asc: /);
});

test('a photo that records no position is sought where a table has it, in degrees or in the system of the orthophoto', () => {
  const at = folder();
  const tif = join(at, 'map.tif');
  writeFileSync(tif, georeferenced(readFileSync(join(OWN.at, 'orthophoto.tif')), 25832, OWN.truth.origin, 0).tif);
  const [photo = ''] = OWN.photos;
  const { width, height, grey } = bare(photo);
  writeFileSync(join(at, 'plain.png'), grey_png(width, height, grey));
  const recorded = read_exif(readFileSync(photo), width, height).position;
  assert.ok(recorded);
  const { longitude_deg: longitude, latitude_deg: latitude, height_m } = recorded;
  const [x, y] = system_coordinates('EPSG:25832', Float64Array.of(longitude, latitude, height_m ?? 0));
  const cameras = file(at, 'cameras.json', JSON.stringify({ cameras: [{ images: '*', focal_px: OWN.truth.cameras[0].focal_px, fixed: true }] }));
  const call = ['place', join(at, 'plain.png'), '--cameras', cameras, '--orthophoto', tif, '--level', '0', '--points', '3000', '--json'];
  const placed = (/** @type {string} */ table, /** @type {string[]} */ ...args) =>
    JSON.parse(tiepoint(...call, '--positions', file(at, 'table.csv', table), ...args).stdout);
  const alone = JSON.parse(tiepoint(...call).stdout);
  assert.deepEqual([alone.images[0].search, alone.remarks], [undefined, []]);
  for (const [table, ...args] of [
    [`image,lon,lat,acc\nplain.png,${longitude},${latitude},0.03\n`],
    [`image,easting,northing\nplain,${x},${y}\n`],
    [`image,easting,northing\nplain,${x},${y}\n`, '--crs', 'EPSG:25832'],
  ]) {
    const { images, remarks } = placed(table ?? '', ...args);
    // One level stands for hills, by which the place is uncertain.
    assert.deepEqual([images[0].verdict.placing_weakness?.kind, images[0].search.kind, remarks], ['plan', 'gnss', []], JSON.stringify(images[0].verdict));
    // The error of the receiver, and of ground that is taken as level.
    assert.ok(images[0].search.plan_m < 25, `${images[0].search.plan_m} m from its position`);
  }
  const { images, remarks } = placed(`image,lon,lat,roll\nplain.png,${longitude + 1},${latitude},1\nother.png,8,50,1\n`);
  assert.deepEqual(
    remarks.map((/** @type {{ kind: string }} */ { kind }) => kind),
    ['unknown_position_columns', 'positions_of_other_images', 'orthophoto_elsewhere'],
  );
  // Its place is doubted for that, too.
  assert.deepEqual([images[0].search.kind, images[0].search.place_slip.kind, images[0].verdict.kind], ['far_from_gnss', 'unknown', 'weak']);
  // Latitude and longitude stand in each other's place: no operation leads from there into the system of the orthophoto.
  const exchanged = placed(`image,lon,lat\nplain.png,${latitude},${longitude}\n`);
  assert.deepEqual([exchanged.remarks[0].kind, exchanged.remarks[0].place_slip.kind], ['orthophoto_elsewhere', 'exchanged_positions']);
  assert.deepEqual([exchanged.images[0].search.kind, exchanged.images[0].search.place_slip.kind], ['far_from_gnss', 'exchanged_positions']);
  assert.equal(exchanged.images[0].verdict.kind, 'weak');
  for (const [text, args, told] of /** @type {[string, string[], RegExp][]} */ ([
    ['plain.png,50.1,8.2\n', [], /^1 .*table\.csv: .*longitude and latitude/],
    [`image,easting,northing\nplain,${longitude},${latitude}\n`, ['--crs', 'EPSG:25832'], /^1 .*table\.csv: .*degrees/],
  ])) {
    const { code, stderr } = tiepoint('place', photo, '--orthophoto', tif, '--positions', file(at, 'table.csv', text), ...args);
    assert.match(`${code} ${stderr}`, told);
  }
  const { code, stderr } = tiepoint('place', photo, '--orthophoto', tif, '--crs', 'EPSG:25832');
  assert.match(`${code} ${stderr}`, /^2 .*--crs needs --positions beside it/);
});

/** Grey values of a photo, without what it records.  @param {string} path */
function bare(path) {
  const photo = Photo.decode(readFileSync(path));
  try {
    return { width: photo.width, height: photo.height, grey: photo.grey() };
  } finally {
    photo.free();
  }
}
