/** So many bytes tell every kind of file but raw files of cameras. */
export const START_BYTES: number;

/** How many of the first bytes of a file tell its kind, by its first `START_BYTES`. */
export function bytesOfKind(start: Uint8Array): number;

/** The names of files by what is said of them, in the order in which these come first. */
export function byReason(files: readonly { name: string; reason: string }[]): Map<string, string[]>;
