/** A canvas that fills its host, sharp on any screen, in the colours of the page; drawn again when any of this changes. */

export interface Colours {
  text: string;
  muted: string;
  line: string;
  accent: string;
  problem: string;
  good: string;
  bars: string;
  ground: string;
  surface: string;
}

const NAMES: readonly (keyof Colours)[] = ['text', 'muted', 'line', 'accent', 'problem', 'good', 'bars', 'ground', 'surface'];

export class Surface {
  readonly canvas = document.createElement('canvas');
  private readonly context: CanvasRenderingContext2D;
  private readonly probe = document.createElement('span');
  private frame = 0;
  /** Until the theme changes. */
  private known: Colours | null = null;
  width = 1;
  height = 1;

  constructor(readonly host: HTMLElement, private readonly paint: (context: CanvasRenderingContext2D, colours: Colours) => void) {
    const context = this.canvas.getContext('2d');
    if (context === null) throw new Error('this browser offers no canvas to draw on');
    this.context = context;
    this.canvas.className = 'layer';
    this.canvas.setAttribute('aria-hidden', 'true');
    this.probe.hidden = true;
    host.append(this.canvas, this.probe);
    new ResizeObserver(() => { this.resize(); }).observe(host);
    const recolour = () => {
      this.known = null;
      this.redraw();
    };
    new MutationObserver(recolour).observe(document.documentElement, { attributes: true, attributeFilter: ['data-theme'] });
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', recolour);
  }

  redraw(): void {
    if (this.frame === 0) this.frame = requestAnimationFrame(() => { this.draw(); });
  }

  /** The place of a pointer in CSS px. */
  place(event: MouseEvent): [number, number] {
    const box = this.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  private resize(): void {
    const ratio = window.devicePixelRatio || 1;
    this.width = Math.max(1, this.host.clientWidth);
    this.height = Math.max(1, this.host.clientHeight);
    this.canvas.width = Math.round(this.width * ratio);
    this.canvas.height = Math.round(this.height * ratio);
    this.draw();
  }

  private draw(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    // It is drawn when it comes into sight.
    if (this.host.closest('[hidden]') !== null) return;
    const ratio = window.devicePixelRatio || 1;
    this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.context.clearRect(0, 0, this.width, this.height);
    this.known ??= this.colours();
    this.paint(this.context, this.known);
  }

  /** Custom properties hold both themes' colours; an element's own colour is the one that counts now. */
  private colours(): Colours {
    const entries = NAMES.map((name) => {
      this.probe.style.color = `var(--${name})`;
      return [name, getComputedStyle(this.probe).color];
    });
    return Object.fromEntries(entries) as Colours;
  }
}
