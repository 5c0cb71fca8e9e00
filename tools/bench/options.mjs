/** Options of parts of the bench: `--photos=40` behind their names. */

/** @param {string} name @param {number} otherwise @returns {number} */
export function numberOption(name, otherwise) {
  const given = process.argv.find((word) => word.startsWith(`--${name}=`))?.slice(name.length + 3);
  if (given === undefined) return otherwise;
  const value = Number(given);
  if (Number.isInteger(value) && value > 0) return value;
  console.error(`--${name} is ${given || 'empty'}; allowed: whole numbers from 1`);
  process.exit(2);
}

/** @param {string} name @returns {string | null} null where it is not given */
export function textOption(name) {
  return process.argv.find((word) => word.startsWith(`--${name}=`))?.slice(name.length + 3) || null;
}
