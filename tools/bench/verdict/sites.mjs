/** Which pairs thresholds may be chosen by, and which judge them: whole sites go one way, so that no ground is on both sides. */

/** @typedef {'fit' | 'judge'} Part whether thresholds may be chosen by pairs of a site */

/** Sites by a word of the names of their folders: some sites have several. */
const SITES = ['caliterra', 'lewis', 'seneca', 'graf', 'fountain', 'motorcycle', 'arches', 'garfield', 'canberra', 'kh9'];
const FITTED = ['caliterra', 'lewis', 'seneca', 'graf'];

/** @param {string} folder of photographs @returns {{ site: string, part: Part }} */
export function ofFolder(folder) {
  const site = SITES.find((word) => folder.split('_').includes(word)) ?? folder;
  return { site, part: FITTED.includes(site) ? 'fit' : 'judge' };
}

/** @param {number} seed of a simulated ground @returns {{ site: string, part: Part }} */
export const ofSeed = (seed) => ({ site: `seed ${seed}`, part: seed % 2 === 0 ? 'fit' : 'judge' });
