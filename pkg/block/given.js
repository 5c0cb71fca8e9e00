// @ts-check
/** What a run of a block is given, refused before anything is begun; what the crate takes of it the crate refuses. */

import { call_parameters, message } from '../wasm/tiepoint.js';
import { kindOf } from './kind.js';
import { errorOf } from './wire.js';

/** @typedef {import('./types.js').RunOptions} RunOptions @typedef {import('./types.js').Surroundings} Surroundings */

/** @type {readonly (keyof RunOptions)[]} */
const OPTIONS = ['settings', 'cameras', 'gps', 'control', 'masks', 'strayMasks', 'geoid', 'positions', 'onOrthophoto'];

/** @param {readonly import('./types.js').Source[]} sources @param {RunOptions} options @param {Surroundings} surroundings */
export function checkGiven(sources, options, surroundings) {
  if (!isObject(options)) refuse('options', options, 'object');
  const unknown = Object.keys(options).find((name) => !OPTIONS.includes(/** @type {any} */ (name)));
  if (unknown !== undefined) refuseField(unknown);
  const { cameras, gps, masks, strayMasks, geoid, positions, onOrthophoto } = options;
  if (isGiven(cameras)) {
    if (!isObject(cameras)) refuse('cameras', cameras, '{ name, text }');
    checkType('cameras.text', /** @type {any} */ (cameras).text, 'string');
  }
  if (gps !== undefined && gps !== 'use' && gps !== 'ignore') refuse('gps', gps, 'use, ignore');
  if (strayMasks !== undefined && strayMasks !== 'refuse' && strayMasks !== 'list') refuse('strayMasks', strayMasks, 'refuse, list');
  if (onOrthophoto !== undefined && typeof onOrthophoto !== 'boolean') refuse('onOrthophoto', onOrthophoto, 'true, false');
  if (isGiven(positions)) checkType('positions', positions, 'string');
  checkSources('images', sources);
  checkSources('masks', masks ?? []);
  if (isGiven(geoid)) checkSource('geoid', geoid);
  if (!isObject(surroundings)) refuse('surroundings', surroundings, '{ pool, store }');
  const { pool, store } = surroundings;
  if (typeof pool?.run !== 'function') refuse('pool', pool, '{ size, run }');
  const allowed = allowedWorkers();
  if (!Number.isInteger(pool.size) || pool.size < allowed.min || pool.size > allowed.max) refuse('pool.size', pool.size, allowed);
  if (typeof store?.get !== 'function' || typeof store.put !== 'function') refuse('store', store, '{ get, put }');
}

/** @param {string} field @param {readonly import('./types.js').Source[]} sources */
function checkSources(field, sources) {
  if (!Array.isArray(sources)) refuse(field, sources, '[{ name, bytes }]');
  sources.forEach((source, index) => {
    checkSource(`${field}[${index}]`, source);
  });
}

/** @param {string} field @param {unknown} source */
function checkSource(field, source) {
  if (!isObject(source)) refuse(field, source, '{ name, bytes }');
  const { name, bytes } = /** @type {any} */ (source);
  checkType(`${field}.name`, name, 'string');
  checkType(`${field}.bytes`, bytes, 'function');
}

/** Refuses a value of another type.  @param {string} field @param {unknown} value @param {'string' | 'function'} type */
function checkType(field, value, type) {
  if (typeof value !== type) refuse(field, isObject(value) || !isGiven(value) ? value : `${shown(value)} (${typeof value})`, type);
}

/** How many threads the command takes as well. */
function allowedWorkers() {
  const workers = call_parameters().find(({ key }) => key === 'workers');
  if (workers?.kind !== 'integer') throw new Error('the crate says no range of workers');
  return workers;
}

/** @param {unknown} value @returns {value is object} */
const isObject = (value) => typeof value === 'object' && value !== null;

const isGiven = (/** @type {unknown} */ value) => value !== undefined && value !== null;

/**
 * @param {string} field @param {unknown} got @param {string | { min: number, max: number }} allowed words of what is allowed, or a range of whole numbers
 * @returns {never}
 */
function refuse(field, got, allowed) {
  const words = typeof allowed === 'string' ? { kind: 'words', words: allowed } : { kind: 'integer', min: allowed.min, max: allowed.max, odd: false };
  throwRefusal('invalid-option', { kind: 'invalid-option', field, got: shown(got), allowed: words });
}

/** @param {string} field @returns {never} */
function refuseField(field) {
  throwRefusal('invalid-json', {
    kind: 'invalid-json',
    document: { kind: 'named', name: 'options' },
    json_fault: { kind: 'value', field, json_slip: { kind: 'unknown_field', known: OPTIONS.join(', ') }, line: null, column: null },
  });
}

/** Throws what the crate throws where it refuses an option.  @param {string} code @param {{ kind: string, [figure: string]: unknown }} error @returns {never} */
function throwRefusal(code, error) {
  throw errorOf({ name: 'TiepointError', message: message('error', error), code, usage: true, error });
}

/** A value in a few words; null, which reads as absent, where there is none.  @param {unknown} value */
function shown(value) {
  if (!isGiven(value)) return null;
  if (Array.isArray(value)) return `[${value.length}]`;
  if (!isObject(value)) return String(value);
  return kindOf(value) === 'Object' ? `{ ${Object.keys(value).join(', ')} }` : kindOf(value);
}
