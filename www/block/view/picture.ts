/** The picture of the block: its images in plan, joined by lines as wide as they have points in common; pan, zoom, point and press. */
import type { Colours } from '../../shared/view/colours';
import type { Transform } from '../../shared/view/transform';
import { Chart } from './chart';
import type { Looking } from './looking';
import type { Choice } from '../state/state';
import type { BlockStore } from '../engine/engine';
import { fitPlan, hitPlan, linesOf, placeOf, thumbWidth } from './plan';
import { Thumbs } from './thumbs';
import type { BlockView } from '../state/view';

/** Above so many images only those that are pointed at or chosen have their names. */
const NAMED = 60;
/** Of a name: its base line below the middle of its image, its height, and the room to the next one; in CSS px. */
const NAME_BELOW = 19;
const NAME_HEIGHT = 13;
const NAME_GAP = 6;

export class Picture extends Chart {
  private readonly thumbs = new Thumbs(() => this.layers.redraw());

  constructor(host: HTMLElement, store: BlockStore, looking: Looking) {
    super(host, 'plan', store, looking);
  }

  protected override whole(view: BlockView): Transform {
    return fitPlan(view, this.layers.width, this.layers.height);
  }

  protected override limits(whole: number): { least: number; most: number } {
    return { least: 0.2 * whole, most: 200 * whole };
  }

  protected override hit(view: BlockView, plan: Transform, x: number, y: number): Choice | null {
    return hitPlan(view, plan, x, y);
  }

  protected override command(key: string): boolean {
    switch (key) {
      case 'n':
      case 'N':
        this.step(1);
        return true;
      case 'p':
      case 'P':
        this.step(-1);
        return true;
      case 'c':
      case 'C':
        this.stepPair();
        return true;
      default:
        return false;
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
    const own = view.connections
      .map(({ images }) => images)
      .filter((images) => images.includes(image))
      .map(([a, b]): [number, number] => (a === image ? [a, b] : [b, a]));
    const at = choice.kind === 'pair' ? own.findIndex(([, b]) => b === choice.images[1]) : -1;
    const next = own[(at + 1) % Math.max(1, own.length)];
    if (next !== undefined) this.looking.choose({ kind: 'pair', images: next });
  }

  protected override paint(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, plan: Transform): void {
    const marked = [this.store.state.choice, this.hovered].filter((choice) => choice !== null);
    paintLines(context, colours, view, plan, marked);
    paintImages(context, colours, view, plan, marked);
    const below = this.paintThumbs(context, colours, view, plan, marked);
    paintNames(context, colours, view, plan, marked, below);
  }

  /** Paints the photos over their dots once a run has ended; gives how far below the middle of an image its name stands. */
  private paintThumbs(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, plan: Transform, marked: readonly Choice[]): number {
    const width = thumbWidth(view, plan);
    const { shown, files, running } = this.store.state;
    if (width === 0 || shown === null || running.kind === 'yes') return NAME_BELOW;
    const ofName = new Map([...files, ...shown.files].map((file) => [file.name, file]));
    const isSound = soundness(view);
    let below = NAME_BELOW;
    view.images.forEach(({ name }, i) => {
      const file = ofName.get(name);
      const thumb = file === undefined ? null : this.thumbs.get(file);
      if (thumb === null) return;
      const height = (width * thumb.height) / thumb.width;
      const [x, y] = placeOf(view, plan, i);
      context.drawImage(thumb, x - width / 2, y - height / 2, width, height);
      const on = marked.some((choice) => (choice.kind === 'image' ? choice.image === i : choice.images.includes(i)));
      context.lineWidth = on ? 3 : 1.5;
      context.strokeStyle = on ? colours.accent : isSound(i) ? colours.surface : colours.problem;
      context.strokeRect(x - width / 2, y - height / 2, width, height);
      below = Math.max(below, height / 2 + NAME_HEIGHT);
    });
    return below;
  }
}

/** Tells whether an image is oriented, or at least connected with most. While a run goes on nothing is said against an image. */
function soundness(view: BlockView): (image: number) => boolean {
  const largest = new Set(view.groups[0]);
  return (image) => view.partial || (view.layout.kind === 'oriented' ? view.images[image]?.oriented === true : largest.has(image));
}

function isOf(choice: Choice, images: readonly [number, number]): boolean {
  return choice.kind === 'image' ? images.includes(choice.image) : images.every((image) => choice.images.includes(image));
}

function paintLines(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, plan: Transform, marked: readonly Choice[]): void {
  context.lineCap = 'round';
  for (const { images, width, strength } of linesOf(view)) {
    const on = marked.some((choice) => isOf(choice, images));
    context.globalAlpha = on ? 1 : (marked.length > 0 ? 0.35 : 1) * (0.3 + 0.5 * strength);
    context.strokeStyle = on ? colours.accent : colours.bars;
    context.lineWidth = on ? Math.max(width, 2) : width;
    paintLine(context, view, plan, images);
  }
  context.globalAlpha = 1;
  paintRefused(context, colours, view, plan, marked);
}

function paintLine(context: CanvasRenderingContext2D, view: BlockView, plan: Transform, [a, b]: readonly [number, number]): void {
  context.beginPath();
  context.moveTo(...placeOf(view, plan, a));
  context.lineTo(...placeOf(view, plan, b));
  context.stroke();
}

/** Pairs that were tried in vain, dashed: those of the image that is chosen, and the pair that is chosen itself. */
function paintRefused(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, plan: Transform, marked: readonly Choice[]): void {
  context.setLineDash([4, 4]);
  context.lineWidth = 1;
  for (const { images, outcome } of view.connections) {
    if (outcome.kind === 'connected' || !marked.some((choice) => isOf(choice, images))) continue;
    context.strokeStyle = outcome.kind === 'failed' ? colours.problem : colours.muted;
    paintLine(context, view, plan, images);
  }
  context.setLineDash([]);
}

function paintImages(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, plan: Transform, marked: readonly Choice[]): void {
  const isSound = soundness(view);
  view.images.forEach((_, i) => {
    const [x, y] = placeOf(view, plan, i);
    const on = marked.some((choice) => (choice.kind === 'image' ? choice.image === i : choice.images.includes(i)));
    const radius = on ? 7 : view.images.length > 300 ? 3 : 5;
    // Hollow where it is not.
    const sound = isSound(i);
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
function paintNames(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, plan: Transform, marked: readonly Choice[], below: number): void {
  context.font = '11px system-ui, sans-serif';
  context.textAlign = 'center';
  const isMarked = (image: number) => marked.some((choice) => (choice.kind === 'image' ? choice.image === image : choice.images.includes(image)));
  const all = view.images.map((_, image) => image);
  const named = [...all.filter(isMarked), ...(view.images.length > NAMED ? [] : all.filter((image) => !isMarked(image)))];
  const taken: { x: number; y: number; half: number }[] = [];
  for (const image of named) {
    const text = (view.images[image]?.name ?? '').replace(/\.[^.]+$/u, '');
    const [x, middle] = placeOf(view, plan, image);
    const [y, half] = [middle + below, 0.5 * context.measureText(text).width];
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
