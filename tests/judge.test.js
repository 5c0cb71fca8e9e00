/** The judge of the bench: whether it finds the true unknowns and the region of an orientation. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { errorsOf, inRegion, isWrong, student, unknownsOf } from '../tools/bench/verdict/judge.mjs';
import { poseOf } from '../tools/score.mjs';

const UNKNOWNS = { omega_deg: 3, phi_deg: -7, kappa_deg: 130, by_mm: 12, bz_mm: -4 };

/** @param {Partial<import('../pkg/node.js').RelativeOrientation>} of */
const orientation = (of) => /** @type {import('../pkg/node.js').RelativeOrientation} */ ({ ...UNKNOWNS, turn_deg: 0, base_mm: 90, ...of });

test('the unknowns are those whose pose it is, turned and of a negative base too', () => {
  for (const of of [{}, { turn_deg: 90 }, { base_mm: -90 }]) {
    const found = unknownsOf(poseOf(orientation(of)), orientation(of));
    for (const [name, value] of Object.entries(UNKNOWNS))
      assert.ok(Math.abs((found?.[/** @type {keyof typeof UNKNOWNS} */ (name)] ?? NaN) - value) < 1e-9, name);
  }
  assert.equal(unknownsOf(poseOf(orientation({})), orientation({ base_mm: -90 })), null);
});

test('limits of the distributions are those of the tables', () => {
  for (const [outside, freedom, limit] of /** @type {const} */ ([
    [0.05, Infinity, 1.96],
    [0.05, 10, 2.228],
    [0.001, 30, 3.646],
    [0.0002, Infinity, 3.719],
  ]))
    assert.ok(Math.abs(student(outside, freedom) - limit) < 0.003, `${outside} ${freedom}`);
});

test('a pose is wrong beyond 1° where its region does not hold the truth', () => {
  const truth = poseOf(orientation({}));
  const half = (/** @type {number} */ width) => ({ omega_deg: width, phi_deg: width, kappa_deg: width, by_mm: width, bz_mm: width });
  const off = (/** @type {number} */ deg, /** @type {number} */ width) =>
    isWrong(errorsOf(orientation({ omega_deg: 3 + deg, half_widths_95: half(width), degrees_of_freedom: 1000, sigma0_a_priori_mm: null }), truth));
  assert.deepEqual([off(0.9, 0.1), off(1.1, 0.1), off(1.1, 0.56), off(1.1, 0.6)], [false, true, true, false]);
  assert.equal(isWrong(null), true);
  const reference = { ...truth, uncertain: { rotation_deg: 0.5, direction_deg: 9 } };
  const byReference = (/** @type {number} */ deg) =>
    isWrong(errorsOf(orientation({ omega_deg: 3 + deg, half_widths_95: half(0.1), degrees_of_freedom: 1000, sigma0_a_priori_mm: null }), reference));
  assert.deepEqual([byReference(1.4), byReference(1.6)], [false, true]);
});

test('the region of 95 % is that of five intervals that hold jointly', () => {
  const width = { omega_deg: 0.1, phi_deg: 0.1, kappa_deg: 0.1, by_mm: 0.1, bz_mm: 0.1 };
  const of = (/** @type {number} */ deg) => orientation({ omega_deg: 3 + deg, half_widths_95: width, degrees_of_freedom: 1000, sigma0_a_priori_mm: 0.01 });
  const truth = poseOf(orientation({}));
  // Of 1 % outside the limit is 2.576 standard errors, of 5 % 1.96.
  assert.ok(Math.abs(inRegion(of(0.1), truth, 0.05) - 1.96 / 2.576) < 0.002);
  assert.ok(inRegion(of(0.13), truth, 0.05) < 1 && inRegion(of(0.14), truth, 0.05) > 1);
});
