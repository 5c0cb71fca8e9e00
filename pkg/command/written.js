// @ts-check
/** The files that runs have written into a folder: those of earlier runs go, the user's own stay. */

import { createHash } from 'node:crypto';
import { appendFileSync, existsSync, readFileSync, rmdirSync, rmSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { DataError } from './errors.js';
import { makeFolder, readText, replaceInto } from './files.js';

/** Lines of digest and path: one for each file, written before the file itself. */
const LIST = 'work/written.txt';

/** @param {string | Uint8Array} content */
const digestOf = (content) => createHash('sha256').update(content).digest('hex');

export class Written {
  #out;
  /** What earlier runs wrote, by path.  @type {Map<string, string>} */
  #before = new Map();
  /** @type {Map<string, string>} */
  #now = new Map();

  /** @param {string} out the folder that receives the files */
  constructor(out) {
    this.#out = out;
    makeFolder(join(out, dirname(LIST)));
    if (!existsSync(join(out, LIST))) return;
    for (const line of readText(join(out, LIST)).split('\n')) {
      const [, digest = '', path = ''] = /^([0-9a-f]{64}) (.+)$/.exec(line) ?? [];
      if (path !== '') this.#before.set(path, digest);
    }
  }

  /** Refuses to write over a file that no run wrote.  @param {readonly string[]} paths with slashes, below the folder */
  refuseStrangers(paths) {
    const stranger = paths.find((path) => !this.#before.has(path) && !this.#now.has(path) && existsSync(join(this.#out, path)));
    if (stranger !== undefined) throw new DataError(`${join(this.#out, stranger)} is in the way: no run has written it; move it, or name another folder with --out`);
  }

  /** @param {string} path with slashes, below the folder @param {string} content */
  put(path, content) {
    this.refuseStrangers([path]);
    const digest = digestOf(content);
    this.#now.set(path, digest);
    // A run that is ended now has listed what it leaves.
    appendFileSync(join(this.#out, LIST), `${digest} ${path}\n`);
    replaceInto(this.#out, path, content);
  }

  /** Removes what earlier runs wrote and this one did not, but for files that were changed since, and folders that are empty then. */
  finish() {
    for (const [path, digest] of this.#before) {
      const file = join(this.#out, path);
      if (this.#now.has(path) || !existsSync(file) || digestOf(readFileSync(file)) !== digest) continue;
      rmSync(file);
      this.#removeEmpty(dirname(path));
    }
    const lines = [...this.#now].sort(([a], [b]) => (a < b ? -1 : 1)).map(([path, digest]) => `${digest} ${path}\n`);
    replaceInto(this.#out, LIST, lines.join(''));
  }

  /** @param {string} path */
  #removeEmpty(path) {
    if (path === '.') return;
    try {
      rmdirSync(join(this.#out, path));
    } catch {
      // It holds other files.
      return;
    }
    this.#removeEmpty(dirname(path));
  }
}
