/**
 * Firefox as systems install it, driven over WebDriver BiDi: the Firefox that Playwright drives by a protocol of its own is a build of its own. Playwright
 * speaks the newest BiDi; what an installed Firefox does not know of it is answered here.
 */

import { firefox } from 'playwright-core';
import { findFirefox } from '../../tools/lib/setup.mjs';
import { hosted } from '../page/page.js';

const program = findFirefox();

/** Why the tests cannot run; false where they can. */
export const SKIP = program ? false : `skipped: no Firefox (${process.env.NO_FIREFOX || 'install it or name it in FIREFOX'})`;

/** Starts Firefox and the server for the tests of a file.  @param {string} prefix the folder below which the page lies */
export const hostedInFirefox = (prefix) => hosted(prefix, program === null ? null : () => launch(program));

/** The colours that a system prefers, which Playwright asks for in each context. */
const PREFERENCES = 'emulation.setMediaFeaturesOverride';

/**
 * @typedef {{ id?: number, type?: string, method?: string, error?: string, result?: object, params?: Record<string, unknown> }} Message
 * @typedef {{ send: (message: Message) => void, onmessage?: (message: Message) => void }} Transport
 * @typedef {{ _connection: { toImpl: (browser: object) => { _connection: { _transport: Transport } } } }} Inner what Playwright does not show
 */

/** How long it may take to start, on a loaded machine. */
const START_MS = 120_000;

/** Starts it without a window.  @param {string} executablePath */
async function launch(executablePath) {
  const browser = await firefox.launch({ executablePath, channel: 'moz-firefox', timeout: START_MS });
  const transport = /** @type {Inner} */ (/** @type {unknown} */ (browser))._connection.toImpl(browser)._connection._transport;
  const send = transport.send.bind(transport);
  const receive = transport.onmessage;
  /** @type {Set<number | undefined>} */
  const preferences = new Set();
  transport.send = (message) => {
    if (message.method === PREFERENCES) preferences.add(message.id);
    send(message);
  };
  transport.onmessage = (message) => {
    const isUnknown = message.type === 'error' && message.error === 'unknown command' && preferences.has(message.id);
    receive?.(isUnknown ? { id: message.id, type: 'success', result: {} } : named(message));
  };
  return browser;
}

/** A download that has no name yet, by which Playwright tells downloads apart, has its address for one.  @param {Message} message @returns {Message} */
function named(message) {
  if (!/^browsingContext\.download(?:WillBegin|End)$/.test(message.method ?? '')) return message;
  const { params = {} } = message;
  return { ...message, params: { ...params, navigation: params.navigation ?? params.url } };
}

/** Types into a field key by key: what Playwright fills in at once is no input of a user to Firefox.  @param {import('playwright-core').Locator} field @param {string} text */
export async function type(field, text) {
  await field.selectText();
  await field.pressSequentially(text);
  await field.press('Enter');
}
