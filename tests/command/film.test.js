import assert from 'node:assert/strict';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { test } from 'node:test';
import { film_frame, film_pixel_mm, film_positions, grey_png, parse_fiducials, Photo } from '../../pkg/node.js';
import { file, folder, image, json, tiepoint } from './command.js';
import { ASKEW, inScanOfPhoto, MARKS_MM, PIXEL_MM, PRINCIPAL_POINT_MM, SIZE, scanOf } from './scans.js';

/** Of the photos that are scanned. */
const PHOTO = /** @type {const} */ ([480, 360]);
const FLIGHT = [
  '--strips',
  '2',
  '--exposures',
  '3',
  '--width-px',
  String(PHOTO[0]),
  '--height-px',
  String(PHOTO[1]),
  '--pixel-mm',
  String(PIXEL_MM),
  '--relief-m',
  '40',
];

/** No two lie alike: one upside down, one a little larger. */
const LYING = [
  ASKEW,
  { ...ASKEW, turn: -0.05 },
  { ...ASKEW, turn: Math.PI + 0.02 },
  { ...ASKEW, along: 0.996, across: 1.002, middle: /** @type {const} */ ([290, 230]) },
  { ...ASKEW, turn: 0.01, along: 1.02, across: 1.021 },
  { ...ASKEW, turn: 0.06, middle: /** @type {const} */ ([281.2, 240.4]) },
];

/**
 * A photo as the truth has it.
 * @typedef {{ rotation: [number, number, number][], position: [number, number, number] }} Pose
 */

/** The chunk of a PNG file that holds its EXIF.  @param {Buffer} png */
function exifOf(png) {
  const at = png.indexOf('eXIf') - 4;
  return png.subarray(at, at + 12 + png.readUInt32BE(at));
}

/** A flight on film: its scans with their marks, which record where they were taken, its camera, and its truth. */
function scanned() {
  const at = folder();
  const { photos, truth } = json('simulate', '--block', '--out', at, ...FLIGHT, '--seed', '4');
  const scans = photos.map((/** @type {string} */ photo, /** @type {number} */ k) => {
    const { scan } = scanOf(at, `film_${k}`, photo, LYING[k] ?? ASKEW);
    const [png, exif] = [readFileSync(scan), exifOf(readFileSync(photo))];
    // Behind the header.
    writeFileSync(scan, Buffer.concat([png.subarray(0, 33), exif, png.subarray(33)]));
    return scan;
  });
  const { block } = JSON.parse(readFileSync(truth, 'utf8'));
  /** @type {number} */
  const focal_px = block.cameras[0].focal_px;
  const camera = { focal_mm: focal_px * PIXEL_MM, principal_point_mm: PRINCIPAL_POINT_MM };
  /** @type {Pose[]} */
  const poses = block.images.map((/** @type {{ pose: Pose }} */ { pose }) => pose);
  return { at, photos, scans, focal_px, known: camera, camera: file(at, 'film.json', JSON.stringify(camera)), poses };
}

const FILM = scanned();

/** Where a photo shows a point of the ground, in px.  @param {Pose} pose @param {readonly number[]} point @returns {[number, number]} */
function seenAt({ rotation, position }, point) {
  const from = point.map((v, k) => v - (position[k] ?? 0));
  const [u = 0, v = 0, w = 1] = rotation.map((row) => row.reduce((sum, r, k) => sum + r * (from[k] ?? 0), 0));
  return [PHOTO[0] / 2 - (FILM.focal_px * u) / w, PHOTO[1] / 2 + (FILM.focal_px * v) / w];
}

/** Points in the system of the truth, which nothing shows: from below the ground to the tops of towers, so that they determine a camera well. */
const SURVEYED = /** @type {const} */ ([
  ['A', -60, 20, -80],
  ['B', 90, 0, 120],
  ['C', 90, 90, -150],
  ['D', -60, 110, 90],
  ['E', 230, 20, -60],
  ['F', 90, 130, 150],
  ['G', 230, 110, 60],
  ['H', 90, 50, 0],
  ['I', -20, 60, -120],
  ['J', 190, 60, 130],
]);

/** Tables of these points and of where images show them, called by `name`, each measured with an error of some hundredths of a px. */
function controlOf(
  /** @type {string} */ at,
  /** @type {(k: number) => string} */ name,
  /** @type {(px: [number, number], k: number) => readonly number[]} */ inImage,
) {
  const rows = FILM.poses.flatMap((pose, k) =>
    SURVEYED.flatMap(([point, ...ground], p) => {
      const seen = seenAt(pose, ground);
      if (seen.some((v, axis) => v < 20 || v > (PHOTO[axis] ?? 0) - 20)) return [];
      const [x = NaN, y = NaN] = inImage(seen, k);
      const off = (/** @type {number} */ seed) => (((seed * 7919) % 13) - 6) * 0.008;
      return [[name(k), point, x + off(k * 31 + p * 17 + 1), y + off(k * 13 + p * 29 + 5)].join(',')];
    }),
  );
  const marks = file(at, 'measured.csv', `image,point,x,y\n${rows.join('\n')}\n`);
  return { marks, rows: rows.length, points: file(at, 'points.csv', `name,x,y,z\n${SURVEYED.map((row) => row.join(',')).join('\n')}\n`) };
}

/** The rows of a table by the names of its columns.  @param {string} path @returns {Map<string, string>[]} */
function rowsOf(path) {
  const [head = '', ...rows] = readFileSync(path, 'utf8').trim().split('\n');
  const names = head.split(',');
  return rows.map((row) => new Map(row.split(',').map((cell, k) => [names[k] ?? '', cell])));
}

/** What control points of this precision make of a block. */
const BY_CONTROL = ['--gps', 'ignore', '--mark-sigma-px', '0.1'];

test('a block of scans has the geometry of the flight, as its photos have it', () => {
  const [out, digital] = [folder(), folder()];
  const measured = controlOf(
    folder(),
    (k) => `film_${k}.png`,
    (px, k) => inScanOfPhoto(px, PHOTO, LYING[k] ?? ASKEW),
  );
  const { scans, cameras, measurements } = json('film', ...FILM.scans, '--camera', FILM.camera, '--marks', measured.marks, '--out', out);
  assert.equal(scans.length, FILM.scans.length);
  for (const { marks, rmse_mm } of scans) {
    assert.ok(marks.residuals_mm.length === MARKS_MM.length && marks.sigma0_mm < 0.005, JSON.stringify(marks.sigma0_mm));
    assert.ok(rmse_mm > 0 && rmse_mm < marks.sigma0_mm * Math.SQRT2, `${rmse_mm}`);
  }
  assert.deepEqual(measurements, { moved: measured.rows, beside: [] });
  assert.equal(cameras.length, 1, JSON.stringify(cameras));
  const [{ images, fixed, pixel_mm, focal_px, uncertainty }] = cameras;
  assert.deepEqual([images, fixed], ['*-film.png', false]);
  // Marks are measured to 0.1 px: ± 0.03 px of 1133.
  assert.ok(Math.abs(pixel_mm / PIXEL_MM - 1) < 0.025 && Math.abs(focal_px * pixel_mm - FILM.known.focal_mm) < 1e-9, `${pixel_mm}`);
  assert.ok(uncertainty.k1 === 0 && uncertainty.principal_point > 3e-6 && uncertainty.principal_point < 3e-5, JSON.stringify(uncertainty));
  assert.ok(uncertainty.focal > 1e-5 && uncertainty.focal < 2e-4, JSON.stringify(uncertainty));
  const sizes = scans.map((/** @type {{ image: string }} */ { image: name }) => {
    const photo = Photo.decode(readFileSync(join(out, 'images', name)));
    const size = [photo.width, photo.height];
    photo.free();
    return size.join(' x ');
  });
  assert.equal(new Set(sizes).size, 1, sizes.join(', '));
  assert.match(readFileSync(join(out, 'film.csv'), 'utf8'), /^scan,image,marks,sigma0_mm,rmse_mm\nfilm_0\.png,film_0-film\.png,6,0\.00\d+,0\.00\d+\n/);
  const again = tiepoint('film', ...FILM.scans, '--camera', FILM.camera, '--out', out);
  assert.ok(again.code === 1 && /images[\\/]film_0-film\.png is there already; name another folder/.test(again.stderr), again.stderr);

  const block = join(out, 'block');
  const given = ['--cameras', join(out, 'cameras.json'), '--masks', join(out, 'masks'), '--control', measured.points, '--marks', join(out, 'marks.csv')];
  const summary = json('block', join(out, 'images'), ...given, ...BY_CONTROL, '--out', block);
  assert.equal(summary.verdict.oriented, FILM.scans.length, JSON.stringify(summary.verdict));
  const ofPhotos = controlOf(
    digital,
    (k) => basename(FILM.photos[k] ?? ''),
    (px) => px,
  );
  const known = file(digital, 'cameras.json', JSON.stringify({ cameras: [{ focal_px: FILM.focal_px, fixed: true }] }));
  const control = ['--control', ofPhotos.points, '--marks', ofPhotos.marks];
  const plain = json('block', ...FILM.photos, '--cameras', known, ...control, ...BY_CONTROL, '--out', join(digital, 'block'));
  const [own, other] = [summary, plain].map(({ verdict }) => verdict.sigma0_px * 1);
  assert.ok((own ?? NaN) < 1.15 * (other ?? NaN), `${own} px of scans, ${other} px of photos`);

  rowsOf(join(block, 'images.csv')).forEach((row, k) => {
    const truth = FILM.poses[k]?.position ?? [];
    ['x', 'y', 'z'].forEach((axis, a) => {
      const [off, sigma] = [Number(row.get(axis)) - (truth[a] ?? NaN), Number(row.get(`sigma_${axis}`))];
      assert.ok(sigma > 0 && sigma < 0.6 && Math.abs(off) < 2.5 * sigma, `${row.get('name')}: ${axis} is off by ${off} ± ${sigma} m`);
    });
    // What its scan recorded.
    assert.ok(
      Math.abs(Number(row.get('recorded_longitude_deg')) - 8) < 0.01 && Math.abs(Number(row.get('recorded_height_m')) - 900) < 20,
      JSON.stringify([...row]),
    );
  });
  rmSync(out, { recursive: true });
});

test('a principal distance that is stated wrong is calibrated within what is not known of it', () => {
  const [out, share] = [folder(), 1.002];
  const stated = { ...FILM.known, focal_mm: FILM.known.focal_mm * share, uncertainty: { focal: 0.003, principal_point: 0, k1: 0 } };
  const measured = controlOf(
    folder(),
    (k) => `film_${k}.png`,
    (px, k) => inScanOfPhoto(px, PHOTO, LYING[k] ?? ASKEW),
  );
  const { cameras } = json('film', ...FILM.scans, '--camera', file(folder(), 'film.json', JSON.stringify(stated)), '--marks', measured.marks, '--out', out);
  const { pixel_mm, focal_px, uncertainty } = cameras[0];
  assert.ok(Math.abs(uncertainty.focal - 0.003) < 1e-5, JSON.stringify(uncertainty));
  const given = ['--cameras', join(out, 'cameras.json'), '--masks', join(out, 'masks'), '--control', measured.points, '--marks', join(out, 'marks.csv')];
  json('block', join(out, 'images'), ...given, ...BY_CONTROL, '--out', join(out, 'block'));
  const { models } = JSON.parse(readFileSync(join(out, 'block', 'orientation.json'), 'utf8'));
  const adjusted = models[0].adjusted;
  const [found, sigma] = [adjusted.block.cameras[0].focal_px, adjusted.cameras[0].standard_errors[0]];
  const truth = FILM.known.focal_mm / pixel_mm;
  // Half of what was not known is found.
  assert.ok(sigma < 0.6 * 0.003 * truth && Math.abs(found - truth) < 0.5 * sigma, `${found} ± ${sigma} px of ${truth} px, stated as ${focal_px} px`);
  rmSync(out, { recursive: true });
});

test('a position of a scan lies in its frame where the truth has it, and the frame shows the same there', () => {
  const films = FILM.scans.map((/** @type {string} */ scan) => ({
    camera: FILM.known,
    scan: { fiducials: parse_fiducials(readFileSync(scan.replace(/png$/, 'csv'), 'utf8')) },
    marks_mm: MARKS_MM.map(([x, y]) => /** @type {[number, number]} */ ([x, y])),
  }));
  const pixel = Math.max(...films.map((/** @type {any} */ film) => film_pixel_mm(film)));
  FILM.scans.forEach((/** @type {string} */ scan, /** @type {number} */ k) => {
    const { image: png, camera, scan: own } = film_frame(readFileSync(scan), films[k], { image: 'frame.png', pixel_mm: pixel });
    const [x0, y0] = camera.principal_point_px ?? [NaN, NaN];
    const inFrame = (/** @type {readonly number[]} */ [x = NaN, y = NaN]) => [
      x0 + ((x - PHOTO[0] / 2) * PIXEL_MM) / pixel,
      y0 + ((y - PHOTO[1] / 2) * PIXEL_MM) / pixel,
    ];
    const photo = Array.from({ length: 63 }, (_, n) => /** @type {[number, number]} */ ([40 + 50 * (n % 9), 30 + 50 * Math.floor(n / 9)]));
    const positions = Float64Array.from(photo.flatMap((px) => inScanOfPhoto(px, PHOTO, LYING[k] ?? ASKEW)));
    const led = film_positions(own, positions, 'frame');
    const wanted = photo.flatMap(inFrame);
    for (const [n, v] of wanted.entries()) assert.ok(Math.abs((led[n] ?? NaN) - v) < 0.05, `${scan}: ${led[n]} px, wanted ${v} px`);
    for (const [n, v] of film_positions(own, led, 'scan').entries()) assert.ok(Math.abs(v - (positions[n] ?? NaN)) < 1e-6, `${v} ${positions[n]}`);
    // Beside the frame there is nothing.
    assert.deepEqual([...film_positions(own, Float64Array.of(1, 1), 'frame')], [NaN, NaN]);
    const [dx, dy] = shiftOf(png, FILM.photos[k] ?? '', pixel, [x0, y0]);
    assert.ok(Math.hypot(dx, dy) < 0.05, `${scan}: its frame is off by ${dx}, ${dy} px`);
  });
  assert.throws(() => film_positions(/** @type {any} */ ({}), new Float64Array(2), 'frame'), /scan/);
});

/**
 * By how much a frame is moved against the photo, in px of the photo, in the mean over all of it: by least squares of its grey values.
 * @param {Uint8Array} png @param {string} file @param {number} pixelMm @param {readonly [number, number]} at the principal point of the frame @returns {[number, number]}
 */
function shiftOf(png, file, pixelMm, [x0, y0]) {
  const [frame, photo] = [Photo.decode(png), Photo.decode(readFileSync(file))];
  const [greys, wide, grey, width] = [frame.grey(), frame.width, photo.grey(), photo.width];
  frame.free();
  photo.free();
  const of = (/** @type {Uint8Array} */ values, /** @type {number} */ stride, /** @type {number} */ x, /** @type {number} */ y) => {
    const [c, r] = [Math.floor(x - 0.5), Math.floor(y - 0.5)];
    const [s, t] = [x - 0.5 - c, y - 0.5 - r];
    const value = (/** @type {number} */ col, /** @type {number} */ row) => values[row * stride + col] ?? 0;
    return (1 - t) * ((1 - s) * value(c, r) + s * value(c + 1, r)) + t * ((1 - s) * value(c, r + 1) + s * value(c + 1, r + 1));
  };
  let [a, b, c, p, q] = [0, 0, 0, 0, 0];
  for (let y = 20.5; y < PHOTO[1] - 20; y += 1)
    for (let x = 20.5; x < PHOTO[0] - 20; x += 1) {
      const own = of(greys, wide, x0 + ((x - PHOTO[0] / 2) * PIXEL_MM) / pixelMm, y0 + ((y - PHOTO[1] / 2) * PIXEL_MM) / pixelMm);
      const gx = (of(grey, width, x + 1, y) - of(grey, width, x - 1, y)) / 2;
      const gy = (of(grey, width, x, y + 1) - of(grey, width, x, y - 1)) / 2;
      const off = of(grey, width, x, y) - own;
      [a, b, c] = [a + gx * gx, b + gx * gy, c + gy * gy];
      [p, q] = [p + gx * off, q + gy * off];
    }
  return [(c * p - b * q) / (a * c - b * b), (a * q - b * p) / (a * c - b * b)];
}

test('scans as they are have another geometry each', () => {
  const out = folder();
  json('film', ...FILM.scans, '--camera', FILM.camera, '--out', out);
  const block = json(
    'block',
    join(out, 'images'),
    '--cameras',
    join(out, 'cameras.json'),
    '--masks',
    join(out, 'masks'),
    '--gps',
    'ignore',
    '--out',
    join(out, 'block'),
  );
  // Scans as they are have other scales along columns and rows, each its own.
  const all = file(out, 'all.json', readFileSync(join(out, 'cameras.json'), 'utf8').replace('*-film.png', '*'));
  const raw = json('block', ...FILM.scans, '--cameras', all, '--gps', 'ignore', '--out', join(out, 'raw'));
  assert.ok(raw.verdict.sigma0_px > 1.3 * block.verdict.sigma0_px, `${raw.verdict.sigma0_px} ${block.verdict.sigma0_px} px`);
  rmSync(out, { recursive: true });
});

test('masks of scans and measurements beside a frame', () => {
  const [at, out] = [folder(), folder()];
  const scans = FILM.scans.slice(0, 2);
  image(at, 'film_0_mask.png', ...SIZE, (col, row) => (col >= 200 && col < 300 && row >= 150 && row < 250 ? 0 : 255));
  image(at, 'other.png', 4, 4, () => 0);
  const marks = file(at, 'measured.csv', 'image,point,x,y\nFilm_0,P1,284.5,236.5\nscans/film_1.PNG,P2,3,4\nIMG_7.jpg,P1,10.25,20.5\n');
  const { code, stdout, stderr } = tiepoint('film', ...scans, '--camera', FILM.camera, '--masks', at, '--marks', marks, '--out', out, '--json');
  assert.equal(code, 0, stderr);
  assert.match(stderr, /masks of no scan: other\.png/);
  assert.match(stderr, /beside the image of their scan, .* skipped: P2 in film_1\.png/);
  const { measurements } = JSON.parse(stdout);
  assert.deepEqual(measurements, { moved: 1, beside: [{ image: 'film_1.png', point: 'P2', x_px: 3, y_px: 4 }] });
  assert.match(readFileSync(join(out, 'marks.csv'), 'utf8'), /^image,point,x_px,y_px\nfilm_0-film\.png,P1,[\d.]+,[\d.]+\nIMG_7\.jpg,P1,10\.25,20\.5\n$/);
  const hidden = scans.map((/** @type {string} */ scan) => {
    const mask = Photo.decode(readFileSync(join(out, 'masks', basename(scan).replace('.png', '-film.png'))));
    const count = mask.grey().filter((value) => value === 0).length;
    mask.free();
    return count;
  });
  // 100 x 100 px of the scan.
  const [first = 0, second = 0] = hidden;
  assert.ok(Math.abs(first - second - 10_000) < 400, hidden.join(' '));
  const wrong = (/** @type {string[]} */ ...args) => tiepoint('film', ...scans, '--camera', FILM.camera, ...args, '--out', join(at, 'out')).stderr;
  assert.match(wrong('--marks', file(at, 'none.csv', 'a.jpg,P1,1,2\n')), /none\.csv: no measurement is of a scan; .*film_0\.png/);
  assert.match(wrong('--masks', marks), /--masks is .*measured\.csv, which is no folder/);
  const small = folder();
  file(small, 'film_0.png', grey_png(4, 4, new Uint8Array(16)));
  assert.match(wrong('--masks', small), /film_0\.png: .*film_0\.png with 4 x 4 px; allowed: the image's 570 x 470 px/);
});

/** A folder of marks in which all scans have those of the first one, and so its pixel.  @param {string} first @param {string[]} others */
function alike(first, ...others) {
  const [at, marks] = [folder(), readFileSync(first.replace(/png$/, 'csv'))];
  for (const scan of [first, ...others]) file(at, basename(scan).replace(/png$/, 'csv'), marks);
  return at;
}

test('a pixel size of the camera that the marks contradict is named with theirs', () => {
  const [scan = ''] = FILM.scans;
  const call = (/** @type {number} */ pixel_mm) => {
    const camera = file(folder(), 'film.json', JSON.stringify({ ...FILM.known, pixel_mm }));
    return tiepoint('film', scan, '--camera', camera, '--out', join(folder(), 'out')).stderr;
  };
  assert.match(
    call(0.014),
    /film\.json: The pixel size of the camera, 0\.0140 mm, is not used: by the fiducial marks a pixel of the scan is 0\.075\d mm large\./,
  );
  assert.equal(call(0.075), '');
});

test('two films in one folder keep their cameras, with what is not known of each', () => {
  const out = folder();
  const [a, b, c, d] = FILM.scans;
  const camera = (/** @type {number} */ share) =>
    file(
      folder(),
      'film.json',
      JSON.stringify({ ...FILM.known, focal_mm: FILM.known.focal_mm * share, uncertainty: { focal: 0.001 * share, principal_point: 0, k1: 0 } }),
    );
  const [first, second] = [camera(1), camera(2)];
  const marks = (/** @type {string[]} */ ...rows) => file(folder(), 'measured.csv', ['image,point,x,y', ...rows, ''].join('\n'));
  json('film', a, b, '--camera', first, '--marks', marks('film_0.png,P1,284.5,236.5', 'IMG_7.jpg,P1,10.25,20.5'), '--out', out);
  const { cameras } = json('film', c, '--camera', second, '--marks', marks('film_2.png,P1,284.5,236.5'), '--out', out);
  const read = () => JSON.parse(readFileSync(join(out, 'cameras.json'), 'utf8')).cameras;
  assert.deepEqual(read(), cameras);
  const of = (/** @type {string} */ images) => cameras.find((/** @type {any} */ rule) => rule.images === images);
  const [own, other] = [of('*-film.png'), of('*-film2.png')];
  assert.equal(cameras.length, 2, JSON.stringify(cameras));
  assert.ok(Math.abs((other.focal_px * other.pixel_mm) / (own.focal_px * own.pixel_mm) - 2) < 1e-9, JSON.stringify(cameras));
  assert.ok(Math.abs(own.uncertainty.focal - 0.001) < 1e-5 && Math.abs(other.uncertainty.focal - 0.002) < 1e-5, JSON.stringify(cameras));
  const images = ['film_0-film.png', 'film_1-film.png', 'film_2-film2.png'];
  assert.deepEqual([readdirSync(join(out, 'images')), readdirSync(join(out, 'masks'))], [images, images]);
  assert.deepEqual(
    rowsOf(join(out, 'film.csv')).map((row) => row.get('image')),
    images,
  );
  assert.match(
    readFileSync(join(out, 'marks.csv'), 'utf8'),
    /^image,point,x_px,y_px\nfilm_0-film\.png,P1,.*\nIMG_7\.jpg,P1,10\.25,20\.5\nfilm_2-film2\.png,P1,.*\n$/,
  );
  // The block has both.
  const block = join(out, 'block');
  json('block', join(out, 'images'), '--cameras', join(out, 'cameras.json'), '--gps', 'ignore', '--out', block);
  assert.equal(JSON.parse(readFileSync(join(block, 'summary.json'), 'utf8')).cameras.length, 2);
  // A scan whose image is there is refused, with what comes with it.
  const taken = tiepoint('film', c, d, '--camera', camera(2), '--fiducials', alike(c, d), '--out', out);
  assert.ok(taken.code === 1 && /film_2-film2\.png is there already/.test(taken.stderr), taken.stderr);
  assert.deepEqual([read(), readdirSync(join(out, 'images'))], [cameras, images]);
  rmSync(out, { recursive: true });
});

test('scans that are added to their film have its camera, and one table of measurements in all scans serves each call', () => {
  const out = folder();
  const [a, b, , d] = FILM.scans;
  const all = file(folder(), 'all.csv', 'image,point,x,y\nfilm_0.png,P1,284.5,236.5\nfilm_3.png,P1,284.5,236.5\nIMG_7.jpg,P1,10.25,20.5\n');
  const first = json('film', a, b, '--camera', FILM.camera, '--marks', all, '--out', out);
  // Its own pixel is another one, by a tenth of a per cent.
  const own = film_pixel_mm({ camera: /** @type {any} */ (FILM.known), scan: { fiducials: parse_fiducials(readFileSync(d.replace(/png$/, 'csv'), 'utf8')) } });
  const off = Math.abs(own / first.cameras[0].pixel_mm - 1);
  assert.ok(off > 2e-4 && off < 0.01, `${off}`);
  const added = json('film', d, '--camera', FILM.camera, '--marks', all, '--out', out);
  assert.deepEqual([first.camera, added.camera, added.cameras.length], ['*-film.png', '*-film.png', 1]);
  assert.equal(added.cameras[0].pixel_mm, first.cameras[0].pixel_mm);
  assert.deepEqual(
    readFileSync(join(out, 'marks.csv'), 'utf8')
      .trim()
      .split('\n')
      .map((row) => row.split(',').slice(0, 2).join()),
    ['image,point', 'film_0-film.png,P1', 'film_3-film.png,P1', 'IMG_7.jpg,P1'],
  );
  const { stdout } = tiepoint('film', FILM.scans[2], '--camera', FILM.camera, '--out', out);
  assert.match(stdout, /camera: \*-film\.png in .*cameras\.json, that of images that were there/);
  // What was measured in a scan of a call that had no table is said to be missing.
  const late = file(folder(), 'late.csv', 'image,point,x,y\nfilm_2.png,P1,284.5,236.5\nfilm_4.png,P1,284.5,236.5\n');
  const { code, stderr } = tiepoint('film', FILM.scans[4], '--camera', FILM.camera, '--marks', late, '--out', out);
  assert.ok(code === 0 && /scans of calls before, whose images have none in marks\.csv, are skipped: film_2\.png/.test(stderr), stderr);
  assert.ok(!/,film_2|^film_2/m.test(readFileSync(join(out, 'marks.csv'), 'utf8')));
});

test('a call that broke off is repeated, and a table that a spreadsheet saved is read', () => {
  const out = folder();
  const [a, b, c] = FILM.scans;
  const [table, cameras] = ['film.csv', 'cameras.json'].map((name) => join(out, name));
  // It breaks off at the second image, for which a folder stands in the way.
  mkdirSync(join(out, 'images', 'film_1-film.png'), { recursive: true });
  writeFileSync(table ?? '', 'scan,image,marks,sigma0_mm,rmse_mm\n');
  assert.equal(tiepoint('film', a, b, '--camera', FILM.camera, '--out', out).code, 1);
  assert.ok(existsSync(join(out, 'images', 'film_0-film.png')));
  assert.equal(JSON.parse(readFileSync(cameras ?? '', 'utf8')).cameras[0].images, '*-film.png');
  assert.equal(rowsOf(table ?? '').length, 0);
  rmSync(join(out, 'images', 'film_1-film.png'), { recursive: true });
  json('film', a, b, '--camera', FILM.camera, '--out', out);
  const images = () => rowsOf(table ?? '').map((row) => row.get('image'));
  assert.deepEqual(images(), ['film_0-film.png', 'film_1-film.png']);
  writeFileSync(
    table ?? '',
    readFileSync(table ?? '', 'utf8')
      .trim()
      .replaceAll('\n', '\r\n'),
  );
  json('film', c, '--camera', FILM.camera, '--out', out);
  assert.deepEqual(images(), ['film_0-film.png', 'film_1-film.png', 'film_2-film.png']);
  writeFileSync(table ?? '', readFileSync(table ?? '', 'utf8').replaceAll(',', ';'));
  const { code, stderr } = tiepoint('film', FILM.scans[3], '--camera', FILM.camera, '--out', out);
  assert.ok(code === 1 && /film\.csv: its first line is "scan;image;/.test(stderr), stderr);
});

test('a mark that one scan lacks, and a scan that cannot be read, cost the others nothing', () => {
  const [at, out] = [folder(), join(folder(), 'out')];
  const scans = FILM.scans.slice(0, 3).map((/** @type {string} */ scan, /** @type {number} */ k) => {
    const rows = readFileSync(scan.replace(/png$/, 'csv'), 'utf8').trim().split('\n');
    file(at, `s${k}.csv`, (k === 1 ? rows.filter((row) => !row.endsWith(',17.5,0.1')) : rows).join('\n'));
    return file(at, `s${k}.png`, k === 2 ? 'no picture' : readFileSync(scan));
  });
  const { code, stderr } = tiepoint('film', ...scans, '--camera', FILM.camera, '--out', out);
  assert.ok(code === 1 && /s2\.png/.test(stderr) && !/s[01]\.png/.test(stderr), stderr);
  const { cameras } = JSON.parse(readFileSync(join(out, 'cameras.json'), 'utf8'));
  assert.equal(cameras.length, 1, JSON.stringify(cameras));
  assert.deepEqual(readdirSync(join(out, 'images')), ['s0-film.png', 's1-film.png']);
});

test('scans without marks, and without a camera, are refused', () => {
  const at = folder();
  const refused = (/** @type {string[]} */ ...args) => {
    const { code, stdout, stderr } = tiepoint('film', ...args, '--out', join(at, 'out'));
    assert.equal(stdout, '');
    return `${code} ${stderr}`;
  };
  const [scan = ''] = FILM.scans;
  assert.match(refused(scan), /^2 .*--camera is missing/);
  assert.match(refused('--camera', FILM.camera), /^2 .*name the scans/);
  assert.match(refused(scan, scan, '--camera', FILM.camera), /^2 .*images of the same name/);
  assert.match(refused(scan, '--camera', FILM.camera, '--fiducials', at), /^1 .*film_0\.png: its fiducial marks are missing: there is no .*film_0\.csv/);
  assert.match(refused(join(at, 'none.png'), '--camera', FILM.camera), /^1 .*there is no such file/);
  file(at, 'film_0.csv', 'col,row,x_mm,y_mm\n1,2,3,4\n');
  assert.match(refused(scan, '--camera', FILM.camera, '--fiducials', at), /^1 .*film_0\.csv: fiducial marks: 1 given/);
});
