/** The picture of the block: its images in plan, joined by lines as wide as they have points in common; pan, zoom, point and press. */
import { press } from './looking';
import type { Looking } from './looking';
import type { Choice } from '../state/state';
import type { BlockStore } from '../engine/engine';
import { fitPlan, hitPlan, linesOf, placeOf, zoomedPlan, ZOOM_LIMIT } from './plan';
import type { PlanView } from './plan';
import { Surface } from '../../shared/view/surface';
import type { Colours } from '../../shared/view/surface';
import type { BlockView } from '../state/view';

/** Movement below which a press is a click. */
const CLICK_SLACK = 5;
const KEY_PAN = 60;
const KEY_ZOOM = 1.25;
/** Above so many images only those that are pointed at or chosen have their names. */
const NAMED = 60;
/** Of a name: its base line below the middle of its image, its height, and the room to the next one; in CSS px. */
const NAME_BELOW = 19;
const NAME_HEIGHT = 13;
const NAME_GAP = 6;

export class Picture {
  private readonly surface: Surface;
  private plan: PlanView | null = null;
  private of: BlockView | null = null;
  private hovered: Choice | null = null;
  private readonly presses = new Map<number, { x: number; y: number; startX: number; startY: number }>();
  private clicked = false;

  constructor(readonly host: HTMLElement, private readonly store: BlockStore, private readonly looking: Looking) {
    this.surface = new Surface(host, (context, colours) => { this.paint(context, colours); });
    this.surface.canvas.dataset['testid'] = 'block-picture-canvas';
    host.addEventListener('pointerdown', (event) => { this.down(event); });
    host.addEventListener('pointermove', (event) => { this.move(event); });
    host.addEventListener('pointerup', (event) => { this.up(event); });
    host.addEventListener('pointercancel', (event) => { this.presses.delete(event.pointerId); });
    host.addEventListener('pointerleave', () => { this.hover(null); });
    host.addEventListener('wheel', (event) => {
      event.preventDefault();
      const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 24 : 1;
      this.zoom(Math.exp((event.ctrlKey ? -0.01 : -0.0016) * lines * event.deltaY), ...this.surface.place(event));
    }, { passive: false });
    host.addEventListener('keydown', (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey || event.target !== host) return;
      if (this.key(event.key)) event.preventDefault();
    });
    store.watch((s) => [s.shown, s.choice] as const, ([shown]) => {
      // What the user looks at stays while more of the same comes in.
      const same = shown?.view.partial === true && this.of?.partial === true && shown.view.layout.kind === this.of.layout.kind;
      if (shown?.view !== this.of && !same) this.plan = null;
      this.of = shown?.view ?? null;
      this.surface.redraw();
    });
  }

  fit(): void {
    this.plan = null;
    this.surface.redraw();
  }

  zoomMiddle(factor: number): void {
    this.zoom(factor, this.surface.width / 2, this.surface.height / 2);
  }

  private view(): BlockView | null {
    return this.store.state.shown?.view ?? null;
  }

  /** The plan as it is looked at; all of it until it was moved. */
  private current(view: BlockView): PlanView {
    return this.plan ?? fitPlan(view, this.surface.width, this.surface.height);
  }

  private zoom(factor: number, x: number, y: number): void {
    const view = this.view();
    if (view === null) return;
    const whole = fitPlan(view, this.surface.width, this.surface.height).scale;
    const { scale } = this.current(view);
    const limited = Math.min(ZOOM_LIMIT * whole, Math.max(0.2 * whole, scale * factor)) / scale;
    this.plan = zoomedPlan(this.current(view), limited, x, y);
    this.surface.redraw();
  }

  private pan(x: number, y: number): void {
    const view = this.view();
    if (view === null) return;
    const plan = this.current(view);
    this.plan = { ...plan, x: plan.x + x, y: plan.y + y };
    this.surface.redraw();
  }

  private hover(choice: Choice | null): void {
    this.hovered = choice;
    this.looking.point(choice);
    this.surface.redraw();
  }

  private down(event: PointerEvent): void {
    if (event.button !== 0) return;
    const [x, y] = this.surface.place(event);
    this.host.setPointerCapture(event.pointerId);
    this.clicked = this.presses.size === 0;
    this.presses.set(event.pointerId, { x, y, startX: x, startY: y });
  }

  private move(event: PointerEvent): void {
    const [x, y] = this.surface.place(event);
    const press = this.presses.get(event.pointerId);
    const view = this.view();
    if (view === null) return;
    if (press === undefined) {
      this.hover(hitPlan(view, this.current(view), x, y));
      return;
    }
    if (this.clicked && Math.hypot(x - press.startX, y - press.startY) <= CLICK_SLACK) return;
    this.clicked = false;
    const still = [...this.presses].find(([id]) => id !== event.pointerId)?.[1];
    if (still === undefined) {
      this.pan(x - press.x, y - press.y);
    } else {
      // Two fingers: pan by their middle, zoom by their distance.
      this.pan((x - press.x) / 2, (y - press.y) / 2);
      const before = Math.hypot(press.x - still.x, press.y - still.y);
      if (before > 1) this.zoom(Math.hypot(x - still.x, y - still.y) / before, (x + still.x) / 2, (y + still.y) / 2);
    }
    press.x = x;
    press.y = y;
  }

  private up(event: PointerEvent): void {
    const view = this.view();
    if (!this.presses.delete(event.pointerId) || !this.clicked || view === null) return;
    press(this.store, this.looking, hitPlan(view, this.current(view), ...this.surface.place(event)));
  }

  /** Runs the command of a key; false where it has none. */
  private key(key: string): boolean {
    const { choice } = this.store.state;
    switch (key) {
      case 'ArrowLeft': this.pan(KEY_PAN, 0); return true;
      case 'ArrowRight': this.pan(-KEY_PAN, 0); return true;
      case 'ArrowUp': this.pan(0, KEY_PAN); return true;
      case 'ArrowDown': this.pan(0, -KEY_PAN); return true;
      case '+': case '=': this.zoomMiddle(KEY_ZOOM); return true;
      case '-': case '_': this.zoomMiddle(1 / KEY_ZOOM); return true;
      case '0': this.fit(); return true;
      case 'n': case 'N': this.step(1); return true;
      case 'p': case 'P': this.step(-1); return true;
      case 'c': case 'C': this.stepPair(); return true;
      case 'Enter': if (choice?.kind === 'pair') this.looking.open(choice.images); return choice?.kind === 'pair';
      case 'Escape': this.looking.choose(null); return true;
      default: return false;
    }
  }

  /** Chooses the next image. */
  private step(by: number): void {
    const count = this.view()?.images.length ?? 0;
    const { choice } = this.store.state;
    const now = choice === null ? (by > 0 ? -1 : 0) : choice.kind === 'image' ? choice.image : choice.images[0];
    if (count > 0) this.looking.choose({ kind: 'image', image: (now + by + count) % count });
  }

  /** Chooses the next connection of the image that is chosen, or of the first of the pair. */
  private stepPair(): void {
    const view = this.view();
    const { choice } = this.store.state;
    if (view === null || choice === null) return;
    const image = choice.kind === 'image' ? choice.image : choice.images[0];
    const own = view.connections.map(({ images }) => images).filter((images) => images.includes(image)).map(([a, b]): [number, number] => (a === image ? [a, b] : [b, a]));
    const at = choice.kind === 'pair' ? own.findIndex(([, b]) => b === choice.images[1]) : -1;
    const next = own[(at + 1) % Math.max(1, own.length)];
    if (next !== undefined) this.looking.choose({ kind: 'pair', images: next });
  }

  private paint(context: CanvasRenderingContext2D, colours: Colours): void {
    const view = this.view();
    if (view === null || view.images.length === 0) return;
    const plan = this.current(view);
    const marked = [this.store.state.choice, this.hovered].filter((choice) => choice !== null);
    paintLines(context, colours, view, plan, marked);
    paintImages(context, colours, view, plan, marked);
    paintNames(context, colours, view, plan, marked);
  }
}

function isOf(choice: Choice, images: readonly [number, number]): boolean {
  return choice.kind === 'image' ? images.includes(choice.image) : images.every((image) => choice.images.includes(image));
}

function paintLines(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, plan: PlanView, marked: readonly Choice[]): void {
  context.lineCap = 'round';
  for (const { images, width, strength } of linesOf(view)) {
    const on = marked.some((choice) => isOf(choice, images));
    context.globalAlpha = on ? 1 : (marked.length > 0 ? 0.35 : 1) * (0.3 + 0.5 * strength);
    context.strokeStyle = on ? colours.accent : colours.bars;
    context.lineWidth = on ? Math.max(width, 2) : width;
    context.beginPath();
    context.moveTo(...placeOf(view, plan, images[0]));
    context.lineTo(...placeOf(view, plan, images[1]));
    context.stroke();
  }
  context.globalAlpha = 1;
  paintRefused(context, colours, view, plan, marked);
}

/** Pairs that were tried in vain, dashed: those of the image that is chosen, and the pair that is chosen itself. */
function paintRefused(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, plan: PlanView, marked: readonly Choice[]): void {
  context.setLineDash([4, 4]);
  context.lineWidth = 1;
  for (const { images, outcome } of view.connections) {
    if (outcome.kind === 'connected' || !marked.some((choice) => isOf(choice, images))) continue;
    context.strokeStyle = outcome.kind === 'failed' ? colours.problem : colours.muted;
    context.beginPath();
    context.moveTo(...placeOf(view, plan, images[0]));
    context.lineTo(...placeOf(view, plan, images[1]));
    context.stroke();
  }
  context.setLineDash([]);
}

function paintImages(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, plan: PlanView, marked: readonly Choice[]): void {
  const largest = new Set(view.groups[0]);
  view.images.forEach(({ oriented }, i) => {
    const [x, y] = placeOf(view, plan, i);
    const on = marked.some((choice) => (choice.kind === 'image' ? choice.image === i : choice.images.includes(i)));
    const radius = on ? 7 : view.images.length > 300 ? 3 : 5;
    // Filled: oriented, or at least connected with most; hollow: neither.
    // While a run goes on nothing is said against an image.
    const sound = view.partial || (view.layout.kind === 'oriented' ? oriented : largest.has(i));
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.fillStyle = sound ? (on ? colours.accent : colours.bars) : colours.surface;
    context.fill();
    context.lineWidth = sound ? 1.5 : 2;
    context.strokeStyle = sound ? colours.surface : colours.problem;
    context.stroke();
  });
}

/** Names below their images, as far as there is room beside each other: first those that are pointed at or chosen, which always stand. */
function paintNames(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, plan: PlanView, marked: readonly Choice[]): void {
  context.font = '11px system-ui, sans-serif';
  context.textAlign = 'center';
  const isMarked = (image: number) => marked.some((choice) => (choice.kind === 'image' ? choice.image === image : choice.images.includes(image)));
  const all = view.images.map((_, image) => image);
  const named = [...all.filter(isMarked), ...(view.images.length > NAMED ? [] : all.filter((image) => !isMarked(image)))];
  const taken: { x: number; y: number; half: number }[] = [];
  for (const image of named) {
    const text = (view.images[image]?.name ?? '').replace(/\.[^.]+$/u, '');
    const [x, middle] = placeOf(view, plan, image);
    const [y, half] = [middle + NAME_BELOW, 0.5 * context.measureText(text).width];
    const crowded = taken.some((other) => Math.abs(other.x - x) < other.half + half + NAME_GAP && Math.abs(other.y - y) < NAME_HEIGHT);
    if (crowded && !isMarked(image)) continue;
    taken.push({ x, y, half });
    paintName(context, colours, text, x, y);
  }
}

function paintName(context: CanvasRenderingContext2D, colours: Colours, text: string, x: number, y: number): void {
  context.lineWidth = 3;
  context.strokeStyle = colours.ground;
  context.strokeText(text, x, y);
  context.fillStyle = colours.text;
  context.fillText(text, x, y);
}
