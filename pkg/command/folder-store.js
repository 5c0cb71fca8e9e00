// @ts-check
/** Keeps records as files of a folder, each written whole or not at all. */

import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { DataError } from './errors.js';
import { makeFolder, reasonOf, replaceFile } from './files.js';

const ENDING = '.record';
const PARTS = ['features', 'likeness', 'pairs', 'windows'];

export class FolderStore {
  #root;

  /** @param {string} root made where it is missing */
  constructor(root) {
    this.#root = root;
    for (const part of PARTS) makeFolder(join(root, part));
  }

  /** @param {string} key @returns {Promise<Uint8Array | null>} */
  async get(key) {
    const path = this.#path(key);
    try {
      return await readFile(path);
    } catch (error) {
      if (/** @type {NodeJS.ErrnoException} */ (error).code === 'ENOENT') return null;
      throw new DataError(`cannot read ${path}: ${reasonOf(error)}`);
    }
  }

  /** Two images of the same content are of one record, which may be written twice at the same time.  @param {string} key @param {Uint8Array} record */
  async put(key, record) {
    await replaceFile(this.#path(key), record);
  }

  /** @param {string} key */
  #path(key) {
    return join(this.#root, key + ENDING);
  }
}
