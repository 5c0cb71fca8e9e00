/** The page's own texts: each that it names stands in the catalogue with the figures that it gives, none stands there for nothing, and no other is in the code. */

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { FluentBundle, FluentResource } from '@fluent/bundle';
import { englishIn } from './english.js';
import { saidIn } from './syntax.js';

const ROOT = fileURLToPath(new URL('..', import.meta.url));
const WWW = join(ROOT, 'www');
const TEXTS = join(WWW, 'shared', 'text');
const SOURCES = new Map(
  readdirSync(WWW, { recursive: true, encoding: 'utf8' })
    .filter((file) => file.endsWith('.ts') && !file.endsWith('.d.ts'))
    .map((file) => [file.replaceAll('\\', '/'), readFileSync(join(WWW, file), 'utf8')]),
);
const PAGE = readFileSync(join(WWW, 'index.html'), 'utf8');
const ALL = [...SOURCES.values(), PAGE].join('\n');

/** The texts that the code says by name, with their figures and files. */
const SAID = [...SOURCES].flatMap(([file, code]) => saidIn(file, code).map((said) => ({ file, ...said })));

/** The texts that the document says by name. */
const MARKED = [...PAGE.matchAll(/\bdata-say(?:-[a-z]+)?="([a-z0-9-]+)"/gu)].map(([, name = '']) => name);

const CRATE = join(ROOT, 'src', 'catalogue');

/** The files of a language in the folder of the page, one after the other.  @param {string} language */
const ofPage = (language) => readdirSync(join(TEXTS, language)).map((file) => readFileSync(join(TEXTS, language, file), 'utf8'));

/** The options of the crate in Arabic, which page and reports say: their English stands where they are declared. */
const OPTIONS = readFileSync(join(CRATE, 'ar-options.ftl'), 'utf8');

/** All that the page says in a language.  @param {string} language */
const catalogueOf = (language) => [...ofPage(language), ...(language === 'ar' ? [OPTIONS] : [])];

/** The entries of a language by their names, each as it is written.  @param {string} language */
function entriesOf(language) {
  const parts = catalogueOf(language).flatMap((text) => text.split(/^(?=[a-z#])/mu).filter((entry) => /^[a-z]/u.test(entry)));
  return parts.map((entry) => /** @type {const} */ ([entry.slice(0, entry.indexOf(' =')), entry.slice(entry.indexOf(' =') + 2)]));
}

const entries = new Map(entriesOf('en'));

/** Errors that no action of a user reaches: what a fault of the program reports to who looks for it. */
const FAULTS = new Set([
  'the page has no element "{}"',
  'the block gives no file in this format',
  'no mosaic is laid out',
  'no orthophoto is given',
  'there is no {} image',
  'no image is open in this worker',
  'no block is held',
  'no input is held',
  'no canvas can be drawn on here',
  'a project does not hold its images',
  'no pair is held in this worker',
  'these candidates lie around an expected place',
  'no report is begun in this worker',
  'the stage {} has no result',
  'the settings are not loaded',
  'the matches are of other points',
  'no interior orientation is known',
  'these images have no truth',
  'the program names no flight',
  'the page and the program do not fit each other: rules {}',
  'no style for code {}',
  'the image is no longer shown',
  '{} is no script of this page',
]);

/** Names that only the program reads: of workers, records and messages between scripts. */
const NAMES = new Set(['points {}', 'point {}', 'line {}', 'placing {}', 'level {}', 'file {}', 'placed {}', 'pool {}', 'take over', 'Files']);

/** Files for other programs are English in every language. */
const FOR_PROGRAMS = new Set(['pair/files/export.ts']);

test('no text for people stands in the code', () => {
  const found = [...SOURCES].filter(([file]) => !FOR_PROGRAMS.has(file)).flatMap(([file, code]) => englishIn(file, code).map((one) => ({ file, ...one })));
  const left = found.filter(({ text }) => !FAULTS.has(text) && !NAMES.has(text));
  assert.deepEqual(
    left.map(({ file, line, text }) => `${file}:${String(line)}: ${text}`),
    [],
  );
  const told = new Set(found.map(({ text }) => text));
  assert.deepEqual(
    [...FAULTS, ...NAMES].filter((text) => !told.has(text)),
    [],
    'exceptions that nothing needs',
  );
});

test('a text for people is found wherever it is put', () => {
  const planted = [
    "h('p', {}, 'vectors')",
    "button('Save', 'save', act)",
    "button(say('save'), 'save', act, 'Saves it')",
    `host.title = \`\${name} was saved\``,
    "const NAMES = { left: 'Left image' }",
    "h('div', { aria: { label: 'images' } })",
    "fill(line, isOld ? 'earlier' : '')",
    `throw new Error(\`\${name} cannot be read\`)`,
    "const text = done ? 'Copied' : 'Not copied'",
    "declare({ where: say('map'), host, list: [{ keys: ['n'], does: 'chooses', run }] })",
    "word('state', 'State of it')",
  ];
  for (const code of planted) assert.equal(englishIn('planted.ts', code).length > 0, true, code);
  const others = [
    "h('p', { class: 'is-open', testid: 'a-b' }, say('save'))",
    "if (kind === 'Left image') run('left')",
    "import { a } from './The file'",
    "button('CSV', 'x', y)",
  ];
  for (const code of others) assert.deepEqual(englishIn('other.ts', code), [], code);
});

test('every text that the page names stands in the catalogue', () => {
  const named = [...SAID.map(({ name }) => name), ...MARKED];
  assert.ok(named.length > 1000, `only ${named.length} texts were found`);
  assert.deepEqual(
    named.filter((name) => !entries.has(name)),
    [],
  );
});

test('a text that is said without the block stands in a file that is loaded without it', () => {
  const block = new Set([...readFileSync(join(TEXTS, 'en', 'block.ftl'), 'utf8').matchAll(/^([a-z0-9][a-z0-9-]*) =/gmu)].map(([, name]) => name));
  const named = [...SAID.filter(({ file }) => !file.startsWith('block/')).map(({ name }) => name), ...MARKED];
  assert.deepEqual(
    named.filter((name) => block.has(name)),
    [],
  );
});

test('every text of the page is named by it, or by another text', () => {
  const texts = [...entries.values()].join('\n');
  const unused = [...entries.keys()].filter((name) => !ALL.includes(`'${name}'`) && !ALL.includes(`"${name}"`) && !texts.includes(`{ ${name} }`));
  assert.deepEqual(unused, []);
});

test('the figures of a text are given where it is named', () => {
  const own = (/** @type {string} */ text) => [...text.matchAll(/\$([a-z0-9_]+)/gu)].map(([, name = '']) => name);
  const missing = SAID.flatMap(({ file, name, figures }) => {
    const given = new Set(figures ?? own(entries.get(name) ?? ''));
    return own(entries.get(name) ?? '').flatMap((figure) => (given.has(figure) ? [] : [`${file}: ${name} without ${figure}`]));
  });
  assert.deepEqual(missing, []);
  assert.deepEqual(saidIn('planted.ts', "say(isLong ? 'a' : 'b', { one, two: 2 })"), [
    { name: 'a', figures: ['one', 'two'] },
    { name: 'b', figures: ['one', 'two'] },
  ]);
  // Where figures are handed on as a whole they are looked for by their names.
  const elsewhere = new Set(entries.keys());
  for (const { name, figures } of SAID) if (figures !== null) elsewhere.delete(name);
  const unknown = [...elsewhere].flatMap((name) => own(entries.get(name) ?? '').filter((figure) => !new RegExp(`\\b${figure}\\b`, 'u').test(ALL)));
  assert.deepEqual(unknown, []);
});

test('the document says the same in English before the program is there', () => {
  const page = readFileSync(join(WWW, 'index.html'), 'utf8').replaceAll(/<kbd>([^<]*)<\/kbd>/gu, '[$1]');
  const marks = [...page.matchAll(/<[^>]*\sdata-say[^>]*>([^<]*)/gu)].flatMap(([element, text]) =>
    [...element.matchAll(/data-say(?:-([a-z]+))?="([^"]*)"/gu)].map(([, attribute, name = '']) => {
      const written = attribute === undefined ? text : new RegExp(`\\s(?:aria-)?${attribute}="([^"]*)"`, 'u').exec(element)?.[1];
      return /** @type {const} */ ([name, written, ` ${entries.get(name)?.trim() ?? ''}`]);
    }),
  );
  assert.ok(marks.length > 40, `only ${marks.length} texts were found`);
  for (const [name, written, text] of marks) assert.equal(` ${written ?? ''}`, text, name);
});

test('a catalogue has each name once, and all of it can be read', () => {
  for (const language of ['en', 'ar']) {
    const names = entriesOf(language).map(([name]) => name);
    assert.deepEqual(
      names.filter((name, i) => names.indexOf(name) !== i),
      [],
      language,
    );
    const read = catalogueOf(language).flatMap((text) => new FluentResource(text).body.map(({ id }) => id));
    assert.deepEqual(
      names.filter((name) => !read.includes(name)),
      [],
      language,
    );
  }
});

/**
 * What a pattern writes by: its figures, functions with their options, and texts that it refers to.
 * @param {any} element @returns {string[]}
 */
function writtenBy(element) {
  if (element === null || typeof element !== 'object') return [];
  if (Array.isArray(element)) return element.flatMap(writtenBy);
  const { type, name, args, selector, variants, value } = element;
  if (type === 'var') return [`$${name}`];
  if (type === 'mesg') return [name];
  if (type === 'func') return [`${name}(${JSON.stringify(args)})`, ...writtenBy(args)];
  if (type === 'select') return [...writtenBy(selector), ...writtenBy(variants)];
  return writtenBy(value);
}

/** The texts of catalogues, attributes by their names, with what each writes by.  @param {readonly string[]} catalogues */
function textsOf(catalogues) {
  const messages = catalogues.flatMap((text) => new FluentResource(text).body);
  const written = messages.flatMap(({ id, value, attributes }) => [
    /** @type {const} */ ([id, value]),
    ...Object.entries(attributes).map(([name, pattern]) => /** @type {const} */ ([`${id}.${name}`, pattern])),
  ]);
  return Object.fromEntries(written.map(([name, pattern]) => [name, [...new Set(writtenBy(pattern))].sort()]));
}

const ofCrate = (/** @type {string} */ language) => [language, `${language}-report`].map((name) => readFileSync(join(CRATE, `${name}.ftl`), 'utf8'));

test('both languages have the same texts, of the same figures', () => {
  assert.deepEqual(textsOf(ofPage('ar')), textsOf(ofPage('en')), 'of the page');
  assert.deepEqual(textsOf(ofCrate('ar')), textsOf(ofCrate('en')), 'of the crate');
});

test('every text can be written in both languages, with any number', () => {
  const functions = Object.fromEntries(
    ['COUNT', 'NTH', 'FIXED', 'AMOUNT', 'SIGNIFICANT', 'POWER', 'PERCENT', 'SIGN', 'HEX', 'LIKE'].map((name) => [name, () => '1']),
  );
  for (const language of ['en', 'ar'])
    for (const catalogues of [catalogueOf(language), ofCrate(language)]) {
      const bundle = new FluentBundle(language, { functions });
      for (const text of catalogues) assert.deepEqual(bundle.addResource(new FluentResource(text)), []);
      const texts = textsOf(catalogues);
      for (const [name, figures] of Object.entries(texts)) {
        const [id = '', attribute] = name.split('.');
        const message = bundle.getMessage(id);
        const pattern = attribute === undefined ? message?.value : message?.attributes[attribute];
        for (const number of pattern ? [0, 1, 2, 5, 11, 100] : []) {
          /** @type {Error[]} */
          const errors = [];
          const named = [...figures, ...figures.flatMap((figure) => texts[figure] ?? [])].filter((figure) => figure.startsWith('$'));
          const given = Object.fromEntries(named.map((figure) => [figure.slice(1), number]));
          bundle.formatPattern(pattern ?? '', given, errors);
          assert.deepEqual(errors, [], `${language} ${name} with ${String(number)}`);
        }
      }
    }
});

test('every option of the crate has its texts in Arabic', async () => {
  const crate = await import('../pkg/node.js');
  const options = [crate.parameters, crate.block_parameters, crate.flight_parameters, crate.block_flight_parameters, crate.placing_parameters];
  const texts = textsOf(catalogueOf('ar'));
  const wanted = options
    .flatMap((list) => list())
    .flatMap((option) => {
      const name = option.key.replaceAll(/[._]/gu, '-');
      const values = option.kind === 'choice' ? option.values.map((value) => `${name}.${value}`) : [];
      return [
        name,
        `${name}.help`,
        ...(option.absent === '' ? [] : [`${name}.absent`]),
        `section-${option.section.toLowerCase().replaceAll(' ', '-')}`,
        ...(/^[a-z]{3,}/u.test(option.unit) ? [`unit-${option.unit.replaceAll(' ', '-')}`] : []),
        ...values,
      ];
    });
  assert.deepEqual(
    wanted.filter((name) => !(name in texts)),
    [],
  );
});
