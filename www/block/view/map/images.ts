/** Images of the map: dots or small photos with their names, joined by lines as wide as they have points in common. */
import type { Colours } from '../../../shared/view/colours';
import type { Transform } from '../../../shared/view/transform';
import { imagesOf, keyOfPair, pairsOf } from '../../state/selection';
import type { Choice } from '../../state/selection';
import type { BlockView } from '../../state/view';
import { haloed } from './frame';
import { linesOf, placeOf } from './plan';

/** Above so many images only those that are pointed at or chosen have their names. */
const NAMED = 60;
/** Of a name: its base line below the middle of its image, its height, and the room to the next one; in CSS px. */
export const NAME_BELOW = 19;
export const NAME_HEIGHT = 13;
const NAME_GAP = 6;

/** What is marked, and what the filters keep. */
export interface Shown {
  marked: readonly Choice[];
  keepsImage: (image: number) => boolean;
  keepsPair: (pair: number) => boolean;
}

export function isMarked({ marked }: Shown, image: number): boolean {
  return marked.some((choice) => imagesOf(choice).includes(image));
}

/** Tells whether an image is oriented, or at least connected with most. While a run goes on nothing is said against an image. */
export function soundness(view: BlockView): (image: number) => boolean {
  const largest = new Set(view.groups[0]);
  return (image) => view.partial || (view.layout.kind === 'oriented' ? view.images[image]?.oriented === true : largest.has(image));
}

function isOf(choice: Choice, images: readonly [number, number]): boolean {
  if (choice.kind === 'pairs') return pairsOf(choice).map(keyOfPair).includes(keyOfPair(images));
  const own = imagesOf(choice);
  return own.length === 1 ? own.every((image) => images.includes(image)) : images.every((image) => own.includes(image));
}

/** From so many lines on they are drawn once, and moved as a picture. */
export const MANY_LINES = 500;

/** Of lines of pairs that nothing comes of, in CSS px. */
const DASHES = [4, 4];

/** The lines of all pairs that are kept; dashed those that were rejected by hand. */
export function paintLines(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, plan: Transform, keepsPair: (pair: number) => boolean): void {
  const alpha = context.globalAlpha;
  context.lineCap = 'round';
  for (const line of linesOf(view)) {
    if (!keepsPair(line.pair)) continue;
    context.strokeStyle = line.rejected ? colours.problem : colours.bars;
    context.setLineDash(line.rejected ? DASHES : []);
    context.globalAlpha = line.rejected ? alpha : alpha * (0.3 + 0.5 * line.strength);
    context.lineWidth = line.width;
    paintLine(context, view, plan, line.images);
  }
  context.setLineDash([]);
  context.globalAlpha = alpha;
}

/** Over them the lines of what is marked, and dashed the pairs of it that were tried in vain. */
export function paintMarkedLines(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, plan: Transform, { marked, keepsPair }: Shown): void {
  if (marked.length === 0) return;
  const isOn = (images: readonly [number, number]) => marked.some((choice) => isOf(choice, images));
  context.strokeStyle = colours.accent;
  for (const { pair, images, width, rejected } of linesOf(view)) {
    if (!keepsPair(pair) || !isOn(images)) continue;
    context.setLineDash(rejected ? DASHES : []);
    context.lineWidth = Math.max(width, 2);
    paintLine(context, view, plan, images);
  }
  context.setLineDash(DASHES);
  context.lineWidth = 1;
  for (const [pair, { images, outcome }] of view.connections.entries()) {
    if (outcome.kind === 'connected' || !keepsPair(pair) || !isOn(images)) continue;
    context.strokeStyle = outcome.kind === 'failed' ? colours.problem : colours.muted;
    paintLine(context, view, plan, images);
  }
  context.setLineDash([]);
}

function paintLine(context: CanvasRenderingContext2D, view: BlockView, plan: Transform, [a, b]: readonly [number, number]): void {
  context.beginPath();
  context.moveTo(...placeOf(view, plan, a));
  context.lineTo(...placeOf(view, plan, b));
  context.stroke();
}

export function paintImages(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, plan: Transform, shown: Shown): void {
  const isSound = soundness(view);
  view.images.forEach((_, i) => {
    if (!shown.keepsImage(i)) return;
    const [x, y] = placeOf(view, plan, i);
    const on = isMarked(shown, i);
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
export function paintNames(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, plan: Transform, shown: Shown, below: number): void {
  context.font = '11px system-ui, sans-serif';
  context.textAlign = 'center';
  const all = view.images.map((_, image) => image).filter(shown.keepsImage);
  const on = new Set(all.filter((image) => isMarked(shown, image)));
  const named = [...on, ...(all.length > NAMED ? [] : all.filter((image) => !on.has(image)))];
  const taken: { x: number; y: number; half: number }[] = [];
  for (const image of named) {
    const text = (view.images[image]?.name ?? '').replace(/\.[^.]+$/u, '');
    const [x, middle] = placeOf(view, plan, image);
    const [y, half] = [middle + below, 0.5 * context.measureText(text).width];
    const crowded = taken.some((other) => Math.abs(other.x - x) < other.half + half + NAME_GAP && Math.abs(other.y - y) < NAME_HEIGHT);
    if (crowded && !on.has(image)) continue;
    taken.push({ x, y, half });
    haloed(context, colours, text, x, y);
  }
}
