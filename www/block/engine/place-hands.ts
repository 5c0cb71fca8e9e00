/** Places of the orthophoto measured by hand for the block: the next press gives the map position, and the images that show it are opened to be measured. */
import { sentence } from '../../shared/text/format';
import { messageOf } from '../../shared/text/messages';
import { nextPlace } from '../state/added';
import { isEditable } from '../state/editing';
import { takesPlaces } from '../state/places';
import { isBusy } from '../state/state';
import type { BlockStore } from './engine';
import type { PlacingEngine } from './placing';

export class PlaceHands {
  constructor(
    private readonly store: BlockStore,
    private readonly engine: PlacingEngine,
    /** Measures the chosen point in images. */
    private readonly measure: () => void,
  ) {}

  /** Whether a place can be added now. */
  get can(): boolean {
    const { state } = this.store;
    return takesPlaces(state) && isEditable(state) && !isBusy(state);
  }

  /** The next press adds a place, or none any more. */
  toggle(): void {
    this.store.dispatch({ type: 'addsPlace', adds: !this.store.state.placing.adds && this.can });
  }

  /** Adds the place X, Y of the orthophoto to the block. */
  async take(place: readonly [number, number]): Promise<void> {
    if (!this.can) return;
    const { shown, history } = this.store.state;
    if (shown === null) return;
    const number = nextPlace(history);
    try {
      const edit = await this.engine.controlByHand(place, number, shown.view);
      // The user went on to something else, or the block is another one.
      if (!this.store.state.placing.adds || this.store.state.shown?.found !== shown.found) return;
      this.store.dispatch({ type: 'addsPlace', adds: false });
      this.store.dispatch({ type: 'edit', edits: [edit] });
      this.store.dispatch({ type: 'choose', choice: { kind: 'given', name: edit.name } });
      this.measure();
    } catch (error) {
      this.store.dispatch({ type: 'notice', notice: { kind: 'problem', text: sentence(messageOf(error)) } });
    }
  }
}
