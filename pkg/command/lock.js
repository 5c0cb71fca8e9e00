// @ts-check
/** The lock of a block's folder: two runs on one folder would compute everything twice and write into each other's files. */

import { linkSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { hostname } from 'node:os';
import { join } from 'node:path';
import { DataError } from './errors.js';
import { attempt, isRunning, makeFolder } from './files.js';

const LOCK = 'work/lock.txt';

/**
 * Takes the folder for this process, or says which one has it. The lock of a process that does not run any more is taken over.
 * @param {string} out made where it is missing @returns {() => void} gives the folder back
 */
export function lockFolder(out) {
  makeFolder(join(out, 'work'));
  const path = join(out, LOCK);
  const own = `process ${process.pid} on ${hostname()}\n`;
  if (!taken(path, own)) {
    const other = read(path);
    const [, pid, host] = /^process (\d+) on (.*)\n$/.exec(other) ?? [];
    // Whether a process of another machine runs is not known here.
    const runs = host !== hostname() || isRunning(Number(pid));
    if (runs || !removed(path, other) || !taken(path, own)) {
      throw new DataError(
        `${out} is in use: ${read(path).trim() || 'another process'} works on it; wait for it, name another folder with --out, or remove ${path} if no such process runs`,
      );
    }
  }
  const release = () => {
    process.off('exit', release);
    if (read(path) === own) rmSync(path, { force: true });
  };
  process.on('exit', release);
  return release;
}

/** Makes the lock with its content at once; false where there is one.  @param {string} path @param {string} content */
function taken(path, content) {
  const draft = `${path}.${process.pid}`;
  return attempt('write', path, () => {
    try {
      writeFileSync(draft, content);
      linkSync(draft, path);
      return true;
    } catch (error) {
      const { code } = /** @type {NodeJS.ErrnoException} */ (error);
      if (code === 'EEXIST') return false;
      // Some disks of cameras and sticks have no links: then the file may be seen before its content is there.
      if (code !== 'EPERM' && code !== 'ENOTSUP' && code !== 'ENOSYS') throw error;
      return created(path, content);
    } finally {
      rmSync(draft, { force: true });
    }
  });
}

/** @param {string} path @param {string} content */
function created(path, content) {
  try {
    writeFileSync(path, content, { flag: 'wx' });
    return true;
  } catch (error) {
    if (/** @type {NodeJS.ErrnoException} */ (error).code === 'EEXIST') return false;
    throw error;
  }
}

/** Removes the lock if it still is the one that was read: a third process may have taken it over first.  @param {string} path @param {string} content */
function removed(path, content) {
  const aside = `${path}.left-${process.pid}`;
  try {
    renameSync(path, aside);
  } catch {
    return false;
  }
  if (read(aside) !== content) {
    renameSync(aside, path);
    return false;
  }
  rmSync(aside);
  return true;
}

/** @param {string} path */
function read(path) {
  try {
    return readFileSync(path, 'utf8');
  } catch {
    return '';
  }
}
