/** What a block was made of, as its project file says: the file begins with it, and ends with the part of a geoid, where one was given. */
import type { FinishedBlock, RunInput } from '../../../pkg/wasm/tiepoint.js';

export interface ProjectInput {
  input: RunInput;
  /** The part of its geoid about the block, as a file of the format GTX; null where none was given. */
  geoid: Uint8Array<ArrayBuffer> | null;
}

const BEGINNING = '{"block":{"input":';
const GEOID = ',"geoid":';
/** What closes block and file behind the geoid. */
const END = /\}\}\s*$/u;
/** No part of a geoid is longer. */
const LONGEST_GEOID = 1 << 24;
const [LINE_END, QUOTE, BACKSLASH, OPENS, CLOSES] = [...'\n"\\{}'].map((sign) => sign.charCodeAt(0));

/** `file`: from which the block was opened. */
export function projectInputOf(file: Uint8Array, block: FinishedBlock): ProjectInput {
  // A file of an earlier version says less, in another order: it is brought forward.
  const bytes = startOf(file) === null ? new TextEncoder().encode(block.project()) : file;
  const start = startOf(bytes);
  if (start === null) throw new Error('no input is held');
  const input = JSON.parse(new TextDecoder().decode(bytes.subarray(start, endOfObject(bytes, start)))) as RunInput;
  return { input, geoid: input.geoid === undefined ? null : geoidOf(bytes) };
}

/** Where the input begins; null in a file that does not begin with it. */
function startOf(bytes: Uint8Array): number | null {
  const line = bytes.indexOf(LINE_END ?? 0) + 1;
  const start = line + BEGINNING.length;
  return new TextDecoder().decode(bytes.subarray(line, start)) === BEGINNING ? start : null;
}

/** A large block is not read whole for its first kilobytes. */
function endOfObject(bytes: Uint8Array, start: number): number {
  let depth = 0;
  let quoted = false;
  for (let at = start; at < bytes.length; at++) {
    const sign = bytes[at];
    if (quoted && sign === BACKSLASH) at++;
    else if (sign === QUOTE) quoted = !quoted;
    else if (!quoted && sign === OPENS) depth++;
    else if (!quoted && sign === CLOSES && --depth === 0) return at + 1;
  }
  return bytes.length;
}

interface Geoid {
  south_west_deg: [number, number];
  step_deg: [number, number];
  columns: number;
  heights_m: number[];
}

function geoidOf(bytes: Uint8Array): Uint8Array<ArrayBuffer> | null {
  const tail = new TextDecoder().decode(bytes.subarray(-LONGEST_GEOID));
  const at = tail.lastIndexOf(`${GEOID}{`);
  return at < 0 ? null : gtxOf(JSON.parse(tail.slice(at + GEOID.length).replace(END, '')) as Geoid);
}

/** NOAA VDatum, GTX: latitude and longitude of the south-west node, steps of both, numbers of rows and columns, heights row by row from the south; big-endian. */
function gtxOf({ south_west_deg: [west, south], step_deg: [east, north], columns, heights_m: heights }: Geoid): Uint8Array<ArrayBuffer> {
  const HEAD = 40;
  const file = new DataView(new ArrayBuffer(HEAD + 4 * heights.length));
  for (const [i, degrees] of [south, west, north, east].entries()) file.setFloat64(8 * i, degrees);
  for (const [i, count] of [heights.length / columns, columns].entries()) file.setInt32(32 + 4 * i, count);
  for (const [i, height] of heights.entries()) file.setFloat32(HEAD + 4 * i, height);
  return new Uint8Array(file.buffer);
}
