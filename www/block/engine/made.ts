/** The files that a block is saved as: one by itself, several as one archive. */
import { export_formats } from '../../../pkg/wasm/tiepoint.js';
import type { BlockWriting, Emit, FinishedBlock } from '../../../pkg/wasm/tiepoint.js';
import { Archive } from '../../shared/engine/archive';
import { LANGUAGE } from '../../shared/text/language';
import type { ExportKind, MadeFile } from './calls';

/** @throws Error with the crate's `code` where the block cannot be written so; the reason of the signal, which is looked at after each file */
export async function made(block: FinishedBlock, kind: ExportKind, name: string, signal: AbortSignal): Promise<MadeFile> {
  const files = new Map<string, string>();
  const write: Emit = (path, text) => files.set(path, text);
  if (kind === 'project') write(`${name}-project.tiepoint`, block.project());
  else if (kind === 'everything') await inSteps(block.files(export_formats(), null, LANGUAGE), write, signal);
  else if (kind === 'csv') await inSteps(block.files([], null, LANGUAGE), tablesTo(write), signal, () => files.size > 0);
  else block.export(kind, write);
  return packed(files, `${name}-${kind}`, signal);
}

/** The tables among all files: those of surveyed points and pairs too, and in the system of the results. */
function tablesTo(write: Emit): Emit {
  return (path, text) => {
    if (path.endsWith('.csv')) write(path, text);
  };
}

/** `isDone`: of a part of the files, whether all of it is written. */
async function inSteps(writing: BlockWriting, write: Emit, signal: AbortSignal, isDone = () => false): Promise<void> {
  try {
    while (writing.step(write) === null && !isDone()) await pause(signal);
  } finally {
    writing.free();
  }
}

/** Lets messages in, of which one may end it all. */
async function pause(signal: AbortSignal): Promise<void> {
  await new Promise((resolve) => setTimeout(resolve));
  signal.throwIfAborted();
}

async function packed(files: ReadonlyMap<string, string>, name: string, signal: AbortSignal): Promise<MadeFile> {
  const encoder = new TextEncoder();
  const [first, ...others] = files;
  if (first === undefined) throw new Error('the block gives no file in this format');
  const [path, text] = first;
  if (others.length === 0) {
    const plain = path.split('/').at(-1) ?? path;
    return { name: plain.startsWith(name.replace(/-[^-]*$/u, '')) ? plain : `${name}-${plain}`, type: 'text/plain', bytes: encoder.encode(text) };
  }
  const archive = new Archive();
  for (const [at, content] of files) {
    await pause(signal);
    archive.add(at, encoder.encode(content), false);
  }
  return { name: `${name}.zip`, type: 'application/zip', bytes: new Uint8Array(await archive.end().arrayBuffer()) };
}
