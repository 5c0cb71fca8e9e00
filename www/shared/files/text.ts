/** Texts of files as spreadsheets save them. */
import { textOf } from '../../../pkg/block/text-of.js';

/** The text of a file in the encoding that it has. */
export async function textIn(file: Blob): Promise<string> {
  return textOf(new Uint8Array(await file.arrayBuffer()));
}
