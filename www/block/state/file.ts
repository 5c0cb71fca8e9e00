/** Files that a block was given. */

/** An image file of a block. */
export interface BlockFile {
  /** Differs for every file ever given. */
  id: number;
  /** No two of a block have the same. */
  name: string;
  file: Blob;
}

/** A file that was read as text. */
export interface TextFile {
  name: string;
  text: string;
}
