/** The plots of a block: their values, what is chosen in them, and their axes, without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(page, await pageModules(['block/state/plots', 'block/state/plot-words', 'block/view/plot/axes', 'block/state/normal']));
});

/** Three images of which one is not oriented; four points of which the last was rejected. */
const VIEW = {
  images: [
    { name: 'a', width: 100, rmsePx: 0.2, position: [0, 0, 100] },
    { name: 'b', width: 100, rmsePx: null, position: null },
    { name: 'c', width: 100, rmsePx: 0.4, position: [3, 4, 100] },
  ],
  points: {
    count: 4,
    taking: 3,
    lost: new Set(),
    numbers: Uint32Array.of(1, 2, 1001, 1002),
    rays: Uint16Array.of(2, 3, 2, 5),
    positions: Float64Array.of(0, 0, 0, 10, 90, 0, 5, 50, 0, 1, 1, 1),
    errors: Float64Array.of(3, 4, 9, 0, 1, 2, NaN, NaN, NaN, NaN, NaN, NaN),
  },
  surveyed: [
    { name: 'G1', role: 'check', point: 2, isUsed: true, difference_m: [3, 4, -2], standard_errors_m: [1, 2, 4] },
    { name: 'G2', role: 'control', point: 3, isUsed: false, difference_m: [NaN, NaN, NaN], standard_errors_m: [null, null, null] },
  ],
};

const OBSERVED = {
  images: Uint32Array.of(0, 2, 0, 2),
  points: Uint32Array.of(0, 0, 1, 1),
  places: Float64Array.of(50, 10, 100, 10, 0, 5, 1, 1),
  residuals: Float64Array.of(1, 0, 0, -2, NaN, NaN, 0.5, 0.5),
  redundancy: Float64Array.of(0.5, 0.6, 0.7, 0, NaN, NaN, 0.5, 0.5),
  w: Float64Array.of(1.5, 0, -0.4, -2, NaN, NaN, 7, 7),
  detectable: Float64Array.of(0.6, 2, 0.5, NaN, NaN, NaN, 0.5, 0.5),
  parts: Uint8Array.of(0, 0, 0, 2),
};

const FACTS = {
  observations: () => OBSERVED,
  ground: () => ({ gnss: Float64Array.of(0, 0, 101, 0, 0, 0, NaN, NaN, NaN) }),
};

const values = (/** @type {string} */ name) => {
  const { x, y } = page.plots.plotOf(name, VIEW, FACTS);
  return [x.names ?? [...x.values], [...y.values]];
};

test('plots show what is known, and choose what their values are about', () => {
  assert.deepEqual(values('images'), [
    ['a', 'c'],
    [0.2, 0.4],
  ]);
  assert.deepEqual(values('gnss'), [['a'], [1]]);
  // Of tie points: the third point is a check point.
  assert.deepEqual(values('rays'), [
    ['2', '3'],
    [1, 1],
  ]);
  // Along the longer side of the block; points without a standard error, and rejected ones, are left out.
  assert.deepEqual(values('sigma-plan'), [
    [0, 90],
    [5, 1],
  ]);
  assert.deepEqual(values('sigma-height')[1], [9, 2]);
  assert.deepEqual(values('surveyed-plan'), [['G1'], [5]]);
  assert.deepEqual(values('surveyed-height')[1], [-2]);
  assert.deepEqual(values('residuals'), [
    [1, 0],
    [0, -2],
  ]);
  assert.equal(page.plots.plotOf('residuals', VIEW, { ...FACTS, observations: () => null }), null);

  const { plotOf } = page.plots;
  const images = plotOf('images', VIEW, FACTS);
  assert.deepEqual(images.choice(1), { kind: 'image', image: 2 });
  assert.deepEqual(images.together([0, 1]), { kind: 'images', images: [0, 2] });
  assert.deepEqual([0, 1].map(images.chosen({ kind: 'pair', images: [1, 2] })), [false, true]);
  const rays = plotOf('rays', VIEW, FACTS);
  assert.deepEqual(rays.choice(0), { kind: 'point', point: 0 });
  assert.deepEqual([0, 1].map(rays.chosen({ kind: 'point', point: 1 })), [false, true]);
  const residuals = plotOf('residuals', VIEW, FACTS);
  assert.deepEqual(residuals.choice(1), { kind: 'observation', point: 0, image: 2 });
  assert.deepEqual([0, 1].map(residuals.chosen({ kind: 'observation', point: 0, image: 2 })), [false, true]);
  const several = { kind: 'observations', points: Uint32Array.of(0, 1), images: Uint32Array.of(2, 0) };
  assert.deepEqual([0, 1].map(residuals.chosen(several)), [false, true]);
  assert.deepEqual([0, 1].map(residuals.chosen(null)), [false, false]);
  assert.deepEqual(plotOf('sigma-plan', VIEW, FACTS).together([0, 1]), { kind: 'points', points: Uint32Array.of(0, 1) });
});

/** What a file of a plot says of its values, beside the axes.  @param {string} name @param {object} [view] */
const about = (name, view = VIEW) => {
  const data = page.plots.plotOf(name, view, FACTS);
  return (data.about ?? []).map((/** @type {any} */ { label, text }) => [label, ...Array.from(data.x.values.keys(), text)]);
};

test('files of plots name the image and the point of each value', () => {
  const images = ['Image', 'a', 'c'];
  assert.deepEqual(about('residuals'), [images, ['Point', '1', '1']]);
  assert.deepEqual(about('w'), [
    ['Image', 'a', 'a', 'c', 'c'],
    ['Point', '1', '1', '1', '1'],
    ['Coordinate', 'x', 'y', 'x', 'y'],
  ]);
  // Its axis names the images.
  assert.deepEqual(about('detectable'), [['Point', '1', '1']]);
  assert.deepEqual(about('sigma-height'), [['Point', '1', '2']]);
  const named = { ...VIEW, surveyed: [{ name: 'G1', role: 'check', point: 0, isUsed: true, difference_m: [3, 4, -2], standard_errors_m: [1, 2, 4] }] };
  assert.deepEqual(about('residuals', named), [images, ['Point', 'G1', 'G1']]);
  assert.deepEqual(about('images'), []);
});

const surveyed = (/** @type {string} */ name, /** @type {string} */ role, /** @type {object} */ more) => ({
  name,
  role,
  point: 0,
  isUsed: true,
  difference_m: [3, 4, -2],
  standard_errors_m: [1, 2, 4],
  ...more,
});

test('control points are shown by what they are worth left out, apart from check points, with their predicted errors', () => {
  const leftOut = { left_out: { difference: [0, 6, 9], standard_errors: [1, 2, 3] }, difference_m: [0, 0, 0.001] };
  const view = {
    ...VIEW,
    surveyed: [
      surveyed('C1', 'check', {}),
      surveyed('G1', 'control', leftOut),
      surveyed('G2', 'control', {}),
      surveyed('C2', 'check', { standard_errors_m: [null, null, null] }),
      // A check point takes no part in any case.
      surveyed('C3', 'check', leftOut),
    ],
  };
  const height = page.plots.plotOf('surveyed-height', view, FACTS);
  assert.deepEqual([...height.y.values], [-2, 9, -2, -2, 0.001]);
  assert.deepEqual(
    [...height.whiskers.from].map((value) => Number(value.toFixed(6))),
    [-9.84, 3.12, -9.84, NaN, -7.839],
  );
  assert.deepEqual(
    [...height.whiskers.to].map((value) => Number(value.toFixed(6))),
    [5.84, 14.88, 5.84, NaN, 7.841],
  );
  const { kinds, of } = height.groups;
  assert.deepEqual(
    [0, 1, 2, 3, 4].map((row) => kinds[of(row)].label),
    ['check point', 'control point, left out', 'control point, in the adjustment', 'check point', 'check point'],
  );
  assert.equal(new Set(kinds.map((/** @type {any} */ { mark }) => mark)).size, 3);
  assert.equal(height.said(1), 'G1, control point, left out: 9.000 m, σ 3.000 m, Δ/σ 3.0');
  assert.equal(height.said(3), 'C2, check point: −2.000 m');
  const columns = [...height.about, ...height.more].map((/** @type {any} */ { label, text }) => [label, text(0), text(1), text(3)]);
  assert.deepEqual(columns, [
    ['Use', 'check', 'control', 'check'],
    ['Kind', 'check point', 'control point, left out', 'check point'],
    ['σ', '4.0000', '3.0000', '–'],
    ['Δ/σ', '−0.50', '3.00', '–'],
  ]);
  // In plan a length, with the standard error in its direction; it ends at 0.
  const plan = page.plots.plotOf('surveyed-plan', view, FACTS);
  assert.deepEqual([...plan.y.values], [5, 6, 5, 5, 0]);
  const along = Math.hypot(3 * 1, 4 * 2) / 5;
  assert.ok(Math.abs(plan.whiskers.to[0] - 5 - 1.96 * along) < 1e-9 && plan.whiskers.from[4] === 0);
  // Whiskers are within the picture, and so is zero.
  const { y } = page.axes.endsOf(height, 400, 300);
  assert.ok(y[0] < -9.84 && y[1] > 14.88);
});

test('names of a plot are all written while they fit, upright where they are many, and never by turns alone', () => {
  const { laidOut, namesWritten, ROOM } = page.axes;
  const measure = (/** @type {string} */ text) => 6 * text.length;
  const named = (/** @type {number} */ many) => ({ x: { names: Array.from({ length: many }, (_, i) => `P${i + 1}`) } });
  const few = laidOut(named(17), 900, measure);
  assert.deepEqual([few.upright, few.room.bottom, few.room.top, few.legend], [false, ROOM.bottom, ROOM.top, []]);
  const many = laidOut(named(40), 900, measure);
  assert.ok(many.upright && many.room.bottom > ROOM.bottom);
  assert.deepEqual(namesWritten([-0.5, 3.5], ['a', 'b', 'c', 'd'], 20), [0, 1, 2, 3]);
  assert.deepEqual(namesWritten([1, 3.5], ['a', 'b', 'c', 'd'], 20), [1, 2, 3]);
  // Control and check points often come in turns.
  const steps = [13, 8, 5, 1].map((apart) => namesWritten([0, 99], new Array(100).fill(''), apart)[1]);
  assert.deepEqual(steps, [1, 3, 3, 13]);
  // The legend has the lines that it needs.
  const groups = { kinds: [{ label: 'check point' }, { label: 'control point, left out' }] };
  const legend = (/** @type {number} */ width) => laidOut({ x: {}, groups, whiskers: {} }, width, measure).legend.map((/** @type {any} */ { line }) => line);
  assert.deepEqual(
    [legend(900), legend(360)],
    [
      [0, 0, 0],
      [0, 0, 1],
    ],
  );
});

test('standard errors lie along the block in the system of the results, which the axis names', () => {
  const { x, y } = page.plots.plotOf('sigma-height', VIEW, FACTS);
  assert.deepEqual([x.label, x.unit, [...x.values]], ['Y', 'm', [0, 90]]);
  const view = {
    ...VIEW,
    points: { ...VIEW.points, positions: VIEW.points.positions.slice() },
    origin: { longitude_deg: 8.5, latitude_deg: 50.1, height_m: 150 },
    crs: 'EPSG:25832',
    system: 'ETRS89 / UTM zone 32N',
    geoidM: null,
  };
  const there = page.plots.plotOf('sigma-height', view, FACTS);
  assert.deepEqual([there.x.label, there.x.unit], ['Y EPSG:25832', 'm']);
  const [first = NaN, second = NaN] = there.x.values;
  assert.ok(first > 5_549_000 && first < 5_551_000 && Math.abs(second - first - 90) < 0.5, `${first} ${second}`);
  assert.deepEqual([...there.y.values], [...y.values]);
  assert.match(page.plot_words.plotText(there), /^2 values over Y EPSG:25832\. /u);
});

test('w-statistics are shown over those of normal errors, minimal detectable biases where their images are', () => {
  const { plotOf } = page.plots;
  const tests = plotOf('w', VIEW, FACTS);
  // Of columns and rows of what takes part, over the quantiles of 1/8, 3/8, 5/8 and 7/8.
  assert.deepEqual([...tests.y.values], [1.5, 0, -0.4, -2]);
  const expected = [1.1503494, 0.3186394, -0.3186394, -1.1503494];
  assert.ok(
    expected.every((value, i) => Math.abs(value - tests.x.values[i]) < 1e-6),
    [...tests.x.values].join(),
  );
  assert.ok(tests.equal);
  assert.deepEqual(tests.choice(1), { kind: 'observation', point: 0, image: 0 });
  assert.deepEqual(tests.choice(3), { kind: 'observation', point: 0, image: 2 });
  assert.deepEqual(tests.together([0, 3]), { kind: 'point', point: 0 });
  assert.deepEqual([0, 1, 2, 3].map(tests.chosen({ kind: 'image', image: 2 })), [false, false, true, true]);

  // The larger one of column and row; where nothing checks one of them, it stands over all others.
  const detectable = plotOf('detectable', VIEW, FACTS);
  assert.deepEqual([...detectable.y.values], [2, Infinity]);
  assert.equal(detectable.x.values[0], 0);
  assert.deepEqual(detectable.choice(1), { kind: 'observation', point: 0, image: 2 });
  assert.match(
    page.plot_words.plotText(detectable),
    /^1 values over image\. .*: median 2\.000, from 2\.000 to 2\.000 px\. 1 more stands at the top: nothing checks one of the two coordinates\.$/,
  );
  const unchecked = { ...OBSERVED, detectable: new Float64Array(8).fill(NaN) };
  assert.match(page.plot_words.plotText(plotOf('detectable', VIEW, { ...FACTS, observations: () => unchecked })), /^2 more stand at the top/);
  assert.match(page.plot_words.plotText(plotOf('images', VIEW, FACTS)), /px\.$/);
  assert.deepEqual(detectable.x.names, ['a', 'b', 'c']);
  assert.deepEqual(detectable.choice(0), { kind: 'observation', point: 0, image: 0 });
  assert.equal(plotOf('detectable', VIEW, { ...FACTS, observations: () => null }), null);
});

test('quantiles are those of the tables, for any number of values', () => {
  const { normalQuantiles } = page.normal;
  assert.deepEqual([...normalQuantiles(0)], []);
  assert.deepEqual([...normalQuantiles(1)], [0]);
  const many = normalQuantiles(1000);
  // Abramowitz & Stegun 1964, table 26.1: P(1.9599640) = 0.975, P(0.6744898) = 0.75.
  const between = (/** @type {number} */ i) => (many[i] + many[i - 1]) / 2;
  assert.ok(Math.abs(between(975) - 1.959964) < 1e-4 && Math.abs(between(750) - 0.6744898) < 1e-5, `${between(975)} ${between(750)}`);
  assert.ok(many.every((/** @type {number} */ value, /** @type {number} */ i) => i === 0 || value > many[i - 1]));
});

test('plots of 100,000 observations are made within the time of a few frames', () => {
  const rows = 100_000;
  let seed = 1;
  const next = () => {
    seed = (seed * 48271) % 2147483647;
    return seed / 2147483647;
  };
  const normal = () => Math.sqrt(-2 * Math.log(next())) * Math.cos(2 * Math.PI * next());
  const of = {
    images: Uint32Array.from({ length: rows }, (_, i) => i % 3),
    points: Uint32Array.from({ length: rows }, (_, i) => i >> 2),
    places: Float64Array.from({ length: 2 * rows }, () => 100 * next()),
    residuals: new Float64Array(2 * rows),
    redundancy: new Float64Array(2 * rows),
    w: Float64Array.from({ length: 2 * rows }, normal),
    detectable: Float64Array.from({ length: 2 * rows }, () => 0.1 + next()),
    parts: new Uint8Array(rows),
  };
  const started = performance.now();
  const tests = page.plots.plotOf('w', VIEW, { ...FACTS, observations: () => of });
  const detectable = page.plots.plotOf('detectable', VIEW, { ...FACTS, observations: () => of });
  const took = performance.now() - started;
  // Normal values lie along the line.
  const off = tests.x.values.map((/** @type {number} */ x, /** @type {number} */ i) => (Math.abs(tests.y.values[i]) < 3 ? Math.abs(x - tests.y.values[i]) : 0));
  assert.equal(tests.x.values.length, 2 * rows);
  assert.ok(Math.max(...off.subarray(0, 50_000)) < 0.1, `${Math.max(...off.subarray(0, 50_000))}`);
  assert.equal(detectable.y.values.length, rows);
  assert.ok(took < 1500, `${took} ms`);
});

test('axes end beside their values, bars stand on zero, and ticks are round', () => {
  const { decimalsOf, endsOf, ticksBetween } = page.axes;
  assert.deepEqual(ticksBetween([0.13, 0.91], 4), [0.2, 0.4, 0.6, 0.8]);
  assert.deepEqual(ticksBetween([-2.2, 2.2], 5), [-2, -1, 0, 1, 2]);
  assert.equal(decimalsOf([0.2, 0.4]), 1);
  assert.equal(decimalsOf([0, 50]), 0);
  assert.deepEqual(ticksBetween([1, 1], 5), []);
  const { x, y } = endsOf(page.plots.plotOf('images', VIEW, FACTS), 400, 300);
  assert.deepEqual([x, y[0]], [[-0.5, 1.5], 0]);
  assert.ok(y[1] > 0.4 && y[1] < 0.45);
  // Logarithmic ones: 1, 2 and 5, the powers alone, or round steps.
  const { ticksOfPowers } = page.axes;
  assert.deepEqual(ticksOfPowers([-0.4, 1.1], 6), [0.5, 1, 2, 5, 10]);
  assert.deepEqual(ticksOfPowers([-2, 3], 6), [0.01, 0.1, 1, 10, 100, 1000]);
  assert.deepEqual(ticksOfPowers([Math.log10(0.31), Math.log10(0.68)], 4), [0.4, 0.5, 0.6]);
  const { y: powers } = endsOf(page.plots.plotOf('detectable', VIEW, FACTS), 400, 300);
  assert.ok(powers[0] < Math.log10(2) && powers[1] > Math.log10(2));
  // Residuals have one scale in both directions, about zero.
  const square = endsOf(page.plots.plotOf('residuals', VIEW, FACTS), 464, 300);
  assert.ok(Math.abs(square.x[0] + square.x[1]) < 1e-12 && Math.abs(square.y[0] + square.y[1]) < 1e-12);
  assert.ok(Math.abs((square.x[1] - square.x[0]) / (464 - 80) - (square.y[1] - square.y[0]) / (300 - 54)) < 1e-12);
});

test('a title stays in sight: at the middle of its axis, beside it where it is long, and drawn narrower where it is longer than the picture', () => {
  const { titleWithin } = page.axes;
  assert.deepEqual(titleWithin(50, 100, 240), { middle: 100, most: 232 });
  // The axis is nearer to the upper edge.
  assert.deepEqual(titleWithin(200, 90, 240), { middle: 104, most: 232 });
  assert.deepEqual(titleWithin(200, 150, 240), { middle: 136, most: 232 });
  assert.deepEqual(titleWithin(500, 90, 240), { middle: 120, most: 232 });
});
