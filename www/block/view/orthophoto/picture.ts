/** What the orthophoto and the image beside it have in common: a picture that is moved and enlarged, with the links of the chosen image. */
import { onRecolour, themeColours } from '../../../shared/view/colours';
import type { Colours } from '../../../shared/view/colours';
import { listen } from '../../../shared/view/gestures';
import { Layers } from '../../../shared/view/layers';
import { CANDIDATE, MEASURED } from '../../../shared/view/palette';
import { panned, resized, toCanvas, toPosition, zoomedAbout } from '../../../shared/view/transform';
import type { Size, Transform } from '../../../shared/view/transform';
import type { BlockStore } from '../../engine/engine';
import type { LinkHands } from '../../engine/link-hands';
import { chosenPlaced } from '../../state/showing';
import type { PlacedFile } from '../../state/placed';
import { NOTHING_LOOKED_AT } from '../../state/placing';
import type { Looked } from '../../state/placing';
import type { Zoomable } from '../looking';
import { drawCross, linkAt } from './links';
import type { DrawnLinks } from './links';

/** What is to be seen of a picture: left, top, right, bottom in its positions. */
export type Box = readonly [number, number, number, number];

/** A link that is chosen elsewhere is brought into sight where it lies nearer to the edge than this, CSS px. */
const EDGE = 24;
/** A little room is left about what is shown whole. */
const SPARE = 0.96;

export abstract class LinkPicture implements Zoomable {
  protected readonly layers: Layers<'picture' | 'marks'>;
  /** Where it was moved to, and how large the canvas was; null: all of `part` is shown. */
  private moved: { t: Transform; on: Size } | null = null;
  /** Null: the whole picture. */
  private part: Box | null = null;
  /** Where the pointer is, in positions of the picture. */
  private pointer: [number, number] | null = null;
  private readonly listeners: (() => void)[] = [];

  constructor(
    host: HTMLElement,
    protected readonly store: BlockStore,
    protected readonly hands: LinkHands,
    keys: (key: string, shift: boolean) => boolean,
  ) {
    this.layers = new Layers(host, ['picture', 'marks'], (name, context) => {
      const box = this.whole();
      if (box === null) return;
      const t = this.current(box);
      if (name === 'picture') this.paintPicture(context, t);
      else this.paintMarks(context, themeColours(), t);
    });
    onRecolour(() => this.layers.redraw());
    listen<Box>(host, {
      at: () => this.whole(),
      focused: () => this.whole(),
      pan: (box, dx, dy) => this.move(panned(this.current(box), dx, dy)),
      zoom: (box, factor, x, y) => this.zoom(box, factor, x, y),
      zoomMiddle: (factor) => this.zoomMiddle(factor),
      fit: () => this.fit(),
      pressed: (x, y) => this.pressed(x, y),
      pointed: (at, dragging) => this.hover(at, dragging),
      command: keys,
    });
  }

  /** All of the picture; null where there is none. */
  protected abstract whole(): Box | null;
  protected abstract paintPicture(context: CanvasRenderingContext2D, t: Transform): void;
  protected abstract paintMarks(context: CanvasRenderingContext2D, colours: Colours, t: Transform): void;
  /** The links of the chosen image; null where it has none. */
  protected abstract links(): DrawnLinks | null;

  /** What lies at a place beside links. */
  protected other(_x: number, _y: number): Looked | null {
    return null;
  }

  /** Calls back whenever the pointer is elsewhere. */
  watch(changed: () => void): void {
    this.listeners.push(changed);
  }

  /** Where the pointer is, in positions of the picture; null where it is not over it. */
  get place(): readonly [number, number] | null {
    return this.pointer;
  }

  redraw(): void {
    this.layers.redraw();
  }

  fit(): void {
    this.show(null);
  }

  /** Shows all of a part of the picture, however large its canvas becomes; null: of all of it. */
  show(part: Box | null): void {
    this.part = part;
    this.moved = null;
    this.layers.redraw();
  }

  /** Brings a link that is chosen elsewhere into sight. */
  reveal(link: number): void {
    const [x, y] = this.links()?.points.subarray(3 * link, 3 * link + 2) ?? [];
    if (x !== undefined && y !== undefined) this.bring([x, y]);
  }

  /** Brings a position into sight. */
  protected bring(at: readonly [number, number]): void {
    const box = this.whole();
    const { width, height } = this.layers;
    // What is not on the stage has no size.
    if (box === null || width < 2 * EDGE || height < 2 * EDGE) return;
    const t = this.current(box);
    const [x, y] = toCanvas(t, ...at);
    // What is shown whole stays so, whatever size its canvas gets: moved by an edge it would be cut there from then on.
    if (this.moved === null && x >= 0 && y >= 0 && x <= width && y <= height) return;
    const [dx, dy] = [into(x, width), into(y, height)];
    if (dx !== 0 || dy !== 0) this.move(panned(t, dx, dy));
  }

  zoomMiddle(factor: number): void {
    const box = this.whole();
    if (box !== null) this.zoom(box, factor, this.layers.width / 2, this.layers.height / 2);
  }

  protected chosen(): PlacedFile | null {
    return chosenPlaced(this.store.state);
  }

  protected current(box: Box): Transform {
    if (this.moved !== null) return resized(this.moved.t, this.moved.on, this.layers);
    const { width, height } = this.layers;
    const [left, top, right, bottom] = this.part ?? box;
    const scale = SPARE * Math.min(width / Math.max(right - left, 1e-9), height / Math.max(bottom - top, 1e-9));
    return { scale, x: width / 2 - (scale * (left + right)) / 2, y: height / 2 - (scale * (top + bottom)) / 2 };
  }

  private move(t: Transform): void {
    const { width, height } = this.layers;
    this.moved = { t, on: { width, height } };
    this.layers.redraw();
  }

  private zoom(box: Box, factor: number, x: number, y: number): void {
    const t = this.current(box);
    const fits = Math.min(this.layers.width / (box[2] - box[0]), this.layers.height / (box[3] - box[1]));
    this.move(zoomedAbout(t, factor, x, y, { least: 0.2 * fits, most: this.mostScale(fits) }));
  }

  protected mostScale(fits: number): number {
    return 400 * fits;
  }

  /** An end of the link that is measured, in positions of the picture; where it is predicted; null: nowhere. */
  protected abstract end(): readonly [number, number] | null;
  /** Takes a press while a link is measured. */
  protected abstract measured(at: [number, number]): void;

  /** Where the end of the link is expected; null: not known. */
  predicted: readonly [number, number] | null = null;

  /** Brings a position into sight, where an end of a link is expected. */
  expect(at: readonly [number, number] | null): void {
    this.predicted = at;
    if (at !== null) this.bring(at);
    this.layers.redraw('marks');
  }

  /** Draws the end of the link that is measured. */
  protected paintEnd(context: CanvasRenderingContext2D, t: Transform): void {
    if (this.store.state.placing.draft === null) return;
    const end = this.end();
    if (end !== null) drawCross(context, toCanvas(t, ...end), MEASURED.colour);
    else if (this.predicted !== null) drawCross(context, toCanvas(t, ...this.predicted), CANDIDATE);
  }

  protected pressed(x: number, y: number): void {
    const box = this.whole();
    if (this.store.state.placing.draft !== null && box !== null) {
      this.measured(toPosition(this.current(box), x, y));
      return;
    }
    this.store.dispatch({ type: 'choosePlaced', looked: this.lookedAt(x, y) });
  }

  /** The pointer is over a place of the canvas, or has left. */
  protected point(at: [number, number] | null): void {
    this.store.dispatch({ type: 'pointPlaced', looked: at === null ? NOTHING_LOOKED_AT : this.lookedAt(...at) });
  }

  protected lookedAt(x: number, y: number): Looked {
    const box = this.whole();
    const links = this.links();
    const { chosen, uses } = this.store.state.placing;
    const link = box === null || links === null ? -1 : linkAt(links, uses, this.current(box), x, y);
    if (link >= 0) return { image: chosen.image, link };
    return this.other(x, y) ?? NOTHING_LOOKED_AT;
  }

  private hover(at: [number, number] | null, dragging: boolean): void {
    const box = this.whole();
    this.pointer = at === null || box === null ? null : toPosition(this.current(box), ...at);
    if (!dragging) this.point(at);
    for (const listener of this.listeners) listener();
  }
}

/** How far something must move to be on the canvas, clear of its edges. */
function into(at: number, length: number): number {
  return at < EDGE ? 3 * EDGE - at : at > length - EDGE ? length - 3 * EDGE - at : 0;
}
