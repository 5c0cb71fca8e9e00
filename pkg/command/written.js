// @ts-check
/** The files that runs have written into a folder: those of earlier runs go, the user's own stay. */

import { createHash } from 'node:crypto';
import { appendFileSync, existsSync, readFileSync, renameSync, rmdirSync, rmSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { DataError } from './errors.js';
import { isFolder, makeFolder, readText, replaceInto } from './files.js';

/** Lines of check, digest and path: one for each file, written before the file itself. */
const LIST = 'work/written.txt';

/** @param {string | Uint8Array} content */
const digestOf = (content) => createHash('sha256').update(content).digest('hex');

/** @param {string} digest @param {string} path */
const lineOf = (digest, path) => `${digestOf(`${digest} ${path}`).slice(0, 16)} ${digest} ${path}\n`;

export class Written {
  #out;
  /** What earlier runs wrote, by path: more than one digest where a run was ended before it wrote what it had listed.  @type {Map<string, Set<string>>} */
  #before = new Map();
  /** @type {Map<string, string>} */
  #now = new Map();
  /** Files that were in the way when they were to be written, and what they are called since.  @type {{ path: string, kept: string }[]} */
  setAside = [];
  /** Lines of the list were torn: which files runs have written is not known in full. */
  #torn = false;

  /** @param {string} out the folder that receives the files */
  constructor(out) {
    this.#out = out;
    makeFolder(join(out, dirname(LIST)));
    if (!existsSync(join(out, LIST))) return;
    for (const line of readText(join(out, LIST))
      .split(/(?<=\n)/)
      .filter(Boolean)) {
      const [, digest = '', path = ''] = /^[0-9a-f]{16} ([0-9a-f]{64}) (.+)\n$/.exec(line) ?? [];
      if (line === lineOf(digest, path)) this.#before.set(path, (this.#before.get(path) ?? new Set()).add(digest));
      else this.#torn = true;
    }
  }

  /**
   * Refuses to write over files that no run wrote, and over those that were changed since. Where the list was torn these cannot be told
   * from files of a run: they are set aside when their turn comes.
   * @param {readonly string[]} paths with slashes, below the folder @param {readonly string[]} folders of which any file that a run wrote may be written again
   */
  refuseOthers(paths, folders) {
    if (this.#torn) return;
    const again = [...this.#before.keys()].filter((path) => folders.some((folder) => path.startsWith(`${folder}/`)));
    for (const path of [...paths, ...again]) {
      const reason = this.#objection(path);
      if (reason !== null) throw new DataError(`${join(this.#out, path)} is in the way: ${reason}; move it, or name another folder with --out`);
    }
  }

  /** Why a file is not to be written over; null where it may be.  @param {string} path @returns {string | null} */
  #objection(path) {
    const file = join(this.#out, path);
    if (!existsSync(file)) return null;
    if (isFolder(file)) return 'it is a folder';
    const known = this.#before.get(path);
    if (!known) return 'no run has written it';
    return known.has(digestOf(readFileSync(file))) ? null : 'it was changed since it was written';
  }

  /** What came in the way since the run began is set aside: what was computed is not given up for it.  @param {string} path with slashes, below the folder @param {string} content */
  put(path, content) {
    if (!this.#now.has(path) && this.#objection(path) !== null) this.#setAside(path);
    const digest = digestOf(content);
    this.#now.set(path, digest);
    // A run that is ended now has listed what it leaves.
    appendFileSync(join(this.#out, LIST), lineOf(digest, path), { flush: true });
    replaceInto(this.#out, path, content);
  }

  /** @param {string} path */
  #setAside(path) {
    const names = Array.from({ length: 1000 }, (_, i) => `${path}.mine${i === 0 ? '' : i + 1}`);
    const kept = names.find((name) => !existsSync(join(this.#out, name)));
    if (kept === undefined) throw new DataError(`${join(this.#out, path)} is in the way; move it, or name another folder with --out`);
    renameSync(join(this.#out, path), join(this.#out, kept));
    this.setAside.push({ path: join(this.#out, path), kept: join(this.#out, kept) });
  }

  /** Removes what earlier runs wrote and this one did not, but for files that were changed since, and folders that are empty then. */
  finish() {
    /** @type {[path: string, digest: string][]} */
    const changed = [];
    for (const [path, digests] of this.#before) {
      if (this.#now.has(path) || !existsSync(join(this.#out, path))) continue;
      if (this.#objection(path) !== null) {
        // Still known, so that a later run tells it from a file that was never written.
        for (const digest of digests) changed.push([path, digest]);
        continue;
      }
      rmSync(join(this.#out, path));
      this.#removeEmpty(dirname(path));
    }
    const lines = [...this.#now, ...changed].sort(([a], [b]) => (a < b ? -1 : 1)).map(([path, digest]) => lineOf(digest, path));
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
