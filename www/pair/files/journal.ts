/** What is done by hand in a pair, and in pairs that are not on the page: the journals of its edits, masks and marks, and the match that is being measured. */
import type { Kept } from '../../shared/files/database';
import { doneFrom, Journal as Edits } from '../../shared/files/journal';
import { likeOf, listOf, objectOf, orNull } from '../../shared/files/keepable';
import type { Shelved, State } from '../state/state';
import { say } from '../../shared/text/words';
import { bytesOf, draftFrom, editFrom, OF_MATCH } from './edit';
import { bytesOfMarkStep, bytesOfMaskStep, keptMaskSteps, markStepFrom, maskStepFrom, maskStepsFrom } from './steps';

const DRAFT = 'pair/draft';
/** What is done in pairs that are not on the page. */
const SHELF = 'pair/shelf';

/** Of the state what is done by hand. */
type ByHand = Pick<State, 'history' | 'maskSteps' | 'markSteps' | 'draft' | 'shelf'>;

export class Journal {
  private readonly edits = new Edits('pair/edits', editFrom, bytesOf);
  private readonly masks = new Edits('pair/masks', maskStepFrom, bytesOfMaskStep);
  private readonly marks = new Edits('pair/marks', markStepFrom, bytesOfMarkStep);

  /** What is kept of it; what has not changed is the same value as before. Nothing where there is none. */
  parts({ history, maskSteps, markSteps, draft, shelf }: ByHand): Map<string, Kept> {
    const parts = new Map([...this.edits.parts(history), ...this.masks.parts(keptMaskSteps(maskSteps)), ...this.marks.parts(markSteps)]);
    if (draft !== null) parts.set(DRAFT, { value: draft, bytes: OF_MATCH });
    if (shelf.size > 0) parts.set(SHELF, { value: shelf, bytes: [...shelf.values()].reduce((sum, other) => sum + this.edits.size(other.edits) + OF_MATCH, 0) });
    return parts;
  }

  /** @throws Error naming what is damaged */
  read(parts: ReadonlyMap<string, unknown>): ByHand {
    return {
      history: this.edits.read(parts),
      maskSteps: maskStepsFrom(parts, this.masks.read(parts)),
      markSteps: this.marks.read(parts),
      draft: orNull(parts.get(DRAFT), (draft) => draftFrom(draft, 'draft')),
      shelf: shelfFrom(parts.get(SHELF)),
    };
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
