// @ts-check
/** Options that are given and have no effect beside the others. */

import { acting_parameters } from '../node.js';
import { note } from './output.js';

/**
 * Says which options have no effect beside the others, as those of moments where gradients are compared.
 * @param {readonly import('./options.js').Option[]} options that stand for settings @param {import('./args.js').Call['values']} values
 * @param {import('../node.js').PairSettings} settings @param {string} beside what decides that, in words
 */
export function noteNotActing(options, values, settings, beside) {
  const acting = new Set(acting_parameters(settings));
  const idle = options.filter(({ name, key = '', path }) => path !== undefined && values.has(name) && !acting.has(key));
  if (idle.length > 0) note(`without effect with the ${beside} and the other options: ${idle.map(({ name }) => `--${name}`).join(', ')}`);
}
