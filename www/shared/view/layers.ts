/** Canvases that fill their host, one above the other, sharp on any screen; each is drawn again only when what it shows changed. */
import type { Rect } from './transform';
import { say } from '../text/words';

function contextOf(canvas: HTMLCanvasElement): CanvasRenderingContext2D {
  const context = canvas.getContext('2d');
  if (context === null) throw new Error(say('this-browser-offers-no-canvas'));
  return context;
}

/** Draws within a rectangle alone. */
export function within(context: CanvasRenderingContext2D, rect: Rect, draw: () => void): void {
  context.save();
  context.beginPath();
  context.rect(rect.left, rect.top, rect.width, rect.height);
  context.clip();
  draw();
  context.restore();
}

export class Layers<Name extends string> {
  private readonly contexts: Readonly<Record<Name, CanvasRenderingContext2D>>;
  private readonly dirty = new Set<Name>();
  private frame = 0;
  /** Device px per CSS px. */
  ratio = 1;
  width = 1;
  height = 1;

  /** `names` from the lowest layer to the highest; `paint` draws one of them, in CSS px. */
  constructor(
    readonly host: HTMLElement,
    private readonly names: readonly Name[],
    private readonly paint: (name: Name, context: CanvasRenderingContext2D) => void,
  ) {
    this.contexts = Object.fromEntries(names.map((name) => [name, contextOf(canvasIn(host, name))])) as Record<Name, CanvasRenderingContext2D>;
    new ResizeObserver(() => this.resize()).observe(host);
  }

  /** Whether the host has a size: not before it is first in sight, nor while it is hidden. */
  get isLaid(): boolean {
    return this.width > 1 && this.height > 1;
  }

  redraw(...names: Name[]): void {
    for (const name of names.length > 0 ? names : this.names) this.dirty.add(name);
    if (this.frame === 0) this.frame = requestAnimationFrame(() => this.draw());
  }

  /** The place of a pointer, CSS px. */
  place(event: MouseEvent): [number, number] {
    const box = this.host.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  /** The picture as it is on the screen, all layers together. */
  snapshot(): HTMLCanvasElement {
    this.draw();
    const canvas = document.createElement('canvas');
    canvas.width = Math.round(this.width * this.ratio);
    canvas.height = Math.round(this.height * this.ratio);
    const context = contextOf(canvas);
    for (const name of this.names) {
      const layer = this.contexts[name].canvas;
      // Not all browsers filter what is drawn; they draw pictures as they are.
      context.filter = getComputedStyle(layer).filter;
      context.drawImage(layer, 0, 0);
    }
    return canvas;
  }

  private resize(): void {
    this.ratio = window.devicePixelRatio || 1;
    this.width = Math.max(1, this.host.clientWidth);
    this.height = Math.max(1, this.host.clientHeight);
    for (const name of this.names) {
      const { canvas } = this.contexts[name];
      canvas.width = Math.round(this.width * this.ratio);
      canvas.height = Math.round(this.height * this.ratio);
      this.dirty.add(name);
    }
    // At once: a resized canvas is empty until it is drawn.
    this.draw();
  }

  private draw(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    // What is hidden is drawn when it comes into sight, which resizes it.
    if (this.host.closest('[hidden]') !== null) return;
    const names = this.names.filter((name) => this.dirty.has(name));
    this.dirty.clear();
    for (const name of names) {
      const context = this.contexts[name];
      context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
      context.clearRect(0, 0, this.width, this.height);
      context.lineCap = 'butt';
      this.paint(name, context);
    }
  }
}

function canvasIn(host: HTMLElement, name: string): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.className = 'layer';
  canvas.dataset.testid = `layer-${name}`;
  canvas.setAttribute('aria-hidden', 'true');
  host.append(canvas);
  return canvas;
}
