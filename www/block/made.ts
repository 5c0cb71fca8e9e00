/** The files that a block is saved as: one by itself, several as one archive. */
import { zipSync } from 'fflate';
import type { Zippable } from 'fflate';
import { PROJECT_FILE, writeBlock } from '../../pkg/block/index.js';
import { export_block, export_formats, write_project } from '../../pkg/wasm/tiepoint.js';
import type { ExportKind, MadeFile } from './calls';
import type { Held } from './outcome';

/** The time in archives: that of their making would give the same block other bytes. */
const TIME = '1980-01-01T00:00:00';

/** @throws Error with the crate's `code` where the block cannot be written so */
export function made({ run, project }: Held, kind: ExportKind, name: string): MadeFile {
  const files = new Map<string, string>();
  const write = (path: string, text: string) => { files.set(path, text); };
  if (kind === 'project') write(`${name}-${PROJECT_FILE}`, write_project(project));
  else if (kind !== 'everything') export_block(project.block, kind, write);
  else if (run !== null) writeBlock(run, export_formats(), write);
  else throw new Error('a block that was opened has no run behind it: run it again to save everything');
  return packed(files, `${name}-${kind}`);
}

function packed(files: ReadonlyMap<string, string>, name: string): MadeFile {
  const encoder = new TextEncoder();
  const [first, ...others] = files;
  if (first === undefined) throw new Error('the block gives no file in this format');
  const [path, text] = first;
  if (others.length === 0) {
    const plain = path.split('/').at(-1) ?? path;
    return { name: plain.startsWith(name.replace(/-[^-]*$/u, '')) ? plain : `${name}-${plain}`, type: 'text/plain', bytes: encoder.encode(text) };
  }
  const entries: Zippable = Object.fromEntries([...files].map(([at, content]) => [at, encoder.encode(content)]));
  return { name: `${name}.zip`, type: 'application/zip', bytes: zipSync(entries, { level: 6, mtime: TIME }) };
}
