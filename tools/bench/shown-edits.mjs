/** How many edits a page shows. */

/**
 * The history lists those about the present state alone: each entry is named by how many edits hold there.
 * @param {readonly string[]} current the test ids of entries that are the present state @param {string} history its own test id
 */
export function editsShown(current, history) {
  const [id] = current.filter((name) => name.startsWith(`${history}-`));
  return Number(id?.slice(history.length + 1) ?? 0);
}
