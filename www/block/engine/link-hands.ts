/** Links of the chosen image by hand: left out, used again, measured. The image is adjusted after each step, and a step that the crate refuses is taken back. */
import { sentence } from '../../shared/text/format';
import { Cancelled } from '../../shared/engine/client';
import { shownLinks, stepName } from '../state/steps';
import type { LinkStep } from '../state/steps';
import { chosenPlaced } from '../state/showing';
import type { PlacedFile } from '../state/placed';
import { isBusy } from '../state/state';
import type { BlockStore } from './engine';
import type { PlacingEngine } from './placing';
import { say } from '../../shared/text/words';
import { messageOf } from '../../shared/text/messages';

export class LinkHands {
  constructor(
    private readonly store: BlockStore,
    private readonly engine: PlacingEngine,
  ) {}

  /** The image whose links can be changed now. */
  get image(): PlacedFile | null {
    const placed = chosenPlaced(this.store.state);
    const isFree = !isBusy(this.store.state) && this.store.state.placing.adjusting === null;
    return placed !== null && placed.result !== null && isFree ? placed : null;
  }

  /** Leaves the chosen link out, or uses it again. */
  use(kind: 'reject' | 'restore'): void {
    const { link } = this.store.state.placing.chosen;
    if (link !== null) this.step({ kind, link });
  }

  /** Begins to measure a link, or gives it up. */
  measure(): void {
    const begins = this.store.state.placing.draft === null && this.image !== null;
    this.store.dispatch({ type: 'linkDraft', draft: begins ? { at: null, place: null } : null });
  }

  /** One end of the link that is measured, and what is expected of the other one. */
  place(end: 'at' | 'place', position: [number, number]): Promise<[number, number] | null> {
    const { draft } = this.store.state.placing;
    if (draft === null || this.image === null) return Promise.resolve(null);
    this.store.dispatch({ type: 'linkDraft', draft: { ...draft, [end]: position } });
    return this.expected();
  }

  /** Where the end that is not measured yet is predicted; null where both are or none is, and where the image is not placed. */
  async expected(): Promise<[number, number] | null> {
    const { draft } = this.store.state.placing;
    const placement = this.image?.result?.placement ?? null;
    if (draft === null || placement === null || (draft.at === null) === (draft.place === null)) return null;
    try {
      return await this.engine.predict(placement, draft);
    } catch {
      // It is measured without a prediction.
      return null;
    }
  }

  /** Takes the link that is measured. */
  accept(): void {
    const { draft } = this.store.state.placing;
    // It stays until it can be taken.
    if (draft?.at == null || draft.place === null || this.image === null) return;
    const { at, place } = draft;
    this.store.dispatch({ type: 'linkDraft', draft: null });
    this.step({ kind: 'add', at, place });
  }

  /** Goes to the state after so many steps more, or fewer. */
  go(by: number): void {
    const { image } = this;
    if (image === null) return;
    const done = image.done + by;
    if (done >= 0 && done <= image.steps.length) void this.follow(image, image.steps, done);
  }

  private step(step: LinkStep): void {
    const { image } = this;
    if (image !== null) void this.follow(image, [...image.steps.slice(0, image.done), step], image.done + 1);
  }

  private async follow(
    { file, key, result, problem, found, steps: former, done: before }: PlacedFile,
    steps: readonly LinkStep[],
    done: number,
  ): Promise<void> {
    const own = { key, problem, found };
    const tell = (text: string) => this.store.dispatch({ type: 'notice', notice: { kind: 'problem', text } });
    this.store.dispatch({ type: 'notice', notice: null });
    this.store.dispatch({ type: 'placed', image: file, placed: { ...own, result, steps, done } });
    try {
      const adjusted = await this.engine.adjust(file, found, steps.slice(0, done));
      this.store.dispatch({ type: 'placed', image: file, placed: { ...own, result: adjusted, steps, done } });
      const added = steps[done - 1]?.kind === 'add' && done > before ? shownLinks({ result: adjusted, steps, done }) : null;
      // How well it fits is seen at once.
      if (added !== null) this.store.dispatch({ type: 'choosePlaced', looked: { image: file.id, link: added.count - 1 } });
    } catch (error) {
      this.store.dispatch({ type: 'placed', image: file, placed: { ...own, result, steps: former, done: before } });
      const last = steps[done - 1];
      if (!(error instanceof Cancelled))
        tell(say('not-done', { what: last === undefined ? '' : say('n-', { last: stepName(last) }), sentence: sentence(messageOf(error)) }));
    }
  }
}
