import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { test } from 'node:test';
import { Photo } from '../../pkg/node.js';
import { file, folder, json, tiepoint } from './command.js';
import { ASKEW, MARKS_MM, onFilm, PIXEL_MM, PRINCIPAL_POINT_MM, scanOf, SIZE } from './scans.js';

const FLIGHT = ['--strips', '1', '--exposures', '1', '--width-px', '480', '--height-px', '360', '--pixel-mm', String(PIXEL_MM), '--relief-m', '40'];

/** A photo of a scene on film: its scan, its marks and its camera as files. */
function scanned() {
  const at = folder();
  const { photos } = json('simulate', '--block', '--out', at, ...FLIGHT, '--seed', '3', '--orthophoto', '0.8');
  const { block } = JSON.parse(readFileSync(join(at, 'truth.json'), 'utf8'));
  const camera = { focal_mm: block.cameras[0].focal_px * PIXEL_MM, principal_point_mm: PRINCIPAL_POINT_MM };
  return {
    ...scanOf(at, 'scan', photos[0], ASKEW),
    camera: file(at, 'film.json', JSON.stringify(camera)),
    photos,
    position: block.images[0].pose.position,
    ground: ['--orthophoto', join(at, 'orthophoto.tif'), '--heights', join(at, 'heights.tif'), '--points', '3000'],
  };
}

const FILM = scanned();
const MARKED = ['--fiducials', FILM.fiducials, '--camera', FILM.camera];

test('a scanned photo on film is placed by its fiducial marks, and what they say stands beside its place', () => {
  const out = folder();
  const result = json('place', FILM.scan, ...FILM.ground, ...MARKED, '--out', out, '--rectified');
  const [{ name, verdict, placement }] = result.images;
  assert.equal(verdict.kind, 'placed', JSON.stringify(verdict));
  for (const [axis, value] of FILM.position.entries()) {
    const off = placement.pose.position[axis] - value;
    assert.ok(Math.abs(off) < 4 * placement.position_errors_m[axis] && Math.abs(off) < 1.5, `${off} along axis ${axis}`);
  }
  const { marks, width_px, height_px } = placement.film;
  assert.deepEqual([name, width_px, height_px, marks.residuals_mm.length], [basename(FILM.scan), ...SIZE, MARKS_MM.length]);
  assert.ok(marks.sigma0_mm > 0 && marks.sigma0_mm < 0.01, `${marks.sigma0_mm} mm`);
  // Links are measured in the scan, within its marks.
  for (const { at } of placement.links) {
    const [x, y] = onFilm(at[0], at[1], ASKEW);
    assert.ok(Math.abs(x) < 17.2 && Math.abs(y) < 12.7, `${x} ${y}`);
  }
  const [head = '', row = ''] = readFileSync(join(out, 'placed.csv'), 'utf8').trim().split('\n');
  const column = head.split(',').indexOf('marks_sigma0_mm');
  assert.equal(head.split(',')[column + 1], 'marks_rmse_mm');
  assert.equal(Number(row.split(',')[column]), marks.sigma0_mm);
  assert.ok(Photo.decode(readFileSync(join(out, 'scan-rectified.tif'))).width > 300);
  const { stdout } = tiepoint('place', FILM.scan, ...FILM.ground, ...MARKED);
  assert.match(stdout, /scan\.png: interior orientation by 6 fiducial marks, sigma0 0\.00\d\d mm, largest residual 0\.0\d+ mm/);
});

test('a scan may have as many pixels for a place as for a block', () => {
  // A PNG of grey values that ends behind its header: 272 MP, and 306 MP.
  const declared = (/** @type {number} */ side) => {
    const head = Buffer.from('89504e470d0a1a0a0000000d49484452', 'hex');
    const sides = Buffer.alloc(8);
    for (const at of [0, 4]) sides.writeUInt32BE(side, at);
    const scan = file(folder(), 'scan.png', Buffer.concat([head, sides, Buffer.from([8, 0, 0, 0, 0, 0, 0, 0, 0])]));
    return ['place', 'film'].map((name) => {
      const more =
        name === 'place' ? [...FILM.ground, ...MARKED] : ['--camera', FILM.camera, '--fiducials', dirname(FILM.fiducials), '--out', join(folder(), 'out')];
      return tiepoint(name, scan, ...more).stderr;
    });
  };
  for (const stderr of declared(16_500)) assert.match(stderr, /scan\.png: .*truncated/);
  for (const stderr of declared(17_500)) assert.match(stderr, /300/);
});

test('marks and cameras of film that cannot be are refused with what to give', () => {
  const at = folder();
  const refused = (/** @type {string[]} */ ...args) => {
    const { code, stdout, stderr } = tiepoint('place', ...args, ...FILM.ground);
    assert.equal(stdout, '');
    return `${code} ${stderr}`;
  };
  assert.match(refused(FILM.scan, '--fiducials', FILM.fiducials), /^2 .*--fiducials needs --camera beside it/);
  assert.match(refused(FILM.scan, '--camera', FILM.camera), /^2 .*--camera needs --fiducials beside it/);
  assert.match(refused(FILM.scan, '--origin', '3,4'), /^2 .*--origin needs --fiducials beside it/);
  assert.match(refused(FILM.scan, FILM.photos[0], ...MARKED), /^2 .*--fiducials are of one image/);
  assert.match(refused(FILM.scan, ...MARKED, '--cameras', FILM.camera), /^2 .*--camera and --cameras both give a camera/);
  const lines = readFileSync(FILM.fiducials, 'utf8').trim().split('\n');
  const marked = (/** @type {string[]} */ given) => ['--camera', FILM.camera, '--fiducials', file(at, 'marks.csv', given.join('\n'))];
  assert.match(refused(FILM.scan, ...marked(lines.slice(0, 3))), /^1 .*scan\.png.*fiducial marks/);
  assert.match(refused(FILM.scan, ...marked(['col,row,x_mm,y_mm', ...lines.slice(1, -1), '900,20,3,3'])), /^1 .*900, 20 px of an image of 570 × 470 px/);
  const mirrored = lines.slice(1).map((line) => line.split(','));
  assert.match(
    refused(FILM.scan, ...marked(['col,row,x_mm,y_mm', ...mirrored.map(([col, row, x, y]) => [col, row, -Number(x), y].join(','))])),
    /^1 .*mirrored/,
  );
  const noFocal = file(at, 'film.json', '{"principal_point_mm": [0, 0]}');
  assert.match(refused(FILM.scan, '--fiducials', FILM.fiducials, '--camera', noFocal), /^1 .*film\.json.*focal_mm/);
});
