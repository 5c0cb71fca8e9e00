/** The content-security policies: all that is not named is forbidden. */

import { createHash } from 'node:crypto';

/** @param {string | Buffer} content @returns {string} the hash by which a policy names an inline element, and a page a file */
export const hash = (content) => `sha256-${createHash('sha256').update(content).digest('base64')}`;

/** The hash of the one script that stands in the page itself, before anything is drawn.  @param {string} page */
const hashOfOwn = (page) => hash(/<script>(.*?)<\/script>/s.exec(page)?.[1] ?? '');

const COMMON = ["default-src 'none'", "base-uri 'none'", "form-action 'none'", "require-trusted-types-for 'script'", 'trusted-types tiepoint'];

/** The page on a host: its own files and nothing else.  @param {string} page */
export const webPolicy = (page) =>
  [
    ...COMMON,
    `script-src 'self' '${hashOfOwn(page)}' 'wasm-unsafe-eval'`,
    "style-src 'self'",
    "img-src 'self' blob: data:",
    "connect-src 'self'",
    "worker-src 'self'",
    "manifest-src 'self'",
  ].join('; ');

/**
 * The page in one file: the very scripts and style it was built with, nothing from anywhere.
 * @param {string} page @param {string} script @param {string} style
 */
export function singlePolicy(page, script, style) {
  const scripts = `script-src '${hashOfOwn(page)}' '${hash(script)}' 'wasm-unsafe-eval'`;
  return [...COMMON, scripts, `style-src '${hash(style)}'`, 'img-src blob: data:', 'worker-src blob:'].join('; ');
}

/** What a server says, which adds what cannot stand in the page.  @param {string} page */
export const serverPolicy = (page) => `${webPolicy(page)}; frame-ancestors 'none'`;
