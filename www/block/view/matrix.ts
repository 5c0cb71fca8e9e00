/** The matrix of matches: images by images, darker where a pair has more; marked where it was tried in vain, blank where it was not tried. */
import type { Colours } from '../../shared/view/colours';
import { within } from '../../shared/view/layers';
import { toCanvas, toPosition } from '../../shared/view/transform';
import type { Transform } from '../../shared/view/transform';
import type { BlockStore } from '../engine/engine';
import type { Choice } from '../state/selection';
import type { BlockView } from '../state/view';
import { keptBy } from '../state/columns';
import { imagesOf, pairsOf } from '../state/selection';
import { connectionOf, matchesOf } from '../state/words';
import { Chart } from './chart';
import type { Looking } from './looking';

/** Side of a cell in CSS px: in the whole matrix, and enlarged. */
const LARGEST_WHOLE = 44;
const LARGEST = 160;
/** Room for the numbers of the images. */
const HEAD = 30;
/** From this side on a cell holds the number of matches. */
const NUMBERED = 30;

type Cell = [row: number, column: number];

export class Matrix extends Chart {
  constructor(host: HTMLElement, store: BlockStore, looking: Looking) {
    super(host, 'matrix', store, looking);
  }

  protected override whole({ images: { length } }: BlockView): Transform {
    const room = Math.min(this.layers.width, this.layers.height) - HEAD - 4;
    const side = Math.min(LARGEST_WHOLE, room / Math.max(1, length));
    return { scale: side > 4 ? Math.floor(side) : side, x: HEAD, y: HEAD };
  }

  protected override limits(whole: number): { least: number; most: number } {
    return { least: whole, most: LARGEST };
  }

  /** It leaves the heads only towards the upper left, and its last cell comes no farther than the middle. */
  protected override held({ images: { length } }: BlockView, { scale, x, y }: Transform): Transform {
    const within = (shift: number, room: number) => Math.min(HEAD, Math.max(Math.min(HEAD, (HEAD + room) / 2 - length * scale), shift));
    return { scale, x: within(x, this.layers.width), y: within(y, this.layers.height) };
  }

  protected override hit(view: BlockView, t: Transform, x: number, y: number): Choice | null {
    const [column, row] = toPosition(t, x, y).map(Math.floor) as [number, number];
    const inside = (index: number) => index >= 0 && index < view.images.length;
    return x >= HEAD && y >= HEAD && inside(column) && inside(row) ? choiceOf([row, column]) : null;
  }

  /** Arrows go from cell to cell. */
  protected override command(key: string): boolean {
    const step = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0] }[key];
    const view = this.view();
    if (step === undefined || view === null) return false;
    const [row, column] = cellOf(this.store.state.selection.chosen) ?? [0, 0];
    const inside = (index: number) => Math.min(Math.max(index, 0), view.images.length - 1);
    const cell: Cell = [inside(row + (step[0] ?? 0)), inside(column + (step[1] ?? 0))];
    this.looking.choose(choiceOf(cell));
    this.reveal(view, cell);
    return true;
  }

  /** Brings a cell into sight. */
  private reveal(view: BlockView, [row, column]: Cell): void {
    const t = this.current(view);
    const brought = (index: number, shift: number, room: number) => Math.max(HEAD - index * t.scale, Math.min(shift, room - (index + 1) * t.scale - 2));
    this.move(view, { scale: t.scale, x: brought(column, t.x, this.layers.width), y: brought(row, t.y, this.layers.height) });
  }

  protected override paint(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, t: Transform): void {
    const { width, height } = this.layers;
    paintHeads(context, colours, view.images.length, t, width, height);
    within(context, { left: HEAD - 1, top: HEAD - 1, width, height }, () => {
      this.paintCells(context, colours, view, t);
      this.paintMarks(context, colours, view, t);
    });
  }

  private paintCells(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, t: Transform): void {
    const { scale: side } = t;
    const count = view.images.length;
    const most = view.connections.reduce((high, connection) => Math.max(high, matchesOf(connection)), 1);
    const keeps = keptBy('pairs', view, this.store.state.selection);
    for (const [pair, connection] of view.connections.entries()) {
      if (!keeps(pair)) continue;
      const [a, b] = connection.images;
      const matches = matchesOf(connection);
      const tried = connection.outcome.kind === 'connected';
      const alpha = tried ? 0.15 + 0.85 * Math.sqrt(matches / most) : 0.6;
      for (const [row, column] of [
        [a, b],
        [b, a],
      ] as const) {
        const [x, y] = toCanvas(t, column, row);
        if (x > this.layers.width || y > this.layers.height || x + side < HEAD || y + side < HEAD) continue;
        context.globalAlpha = alpha;
        // Images without common ground are nothing wrong.
        context.fillStyle = tried ? colours.bars : connection.outcome.kind === 'failed' ? colours.problem : colours.muted;
        if (connection.rejected) paintRejected(context, colours, x, y, side);
        else paintCell(context, x, y, side, tried);
        context.globalAlpha = 1;
        if (tried && side >= NUMBERED) paintNumber(context, colours, x + side / 2, y + side / 2 + 3.5, matches);
      }
    }
    context.strokeStyle = colours.line;
    context.lineWidth = 1;
    context.strokeRect(t.x - 0.5, t.y - 0.5, count * side + 1, count * side + 1);
    context.fillStyle = colours.line;
    for (let i = 0; i < count; i++) context.fillRect(...toCanvas(t, i, i), side, side);
  }

  private paintMarks(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, t: Transform): void {
    const { chosen, pointed } = this.store.state.selection;
    const { scale: side } = t;
    context.strokeStyle = colours.accent;
    context.lineWidth = 2;
    const cells = [...pairsOf(chosen), cellOf(pointed)].filter((cell) => cell !== null);
    for (const [row, column] of cells) {
      context.strokeRect(...toCanvas(t, column, row), side, side);
      if (connectionOf(view, [row, column]) !== undefined) context.strokeRect(...toCanvas(t, row, column), side, side);
    }
    if (chosen?.kind !== 'image' && chosen?.kind !== 'images') return;
    const length = view.images.length * side;
    for (const image of imagesOf(chosen)) {
      context.strokeRect(...toCanvas(t, 0, image), length, side);
      context.strokeRect(...toCanvas(t, image, 0), side, length);
    }
  }
}

function choiceOf([row, column]: Cell): Choice {
  return row === column ? { kind: 'image', image: row } : { kind: 'pair', images: [row, column] };
}

/** Of an image that on the diagonal; null for what has none. */
function cellOf(choice: Choice | null): Cell | null {
  const [row, column = row] = imagesOf(choice);
  return row === undefined || column === undefined ? null : [row, column];
}

/** A pair that was tried in vain is a small square: told apart from a weak one without its colour. */
function paintCell(context: CanvasRenderingContext2D, x: number, y: number, side: number, connected: boolean): void {
  const gap = side > 8 ? 1 : 0;
  const share = side > 12 ? 0.28 : 0.6;
  if (connected) context.fillRect(x, y, side - gap, side - gap);
  else context.fillRect(x + 0.5 * (1 - share) * side, y + 0.5 * (1 - share) * side, share * side, share * side);
}

/** A pair that was rejected by hand is hollow, as an image is on the map. */
function paintRejected(context: CanvasRenderingContext2D, colours: Colours, x: number, y: number, side: number): void {
  const width = side > 8 ? 2 : 1;
  context.globalAlpha = 1;
  context.strokeStyle = colours.problem;
  context.lineWidth = width;
  context.strokeRect(x + width, y + width, side - 2 * width - 1, side - 2 * width - 1);
}

function paintNumber(context: CanvasRenderingContext2D, colours: Colours, x: number, y: number, matches: number): void {
  context.font = '10px system-ui, sans-serif';
  context.textAlign = 'center';
  context.lineWidth = 3;
  context.strokeStyle = colours.surface;
  context.strokeText(String(matches), x, y);
  context.fillStyle = colours.text;
  context.fillText(String(matches), x, y);
}

/** Numbers of the images, as in their table, so many that they do not touch; they stay in sight wherever the matrix is moved. */
function paintHeads(context: CanvasRenderingContext2D, colours: Colours, count: number, t: Transform, width: number, height: number): void {
  const step = [1, 2, 5, 10, 20, 50, 100, 200, 500].find((s) => s * t.scale >= 24) ?? 1000;
  context.font = '10px system-ui, sans-serif';
  context.fillStyle = colours.muted;
  for (let i = 0; i < count; i += step) {
    const [x, y] = toCanvas(t, i + 0.5, i + 0.5);
    context.textAlign = 'center';
    if (x > HEAD && x < width) context.fillText(String(i + 1), x, HEAD - 6);
    context.textAlign = 'right';
    if (y > HEAD && y < height) context.fillText(String(i + 1), HEAD - 5, y + 3.5);
  }
}
