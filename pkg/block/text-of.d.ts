/** The text of a file, without the mark that may stand before it: in UTF-16 where it is marked so, else in UTF-8 where it can be. */
export function textOf(bytes: Uint8Array): string;
