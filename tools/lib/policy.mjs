/** The content-security policies: all that is not named is forbidden. */

const COMMON = ["default-src 'none'", "base-uri 'none'", "form-action 'none'", "require-trusted-types-for 'script'", 'trusted-types tiepoint'];

/** The page on a host: its own files and nothing else. */
export const WEB_POLICY = [
  ...COMMON,
  "script-src 'self' 'wasm-unsafe-eval'",
  "style-src 'self'",
  "img-src 'self' blob: data:",
  "connect-src 'self'",
  "worker-src 'self'",
  "manifest-src 'self'",
].join('; ');

/**
 * The page in one file: the very script and style it was built with, nothing from anywhere.
 * @param {string} scriptHash @param {string} styleHash as in `sha256-…`
 */
export const singlePolicy = (scriptHash, styleHash) =>
  [...COMMON, `script-src '${scriptHash}' 'wasm-unsafe-eval'`, `style-src '${styleHash}'`, 'img-src blob: data:', 'worker-src blob:'].join('; ');

/** What a server adds; these two cannot stand in the page. */
export const SERVER_POLICY = `${WEB_POLICY}; frame-ancestors 'none'`;
