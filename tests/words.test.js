/** The page's own texts: each that it names stands in the catalogue with the figures that it gives, and none stands there for nothing. */

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const ROOT = fileURLToPath(new URL('..', import.meta.url));
const CATALOGUE = readFileSync(join(ROOT, 'src', 'catalogue', 'en.ftl'), 'utf8');
const WWW = join(ROOT, 'www');
const SOURCES = readdirSync(WWW, { recursive: true, encoding: 'utf8' })
  .filter((file) => file.endsWith('.ts'))
  .map((file) => readFileSync(join(WWW, file), 'utf8'))
  .join('\n');

/** Kinds of the page's texts in the catalogue, with what each writes. */
const entries = new Map(
  CATALOGUE.split(/^(?=[a-z-]+ =)/mu)
    .filter((entry) => entry.startsWith('page-'))
    .map((entry) => {
      const [, id = '', text = ''] = /^page-([a-z-]+) =([\s\S]*)$/u.exec(entry) ?? [];
      return [id.replaceAll('-', '_'), text];
    }),
);

test('every text that the page names stands in the catalogue', () => {
  const named = [...SOURCES.matchAll(/\bpage\(\s*'([a-z_]+)'\s*[,)]/gu)].map(([, kind = '']) => kind);
  assert.ok(named.length > 15, `only ${named.length} texts were found`);
  assert.deepEqual(
    named.filter((kind) => !entries.has(kind)),
    [],
  );
});

test('every text of the page is named by it, or by another text', () => {
  const unused = [...entries.keys()].filter((kind) => !SOURCES.includes(`'${kind}'`) && !CATALOGUE.includes(`{ page-${kind.replaceAll('_', '-')} }`));
  assert.deepEqual(unused, []);
});

test('the figures of a text are given where it is named', () => {
  const own = (/** @type {string} */ text) => [...text.matchAll(/\$([a-z0-9_]+)/gu)].map(([, name = '']) => name);
  const missing = [...entries].flatMap(([kind, text]) =>
    own(text)
      .filter((name) => !new RegExp(`\\b${name}\\b`, 'u').test(SOURCES))
      .map((name) => `${kind}: ${name}`),
  );
  assert.deepEqual(missing, []);
});
