/** The codes of points: the crate's rules, then what the page adds. Their order is the crate's `rule_names()`, which is checked at the start. */
import type { Rule } from '../engine/wasm';

const RULES = [
  'matched', 'no_descriptor', 'no_candidate', 'threshold', 'ambiguous', 'many_to_one', 'parallax', 'border', 'left_right', 'not_converged',
  'imprecise', 'frame',
] as const satisfies readonly Rule[];

/** After the rules: a match that the adjustment rejected; a point that nothing was decided about, or a right point that no match uses. */
export const CODES = [...RULES, 'gross_error', 'undecided'] as const;

export type CodeName = (typeof CODES)[number];

export function codeOf(name: CodeName): number {
  return CODES.indexOf(name);
}

export const MATCHED = codeOf('matched');
export const GROSS_ERROR = codeOf('gross_error');
export const UNDECIDED = codeOf('undecided');

/** The rules that refuse, in the order in which the panel lists them. */
export const REFUSALS = RULES.filter((rule) => rule !== 'matched');

/** Whether the page and the crate agree on the rules. */
export function sameRules(names: readonly string[]): boolean {
  return names.length === RULES.length && RULES.every((rule, i) => names[i] === rule);
}
