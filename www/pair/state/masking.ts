/** What a user does to masks: areas are outlined, and hold no points from then on, or do so again. */
import { say } from '../../shared/text/words';
import type { History } from '../../shared/state/history';
import type { Position } from '../../shared/state/pane';
import type { GivenMask, Outline, Side, State } from './state';
import type { Store } from './store';
import { sideOf, Undoing } from './undoing';
import type { Step } from './undoing';

/** Makes a mask of the present one of a side, if any, with an area masked or no longer; null where it was cancelled. */
export type Painter = (state: State, side: Side, corners: Outline['corners'], masked: boolean) => Promise<GivenMask | null>;

/** An area has three corners at least. */
const LEAST_CORNERS = 3;

/** Areas that can be taken back: each holds a whole mask. */
const MOST_UNDONE = 10;

export class Masking {
  private readonly steps: Undoing<GivenMask | null>;
  /** What was outlined before the line that is being drawn. */
  private former: Outline | null = null;
  /** Whether the outline was drawn in one go. */
  private isTraced = false;
  private isTracing = false;
  /** Areas are painted one after the other: each begins with the mask that the one before it left. */
  private painting: Promise<void> = Promise.resolve();

  constructor(
    private readonly store: Store,
    private readonly painter: Painter,
  ) {
    this.steps = new Undoing(
      () => store.state,
      (side) => store.state.masks[side],
      (a, b) => a?.id === b?.id,
      MOST_UNDONE,
    );
  }

  /** Whether there is an image to be masked: of a project that was opened the images themselves may be missing. */
  can(): boolean {
    return Object.values(this.store.state.images).some((image) => image !== null && image.source.kind !== 'project');
  }

  toggle(): void {
    const next = this.store.state.tool === 'mask' || !this.can() ? 'look' : 'mask';
    this.store.dispatch({ type: 'tool', tool: next });
  }

  /** Places the next corner; in another image a new outline begins. */
  place(side: Side, at: Position): void {
    const { outline } = this.store.state;
    const before = outline?.side === side ? outline.corners : [];
    this.isTraced = false;
    this.store.dispatch({ type: 'outline', outline: { side, corners: [...before, at] } });
  }

  /** What is drawn in one go; `ended`: as far as it goes. */
  trace(side: Side, corners: Outline['corners'], ended: boolean): void {
    if (!this.isTracing) this.former = this.store.state.outline;
    this.isTracing = !ended;
    this.isTraced = true;
    this.store.dispatch({ type: 'outline', outline: { side, corners } });
  }

  /** Gives up what is being drawn: what was outlined before it is so again. */
  giveUp(): void {
    if (!this.isTracing) return;
    this.isTracing = false;
    this.isTraced = false;
    this.store.dispatch({ type: 'outline', outline: this.former });
  }

  /** Takes the last corner back, or all that was drawn in one go. */
  back(): void {
    const { outline } = this.store.state;
    if (outline === null) return;
    const corners = this.isTraced ? [] : outline.corners.slice(0, -1);
    this.store.dispatch({ type: 'outline', outline: corners.length === 0 ? null : { ...outline, corners } });
  }

  isArea(): boolean {
    return (this.store.state.outline?.corners.length ?? 0) >= LEAST_CORNERS;
  }

  /** The outlined area holds no points from now on, or does so again. */
  paint(masked: boolean): Promise<void> {
    const { outline, images } = this.store.state;
    const image = outline === null ? null : images[outline.side];
    if (outline === null || image === null || !this.isArea()) return Promise.resolve();
    this.store.dispatch({ type: 'outline', outline: null });
    // Who painted the area before is told of its failure.
    this.painting = this.painting.catch(() => {}).then(() => this.painted(image.id, outline.corners, masked));
    return this.painting;
  }

  /** The areas that can be taken back and painted again. */
  get history(): History<Step<GivenMask | null>> {
    return this.steps.history;
  }

  /** Takes the area back that was painted last, or paints it again. */
  step(by: 1 | -1): void {
    const gone = this.steps.go(by);
    if (gone !== null) this.store.dispatch({ type: 'mask', side: gone.side, mask: gone.value });
  }

  private async painted(imageId: number, corners: Outline['corners'], masked: boolean): Promise<void> {
    const { state } = this.store;
    const side = sideOf(this.store.state, imageId);
    if (side === undefined) return;
    const before = state.masks[side];
    const tell = (kind: 'info' | 'problem', text: string) => this.store.dispatch({ type: 'notice', notice: { kind, text } });
    if (before?.source.kind === 'project') {
      tell('problem', say('the-mask-is-not-here', { name: before.name }));
      this.outlinedAgain(imageId, corners);
      return;
    }
    let mask: GivenMask | null = null;
    try {
      mask = await this.painter(state, side, corners, masked);
    } finally {
      // What was outlined is not lost.
      if (mask === null) this.outlinedAgain(imageId, corners);
    }
    const now = sideOf(this.store.state, imageId);
    if (mask === null || now === undefined || this.store.state.masks[now] !== before) {
      tell('info', say('no-area-was-painted'));
      this.outlinedAgain(imageId, corners);
      return;
    }
    this.steps.record({ imageId, name: say('step-of-mask', { masked: masked ? 'yes' : 'no' }), before, after: mask });
    this.store.dispatch({ type: 'mask', side: now, mask });
    tell('info', say('masks-of-the-image', { name: mask.name, left_out: 100 * mask.leftOut, side: now }));
  }

  private outlinedAgain(imageId: number, corners: Outline['corners']): void {
    const side = sideOf(this.store.state, imageId);
    const { outline, tool } = this.store.state;
    if (side !== undefined && outline === null && tool === 'mask') this.store.dispatch({ type: 'outline', outline: { side, corners } });
  }
}
