/** What images and masks are read from, as the browser keeps it: each by itself, under a name that does not change. */
import type { Kept } from '../../shared/files/database';
import { nameOf, objectOf } from '../../shared/files/keepable';
import { say } from '../../shared/text/words';
import type { ImageSource } from '../state/data';
import type { KeptMask } from '../state/kept';
import type { MaskFile } from '../state/state';

export const FILE = 'pair/file/';

/** A source as a part of what is kept. */
export function keptSource(source: ImageSource): [part: string, kept: Kept] {
  return [FILE + nameOf(source), { value: source, bytes: bytesOf(source), alone: true }];
}

/** @throws Error where the file is not there */
export function sourceFrom(parts: ReadonlyMap<string, unknown>, file: string): ImageSource {
  const source = objectOf(parts.get(FILE + file), `file ${file}`) as unknown as ImageSource;
  if (source.kind === 'file' && !(source.file instanceof Blob)) throw new Error(say('an-image-is-damaged'));
  nameOf(source, file);
  return source;
}

export const keptMask = ({ name, source }: MaskFile): KeptMask => ({ name, file: nameOf(source) });

/** @throws Error where the file is not there */
export function maskFrom(parts: ReadonlyMap<string, unknown>, { name, file }: KeptMask): MaskFile {
  return { name, source: sourceFrom(parts, file) };
}

function bytesOf(source: ImageSource): number {
  switch (source.kind) {
    case 'file':
      return source.file.size;
    case 'grey':
      return source.grey.byteLength;
    case 'project':
      return 0;
  }
}
