/** The rows of the page's tables: order, conditions, totals and files of them, as the page's own code makes them. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(page, await pageModules(['shared/state/rows', 'block/state/columns', 'block/state/selection', 'block/view/map/points']));
});

const VALUES = [3, NaN, -1, 10, 3];
const WORDS = ['photo 2', 'Photo 10', 'sea, "deep"', 'photo 1', ''];
const COLUMNS = [
  {
    key: 'n',
    label: 'Number',
    unit: 'px',
    help: '',
    value: (/** @type {number} */ i) => VALUES[i],
    text: (/** @type {number} */ i) => text(VALUES[i]),
    total: 'mean',
  },
  { key: 'w', label: 'Word', unit: '', help: '', value: (/** @type {number} */ i) => WORDS[i], text: (/** @type {number} */ i) => WORDS[i], words: true },
];
const text = (/** @type {number | undefined} */ value) => (value === undefined || Number.isNaN(value) ? '–' : value.toFixed(1).replace('-', '−'));
const all = () => true;

test('rows are sorted by figures and by words, equal ones in their order, those without a figure last', () => {
  const { keptOf, ordered } = page.rows;
  const order = (/** @type {string} */ key, /** @type {boolean} */ descending) => [...ordered(5, COLUMNS, { key, descending })];
  assert.deepEqual(order('n', false), [2, 0, 4, 3, 1]);
  assert.deepEqual(order('n', true), [3, 0, 4, 2, 1]);
  assert.deepEqual(order('w', false), [4, 3, 0, 1, 2]);
  assert.deepEqual(order('', false), [0, 1, 2, 3, 4]);
  assert.deepEqual([...keptOf(ordered(5, COLUMNS, { key: 'n', descending: false }), (/** @type {number} */ row) => row > 1)], [2, 4, 3]);
});

test('what is typed over a column keeps the rows that it says', () => {
  const { conditionOf, conditionText, keeping, maskOf } = page.rows;
  const kept = (/** @type {string} */ typed, key = 'n') => {
    const condition = conditionOf(typed, key === 'w');
    const meets = keeping(COLUMNS, { [key]: condition });
    // What is written back says the same.
    assert.deepEqual(conditionOf(conditionText(condition), key === 'w'), condition, typed);
    return [0, 1, 2, 3, 4].filter(meets);
  };
  assert.deepEqual(kept('3..10'), [0, 3, 4]);
  assert.deepEqual(kept('-1 – 3'), [0, 2, 4]);
  assert.deepEqual(kept('>3'), [3]);
  assert.deepEqual(kept('≥ 3'), [0, 3, 4]);
  assert.deepEqual(kept('<=−1'), [2]);
  assert.deepEqual(kept('3'), [0, 4]);
  assert.deepEqual(kept('PHOTO 1', 'w'), [1, 3]);
  assert.deepEqual(conditionOf('0.32', false), { kind: 'range', from: 0.315, to: 0.325 });
  for (const bad of ['abc', '3..', '>', '1 2']) assert.equal(conditionOf(bad, false), undefined, bad);
  // As it was typed, not as the number that is kept for it.
  for (const typed of ['>0.1', '<2', '>0', '≥0.1', '≤3']) assert.equal(conditionText(conditionOf(typed, false)), typed);
  assert.equal(conditionOf('  ', false), null);
  assert.equal(keeping(COLUMNS, {}), null);
  assert.equal(maskOf(5, COLUMNS, {}), null);
  assert.deepEqual([...maskOf(5, COLUMNS, { n: conditionOf('>2', false) })], [1, 0, 0, 1, 1]);
  // A condition of the other kind than its column is none.
  assert.equal(keeping(COLUMNS, { w: { kind: 'range', from: 1, to: 2 } }), null);
});

test('totals count what is there', () => {
  const { totalOf } = page.rows;
  const total = (/** @type {string} */ kind, /** @type {number[]} */ rows) => totalOf({ ...COLUMNS[0], total: kind }, rows);
  assert.equal(total('sum', [0, 1, 2]), 2);
  assert.equal(total('mean', [0, 1, 2, 3]), 4);
  assert.equal(total('rms', [2, 1]), 1);
  assert.ok(Number.isNaN(total('sum', [1])));
});

test('a file holds what is shown: units in the heads, figures that programs read, words in quotes where they need them', () => {
  const { csvOf, tabbedOf } = page.rows;
  assert.equal(csvOf(COLUMNS, [2, 1]), 'Number [px],Word\n-1.0,"sea, ""deep"""\n,Photo 10\n');
  assert.equal(tabbedOf(COLUMNS, [3]), 'Number [px]\tWord\n10.0\tphoto 1\n');
});

test('no cell of a file that the page writes runs as a formula', () => {
  const { csvOf, tabbedOf } = page.rows;
  // The texts of `no_cell_of_a_table_runs_as_a_formula` in `src/text.rs`, which reads such cells back, and a name that a file can have.
  const texts = ['=1+1', '+1', '-1', '@SUM(1)', '\tx', '\rx', "'=1", "''-1", "'a", 'a=1', '=a, "b"', 'the "a"', '7', '=HYPERLINK("http:x").jpg'];
  const figures = ['-0.5', '−1.5', '+2', '-1e-7', '–', '-', '=1', '−1\u202f000.5', '7', '8', '9', '10', '11', '12'];
  const words = { ...COLUMNS[0], unit: '', label: '=text', words: true, text: (/** @type {number} */ i) => texts[i] };
  const figure = { ...COLUMNS[0], unit: '', label: '-figure', text: (/** @type {number} */ i) => figures[i] };
  const cells = [
    ["'=text", "'-figure"],
    ["'=1+1", '-0.5'],
    ["'+1", '-1.5'],
    ["'-1", '+2'],
    ["'@SUM(1)", '-1e-7'],
    ["'\tx", ''],
    ['"\'\rx"', "'-"],
    ["''=1", "'=1"],
    ["'''-1", '-1000.5'],
    ["'a", '7'],
    ['a=1', '8'],
    ['"\'=a, ""b"""', '9'],
    ['"the ""a"""', '10'],
    ['7', '11'],
    ['"\'=HYPERLINK(""http:x"").jpg"', '12'],
  ];
  assert.equal(csvOf([words, figure], texts.keys()), cells.map((row) => `${row.join(',')}\n`).join(''));
  assert.equal(tabbedOf([words, figure], [0, 4, 10]), "'=text\t'-figure\n'=1+1\t-0.5\n' x\t\n'=a, \"b\"\t9\n");
});

test('100,000 rows are sorted and kept in less than a second', () => {
  const { keptOf, ordered, keeping } = page.rows;
  const values = Float64Array.from({ length: 100_000 }, (_, i) => (i * 7919) % 100_003);
  const columns = [{ ...COLUMNS[0], value: (/** @type {number} */ i) => values[i] }];
  const meets = keeping(columns, { n: { kind: 'range', from: 1000, to: null } });
  // The time of the processor: what else the machine does counts for nothing.
  const began = process.cpuUsage();
  const rows = keptOf(ordered(values.length, columns, { key: 'n', descending: true }), meets);
  const { user, system } = process.cpuUsage(began);
  assert.ok(user + system < 1e6, `${(user + system) / 1000} ms`);
  assert.ok(rows.length > 98_000 && (values[rows[0]] ?? 0) > (values[rows[1]] ?? 0));
});

/** A block of three images and two pairs. */
const VIEW = {
  images: ['a.jpg', 'b.jpg', 'c.jpg'].map((name) => ({
    name,
    features: 10,
    rays: 4,
    places: 9,
    rmsePx: 0.3,
    oriented: true,
    position: [1, 2, 3],
    camera: 0,
    why: '',
  })),
  leftOut: [{ name: 'broken.jpg', reason: 'no image' }],
  cameras: [{ label: 'one' }],
  connections: [
    { images: [0, 1], outcome: { kind: 'connected', matches: 70 }, shared: 30, chosen: 9, geometry: null, reason: '' },
    { images: [1, 2], outcome: { kind: 'failed' }, shared: 0, chosen: 0, geometry: null, reason: 'too few' },
  ],
};

const SHOWN = { view: VIEW, given: [] };

test('a row is what it says, and a choice finds its row in each table', () => {
  const { choiceOfRow, rowsOfChoice, rowsOf } = page.columns;
  assert.equal(rowsOf('images', SHOWN).count, 4);
  assert.equal(choiceOfRow('images', SHOWN, 3), null);
  assert.deepEqual(choiceOfRow('pairs', SHOWN, 1), { kind: 'pair', images: [1, 2] });
  assert.deepEqual([...rowsOfChoice('pairs', SHOWN, { kind: 'pair', images: [2, 1] })], [1]);
  assert.deepEqual([...rowsOfChoice('images', SHOWN, { kind: 'pair', images: [2, 1] })], [2, 1]);
  assert.deepEqual([...rowsOfChoice('points', SHOWN, { kind: 'points', points: Uint32Array.of(4, 9) })], [4, 9]);
});

test('coordinates and their standard errors have their unit in the heads, where the block has a scale', () => {
  const points = { count: 0, positions: [], errors: [] };
  const units = (/** @type {object | null} */ origin) => {
    const view = { ...VIEW, origin, surveyed: [], points };
    const heads = ['images', 'points'].flatMap((subject) => page.columns.rowsOf(subject, { view, given: [] }).columns);
    return heads.filter(({ label }) => /^(?:σ )?[XYZ]$/u.test(label)).map(({ label, unit }) => `${label} ${unit}`);
  };
  const labels = ['X', 'Y', 'Z', 'X', 'σ X', 'Y', 'σ Y', 'Z', 'σ Z'];
  assert.deepEqual(
    units({}),
    labels.map((label) => `${label} m`),
  );
  assert.deepEqual(
    units(null),
    labels.map((label) => `${label} `),
  );
});

test('a file of a table in Arabic has the heads, units and words that are shown, without marks of direction', async () => {
  // As a worker is called that writes Arabic.
  Object.assign(globalThis, { name: 'tables ar' });
  const { columns, rows, texts } = await pageModules(['shared/engine/texts', 'shared/state/rows', 'block/state/columns']);
  Reflect.deleteProperty(globalThis, 'name');
  // As in the page in one file, whose parts are there.
  Object.assign(globalThis, { document: { getElementById: () => ({ textContent: 'there' }) } });
  for (const part of ['program', 'block']) await texts.learnPart(part);
  Reflect.deleteProperty(globalThis, 'document');
  const surveyed = [{ name: 'G1', role: 'check', rays: 4, position: [1, 2, 3], isUsed: true, standard_errors_m: [1, 1, 1], difference_m: [0, 0, -1] }];
  const given = [{ name: 'G2', role: null, images: 2, place: null, position: [7, 8, 9] }];
  const table = columns.rowsOf('surveyed', { view: { ...VIEW, surveyed }, given });
  const shown = table.columns.filter((/** @type {{ key: string }} */ { key }) => /^(?:use|given-X|left-out-X|left-out-sigma-Z)$/u.test(key));
  const bare = (/** @type {string} */ said) => said.replaceAll(/[\u200e\u200f\u2066-\u2069]/gu, '');
  const [heads, ...cells] = rows.csvOf(shown, [0, 1]).trimEnd().split('\n');
  const units = ['', '', ' [م]', ' [م]'];
  assert.equal(heads, shown.map((/** @type {{ label: string }} */ { label }, /** @type {number} */ i) => bare(label) + units[i]).join());
  assert.match(heads, /\p{Script=Arabic}/u);
  assert.deepEqual(
    cells,
    [0, 1].map((row) => shown.map((/** @type {any} */ column) => bare(column.text(row)).replace('–', '')).join()),
  );
});

test('a control point says where it would be without itself, a check point does not', () => {
  const none = [null, null, null];
  const left_out = { difference: [0.01, -0.02, 0.03], standard_errors: [0.004, 0.005, 0.006] };
  const shared = { rays: 4, position: [1, 2, 3], isUsed: true, standard_errors_m: [0.01, 0.01, 0.02], detectable_m: none };
  const surveyed = [
    { ...shared, name: 'G1', role: 'control', difference_m: [0.001, 0.002, 0.003], left_out },
    { ...shared, name: 'G2', role: 'check', difference_m: [0.1, 0.2, 0.3] },
  ];
  const { columns } = page.columns.rowsOf('surveyed', { view: { ...VIEW, surveyed }, given: [] });
  /** @type {[string, string, string, (row: number) => string][]} */
  const own = columns
    .filter((/** @type {{ key: string }} */ { key }) => key.startsWith('left-out'))
    .map((/** @type {any} */ { label, unit, help, text: said }) => [label, unit, help, said]);
  assert.deepEqual(
    own.map(([label, unit]) => [label, unit]),
    ['ΔX left out', 'ΔY left out', 'ΔZ left out', 'σ ΔX left out', 'σ ΔY left out', 'σ ΔZ left out'].map((label) => [label, 'm']),
  );
  assert.deepEqual(
    own.map(([, , , said]) => said(0)),
    ['0.010', '−0.020', '0.030', '0.004', '0.005', '0.006'],
  );
  assert.ok(own.every(([, , help, said]) => said(1) === '–' && help !== ''));
  // What is larger than predicted: of a control point without itself.
  const ratios = columns.filter((/** @type {{ key: string }} */ { key }) => key.startsWith('difference-ratio'));
  assert.deepEqual(
    ratios.map((/** @type {any} */ { label, total, text: said }) => [label, total, said(0), said(1)]),
    [
      ['Δ/σ X', 'rms', '2.5', '10.0'],
      ['Δ/σ Y', 'rms', '−4.0', '20.0'],
      ['Δ/σ Z', 'rms', '5.0', '15.0'],
    ],
  );
});

test('the table of control and check points has the root mean squares of both apart, without those that are not used', () => {
  const surveyed = ['control', 'check', 'control', 'check'].map((role, i) => ({ name: `G${i}`, role, isUsed: i < 3, position: [1, 2, 3] }));
  const { columns } = page.columns.rowsOf('surveyed', {
    view: { ...VIEW, surveyed },
    given: [{ name: 'G9', role: 'check', images: 1, place: null, position: [1, 2, 3] }],
  });
  const { parts } = columns.find((/** @type {{ key: string }} */ { key }) => key === 'use');
  assert.deepEqual(
    parts.map((/** @type {any} */ { label, has }) => [label, [0, 1, 2, 3, 4].filter(has)]),
    [
      ['control', [0, 2]],
      ['check', [1]],
    ],
  );
});

test('an image that a filter leaves out takes its pairs with it', () => {
  const { keptBy } = page.columns;
  const filters = { images: { name: { kind: 'contains', text: 'C.JPG' } } };
  const kept = (/** @type {string} */ subject, /** @type {number} */ count, given = {}) => {
    const keeps = keptBy(subject, VIEW, { filters: given });
    return Array.from({ length: count }, (_, i) => i).filter(keeps);
  };
  assert.deepEqual(kept('images', 3, filters), [2]);
  assert.deepEqual(kept('pairs', 2, filters), []);
  assert.deepEqual(kept('pairs', 2), [0, 1]);
  assert.deepEqual(kept('pairs', 2, { pairs: { matches: { kind: 'range', from: 1, to: null } } }), [0]);
});

test('observations are those of what is chosen: of points in all images, of an image, of the common points of a pair', () => {
  const { observationRows, observationsOf } = page.columns;
  const of = {
    images: Uint32Array.of(0, 0, 1, 1, 2),
    points: Uint32Array.of(7, 8, 7, 9, 7),
    places: new Float64Array(10),
    residuals: Float64Array.of(0.3, 0.4, 0, 0, NaN, NaN, 0, 0, 0, 0),
    redundancy: Float64Array.of(0.25, 0.75, 0, 0, NaN, NaN, 0, 0, 0, 0),
    w: Float64Array.of(1.2, -0.8, 0, 0, NaN, NaN, 0, 0, 0, 0),
    detectable: Float64Array.of(2.4, 1.5, 0, 0, NaN, NaN, 0, 0, 0, 0),
    parts: Uint8Array.of(0, 2, 1, 0, 0),
  };
  const shown = (/** @type {object | null} */ choice) => [0, 1, 2, 3, 4].filter(observationsOf(of, choice));
  assert.deepEqual(shown(null), [0, 1, 2, 3, 4]);
  assert.deepEqual(shown({ kind: 'point', point: 7 }), [0, 2, 4]);
  assert.deepEqual(shown({ kind: 'observation', point: 8, image: 0 }), [1]);
  assert.deepEqual(shown({ kind: 'points', points: Uint32Array.of(8, 9) }), [1, 3]);
  assert.deepEqual(shown({ kind: 'image', image: 1 }), [2, 3]);
  assert.deepEqual(shown({ kind: 'pair', images: [1, 0] }), [0, 2]);
  // Of the three observations of the first point two take part.
  const view = {
    ...VIEW,
    surveyed: [],
    points: { ...VIEW.points, numbers: Uint32Array.of(1, 2, 3, 4, 5, 6, 7, 8, 9, 10), rays: Uint16Array.of(0, 0, 0, 0, 0, 0, 0, 2, 1, 1) },
  };
  const { columns } = observationRows(view, of);
  const row = (/** @type {number} */ i) => columns.map((/** @type {{ text: (row: number) => string }} */ { text: said }) => said(i));
  assert.deepEqual(row(0), ['a.jpg', '8', '0.00', '0.00', '0.30', '0.40', '0.50', '2', '0.25', '1.20', '2.40', '0.75', '−0.80', '1.50', 'accepted']);
  assert.deepEqual(row(2).slice(4), ['–', '–', '–', '2', ...new Array(6).fill('–'), 'rejected']);
});

test('an outline holds the points within it, whichever way it is drawn, and none of its bays or of those that are not kept', () => {
  const { pointsWithin } = page.points;
  // In the block y goes up, on the canvas down.
  const places = [1, -1, 5, -1, 3, -3, 9, -9, 3, -1, NaN, NaN];
  const points = { count: 6, positions: Float64Array.from(places.flatMap((_, i) => (i % 2 === 0 ? [places[i] ?? 0, places[i + 1] ?? 0, 0] : []))) };
  const t = { scale: 10, x: 0, y: 0 };
  const inside = (/** @type {number[][]} */ outline, keeps = all) => pointsWithin(points, keeps, t, outline);
  const bay = [
    [0, 0],
    [60, 0],
    [60, 40],
    [30, 20],
    [0, 40],
  ];
  assert.deepEqual(inside(bay), [0, 1, 4]);
  assert.deepEqual(inside([...bay].reverse()), [0, 1, 4]);
  assert.deepEqual(
    inside(bay, (/** @type {number} */ point) => point !== 1),
    [0, 4],
  );
  assert.deepEqual(inside([]), []);
});
