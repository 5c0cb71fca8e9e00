// @ts-check
/** Bytes that a host has given, in memory that belongs to this thread alone. */

import { message } from '../wasm/tiepoint.js';
import { kindOf } from './kind.js';

/**
 * The bytes themselves, or a copy where other threads may write to them: nothing makes a digest of such.
 * @param {unknown} given @returns {Uint8Array}
 */
export function ownBytes(given) {
  switch (kindOf(given)) {
    case 'Uint8Array':
    case 'Uint8ClampedArray': {
      const { buffer, byteOffset, byteLength } = /** @type {Uint8Array} */ (given);
      const bytes = new Uint8Array(buffer, byteOffset, byteLength);
      return kindOf(buffer) === 'SharedArrayBuffer' ? bytes.slice() : bytes;
    }
    case 'ArrayBuffer':
      return new Uint8Array(/** @type {ArrayBuffer} */ (given));
    default: {
      const error = { kind: 'invalid-argument', what: 'bytes', got: kindOf(given), wanted: 'Uint8Array' };
      throw new TypeError(message('error', error));
    }
  }
}
