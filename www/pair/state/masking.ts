/** What a user does to masks: areas are outlined, and hold no points from then on, or do so again. */
import { say } from '../../shared/text/words';
import type { Position } from '../../shared/state/pane';
import type { GivenMask, Outline, Side, State } from './state';
import type { Store } from './store';

/** Makes a mask of the present one of a side, if any, with an area masked or no longer. */
export type Painter = (state: State, side: Side, corners: Outline['corners'], masked: boolean) => Promise<GivenMask>;

/** An area has three corners at least. */
const LEAST_CORNERS = 3;

/** A mask of an image before an area was painted. */
interface Former {
  imageId: number;
  mask: GivenMask | null;
}

export class Masking {
  private formers: Former[] = [];
  /** Areas are painted one after the other: each begins with the mask that the one before it left. */
  private painting: Promise<void> = Promise.resolve();

  constructor(
    private readonly store: Store,
    private readonly painter: Painter,
  ) {}

  /** Whether there is an image to be masked. */
  can(): boolean {
    return Object.values(this.store.state.images).some((image) => image !== null);
  }

  toggle(): void {
    const next = this.store.state.tool === 'mask' || !this.can() ? 'look' : 'mask';
    this.store.dispatch({ type: 'tool', tool: next });
  }

  /** Places the next corner; in another image a new outline begins. */
  place(side: Side, at: Position): void {
    const { outline } = this.store.state;
    const before = outline?.side === side ? outline.corners : [];
    this.store.dispatch({ type: 'outline', outline: { side, corners: [...before, at] } });
  }

  /** What is drawn in one go. */
  trace(side: Side, corners: Outline['corners']): void {
    this.store.dispatch({ type: 'outline', outline: { side, corners } });
  }

  /** Takes the last corner back; false where there is none. */
  back(): boolean {
    const { outline } = this.store.state;
    if (outline === null) return false;
    const corners = outline.corners.slice(0, -1);
    this.store.dispatch({ type: 'outline', outline: corners.length === 0 ? null : { ...outline, corners } });
    return true;
  }

  isArea(): boolean {
    return (this.store.state.outline?.corners.length ?? 0) >= LEAST_CORNERS;
  }

  /** The outlined area holds no points from now on, or does so again. */
  paint(masked: boolean): Promise<void> {
    const { outline } = this.store.state;
    if (outline === null || !this.isArea()) return Promise.resolve();
    this.store.dispatch({ type: 'outline', outline: null });
    // Who painted the area before is told of its failure.
    this.painting = this.painting.catch(() => {}).then(() => this.painted(outline, masked));
    return this.painting;
  }

  canUndo(): boolean {
    return this.formers.some(({ imageId }) => this.sideOf(imageId) !== undefined);
  }

  /** Takes the area back that was painted last. */
  undo(): void {
    const former = this.formers.pop();
    if (former === undefined) return;
    const side = this.sideOf(former.imageId);
    // Of an image that is no longer here nothing is taken back.
    if (side === undefined) this.undo();
    else this.store.dispatch({ type: 'mask', side, mask: former.mask });
  }

  private async painted({ side, corners }: Outline, masked: boolean): Promise<void> {
    const { state } = this.store;
    const image = state.images[side];
    const before = state.masks[side];
    if (image === null) return;
    if (before?.source.kind === 'project') {
      const text = say('the-mask-is-not-here', { name: before.name });
      this.store.dispatch({ type: 'notice', notice: { kind: 'problem', text } });
      return;
    }
    const mask = await this.painter(state, side, corners, masked);
    // Meanwhile the image or its mask may be another one.
    if (this.store.state.images[side] !== image || this.store.state.masks[side] !== before) return;
    this.formers.push({ imageId: image.id, mask: before });
    this.store.dispatch({ type: 'mask', side, mask });
    const text = say('masks-of-the-image', { name: mask.name, left_out: 100 * mask.leftOut, side });
    this.store.dispatch({ type: 'notice', notice: { kind: 'info', text } });
  }

  private sideOf(imageId: number): Side | undefined {
    const { left, right } = this.store.state.images;
    return left?.id === imageId ? 'left' : right?.id === imageId ? 'right' : undefined;
  }
}
