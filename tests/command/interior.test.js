import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { file, folder, json, tiepoint } from './command.js';

const at = folder();
const [A, B, TX, D, E, TY] = [0.254, 0.0002, -115.8, 0.0001, -0.2538, 116.2];

/** Marks that an affine transformation fits exactly, moved by `noise_mm` as told.  @param {number[][]} noise */
function marks(noise = []) {
  const places = [
    [40, 40],
    [870, 42],
    [38, 875],
    [872, 874],
    [455, 16],
    [16, 457],
    [895, 458],
    [456, 898],
  ];
  const lines = places.map(([col = 0, row = 0], i) => {
    const [nx = 0, ny = 0] = noise[i] ?? [];
    return [col, row, A * col + B * row + TX + nx, D * col + E * row + TY + ny].join(',');
  });
  return ['col,row,x_mm,y_mm', ...lines].join('\n');
}

test('exact marks give the transformation back', () => {
  const result = json('interior', file(at, 'exact.csv', marks()));
  for (const [r, row] of [
    [A, B, TX],
    [D, E, TY],
  ].entries()) {
    for (const [c, value] of row.entries()) assert.ok(Math.abs(result.parameters[r][c] - value) < 1e-10, `parameter ${r}, ${c}`);
  }
  assert.equal(result.residuals_mm.length, 8);
  assert.equal(result.degrees_of_freedom, 10);
  assert.ok(result.sigma0_mm < 1e-10);
});

test('marks whose columns and rows are exchanged lie mirrored, which is said', () => {
  const head = 'row,col,x_mm,y_mm';
  const exchanged = file(at, 'exchanged.csv', marks().replace('col,row,x_mm,y_mm', head));
  assert.deepEqual([json('interior', exchanged).mirrored, json('interior', file(at, 'right.csv', marks())).mirrored], [true, false]);
  assert.match(tiepoint('interior', exchanged).stdout, /^warning: fiducial marks: got marks that lie mirrored in the scan;/m);
  assert.doesNotMatch(tiepoint('interior', file(at, 'right.csv', marks())).stdout, /warning/);
});

test('a table that a spreadsheet saved as Unicode text is read', () => {
  const plain = json('interior', file(at, 'plain.csv', marks()));
  const text = Buffer.from(`\ufeff${marks().replaceAll(',', '\t').replaceAll('.', ',')}`, 'utf16le');
  for (const [name, bytes] of /** @type {[string, Buffer][]} */ ([
    ['little.txt', text],
    ['big.txt', Buffer.from(text).swap16()],
  ])) {
    const path = join(at, name);
    writeFileSync(path, bytes);
    assert.deepEqual(json('interior', path), plain, name);
  }
});

test('sigma0 and the standard errors follow from the residuals', () => {
  const noise = [
    [0.02, -0.01],
    [-0.01, 0.03],
    [0.01, 0.01],
    [-0.02, 0],
    [0, -0.02],
    [0.01, 0.02],
    [-0.03, 0.01],
    [0.02, -0.01],
  ];
  const result = json('interior', file(at, 'noisy.csv', marks(noise)));
  const squares = result.residuals_mm.flat().reduce((/** @type {number} */ sum, /** @type {number} */ v) => sum + v * v, 0);
  assert.ok(Math.abs(result.sigma0_mm - Math.sqrt(squares / 10)) < 1e-12);
  assert.deepEqual(
    result.standard_errors.map((/** @type {number[]} */ row) => row.length),
    [3, 3],
  );
  assert.ok(result.standard_errors.flat().every((/** @type {number} */ e) => e > 0));
});

test('the similarity has four parameters, and three marks leave no redundancy to the affine one', () => {
  const path = file(at, 'exact.csv', marks());
  const {
    parameters: [[a, b], [d, e]],
    degrees_of_freedom: dof,
  } = json('interior', path, '--model', 'similarity');
  assert.ok(Math.abs(a + e) < 1e-12 && Math.abs(b - d) < 1e-12, 'scale and rotation, y turned from down to up');
  assert.equal(dof, 12);
  const three = json('interior', file(at, 'three.csv', marks().split('\n').slice(0, 4).join('\n')));
  assert.deepEqual([three.sigma0_mm, three.standard_errors, three.degrees_of_freedom], [null, null, 0]);
});

test('the table names the parameters', () => {
  const { code, stdout } = tiepoint('interior', file(at, 'exact.csv', marks()));
  assert.equal(code, 0);
  assert.match(stdout, /tx \[mm\] +-115\.80000000/);
  assert.match(stdout, /sigma0 0\.0000 mm, 10 degrees of freedom/);
});
