/** Messages of the crate on the page: they name settings of the page, where those of the command name its options. */

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { before, test } from 'node:test';
import { block_parameters, block_settings, placing_parameters, positions_of_images } from '../pkg/node.js';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(page, await pageModules(['shared/text/messages', 'shared/text/names', 'shared/text/options']));
});

/** A message as the page writes it.  @param {string} text */
const written = (text) =>
  page.names.readable({ parameters: [...block_parameters(), ...placing_parameters()].map(page.options.optionInLanguage), flightParameters: [] }, text);

test('a problem of a table names the setting that is missing, not the option of the command', () => {
  const { placing } = block_settings({});
  /** @type {unknown} */
  let thrown = null;
  try {
    positions_of_images('image,easting,northing\na.jpg,446833.25,5594521.5\n', ['a.jpg'], placing);
  } catch (error) {
    thrown = error;
  }
  const text = written(page.messages.messageOf(thrown));
  assert.match(text, /, or a coordinate system of x and y \(Settings: “Coordinate system”\)$/);
});

test('settings are named in brackets and in sentences, with their values', () => {
  assert.equal(written('the zeros (--geoid, --geoid-m)'), 'the zeros (Settings: “Geoid”, “Height of the geoid”)');
  assert.equal(written('name it (--crs EPSG:4326), or'), 'name it (Settings: “Coordinate system” EPSG:4326), or');
  assert.equal(written('with another `--crs`'), 'with another “Coordinate system”');
  // With a mark of direction, as Arabic has it.
  assert.equal(written('\u200f--crs 25832'), '“Coordinate system” 25832');
  // What is no setting stays, and so do other brackets.
  assert.equal(written('a -- b (see --json) (p. 3)'), 'a -- b (see --json) (p. 3)');
});

test('no message of the crate names an option of the command on the page', () => {
  for (const language of ['en', 'ar']) {
    const catalogue = readFileSync(new URL(`../src/catalogue/${language}.ftl`, import.meta.url), 'utf8');
    const options = catalogue.split('\n').filter((line) => /--[a-z]/.test(line) && !line.startsWith('#'));
    assert.ok(options.length > 5);
    for (const line of options) assert.doesNotMatch(written(line), /--[a-z]/);
  }
});

test('of settings with the same label the one that a problem names is found, of several the first', () => {
  const parameters = [...block_parameters(), ...placing_parameters()].map(page.options.optionInLanguage);
  const named = (/** @type {string} */ text) => page.names.firstNamed(parameters, text)?.key ?? null;
  const labelled = (/** @type {string} */ label) => parameters.filter((parameter) => parameter.label === label).map(({ key }) => key);
  assert.deepEqual(labelled('Number of points'), ['multiscale.number', 'placing.points']);
  for (const key of [...labelled('Number of points'), ...labelled('Seed')]) assert.equal(named(`${key} is 0; allowed: 1 or more`), key);
  assert.equal(named('heights (--geoid-m) without a coordinate system (--crs)'), 'placing.geoid_m');
  assert.equal(named('not finished: positions.csv has no \u200f--crs'), 'placing.crs');
  assert.equal(named('Seed of plane.csv: --json is no setting'), null);
});
