// @ts-check
/** What is said of files that are skipped. */

/** So many files of one reason are named. */
const NAMED = 5;

/** Files that are skipped, each reason once with the first names that it holds for.  @param {readonly { name: string, reason: string }[]} skipped @returns {string[]} */
export function byReason(skipped) {
  /** @type {Map<string, string[]>} */
  const of = new Map();
  for (const { name, reason } of skipped) of.set(reason, [...(of.get(reason) ?? []), name]);
  return [...of].map(([reason, names]) => {
    const more = names.length > NAMED ? ` and ${names.length - NAMED} more` : '';
    const files = `${names.slice(0, NAMED).join(', ')}${more}`;
    return names.length === 1 ? `${files} is skipped: ${reason}` : `${names.length} files are skipped (${files}): ${reason}`;
  });
}
