/** A point that was being measured when its project was left is measured on: it is the chosen one, in the images that were shown. Pure. */
import { choiceOfDraft } from './draft';
import type { KeptDraft } from './draft';
import { NO_PANES, reducePanes } from './panes';
import { NOTHING_SELECTED } from './selection';
import type { BlockState } from './state';
import type { BlockView } from './view';

/** What it changes in the state of a block that was kept; nothing where none was measured. */
export function resumed(kept: KeptDraft | null, view: BlockView | null): Partial<Pick<BlockState, 'draft' | 'panes' | 'selection' | 'onStage'>> {
  if (kept === null || view === null) return { draft: null };
  const { images, ...draft } = kept;
  const shown = reducePanes(NO_PANES, { type: 'showImages', images });
  return {
    draft,
    // Where it is expected it can be placed, as when it was begun.
    panes: draft.of === null ? shown : reducePanes(shown, { type: 'look', look: { unmeasured: true } }),
    selection: { ...NOTHING_SELECTED, chosen: choiceOfDraft(draft, view) },
    onStage: 'images',
  };
}
