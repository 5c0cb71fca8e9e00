// @ts-check
/** Reading and writing files, with errors that name the file and what to change. */

import {
  closeSync,
  existsSync,
  fsyncSync,
  mkdirSync,
  openSync,
  readdirSync,
  readFileSync,
  readSync,
  realpathSync,
  renameSync,
  rmSync,
  statSync,
  writeFileSync,
  writeSync,
} from 'node:fs';
import { rename, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { IMAGE_FILE } from '../block/image-files.js';
import { textOf } from '../block/text-of.js';
import { bytesOfKind, START_BYTES } from '../block/refused-files.js';
import { message, Photo, refused_kind } from '../node.js';
import { about, DataError } from './errors.js';
import { note } from './output.js';
import { skippedTexts } from './skipped.js';

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

/** Why the system refused something, in words.  @param {unknown} error */
export function reasonOf(error) {
  const code = error instanceof Error && 'code' in error ? String(error.code) : '';
  return REASONS[code] ?? (code || String(error));
}

/** @template T @param {string} what @param {string} path @param {() => T} action @returns {T} */
export function attempt(what, path, action) {
  try {
    return action();
  } catch (error) {
    throw new DataError(`cannot ${what} ${path}: ${reasonOf(error)}`);
  }
}

/** @param {string} path @returns {Buffer} */
export const readBytes = (path) => attempt('read', path, () => readFileSync(path));

/**
 * A file that is read in parts, where they are needed: it may be larger than memory. What is no file, as a pipe, is read at once.
 * @param {string} path @returns {import('../node.js').FileInParts | Buffer}
 */
export function inParts(path) {
  const status = attempt('read', path, () => statSync(path));
  if (!status.isFile()) return readBytes(path);
  const { size } = status;
  attempt('read', path, () => closeSync(openSync(path, 'r')));
  return {
    size,
    read(at, length) {
      const bytes = new Uint8Array(length);
      const file = openSync(path, 'r');
      try {
        return bytes.subarray(0, readSync(file, bytes, 0, length, at));
      } finally {
        closeSync(file);
      }
    },
  };
}

/** @param {string} path @returns {string} */
export const readText = (path) => textOf(readBytes(path));

/** @param {string} path @returns {Photo} */
export function readPhoto(path) {
  const bytes = readBytes(path);
  return about(path, () => Photo.decode(bytes));
}

/** Grey values of a mask as large as the image that it belongs to.  @param {string} path @param {Photo} photo @returns {Uint8Array} */
export function readMask(path, photo) {
  const mask = readPhoto(path);
  const [own, image] = [mask, photo].map(({ width, height }) => `${width} x ${height} px`);
  if (own !== image) throw new DataError(`${path}: mask is ${own}; allowed: the image's ${image}`);
  return mask.grey();
}

/** @param {string} path */
export function isFolder(path) {
  return statSync(path, { throwIfNoEntry: false })?.isDirectory() ?? false;
}

/** Whether this is a file, or does not exist, which reading it says.  @param {string} path */
export const isFile = (path) => statSync(path, { throwIfNoEntry: false })?.isFile() ?? true;

/** @param {string} path */
export const exists = (path) => statSync(path, { throwIfNoEntry: false }) !== undefined;

/** The names of the files of a folder, in the order of their letters and of the numbers in them.  @param {string} path @returns {string[]} */
export function filesIn(path) {
  const entries = attempt('read the folder', path, () => readdirSync(path, { withFileTypes: true }));
  return entries
    .filter((entry) => !entry.isDirectory())
    .map(({ name }) => name)
    .sort(byNumbers);
}

/** Single images, and in place of folders the images in them.  @param {readonly string[]} given @returns {string[]} */
export const imagesOf = (given) => given.flatMap((one) => (isFolder(one) ? imagesIn(one) : [one]));

/** The images of a folder, one at least. Files of kinds that are not decoded, as HEIC, are noted.  @param {string} folder @returns {string[]} */
export function imagesIn(folder) {
  const all = filesIn(folder);
  const names = all.filter((name) => IMAGE_FILE.test(name));
  const unread = skippedTexts(
    all
      .filter((name) => !IMAGE_FILE.test(name))
      .flatMap((name) => {
        const refusal = refused_kind(name, startOf(join(folder, name)));
        return refusal === null ? [] : [{ name, reason: message('error', refusal) }];
      }),
  );
  if (names.length === 0) {
    const others = unread.length > 0 ? `; ${unread.join('; ')}` : '';
    throw new DataError(`${folder}: there is no image in this folder (JPEG, PNG, TIFF, BMP, WebP, PNM)${others}`);
  }
  for (const text of unread) note(text);
  return names.map((name) => join(folder, name));
}

/** The first bytes of a file, as many as tell its kind; none of what is no file, or cannot be read.  @param {string} path @returns {Uint8Array} */
function startOf(path) {
  try {
    // Reading a pipe would wait for whoever writes into it.
    if (!isFile(path)) return new Uint8Array();
    const file = inParts(path);
    if (Buffer.isBuffer(file)) return file;
    const start = file.read(0, START_BYTES);
    const bytes = bytesOfKind(start);
    return bytes > START_BYTES ? file.read(0, bytes) : start;
  } catch {
    return new Uint8Array();
  }
}

/** `photo_9` comes before `photo_10`.  @param {string} a @param {string} b */
function byNumbers(a, b) {
  const [left, right] = [a, b].map((text) => text.match(/\d+|\D+/g) ?? []);
  for (const [i, part] of (left ?? []).entries()) {
    const other = right?.[i] ?? '';
    // Numbers of any length: of two without leading zeros the longer one is larger.
    const [one, two] = [part, other].map((word) => (/^\d/.test(word) ? word.replace(/^0+(?=\d)/, '') : word));
    if (one === two || one === undefined || two === undefined) continue;
    const numbers = /^\d/.test(part) && /^\d/.test(other);
    if (numbers && one.length !== two.length) return one.length - two.length;
    return one < two ? -1 : 1;
  }
  return (left?.length ?? 0) - (right?.length ?? 0) || (a < b ? -1 : 1);
}

/** Makes a folder and what is missing above it, and says at once if that cannot be.  @param {string} path */
export function makeFolder(path) {
  attempt('write to the folder', path, () => makeParts(path));
}

/** Part by part: where the system refuses a folder as not there, as below /proc, `recursive` would try again without end.  @param {string} path */
function makeParts(path) {
  if (isFolder(path)) return;
  const above = dirname(path);
  if (above !== path) makeParts(above);
  try {
    mkdirSync(path);
  } catch (error) {
    // Made by another program in between, or named twice, as in `out/.`.
    if (!isFolder(path)) throw error;
  }
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

let drafts = 0;

/** A file beside another one that is being written, with the process that writes it. Its name is not longer where that is long.  @param {string} path */
const draftOf = (path) => join(dirname(path), `${++drafts}.tiepoint-${process.pid}.part`);

/** Waits until the disk has what was written to a file, or the names of a folder.  @param {string} path */
function toDisk(path) {
  const file = openSync(path, 'r');
  try {
    fsyncSync(file);
  } catch (error) {
    // Some systems do this for no folder.
    if (!isFolder(path)) throw error;
  } finally {
    closeSync(file);
  }
}

/**
 * Writes a file of any length whole or not at all: `write` appends to it, and gives the bytes that it begins with in place of the first ones. What a
 * command that was ended has left unfinished beside it goes.
 * @param {string} out @param {(append: (bytes: Uint8Array) => void) => Uint8Array} write
 */
export function writeInParts(out, write) {
  const path = existsSync(out) ? realpathSync(out) : out;
  const folder = dirname(path);
  for (const name of filesIn(folder)) removeIfUnfinished(join(folder, name));
  const draft = draftOf(path);
  const file = attempt('write', path, () => openSync(draft, 'w'));
  try {
    const put = (/** @type {Uint8Array} */ bytes, /** @type {number | null} */ at) =>
      attempt('write', path, () => {
        for (let done = 0; done < bytes.length; ) done += writeSync(file, bytes, done, bytes.length - done, at === null ? null : at + done);
      });
    put(
      write((bytes) => put(bytes, null)),
      0,
    );
    attempt('write', path, () => {
      fsyncSync(file);
      renameSync(draft, path);
      toDisk(folder);
    });
  } finally {
    closeSync(file);
    rmSync(draft, { force: true });
  }
}

/**
 * Writes a file whole or not at all, whatever ends the command or the machine.
 * @param {string} folder @param {string} name with slashes between folders, which are made @param {string | Uint8Array} content
 */
export function replaceInto(folder, name, content) {
  const path = join(folder, ...name.split('/'));
  makeFolder(dirname(path));
  const draft = draftOf(path);
  attempt('write', path, () => {
    try {
      writeFileSync(draft, content, { flush: true });
      renameSync(draft, path);
      toDisk(dirname(path));
    } finally {
      rmSync(draft, { force: true });
    }
  });
}

/**
 * As `replaceInto`, without waiting for the disk: for files that hold a checksum, so that a torn one is noticed.
 * @param {string} path @param {Uint8Array} content
 */
export async function replaceFile(path, content) {
  const draft = draftOf(path);
  try {
    await writeFile(draft, content);
    await rename(draft, path);
  } catch (error) {
    rmSync(draft, { force: true });
    throw new DataError(`cannot write ${path}: ${reasonOf(error)}`);
  }
}

/** Removes what commands that were ended have left unfinished below a folder.  @param {string} folder */
export function removeUnfinished(folder) {
  for (const name of attempt('read the folder', folder, () => readdirSync(folder, { recursive: true, encoding: 'utf8' }))) {
    removeIfUnfinished(join(folder, name));
  }
}

/** Removes a file if a command that was ended has left it unfinished.  @param {string} path */
function removeIfUnfinished(path) {
  const owner = /\.tiepoint-(\d+)\.part$/.exec(path)?.[1];
  if (owner !== undefined && !isRunning(Number(owner))) rmSync(path, { force: true });
}

/** Whether another process of this number runs.  @param {number} pid */
export function isRunning(pid) {
  try {
    process.kill(pid, 0);
    return pid !== process.pid;
  } catch (error) {
    return /** @type {NodeJS.ErrnoException} */ (error).code === 'EPERM';
  }
}
