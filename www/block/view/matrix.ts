/** The matrix of matches: images by images, darker where a pair has more; marked where it was tried in vain, blank where it was not tried. */
import type { BlockStore } from '../engine/engine';
import { press } from './looking';
import type { Looking } from './looking';
import type { Choice } from '../state/state';
import { Surface } from '../../shared/view/surface';
import type { Colours } from '../../shared/view/surface';
import type { BlockView } from '../state/view';
import { connectionOf, connectionsOf, matchesOf } from '../state/words';

/** Side of a cell in CSS px: as large as there is room for, within these. */
const SMALLEST = 4;
/** Browsers draw no larger canvas on a screen of two device pixels a CSS px. */
const LARGEST_SHEET = 8000;
const LARGEST = 44;
/** Room for the numbers of the images. */
const HEAD = 30;
/** From this side on a cell holds the number of matches. */
const NUMBERED = 30;

export class Matrix {
  private readonly sheet = document.createElement('div');
  private readonly surface: Surface;
  private hovered: [number, number] | null = null;

  constructor(private readonly host: HTMLElement, private readonly store: BlockStore, private readonly looking: Looking) {
    this.sheet.className = 'matrix-sheet';
    host.append(this.sheet);
    this.surface = new Surface(this.sheet, (context, colours) => { this.paint(context, colours); });
    this.surface.canvas.dataset['testid'] = 'block-matrix-canvas';
    new ResizeObserver(() => { this.size(); }).observe(host);
    this.sheet.addEventListener('pointermove', (event) => { this.hover(this.cellAt(event)); });
    this.sheet.addEventListener('pointerleave', () => { this.hover(null); });
    this.sheet.addEventListener('click', (event) => {
      const cell = this.cellAt(event);
      press(store, looking, cell === null ? null : choiceOf(cell));
    });
    host.addEventListener('keydown', (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey || event.target !== host) return;
      if (this.key(event.key)) event.preventDefault();
    });
    store.watch((s) => [s.shown] as const, () => { this.size(); });
    store.watch((s) => [s.choice] as const, () => { this.surface.redraw(); });
  }

  private view(): BlockView | null {
    return this.store.state.shown?.view ?? null;
  }

  private cellSide(): number {
    const count = this.view()?.images.length ?? 1;
    const room = Math.min(this.host.clientWidth, this.host.clientHeight) - HEAD - 4;
    const smallest = Math.max(1, Math.min(SMALLEST, Math.floor(LARGEST_SHEET / count)));
    return Math.min(LARGEST, Math.max(smallest, Math.floor(room / count)));
  }

  /** A matrix larger than its host is scrolled; one that is hidden is sized when it comes into sight. */
  private size(): void {
    if (this.host.closest('[hidden]') !== null) return;
    const side = `${String(HEAD + 2 + this.cellSide() * (this.view()?.images.length ?? 0))}px`;
    Object.assign(this.sheet.style, { width: side, height: side });
    this.surface.redraw();
  }

  private cellAt(event: MouseEvent): [number, number] | null {
    const view = this.view();
    const [x, y] = this.surface.place(event);
    const [column, row] = [x, y].map((v) => Math.floor((v - HEAD) / this.cellSide())) as [number, number];
    const inside = (index: number) => index >= 0 && index < (view?.images.length ?? 0);
    return inside(column) && inside(row) ? [row, column] : null;
  }

  private hover(cell: [number, number] | null): void {
    this.hovered = cell;
    this.looking.point(cell === null ? null : choiceOf(cell));
    this.surface.redraw();
  }

  /** Runs the command of a key; false where it has none. */
  private key(key: string): boolean {
    const { choice } = this.store.state;
    const step = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0] }[key];
    if (step !== undefined) {
      const [row, column] = choice === null ? [0, 0] : choice.kind === 'pair' ? choice.images : [choice.image, choice.image];
      const within = (index: number) => Math.min(Math.max(index, 0), (this.view()?.images.length ?? 1) - 1);
      const cell: [number, number] = [within(row + (step[0] ?? 0)), within(column + (step[1] ?? 0))];
      this.looking.choose(choiceOf(cell));
      this.reveal(cell);
      return true;
    }
    if (key === 'Enter' && choice?.kind === 'pair') this.looking.open(choice.images);
    else if (key === 'Escape') this.looking.choose(null);
    else return false;
    return true;
  }

  private reveal([row, column]: [number, number]): void {
    const side = this.cellSide();
    const bring = (at: number, from: number, length: number) => (at < from ? at - side : at + 2 * side > from + length ? at + 2 * side - length : from);
    this.host.scrollTop = bring(row * side, this.host.scrollTop, this.host.clientHeight - HEAD);
    this.host.scrollLeft = bring(column * side, this.host.scrollLeft, this.host.clientWidth - HEAD);
  }

  private paint(context: CanvasRenderingContext2D, colours: Colours): void {
    const view = this.view();
    if (view === null) return;
    const side = this.cellSide();
    const count = view.images.length;
    paintHeads(context, colours, count, side);
    const most = view.connections.reduce((high, connection) => Math.max(high, matchesOf(connection)), 1);
    for (const connection of connectionsOf(view).values()) {
      const [a, b] = connection.images;
      const matches = matchesOf(connection);
      const tried = connection.outcome.kind === 'connected';
      context.globalAlpha = tried ? 0.15 + 0.85 * Math.sqrt(matches / most) : 0.6;
      // Images without common ground are nothing wrong.
      context.fillStyle = tried ? colours.bars : connection.outcome.kind === 'failed' ? colours.problem : colours.muted;
      for (const [row, column] of [[a, b], [b, a]] as const) paintCell(context, HEAD + column * side, HEAD + row * side, side, tried);
      context.globalAlpha = 1;
      if (tried && side >= NUMBERED) paintNumbers(context, colours, [a, b], side, matches);
    }
    context.strokeStyle = colours.line;
    context.lineWidth = 1;
    context.strokeRect(HEAD - 0.5, HEAD - 0.5, count * side + 1, count * side + 1);
    context.fillStyle = colours.line;
    for (let i = 0; i < count; i++) context.fillRect(HEAD + i * side, HEAD + i * side, side, side);
    this.paintMarks(context, colours, view, side);
  }

  private paintMarks(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, side: number): void {
    const { choice } = this.store.state;
    context.strokeStyle = colours.accent;
    context.lineWidth = 2;
    const cells = [choice?.kind === 'pair' ? choice.images : null, this.hovered].filter((cell) => cell !== null);
    for (const [row, column] of cells) {
      context.strokeRect(HEAD + column * side, HEAD + row * side, side, side);
      if (connectionOf(view, [row, column]) !== undefined) context.strokeRect(HEAD + row * side, HEAD + column * side, side, side);
    }
    if (choice?.kind !== 'image') return;
    const length = view.images.length * side;
    context.strokeRect(HEAD, HEAD + choice.image * side, length, side);
    context.strokeRect(HEAD + choice.image * side, HEAD, side, length);
  }
}

function choiceOf([row, column]: [number, number]): Choice {
  return row === column ? { kind: 'image', image: row } : { kind: 'pair', images: [row, column] };
}

/** A pair that was tried in vain is a small square: told apart from a weak one without its colour. */
function paintCell(context: CanvasRenderingContext2D, x: number, y: number, side: number, connected: boolean): void {
  const gap = side > 8 ? 1 : 0;
  const share = side > 12 ? 0.28 : 0.6;
  if (connected) context.fillRect(x, y, side - gap, side - gap);
  else context.fillRect(x + 0.5 * (1 - share) * side, y + 0.5 * (1 - share) * side, share * side, share * side);
}

function paintNumbers(context: CanvasRenderingContext2D, colours: Colours, [a, b]: [number, number], side: number, matches: number): void {
  context.font = '10px system-ui, sans-serif';
  context.textAlign = 'center';
  for (const [row, column] of [[a, b], [b, a]] as const) {
    const [x, y] = [HEAD + (column + 0.5) * side, HEAD + (row + 0.5) * side + 3.5];
    context.lineWidth = 3;
    context.strokeStyle = colours.surface;
    context.strokeText(String(matches), x, y);
    context.fillStyle = colours.text;
    context.fillText(String(matches), x, y);
  }
}

/** Numbers of the images, as in their table, so many that they do not touch. */
function paintHeads(context: CanvasRenderingContext2D, colours: Colours, count: number, side: number): void {
  const step = [1, 2, 5, 10, 20, 50, 100, 200, 500].find((s) => s * side >= 24) ?? 1000;
  context.font = '10px system-ui, sans-serif';
  context.fillStyle = colours.muted;
  for (let i = 0; i < count; i += step) {
    context.textAlign = 'center';
    context.fillText(String(i + 1), HEAD + (i + 0.5) * side, HEAD - 6);
    context.textAlign = 'right';
    context.fillText(String(i + 1), HEAD - 5, HEAD + (i + 0.5) * side + 3.5);
  }
}
