// @ts-check
/** Reading and writing files, with errors that name the file and what to change. */

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { Photo } from '../node.js';
import { about, DataError } from './errors.js';

/** @type {Record<string, string>} */
const REASONS = {
  ENOENT: 'there is no such file or folder',
  EISDIR: 'it is a folder; name a file',
  EACCES: 'permission is denied',
  EPERM: 'permission is denied',
  ENOTDIR: 'a part of the path is a file, not a folder',
  EEXIST: 'a file of that name is in the way',
  ENOSPC: 'the disk is full',
  EROFS: 'the disk cannot be written to',
  ERR_FS_FILE_TOO_LARGE: 'the file is larger than 2 GiB',
};

/** @template T @param {string} what @param {string} path @param {() => T} action @returns {T} */
function attempt(what, path, action) {
  try {
    return action();
  } catch (error) {
    const code = error instanceof Error && 'code' in error ? String(error.code) : '';
    throw new DataError(`cannot ${what} ${path}: ${REASONS[code] ?? (code || String(error))}`);
  }
}

/** @param {string} path @returns {Buffer} */
export const readBytes = (path) => attempt('read', path, () => readFileSync(path));

/** @param {string} path @returns {string} */
export const readText = (path) => readBytes(path).toString('utf8').replace(/^\ufeff/, '');

/** @param {string} path @returns {Photo} */
export function readPhoto(path) {
  const bytes = readBytes(path);
  return about(path, () => Photo.decode(bytes));
}

/** Makes a folder if it is not there, and says at once if nothing can be written to it.  @param {string} path */
export function makeFolder(path) {
  attempt('write to the folder', path, () => mkdirSync(path, { recursive: true }));
}

/**
 * @param {string} folder @param {string} name @param {string | Uint8Array} content
 * @returns {string} the file's path
 */
export function writeInto(folder, name, content) {
  const path = join(folder, name);
  attempt('write', path, () => writeFileSync(path, content));
  return path;
}
