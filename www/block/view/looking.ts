/** What pointing and pressing does, the same in each view. */
import type { BlockStore } from '../engine/engine';
import { isBusy } from '../state/state';
import { isSame } from '../state/selection';
import type { Choice } from '../state/selection';

export interface Looking {
  /** What the pointer is over. */
  point: (choice: Choice | null) => void;
  choose: (choice: Choice | null) => void;
  /** Shows a pair by itself. */
  open: (images: [number, number]) => void;
}

/** What the buttons over a picture do. */
export interface Zoomable {
  fit: () => void;
  zoomMiddle: (factor: number) => void;
}

/** A press chooses; a press on the pair that is chosen opens it. */
export function press(store: BlockStore, looking: Looking, choice: Choice | null): void {
  const again = isSame(choice, store.state.selection.chosen);
  if (choice?.kind === 'pair' && again && !isBusy(store.state)) looking.open(choice.images);
  else looking.choose(choice);
}
