/** Settings of one's own, saved and taken from a file. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { block_parameters, block_settings, defaults, parameters } from '../pkg/node.js';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(page, await pageModules(['shared/panel/own', 'shared/panel/settings', 'block/state/own-settings']));
});

const read = (/** @type {any} */ content, of = 'pair') => page.own.readOwn(JSON.stringify(content), of, parameters(), defaults());

test('a file holds what differs from the defaults, and gives the same settings again', () => {
  const { writeOwn, readOwn } = page.own;
  const { withSetting } = page.settings;
  const own = withSetting(withSetting(defaults(), 'matching.strategy', 'moments'), 'points.fraction', 0.2);
  const text = writeOwn('pair', parameters(), defaults(), own);
  assert.deepEqual(JSON.parse(text), { tiepoint_settings: 'pair', changed: { 'points.fraction': 0.2, 'matching.strategy': 'moments' } });
  assert.deepEqual(readOwn(text, 'pair', parameters(), defaults()), own);
  assert.deepEqual(readOwn(writeOwn('pair', parameters(), defaults(), defaults()), 'pair', parameters(), defaults()), defaults());
});

test('what is no file of such settings is refused, with what is wrong', () => {
  const changed = (/** @type {any} */ one) => ({ tiepoint_settings: 'pair', changed: one });
  assert.throws(() => page.own.readOwn('{', 'pair', parameters(), defaults()), /holds no settings/);
  assert.throws(() => read({ changed: [] }), /holds no settings/);
  assert.throws(() => read(changed({}), 'block'), /settings of a pair, not of a block/);
  assert.throws(() => read(changed({ 'points.colour': 1 })), /no setting points\.colour/);
  for (const one of [{ 'points.fraction': 7 }, { 'points.fraction': 'all' }, { 'matching.strategy': 'magic' }, { 'matching.strategy': true }])
    assert.throws(() => read(changed(one)), /is not allowed/);
});

test('of a block a file also holds whether GNSS positions are used', () => {
  const { ownSettings, optionsOfOwn, USE_GNSS } = page.own_settings;
  const settings = block_settings({});
  const all = [...block_parameters(), USE_GNSS];
  const normal = ownSettings(settings, 'use');
  const text = page.own.writeOwn('block', all, normal, ownSettings(settings, 'ignore'));
  assert.deepEqual(JSON.parse(text), { tiepoint_settings: 'block', changed: { 'recorded.gnss': false } });
  assert.deepEqual(optionsOfOwn(page.own.readOwn(text, 'block', all, normal)), { settings, gps: 'ignore' });
  assert.deepEqual(optionsOfOwn(normal), { settings, gps: 'use' });
});
