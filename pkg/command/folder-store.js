// @ts-check
/** Keeps records as files of a folder, each written whole or not at all. */

import { readdirSync, rmSync } from 'node:fs';
import { readFile, rename, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { DataError } from './errors.js';
import { makeFolder, reasonOf } from './files.js';

const ENDING = '.record';
const PARTS = ['features', 'likeness', 'pairs'];

export class FolderStore {
  #root;
  #written = 0;

  /** @param {string} root made where it is missing */
  constructor(root) {
    this.#root = root;
    for (const part of PARTS) {
      makeFolder(join(root, part));
      clean(join(root, part));
    }
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

  /** @param {string} key @param {Uint8Array} record */
  async put(key, record) {
    const path = this.#path(key);
    // Two images of the same content are of one record, which may be written twice at the same time.
    const unfinished = `${path}.${++this.#written}.${process.pid}.part`;
    try {
      await writeFile(unfinished, record);
      await rename(unfinished, path);
    } catch (error) {
      rmSync(unfinished, { force: true });
      throw new DataError(`cannot write ${path}: ${reasonOf(error)}`);
    }
  }

  /** @param {string} key */
  #path(key) {
    return join(this.#root, key + ENDING);
  }
}

/** Removes what runs that were broken off have left unfinished.  @param {string} folder */
function clean(folder) {
  for (const name of readdirSync(folder)) {
    const owner = /\.(\d+)\.part$/.exec(name)?.[1];
    if (owner !== undefined && !isRunning(Number(owner))) rmSync(join(folder, name), { force: true });
  }
}

/** @param {number} pid */
function isRunning(pid) {
  try {
    process.kill(pid, 0);
    return pid !== process.pid;
  } catch (error) {
    return /** @type {NodeJS.ErrnoException} */ (error).code === 'EPERM';
  }
}
