/** What is said of a point by its code. */
import { message } from '../../shared/crate';
import { CODES } from './codes';

/** What the crate's catalogue does not know: edits are the page's. */
const EDITED = {
  rejected_by_hand: { text: 'Matched, then rejected by hand.', label: 'Rejected by hand' },
  manual: { text: 'Measured by hand.', label: 'Measured by hand' },
} as const;

/** What a code says of a point: a sentence, or its label. */
export function textOfCode(code: number, part: 'text' | 'label' = 'text'): string {
  const name = CODES[code] ?? 'undecided';
  if (name === 'rejected_by_hand' || name === 'manual') return EDITED[name][part];
  return message('verdict', name, part === 'label' ? part : null);
}
