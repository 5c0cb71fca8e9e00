/** Files that cannot be used, told before anything is done with them, and said together where the reason is one. */
import { IMAGE_FILE } from '../../../pkg/block/image-files.js';
import { refused_kind } from '../crate';
import { sentence } from '../text/format';
import { message } from '../text/messages';
import { say } from '../text/words';

/** A file with why it cannot be used. */
export interface Refused {
  name: string;
  reason: string;
}

/** So many bytes tell every kind but raw files, whose first directory of a TIFF stands within more of them. */
const [FEW_BYTES, MORE_BYTES] = [64, 1 << 16];

/** So many files of one reason are named. */
const NAMED = 5;

/** Of these files those of kinds that are not decoded (HEIC, raw, films, …), each with why. */
export async function refusedKinds(files: readonly File[]): Promise<ReadonlyMap<File, string>> {
  const told = await Promise.all(files.map(async (file) => [file, await refusedKind(file)] as const));
  return new Map(told.flatMap(([file, reason]) => (reason === null ? [] : [[file, reason]])));
}

async function refusedKind(file: File): Promise<string | null> {
  const length = IMAGE_FILE.test(file.name) ? FEW_BYTES : MORE_BYTES;
  // What cannot be read says why where it is used.
  const start = await file
    .slice(0, length)
    .arrayBuffer()
    .catch(() => new ArrayBuffer(0));
  const refusal = refused_kind(file.name, new Uint8Array(start));
  return refusal === null ? null : message('error', refusal);
}

/** Files by their reasons, in the order in which these come first. */
export function byReason(refused: readonly Refused[]): Map<string, string[]> {
  const names = new Map<string, string[]>();
  for (const { name, reason } of refused) names.set(reason, [...(names.get(reason) ?? []), name]);
  return names;
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
