/** Calls the `tiepoint` command, and makes the files the tests give it. */

import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after } from 'node:test';
import { fileURLToPath } from 'node:url';
import { grey_png } from '../../pkg/node.js';
import { caller } from './called.js';

export const PROGRAM = fileURLToPath(new URL('../../pkg/bin/tiepoint.js', import.meta.url));

/**
 * What Node runs the processes of the command with that live for a second or two, most of which it would spend on compiling the module once more,
 * optimised: only what runs for long is worth that here.
 */
export const NODE = ['--wasm-tiering-budget=100000000'];

/** @typedef {{ code: number | null, stdout: string, stderr: string }} Ended */

/** @type {((args: string[]) => Ended) | undefined} */
let called;

/** Calls the command within this process: each process of its own would read and compile the module anew.  @param {string[]} args @returns {Ended} */
export function tiepoint(...args) {
  called ??= caller(PROGRAM);
  return called(args);
}

/** Calls the command as a user does, as a process of its own: for what a process alone has.  @param {string[]} args @returns {Ended} */
export function asProcess(...args) {
  const { status, stdout, stderr } = spawnSync(process.execPath, [...NODE, PROGRAM, ...args], { encoding: 'utf8', maxBuffer: 1 << 28 });
  return { code: status, stdout, stderr };
}

/** Runs a call that must print one JSON object: a pair that is weak or not oriented is one too.  @param {string[]} args @returns {any} */
export function json(...args) {
  const { code, stdout, stderr } = tiepoint(...args, '--json');
  if (![0, 3, 4].includes(code ?? 1) || stderr !== '') throw new Error(`exit code ${code}: ${stderr}`);
  return JSON.parse(stdout);
}

/** A folder that goes when the tests end. */
export function folder() {
  const path = mkdtempSync(join(tmpdir(), 'tiepoint-'));
  after(() => rmSync(path, { recursive: true, force: true }));
  return path;
}

/** Writes a file.  @param {string} within @param {string} name @param {string | Uint8Array} content @returns {string} its path */
export function file(within, name, content) {
  const path = join(within, name);
  writeFileSync(path, content);
  return path;
}

/**
 * Writes a grey PNG whose pixel at col, row is `grey(col, row)`.
 * @param {string} within @param {string} name @param {number} width @param {number} height @param {(col: number, row: number) => number} grey
 */
export function image(within, name, width, height, grey) {
  const pixels = Uint8Array.from({ length: width * height }, (_, i) => grey(i % width, Math.floor(i / width)));
  return file(within, name, grey_png(width, height, pixels));
}

/** Grey values without order, the same at every call.  @param {number} col @param {number} row */
export function speckle(col, row) {
  let h = (col * 374761393 + row * 668265263) | 0;
  h = Math.imul(h ^ (h >>> 13), 1274126177);
  return (h ^ (h >>> 16)) & 0xff;
}

/** The built-in sample pair on disk.  @returns {{ at: string, call: string[] }} its folder, and the arguments that match it */
export function samplePair() {
  const at = folder();
  const { match } = json('sample', '--out', at);
  return { at, call: match.slice(1) };
}
