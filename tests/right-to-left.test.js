/** Texts that run from right to left: their parts go on as the sentence does, and units are in its letters. */

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { pageModules } from './www.js';

const ARABIC = readFileSync(new URL('../www/shared/text/ar/block.ftl', import.meta.url), 'utf8');
const { axes, catalogue, direction, format, plot_words, scale, units } = await pageModules([
  'shared/text/catalogue',
  'shared/text/direction',
  'shared/text/format',
  'shared/text/units',
  'block/state/scale',
  'block/state/plot-words',
  'block/view/plot/axes',
]);

const [LRI, RLI, FSI, PDI] = ['\u2066', '\u2067', '\u2068', '\u2069'];

/** The parts of a text that no strong letter of their own gives a direction: from left to right, whatever the sentence (UAX 9, P2 and P3).  @param {string} text */
function undirected(text) {
  /** @type {{ mark: string, at: number, own: string }[]} */
  const open = [];
  /** @type {string[]} */
  const found = [];
  for (const [at, letter] of [...text].entries()) {
    if ([LRI, RLI, FSI].includes(letter)) open.push({ mark: letter, at, own: '' });
    else if (letter === PDI) {
      const { mark = '', own = '' } = open.pop() ?? {};
      if (mark === FSI && !/\p{L}/u.test(own) && /[.;:،؛]/u.test(own)) found.push(own);
    } else for (const part of open.slice(-1)) part.own += letter;
  }
  return found;
}

test('how long a block took goes on as the sentence: its full stop stands after it, not beside that of the sentence before', () => {
  const texts = new catalogue.Catalogue('ar', true);
  texts.add([ARABIC]);
  for (const found of [null, 500])
    for (const skipped of [0, 3])
      for (const warnings of [0, 1, 2, 5, 20]) {
        const figures = { images: 8, verdict: '', skipped, pairs: 12, points: 100, found, time: '12 ث', warnings };
        const text = texts.text('block-done', figures);
        assert.deepEqual(undirected(text), ['.'], 'without marks for it');
        assert.deepEqual(undirected(direction.asClauses(text, true)), [], JSON.stringify(text));
      }
  // In English nothing is set apart.
  assert.equal(direction.asClauses(`a${FSI} b${PDI}`, false), `a${FSI} b${PDI}`);
});

test('a text whose words all stand in parts of their own runs as the language does, within another text too', () => {
  const part = (/** @type {string} */ text) => `${FSI}${text}${PDI}`;
  const step = `${part('رفض')} ${part(`${part('452')} مطابقة`)}`;
  assert.equal(direction.asClauses(`تراجع: ${part(step)}`, true), `تراجع: ${RLI}${step}${PDI}`);
  // Names and figures alone, and what has letters of its own, tell their direction themselves.
  for (const text of [part(`${part('a.jpg')} – ${part('b.jpg')}`), part(`a ${part('رفض')}`), part(part('452'))])
    assert.equal(direction.asClauses(text, true), text);
});

test('a value and its error are one figure from left to right, with their degree signs', () => {
  const text = `κ ${FSI}−16.21${PDI}° ± ${FSI}0.035${PDI}°؛ ${FSI}904${PDI} ±\u00a0${FSI}46${PDI} بكسل، ${FSI}12${PDI}°`;
  assert.equal(direction.asClauses(text, true), `κ ${LRI}−16.21° ± 0.035°${PDI}؛ ${LRI}904 ±\u00a046${PDI} بكسل، ${FSI}12°${PDI}`);
});

test('coordinates have their unit where the block has a scale', () => {
  const surveyed = (/** @type {string} */ role) => [{ role }];
  assert.equal(scale.inUnitOf({ origin: null, surveyed: [] }, '1 2 3'), '1 2 3');
  assert.equal(scale.inUnitOf({ origin: null, surveyed: surveyed('check') }, '1 2 3'), '1 2 3');
  assert.equal(scale.inUnitOf({ origin: null, surveyed: surveyed('control') }, '1 2 3'), '1 2 3 m');
  assert.equal(scale.inUnitOf({ origin: {}, surveyed: [] }, '1 2 3'), '1 2 3 m');
});

test('numbers of a sentence have a minus sign; hyphens of names and between digits stay', () => {
  assert.equal(format.withMinus('IMG-12.jpg: -19.51° ± 0.2°, 3-4, 2026-05-17'), 'IMG-12.jpg: −19.51° ± 0.2°, 3-4, 2026-05-17');
});

test('units have their signs in English', () => {
  assert.deepEqual(['px', 'm', '', '%', 'µm'].map(units.unitText), ['px', 'm', '', '%', 'µm']);
  assert.deepEqual([units.withUnit('−1.5', 'px'), units.withUnit('2', '')], ['−1.5 px', '2']);
  const data = { x: { label: 'x', unit: '', values: Float64Array.of(1) }, y: { label: 'y', unit: 'px', values: Float64Array.of(0.5) } };
  assert.match(plot_words.plotText(data), / px\.$/);
  assert.deepEqual([axes.titleOf(data.x), axes.titleOf(data.y)], ['x', 'y, px']);
});

test('in Arabic units are in its letters in heads, after figures, on axes and in files, and what a map says of its scale runs as a sentence of it', async () => {
  // As a worker is told its language.
  Object.assign(globalThis, { name: 'test ar' });
  const arabic = await pageModules([
    'shared/text/words',
    'shared/text/units',
    'shared/state/rows',
    'block/view/map/frame',
    'block/view/plot/axes',
    'block/state/plot-words',
  ]);
  Object.assign(globalThis, { name: '' });
  const files = ['www/shared/text/ar/block', 'src/catalogue/ar-options', 'www/shared/text/ar/pair', 'www/shared/text/ar/shared'];
  arabic.words.learn(files.map((file) => readFileSync(new URL(`../${file}.ftl`, import.meta.url), 'utf8')));
  const { unitText, withUnit } = arabic.units;
  assert.deepEqual(['px', 'm', 'cm', 'mm', 'µm', 'km', 'grey values', '°', '%', ''].map(unitText), [
    'بكسل',
    'م',
    'سم',
    'مم',
    'ميكرومتر',
    'كم',
    'قيم رمادية',
    '°',
    '%',
    '',
  ]);
  // The sign of a figure stays before its digits, and the unit comes after both.
  assert.deepEqual([withUnit('−1.5', 'px'), withUnit('−1.5', '°'), withUnit('3', '')], [`${RLI}${LRI}−1.5${PDI} بكسل${PDI}`, '−1.5 °', '3']);
  const title = arabic.axes.titleOf({ label: 'الصف', unit: 'px', values: new Float64Array() });
  assert.match(title.replaceAll(/[\u2066-\u2069]/gu, ''), /^الصف، بكسل$/u);
  // The unit stands after the last figure, and the full stop after the unit: the clause of the unit runs as its sentence does.
  const data = { x: { label: 'x', unit: '', values: Float64Array.of(1) }, y: { label: 'y', unit: 'px', values: Float64Array.of(0.5) } };
  assert.match(arabic.plot_words.plotText(data), new RegExp(`${PDI}${RLI}${RLI} ${PDI}${FSI}بكسل${PDI}${PDI}\\.$`, 'u'));
  // A canvas runs from left to right: what stands on it is set apart as a whole, and no word of it is in other letters.
  /** @type {string[]} */
  const written = [];
  const context = new Proxy({ fillText: (/** @type {string} */ text) => written.push(text) }, { get: (own, name) => Reflect.get(own, name) ?? (() => {}) });
  const colours = { ground: '', text: '' };
  for (const system of ['geographic', 'own']) arabic.frame.paintScale(context, colours, { scale: 1, tx: 0, ty: 0 }, 100, system, system === 'own' ? null : 1.4);
  assert.deepEqual(
    written.map((text) => text.replaceAll(/[\u2066-\u2069]/gu, '')),
    ['100 م', 'مسافة العينة الأرضية 1.4 م', '100 من وحدات الكتلة'],
  );
  for (const text of written) assert.ok(text.startsWith(RLI) && text.endsWith(PDI), text);
  // Files of what is shown.
  const column = { key: 'v', label: `${FSI}v${PDI}`, unit: 'px', help: '', value: () => 1, text: () => `${LRI}−1${PDI}` };
  assert.equal(arabic.rows.csvOf([column], [0]), 'v [بكسل]\n-1\n');
});
