import assert from 'node:assert/strict';
import { test } from 'node:test';
import { folder, image, json, speckle, tiepoint } from './command.js';

const at = folder();
const speckled = image(at, 'speckle.png', 64, 48, speckle);

/** The moments of a square window by their definition.  @param {number} col @param {number} row @param {number} side */
function byDefinition(col, row, side) {
  const half = (side - 1) / 2;
  const window = Array.from({ length: side * side }, (_, i) => ({ x: (i % side) - half, y: Math.floor(i / side) - half })).map(({ x, y }) => ({
    x,
    y,
    grey: speckle(col + x, row + y),
  }));
  const least = Math.min(...window.map((p) => p.grey));
  const sum = window.reduce((s, p) => s + p.grey - least, 0);
  const weighted = window.map((p) => ({ ...p, g: (p.grey - least) / sum }));
  const total = (/** @type {(p: { x: number, y: number, g: number }) => number} */ f) => weighted.reduce((s, p) => s + f(p), 0);
  const [cx, cy] = [total((p) => p.x * p.g), total((p) => p.y * p.g)];
  return (/** @type {number} */ i, /** @type {number} */ j) => total((p) => (p.x - cx) ** i * (p.y - cy) ** j * p.g);
}

test('the central moments are those of the definition', () => {
  const { central, normalized } = json('moments', speckled, '--at', '30,20');
  const mu = byDefinition(30, 20, 11);
  for (const [i, j] of [
    [0, 0],
    [2, 0],
    [1, 1],
    [0, 2],
    [3, 0],
    [2, 1],
    [1, 2],
    [0, 3],
  ]) {
    const [value, expected] = [central[`mu${i}${j}`], mu(i ?? 0, j ?? 0)];
    assert.ok(Math.abs(value - expected) < 1e-9 * Math.max(1, Math.abs(expected)), `mu${i}${j} is ${value}, by definition ${expected}`);
  }
  assert.ok(Math.abs(normalized.mu20 - central.mu20 / central.mu00 ** 2) < 1e-12);
  assert.ok(Math.abs(normalized.mu30 - central.mu30 / central.mu00 ** 2.5) < 1e-12);
  assert.deepEqual(Object.keys(normalized), ['mu20', 'mu11', 'mu02', 'mu30', 'mu21', 'mu12', 'mu03']);
});

test('the invariants follow from the normalised moments', () => {
  const { normalized: n, invariants } = json('moments', speckled, '--at', '30,20', '--window', '9');
  const [a, b, c, d] = [n.mu30 + n.mu12, n.mu21 + n.mu03, n.mu30 - 3 * n.mu12, 3 * n.mu21 - n.mu03];
  const expected = [
    n.mu20 + n.mu02,
    (n.mu20 - n.mu02) ** 2 + 4 * n.mu11 ** 2,
    c * c + d * d,
    a * a + b * b,
    c * a * (a * a - 3 * b * b) + d * b * (3 * a * a - b * b),
    (n.mu20 - n.mu02) * (a * a - b * b) + 4 * n.mu11 * a * b,
    d * a * (a * a - 3 * b * b) - c * b * (3 * a * a - b * b),
  ];
  assert.equal(invariants.length, 7);
  for (const [i, value] of expected.entries()) assert.ok(Math.abs(invariants[i] - value) <= 1e-9 * Math.abs(value), `I${i}`);
});

test('a position inside a pixel names that pixel', () => {
  assert.deepEqual(json('moments', speckled, '--at', '30.5,20.5'), json('moments', speckled, '--at', '30,20'));
});

test('the brightness option changes the weights', () => {
  const central = (/** @type {string} */ brightness) => json('moments', speckled, '--at', '30,20', '--brightness', brightness).central.mu00;
  assert.ok(Math.abs(central('sum') - 1) < 1e-12);
  assert.ok(central('range') > 1 && central('unit') > 1 && central('range') !== central('unit'));
});

test('the table shows every moment', () => {
  const { code, stdout } = tiepoint('moments', speckled, '--at', '30,20');
  assert.equal(code, 0);
  for (const name of ['mu00', 'mu20', 'mu03', 'I0', 'I6']) assert.match(stdout, new RegExp(`^${name} `, 'm'));
});
