/** What a user does to masks: areas are outlined, and hold no points from then on, or do so again. */
import { say } from '../../shared/text/words';
import { wentTo } from '../../shared/state/history';
import type { History } from '../../shared/state/history';
import type { Position } from '../../shared/state/pane';
import { areasAfter, compositionOf } from './mask-steps';
import { SIDES } from './state';
import type { Area, GivenMask, MaskFile, MaskStep, Outline, Side, State } from './state';
import type { Store } from './store';

/** Makes the mask of a side: areas over the grey values of a mask, over a file that is read, or over nothing; null where it was cancelled. */
export type Painter = (state: State, side: Side, over: Uint8Array | MaskFile | null, areas: readonly Area[]) => Promise<GivenMask | null>;

/** An area has three corners at least. */
const LEAST_CORNERS = 3;

export class Masking {
  /** What was outlined before the line that is being drawn. */
  private former: Outline | null = null;
  /** Whether the outline was drawn in one go. */
  private isTraced = false;
  private isTracing = false;
  /** Areas are painted one after the other: each begins with the mask that the one before it left. */
  private painting: Promise<void> = Promise.resolve();
  /** How many steps are to be gone next; null where something else is next. */
  private going: { by: number } | null = null;
  /** The file of the mask that a step left: one that is done again is the same mask. */
  private readonly sources = new WeakMap<MaskStep, GivenMask['source']>();

  constructor(
    private readonly store: Store,
    private readonly painter: Painter,
  ) {}

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
    this.going = null;
    return this.next(() => this.painted(image.id, { corners: outline.corners, masked }));
  }

  /**
   * Takes the last step back, or makes it again. Those that are asked for before that begins are gone with it. While an area is outlined its last corner is
   * the last step, and there is none to be made again.
   */
  step(by: 1 | -1): Promise<void> {
    if (this.store.state.outline !== null) {
      if (by < 0) this.back();
      return Promise.resolve();
    }
    if (this.going !== null) {
      this.going.by += by;
      return this.painting;
    }
    const going = { by };
    this.going = going;
    return this.next(() => {
      if (this.going === going) this.going = null;
      return this.went(going.by);
    });
  }

  /** Goes to where so many steps hold; what is outlined stays so. */
  goTo(done: number): Promise<void> {
    this.going = null;
    return this.next(() => this.went(done - this.store.state.maskSteps.done));
  }

  private next(job: () => Promise<void>): Promise<void> {
    // Who asked for what was done before is told of its failure.
    this.painting = this.painting.catch(() => {}).then(job);
    return this.painting;
  }

  private async went(by: number): Promise<void> {
    const { state } = this.store;
    const steps = wentTo(state.maskSteps, state.maskSteps.done + by);
    const masks = { ...state.masks };
    for (const side of SIDES) {
      const made = await this.made(state, side, steps);
      if (made === 'cancelled') return;
      masks[side] = made;
    }
    const { masks: now, maskSteps, images } = this.store.state;
    if (now === state.masks && maskSteps === state.maskSteps && images === state.images) this.store.dispatch({ type: 'masksAfter', done: steps.done, masks });
  }

  /** The mask of an image after other steps. */
  private async made(state: State, side: Side, steps: History<MaskStep>): Promise<GivenMask | null | 'cancelled'> {
    const given = state.givenMasks[side];
    const then = compositionOf(given, steps, side);
    const more = areasAfter(compositionOf(given, state.maskSteps, side), then);
    const present = state.masks[side];
    if (more?.length === 0) return present;
    if (then.file === null && then.areas.length === 0) return null;
    const made = more === null ? this.painter(state, side, then.file, then.areas) : this.painter(state, side, present?.grey ?? null, more);
    const mask = await made;
    if (mask === null) return 'cancelled';
    const last = steps.edits.slice(0, steps.done).findLast((step) => step.side === side);
    const source = (last && this.sources.get(last)) ?? mask.source;
    if (last !== undefined) this.sources.set(last, source);
    return { ...mask, source };
  }

  private async painted(imageId: number, area: Area): Promise<void> {
    const { corners } = area;
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
      mask = await this.painter(state, side, before?.grey ?? null, [area]);
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
    const step = { side: now, ...area };
    this.sources.set(step, mask.source);
    this.store.dispatch({ type: 'painted', step, mask });
    tell('info', say('masks-of-the-image', { name: mask.name, left_out: 100 * mask.leftOut, side: now }));
  }

  private outlinedAgain(imageId: number, corners: Outline['corners']): void {
    const side = sideOf(this.store.state, imageId);
    const { outline, tool } = this.store.state;
    if (side !== undefined && outline === null && tool === 'mask') this.store.dispatch({ type: 'outline', outline: { side, corners } });
  }
}

/** The side of an image; undefined where it is no longer in the pair. */
function sideOf({ images: { left, right } }: State, imageId: number): Side | undefined {
  return left?.id === imageId ? 'left' : right?.id === imageId ? 'right' : undefined;
}
