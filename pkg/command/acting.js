// @ts-check
/** Options that are given and have no effect beside the others. */

import { note } from './output.js';

/**
 * Says which options have no effect beside the others, as those of moments where gradients are compared.
 * @param {readonly import('./options.js').Option[]} options that stand for settings @param {import('./args.js').Call['values']} values
 * @param {readonly string[]} acting the keys of the settings that act @param {string} [beside] what decides that beside other options, in words
 */
export function noteNotActing(options, values, acting, beside) {
  const keys = new Set(acting);
  const idle = options.filter(({ name, key = '', path }) => path !== undefined && values.has(name) && !keys.has(key));
  const others = beside === undefined ? 'the other options' : `the ${beside} and the other options`;
  if (idle.length > 0) note(`without effect with ${others}: ${idle.map(({ name }) => `--${name}`).join(', ')}`);
}
