/** What a fresh machine lacks besides Rust: npm packages, Chromium and Firefox. */

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

/**
 * @typedef {object} Browser
 * @property {string} name as people call it @property {string} variable of the environment that names its program
 * @property {string} debian the package that has it @property {string[]} places of its program
 */

/** @type {Browser} */
const CHROMIUM = {
  name: 'Chromium',
  variable: 'CHROMIUM',
  debian: 'chromium',
  places: [
    '/usr/bin/chromium',
    '/usr/bin/chromium-browser',
    '/usr/bin/google-chrome',
    '/snap/bin/chromium',
    '/Applications/Chromium.app/Contents/MacOS/Chromium',
    '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
  ],
};

/** The same engine without what belongs to windows, which takes processor time in every test of the page.  @type {Browser} */
const HEADLESS_CHROMIUM = { name: 'Chromium', variable: 'CHROMIUM', debian: 'chromium-headless-shell', places: ['/usr/bin/chromium-headless-shell'] };

/** Not the one of a snap, which sees no profile that a test makes: of its places /usr/bin/firefox alone is known, which leads there.  @type {Browser} */
const FIREFOX = {
  name: 'Firefox',
  variable: 'FIREFOX',
  debian: 'firefox-esr',
  places: [
    '/usr/bin/firefox-esr',
    '/usr/lib/firefox/firefox',
    '/usr/lib64/firefox/firefox',
    '/opt/firefox/firefox',
    '/Applications/Firefox.app/Contents/MacOS/firefox',
  ],
};

/** The program of this machine, or the one that the environment names.  @param {Browser} browser @returns {string | null} */
function find({ variable, places }) {
  const named = process.env[variable];
  if (named) return existsSync(named) ? named : null;
  return places.find((place) => existsSync(place)) ?? null;
}

export const findChromium = () => find(CHROMIUM);
/** What tests need no more than. */
export const findHeadlessChromium = () => find(HEADLESS_CHROMIUM) ?? find(CHROMIUM);
export const findFirefox = () => find(FIREFOX);

/** Finds the browser or installs Debian's.  @param {Browser} browser @returns {Promise<{ path: string | null, reason: string }>} reason: why there is none */
async function ensure(browser) {
  const { name, variable, debian } = browser;
  const found = find(browser);
  if (found) return { path: found, reason: '' };
  if (process.env[variable]) return { path: null, reason: `${variable} names ${process.env[variable]}, which is not there` };
  if (!existsSync('/usr/bin/apt-get')) return { path: null, reason: `install ${name}, or name its program in ${variable}` };
  const root = process.getuid?.() === 0;
  if (!root && (await run('sudo', ['-n', 'true'], { quiet: true })).code !== 0) {
    return { path: null, reason: `run \`sudo apt-get install ${debian}\`, or name its program in ${variable}` };
  }
  console.log(`installing ${name} with apt-get`);
  const env = { DEBIAN_FRONTEND: 'noninteractive' };
  const apt = (/** @type {string[]} */ ...args) =>
    run(root ? 'apt-get' : 'sudo', root ? args : ['-n', '--preserve-env=DEBIAN_FRONTEND', 'apt-get', ...args], { env, quiet: true });
  await apt('update', '-q');
  const { code, output } = await apt('install', '-y', '-q', '--no-install-recommends', debian);
  const path = find(browser);
  if (path) return { path, reason: '' };
  return { path: null, reason: `apt-get could not install ${debian} (${code}): ${output.trim().split('\n').at(-1)}` };
}

export const ensureChromium = () => ensure(CHROMIUM);
/** What tests need no more than; a Chromium that is there will do. */
export async function ensureHeadlessChromium() {
  if (findHeadlessChromium() === null) await ensure(HEADLESS_CHROMIUM);
  return find(HEADLESS_CHROMIUM) ? ensure(HEADLESS_CHROMIUM) : ensure(CHROMIUM);
}
export const ensureFirefox = () => ensure(FIREFOX);
