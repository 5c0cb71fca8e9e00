/** What `tools/lib/licences.mjs` gives to the page. */
declare module 'virtual:licences' {
  /** The packages that the page holds. */
  export const LICENCES: readonly { name: string; version: string; licence: string; text: string }[];
}
