/** Which images show a place of the ground, by their footprints. */
import type { Position } from '../../shared/state/pane';

/** The images whose footprints hold a place, those whose middle is nearest first. `footprints`: four corners of each image, x, y; NaN where it has none. */
export function footprintsAt(footprints: Float64Array, [x, y]: Position): number[] {
  const found: { image: number; far: number }[] = [];
  for (let image = 0; 8 * image < footprints.length; image += 1) {
    const corners = footprints.subarray(8 * image, 8 * image + 8);
    if (!holds(corners, x, y)) continue;
    const middle = (axis: 0 | 1) => [0, 1, 2, 3].reduce((sum, corner) => sum + (corners[2 * corner + axis] ?? NaN), 0) / 4;
    found.push({ image, far: Math.hypot(middle(0) - x, middle(1) - y) });
  }
  return found.sort((a, b) => a.far - b.far).map(({ image }) => image);
}

/** Whether a place lies on the same side of all edges. */
function holds(corners: Float64Array, x: number, y: number): boolean {
  const sides = [0, 1, 2, 3].map((i) => {
    const [ax, ay, bx, by] = [corners[2 * i], corners[2 * i + 1], corners[(2 * i + 2) % 8], corners[(2 * i + 3) % 8]].map((value) => value ?? NaN);
    return ((bx ?? NaN) - (ax ?? NaN)) * (y - (ay ?? NaN)) - ((by ?? NaN) - (ay ?? NaN)) * (x - (ax ?? NaN));
  });
  return sides.every((side) => side >= 0) || sides.every((side) => side <= 0);
}
