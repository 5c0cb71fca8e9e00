/** What is said of a point by its code. */
import { CODES } from './codes';
import { say } from '../../shared/text/words';
import { message } from '../../shared/text/messages';

/** What the crate's catalogue does not know: edits are the page's. */
const EDITED = {
  rejected_by_hand: { text: say('matched-then-rejected-by-hand'), label: say('rejected-by-hand') },
  manual: { text: say('measured-by-hand'), label: say('measured-by-hand-2') },
} as const;

/** What a code says of a point: a sentence, or its label. */
export function textOfCode(code: number, part: 'text' | 'label' = 'text'): string {
  const name = CODES[code] ?? 'undecided';
  if (name === 'rejected_by_hand' || name === 'manual') return EDITED[name][part];
  return message('verdict', name, part === 'label' ? part : null);
}
