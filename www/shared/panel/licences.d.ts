/** What `tools/lib/licences.mjs` gives to the page. */
declare module 'virtual:licences' {
  /** The packages that the page holds. */
  export const LICENCES: readonly { name: string; version: string; licence: string; text: string }[];
  /** The crates of its module, by name and version; `text` is the place of a text in `texts`. */
  export const CRATES: { crates: readonly { name: string; version: string; licence: string; text: number }[]; texts: readonly string[] };
}
