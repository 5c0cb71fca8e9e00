/** Python with the packages of other programs, where it is there. */

import { spawnSync } from 'node:child_process';

/** What is asked for: `TIEPOINT_PYTHON` names another one. */
export const PYTHON = process.env.TIEPOINT_PYTHON ?? 'python3';

/** The reason why Python cannot import the packages, with how to install them; null where it can.  @param {Record<string, string>} packages each package by the name under which it is imported @returns {string | null} */
export function pythonLacks(packages) {
  if (spawnSync(PYTHON, ['-c', '']).error) return `there is no ${PYTHON} (TIEPOINT_PYTHON names another one)`;
  const missing = Object.entries(packages).flatMap(([module, name]) => (spawnSync(PYTHON, ['-c', `import ${module}`]).status === 0 ? [] : [name]));
  return missing.length === 0 ? null : `${PYTHON} lacks packages (pip install ${missing.join(' ')}; TIEPOINT_PYTHON names another Python)`;
}
