/** What a fresh machine lacks besides Rust: npm packages and Chromium. */

import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { ROOT } from './paths.mjs';
import { must, run } from './process.mjs';

/**
 * Installs the packages of a folder's package-lock.json unless exactly these are there.
 * @param {string} [folder] the project's root unless given
 */
export async function ensurePackages(folder = ROOT) {
  const lock = readFileSync(join(folder, 'package-lock.json'), 'utf8');
  const stamp = join(folder, 'node_modules', '.installed-lock.json');
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === lock) return;
  console.log(`installing the npm packages of ${relative(ROOT, join(folder, 'package-lock.json'))}`);
  await must(NPM, ['ci', '--no-audit', '--no-fund'], { cwd: folder, quiet: true });
  writeFileSync(stamp, lock);
}

export const NPM = process.platform === 'win32' ? 'npm.cmd' : 'npm';

const PLACES = [
  '/usr/bin/chromium',
  '/usr/bin/chromium-browser',
  '/usr/bin/google-chrome',
  '/snap/bin/chromium',
  '/Applications/Chromium.app/Contents/MacOS/Chromium',
  '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
];

/** The browser of this machine, or the one that CHROMIUM names.  @returns {string | null} */
export function findChromium() {
  const named = process.env.CHROMIUM;
  if (named) return existsSync(named) ? named : null;
  return PLACES.find((place) => existsSync(place)) ?? null;
}

/** Finds Chromium or installs Debian's.  @returns {Promise<{ path: string | null, reason: string }>} reason: why there is none */
export async function ensureChromium() {
  const found = findChromium();
  if (found) return { path: found, reason: '' };
  if (process.env.CHROMIUM) return { path: null, reason: `CHROMIUM names ${process.env.CHROMIUM}, which is not there` };
  if (!existsSync('/usr/bin/apt-get')) return { path: null, reason: 'install Chromium, or name its program in CHROMIUM' };
  const root = process.getuid?.() === 0;
  if (!root && (await run('sudo', ['-n', 'true'], { quiet: true })).code !== 0) {
    return { path: null, reason: 'run `sudo apt-get install chromium`, or name its program in CHROMIUM' };
  }
  console.log('installing Chromium with apt-get');
  const env = { DEBIAN_FRONTEND: 'noninteractive' };
  const apt = (/** @type {string[]} */ ...args) =>
    run(root ? 'apt-get' : 'sudo', root ? args : ['-n', '--preserve-env=DEBIAN_FRONTEND', 'apt-get', ...args], { env, quiet: true });
  await apt('update', '-q');
  const { code, output } = await apt('install', '-y', '-q', '--no-install-recommends', 'chromium');
  const path = findChromium();
  if (path) return { path, reason: '' };
  return { path: null, reason: `apt-get could not install chromium (${code}): ${output.trim().split('\n').at(-1)}` };
}
