// @ts-check
/** Plain text for a terminal: tables and wrapped paragraphs. */

import { programWords } from './program.js';

/**
 * Columns side by side: the first to the left, the others to the right.
 * @param {(string | number)[][]} rows @returns {string}
 */
export function table(rows) {
  const cells = rows.map((row) => row.map(String));
  const widths = cells[0]?.map((_, c) => Math.max(...cells.map((row) => row[c]?.length ?? 0))) ?? [];
  return cells
    .map((row) =>
      row
        .map((cell, c) => (c === 0 ? cell.padEnd(widths[c] ?? 0) : cell.padStart(widths[c] ?? 0)))
        .join('  ')
        .trimEnd(),
    )
    .join('\n');
}

/** Names are listed up to so many. */
const NAMED = 5;

/** The first names, and how many more there are.  @param {readonly string[]} names */
export const listed = (names) => names.slice(0, NAMED).join(', ') + (names.length > NAMED ? ` and ${names.length - NAMED} more` : '');

/** A number for reading.  @param {number | null | undefined} value @param {number} digits after the point @returns {string} */
export const fixed = (value, digits) => (value === null || value === undefined || Number.isNaN(value) ? '-' : value.toFixed(digits));

/** A number to four significant digits.  @param {number | null | undefined} value @returns {string} */
export const significant = (value) => (value === null || value === undefined || Number.isNaN(value) ? '-' : String(Number(value.toPrecision(4))));

/** @param {string} text @param {number} width @param {string} indent of every line @returns {string} */
export function wrap(text, width, indent = '') {
  /** @type {string[]} */
  const lines = [];
  for (const word of text.split(' ')) {
    const last = lines.at(-1);
    if (last !== undefined && indent.length + last.length + 1 + word.length <= width) lines[lines.length - 1] = `${last} ${word}`;
    else lines.push(word);
  }
  return lines.map((line) => indent + line).join('\n');
}

/**
 * A command of this program as a shell takes it, the program called as it is now.
 * @param {readonly string[]} words the name of the program and what follows it
 */
export const shellCommand = ([, ...words]) => [...programWords(process.argv[1] ?? '', process.cwd()), ...words].map(shellWord).join(' ');

/** A word as a shell takes it.  @param {string} word */
const shellWord = (word) => (/^[\w./,:=@%+-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);
