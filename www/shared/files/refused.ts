/** Files that cannot be used, told before anything is done with them, and said together where the reason is one. */
import { IMAGE_FILE } from '../../../pkg/block/image-files.js';
import { byReason, bytesOfKind, START_BYTES } from '../../../pkg/block/refused-files.js';
import { refused_kind } from '../crate';
import { sentence } from '../text/format';
import { message } from '../text/messages';
import { say } from '../text/words';

/** A file with why it cannot be used. */
export interface Refused {
  name: string;
  reason: string;
}

/** So many files are read at once: a folder may hold thousands. */
const AT_ONCE = 32;

/** So many files of one reason are named. */
const NAMED = 5;

/** Of these files those of kinds that are not decoded (HEIC, raw, films, …), each with why. */
export async function refusedKinds(files: readonly File[]): Promise<ReadonlyMap<File, string>> {
  const refused = new Map<File, string>();
  for (let first = 0; first < files.length; first += AT_ONCE) {
    const told = await Promise.all(files.slice(first, first + AT_ONCE).map(async (file) => [file, await refusedKind(file)] as const));
    for (const [file, reason] of told) if (reason !== null) refused.set(file, reason);
  }
  return refused;
}

async function refusedKind(file: File): Promise<string | null> {
  const start = await startOf(file, START_BYTES);
  const bytes = IMAGE_FILE.test(file.name) ? START_BYTES : bytesOfKind(start);
  const refusal = refused_kind(file.name, bytes > START_BYTES ? await startOf(file, bytes) : start);
  return refusal === null ? null : message('error', refusal);
}

/** The first bytes of a file; none of what cannot be read, which says why where it is used. */
async function startOf(file: File, length: number): Promise<Uint8Array> {
  const start = file.slice(0, length).arrayBuffer();
  return new Uint8Array(await start.catch(() => new ArrayBuffer(0)));
}

/** What is said of files of such kinds; nothing where there are none. */
export function kindsText(kinds: ReadonlyMap<File, string>): string {
  return refusedText([...kinds].map(([{ name }, reason]) => ({ name, reason })));
}

/** Each reason once, with the files that it holds for. */
export function refusedText(refused: readonly Refused[]): string {
  return [...byReason(refused)]
    .map(([reason, names]) => say('files-cannot-be-opened', { files: names.length, names: namesText(names), reason: sentence(reason) }))
    .join(' ');
}

/** The first names of a list, and how many more there are. */
export function namesText(names: readonly string[]): string {
  const first = names.slice(0, NAMED).join(say('comma-between-names'));
  const more = names.length - NAMED;
  return more > 0 ? say('names-and-more', { first, more }) : first;
}
