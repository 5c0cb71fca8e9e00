/** The codes of points: the crate's rules, then what the page adds. Their order is the crate's `rule_names()`, which is checked at the start. */
import type { Rule } from '../../shared/crate';

const RULES = [
  'matched',
  'no_descriptor',
  'no_candidate',
  'threshold',
  'ambiguous',
  'many_to_one',
  'parallax',
  'border',
  'left_right',
  'not_converged',
  'imprecise',
  'frame',
] as const satisfies readonly Rule[];

/**
 * After the rules: a match that the adjustment rejected; a point that nothing was decided about, or a right point that no match uses; what the
 * user rejected and measured.
 */
export const CODES = [...RULES, 'gross_error', 'undecided', 'rejected_by_hand', 'manual'] as const;

export type CodeName = (typeof CODES)[number];

export function codeOf(name: CodeName): number {
  return CODES.indexOf(name);
}

export const MATCHED = codeOf('matched');
export const GROSS_ERROR = codeOf('gross_error');
export const UNDECIDED = codeOf('undecided');
export const BY_HAND = codeOf('rejected_by_hand');
export const MANUAL = codeOf('manual');

/** Beyond all codes: of a match that the filter leaves out, which no picture shows. */
export const LEFT_OUT = 255;

/** Codes of matches: whatever became of them, a user looks for them among the matches. */
export const OF_MATCHES: readonly number[] = [MATCHED, GROSS_ERROR, BY_HAND, MANUAL];

/** The rules that refuse, in the order in which the panel lists them. */
export const REFUSALS = RULES.filter((rule) => rule !== 'matched');

/** Throws where the page and the crate disagree on the rules: they are of different builds. */
export function checkRules(names: readonly string[]): void {
  if (names.length !== RULES.length || RULES.some((rule, i) => names[i] !== rule))
    throw new Error(`the page and the program do not fit each other: rules ${names.join(', ')}`);
}
