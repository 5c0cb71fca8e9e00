/** A picture of what takes long to draw: while the map moves it moves with it, and it is drawn anew when the map rests. */
import type { Transform } from '../../../shared/view/transform';

/** The map rests when it has not moved for so long, ms. */
const REST_MS = 120;
/** So much more than the map is drawn at each side, as a share of it: that comes into sight while it moves. */
const BEYOND = 0.25;

export class Still {
  private readonly canvas = document.createElement('canvas');
  private at: Transform = { scale: 1, x: 0, y: 0 };
  private of: readonly unknown[] = [];
  private moving: ReturnType<typeof setTimeout> | null = null;
  private now: Transform = this.at;

  /** `redraw` is called when the map rests. */
  constructor(private readonly redraw: () => void) {}

  /** Paints what `draw` draws; the same picture while all of `what` is the same. */
  paint(
    context: CanvasRenderingContext2D,
    t: Transform,
    [width, height, ratio]: readonly [number, number, number],
    what: readonly unknown[],
    draw: (context: CanvasRenderingContext2D, t: Transform) => void,
  ): void {
    const key = [...what, width, height, ratio];
    const isOther = key.length !== this.of.length || key.some((part, i) => part !== this.of[i]);
    const rests = this.now.scale === t.scale && this.now.x === t.x && this.now.y === t.y;
    const isAt = this.at.scale === t.scale && this.at.x === t.x && this.at.y === t.y;
    if (isOther || (rests && !isAt && this.moving === null)) this.renew(t, width, height, ratio, key, draw);
    else if (!rests) this.wait();
    this.now = t;
    const larger = t.scale / this.at.scale;
    const [left, top] = [-BEYOND * width, -BEYOND * height].map((edge, i) => larger * (edge - (i === 0 ? this.at.x : this.at.y)) + (i === 0 ? t.x : t.y));
    context.drawImage(this.canvas, left ?? 0, top ?? 0, larger * (1 + 2 * BEYOND) * width, larger * (1 + 2 * BEYOND) * height);
  }

  private wait(): void {
    if (this.moving !== null) clearTimeout(this.moving);
    this.moving = setTimeout(() => {
      this.moving = null;
      this.redraw();
    }, REST_MS);
  }

  private renew(
    t: Transform,
    width: number,
    height: number,
    ratio: number,
    key: readonly unknown[],
    draw: (context: CanvasRenderingContext2D, t: Transform) => void,
  ): void {
    const own = this.canvas.getContext('2d');
    if (own === null) return;
    Object.assign(this.canvas, { width: Math.ceil((1 + 2 * BEYOND) * width * ratio), height: Math.ceil((1 + 2 * BEYOND) * height * ratio) });
    own.setTransform(ratio, 0, 0, ratio, 0, 0);
    draw(own, { scale: t.scale, x: t.x + BEYOND * width, y: t.y + BEYOND * height });
    Object.assign(this, { at: t, of: key });
  }
}
