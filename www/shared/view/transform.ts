/** How positions of a picture become positions on the canvas, and back. Lengths on the canvas are CSS px. */

/** canvas = scale · position + shift. */
export interface Transform {
  scale: number;
  x: number;
  y: number;
}

export interface Rect {
  left: number;
  top: number;
  width: number;
  height: number;
}

export function contains(rect: Rect, x: number, y: number): boolean {
  return x >= rect.left && x < rect.left + rect.width && y >= rect.top && y < rect.top + rect.height;
}

export function toCanvas(t: Transform, x: number, y: number): [number, number] {
  return [t.scale * x + t.x, t.scale * y + t.y];
}

/** The position that a place of the canvas shows. */
export function toPosition(t: Transform, x: number, y: number): [number, number] {
  return [(x - t.x) / t.scale, (y - t.y) / t.scale];
}

export interface Size {
  width: number;
  height: number;
}

/** As a canvas of another size shows it: the same in its middle, and all that was seen. */
export function resized(t: Transform, from: Size, to: Size): Transform {
  const [x, y] = toPosition(t, from.width / 2, from.height / 2);
  const scale = t.scale * Math.min(to.width / from.width, to.height / from.height);
  return { scale, x: to.width / 2 - scale * x, y: to.height / 2 - scale * y };
}

export function panned(t: Transform, dx: number, dy: number): Transform {
  return { scale: t.scale, x: t.x + dx, y: t.y + dy };
}

/** Enlarged by a factor about a place of the canvas, within limits of the scale. */
export function zoomedAbout(t: Transform, factor: number, x: number, y: number, { least, most }: { least: number; most: number }): Transform {
  const scale = Math.min(most, Math.max(least, t.scale * factor));
  const actual = scale / t.scale;
  return { scale, x: x + actual * (t.x - x), y: y + actual * (t.y - y) };
}
