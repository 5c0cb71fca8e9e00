/** What is done by hand in a pair, and in pairs that are not on the page: the journal of its edits, and the match that is being measured. */
import type { Kept } from '../../shared/files/database';
import { doneFrom, Journal as Edits } from '../../shared/files/journal';
import { likeOf, listOf, objectOf, orNull } from '../../shared/files/keepable';
import type { Shelved, State } from '../state/state';
import { say } from '../../shared/text/words';
import { bytesOf, draftFrom, editFrom, OF_MATCH } from './edit';

const DRAFT = 'pair/draft';
/** What is done in pairs that are not on the page. */
const SHELF = 'pair/shelf';

export class Journal {
  private readonly edits = new Edits('pair/edits', editFrom, bytesOf);

  /** What is kept of it; what has not changed is the same value as before. Nothing where there is none. */
  parts({ history, draft, shelf }: Pick<State, 'history' | 'draft' | 'shelf'>): Map<string, Kept> {
    const parts = this.edits.parts(history);
    if (draft !== null) parts.set(DRAFT, { value: draft, bytes: OF_MATCH });
    if (shelf.size > 0) parts.set(SHELF, { value: shelf, bytes: [...shelf.values()].reduce((sum, other) => sum + this.edits.size(other.edits) + OF_MATCH, 0) });
    return parts;
  }

  /** @throws Error naming what is damaged */
  read(parts: ReadonlyMap<string, unknown>): Pick<State, 'history' | 'draft' | 'shelf'> {
    return { history: this.edits.read(parts), draft: orNull(parts.get(DRAFT), (draft) => draftFrom(draft, 'draft')), shelf: shelfFrom(parts.get(SHELF)) };
  }
}

function shelfFrom(value: unknown): State['shelf'] {
  if (value === undefined) return new Map();
  if (!(value instanceof Map)) throw new Error(say('the-edits-of-other-pairs'));
  const entry = ([key, kept]: [unknown, unknown]): [string, Shelved] => {
    const { edits, done, draft } = objectOf(kept, 'shelf');
    const list = listOf(edits, 'shelf.edits', editFrom);
    const own = { edits: list, done: doneFrom(done, list.length, 'shelf.done') };
    // Earlier releases kept none.
    return [likeOf(key, '', 'shelf'), { ...own, draft: orNull(draft, (given) => draftFrom(given, 'shelf.draft')) }];
  };
  return new Map([...value].map(entry));
}
