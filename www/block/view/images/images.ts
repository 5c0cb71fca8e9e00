/** Some images of the block side by side: their pictures, observations and residuals, and the chosen point in all of them. */
import type { Position } from '../../../shared/state/pane';
import { declare } from '../../../shared/view/commands';
import { listen } from '../../../shared/view/gestures';
import { Layers } from '../../../shared/view/layers';
import { contains, toPosition } from '../../../shared/view/transform';
import type { BlockEngine, BlockStore } from '../../engine/engine';
import type { Facts } from '../../engine/facts';
import { likeliest, turned } from '../../state/likely';
import { shownImages } from '../../state/panes';
import { pointsOf, withMore } from '../../state/selection';
import type { Looking } from '../looking';
import { Bitmaps } from './bitmaps';
import { looking as lookingKeys, measuringKeys } from './keys';
import type { Commanded } from './keys';
import { draftLenses, lensesAt } from './lenses';
import type { Lens } from './lenses';
import { Measuring } from './measuring';
import { Moving } from './moving';
import { nearestRow } from './observations';
import { Opening } from './opening';
import { paintLenses, paintMarks, paintOverlay, paintPictures } from './paint';
import { isOn, paneAt } from './scene';
import type { At, Pane } from './scene';
import { Seen } from './seen';
import { say } from '../../../shared/text/words';

type LayerName = 'pictures' | 'marks' | 'lenses' | 'overlay';
const LAYERS: readonly LayerName[] = ['pictures', 'marks', 'lenses', 'overlay'];

/** How near a press must be to a point, CSS px. */
const REACH = 14;
/** Of panes one below the other each is so high, CSS px. */
const NARROW_HEIGHT = 220;

export class ImagesView implements Commanded {
  readonly seen: Seen;
  readonly measuring: Measuring;
  readonly moving: Moving;
  readonly opening: Opening;
  private readonly layers: Layers<LayerName>;
  private readonly bitmaps: Bitmaps;
  /** The pointer's place on the canvas. */
  private pointer: Position | null = null;
  private readonly listeners: (() => void)[] = [];

  constructor(
    readonly host: HTMLElement,
    private readonly store: BlockStore,
    private readonly looking: Looking,
    facts: Facts,
    engine: BlockEngine,
  ) {
    this.layers = new Layers(host, LAYERS, (name, context) => this.draw(name, context));
    this.seen = new Seen(store, facts, () => this.layers);
    this.bitmaps = new Bitmaps(
      (file) => engine.grey(file),
      () => this.layers.redraw('pictures', 'lenses'),
    );
    this.measuring = new Measuring(store, engine, facts, () => this.seen.panes());
    this.moving = new Moving(this.seen);
    this.opening = new Opening(this.seen, this.measuring);
    const looks = declare({ where: say('images-of-a-block'), host, list: lookingKeys(this) });
    const measures = declare({ where: say('images-of-a-block-measuring'), host, list: measuringKeys(this), lacks: say('nothing-is-measured') });
    listen<number>(
      host,
      {
        at: (x, y) => paneAt(this.seen.panes(), x, y)?.image ?? null,
        focused: () => this.seen.active()?.image ?? null,
        pan: (image, dx, dy) => this.moving.pan(image, dx, dy),
        zoom: (image, factor, x, y) => this.moving.zoom(image, factor, x, y),
        zoomMiddle: (factor) => this.moving.zoomMiddle(factor),
        fit: () => this.moving.fit(),
        grabbed: (image) => store.dispatch({ type: 'activeImage', image }),
        pressed: (x, y, more) => this.press(x, y, more),
        pointed: (at, dragging) => this.point(at, dragging),
        command: (key, shift) => measures(key, shift) || looks(key, shift),
      },
      // The bar of the view belongs to it: after a press there the keys go on.
      host.parentElement ?? host,
    );
    facts.watch(() => {
      this.opening.follow();
      this.changed();
    });
    store.watch(['shown', 'panes', 'selection', 'files', 'running', 'onStage', 'draft'], () => {
      this.opening.follow();
      this.changed();
    });
    new ResizeObserver(() => this.lay()).observe(host.parentElement ?? host);
    // After the canvases, which have seen its new size.
    new ResizeObserver(() => {
      this.opening.follow();
      this.tell();
    }).observe(host);
  }

  /** Calls back when panes, places or figures may have changed. */
  watch(changed: () => void): void {
    this.listeners.push(changed);
  }

  /** What the pointer is over; null beside the images. */
  pointedAt(): At | null {
    if (this.pointer === null) return null;
    const pane = paneAt(this.seen.panes(), ...this.pointer);
    if (pane === null) return null;
    const at = toPosition(pane.transform, ...this.pointer);
    return isOn(pane, at) ? { image: pane.image, at } : null;
  }

  /** Whether the image of a pane cannot be decoded. */
  hasFailed({ file }: Pane): boolean {
    return file !== null && this.bitmaps.hasFailed(file);
  }

  /** Shows the next images in place of those that are shown; those in which the measured point is placed stay. */
  turn(by: 1 | -1): void {
    const view = this.seen.view();
    if (view === null) return;
    const known = this.measuring.known();
    const order = likeliest(view, [...known.keys()][0]);
    this.store.dispatch({ type: 'showImages', images: turned(shownImages(this.store.state.panes, view), order, new Set(known.keys()), by) });
  }

  /** Chooses the next point of the active image, row by row. */
  step(by: 1 | -1): void {
    const pane = this.seen.active();
    const of = pane?.points;
    if (pane === null || of == null || of.points.length === 0) return;
    const rows = [...of.points.keys()].sort(
      (a, b) => (of.places[2 * a + 1] ?? 0) - (of.places[2 * b + 1] ?? 0) || (of.places[2 * a] ?? 0) - (of.places[2 * b] ?? 0),
    );
    const [now] = pointsOf(this.store.state.selection.chosen);
    const at = rows.findIndex((row) => of.points[row] === now);
    const next = rows[at < 0 ? (by > 0 ? 0 : rows.length - 1) : (at + by + rows.length) % rows.length];
    const point = next === undefined ? undefined : of.points[next];
    if (point !== undefined) this.looking.choose({ kind: 'observation', point, image: pane.image });
  }

  /** Gives the keys to the next pane. */
  other(): void {
    const panes = this.seen.panes();
    const at = panes.findIndex(({ image }) => image === this.seen.active()?.image);
    const next = panes[(at + 1) % Math.max(1, panes.length)];
    if (next !== undefined) this.store.dispatch({ type: 'activeImage', image: next.image });
  }

  /** Matches the point that is chosen or measured in the other images by its place in the active one. */
  match(): void {
    void this.measuring.match(this.seen.active()).then(() => this.opening.showDraft());
  }

  /** Matches it in the active image alone, by another one that is shown. */
  matchAlone(): void {
    void this.measuring.matchAlone(this.seen.active()).then(() => this.opening.showDraft());
  }

  private changed(): void {
    this.lay();
    this.layers.redraw();
    this.tell();
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }

  /** On a narrow page the canvas is as high as its panes need it. */
  private lay(): void {
    const view = this.seen.view();
    const count = view === null ? 0 : shownImages(this.store.state.panes, view).length;
    const wanted = this.seen.isNarrow && count > 1 ? `${String(count * NARROW_HEIGHT)}px` : '';
    if (this.host.style.minHeight !== wanted) this.host.style.minHeight = wanted;
  }

  private hit(x: number, y: number): { pane: Pane; point: number } | null {
    const pane = paneAt(this.seen.panes(), x, y);
    if (pane?.points == null || !this.store.state.panes.look.points) return null;
    const { keeps } = this.seen.marked(pane.image);
    const row = nearestRow(pane.points, pane, ...toPosition(pane.transform, x, y), REACH / pane.transform.scale, keeps);
    const point = row < 0 ? undefined : pane.points.points[row];
    return point === undefined ? null : { pane, point };
  }

  /** `more`: beside what is chosen. */
  private press(x: number, y: number, more: boolean): void {
    const panes = this.seen.panes();
    if (this.measuring.draft !== null) {
      // What the loupe over a pane shows is where it says.
      const lens = this.lenses(panes).find(({ rect }) => contains(rect, x, y));
      const { pane, transform } = lens ?? { pane: paneAt(panes, x, y), transform: paneAt(panes, x, y)?.transform };
      if (pane !== null && transform !== undefined) this.measuring.place(pane, toPosition(transform, x, y));
      this.opening.showDraft();
      return;
    }
    const hit = this.hit(x, y);
    if (more) {
      if (hit !== null) this.looking.choose(withMore(this.store.state.selection.chosen, [hit.point]));
      return;
    }
    this.opening.again();
    this.looking.choose(hit === null ? null : { kind: 'observation', point: hit.point, image: hit.pane.image });
    this.opening.follow();
  }

  private point(at: Position | null, dragging: boolean): void {
    this.pointer = at;
    if (!dragging) {
      const hit = at === null ? null : this.hit(...at);
      this.looking.point(hit === null ? null : { kind: 'observation', point: hit.point, image: hit.pane.image });
    }
    this.layers.redraw('overlay', 'lenses');
    this.tell();
  }

  private lenses(panes: readonly Pane[]): Lens[] {
    if (this.measuring.draft !== null) return draftLenses(this.measuring, panes);
    const pointed = this.pointedAt();
    if (!this.store.state.panes.look.loupe || pointed === null || this.pointer === null) return [];
    return lensesAt(this.seen, panes, this.pointer, pointed);
  }

  private draw(name: LayerName, context: CanvasRenderingContext2D): void {
    const panes = this.seen.panes();
    const { ratio } = this.layers;
    if (name === 'pictures') paintPictures(context, this.bitmaps, panes, ratio);
    else if (name === 'marks') paintMarks(context, this.seen, panes);
    else if (name === 'lenses') paintLenses(context, this.bitmaps, this.lenses(panes), ratio);
    else paintOverlay(context, this.seen, this.measuring, panes, this.lenses(panes), this.pointedAt());
  }
}
