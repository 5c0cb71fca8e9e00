/** Where a left point is expected in the right image. */
import type { OffsetField } from '../../shared/crate';

/** The node below a position along one axis, the one above, and how far between them. */
function along(position: number, spacing: number, nodes: number): [number, number, number] {
  const place = Math.min(nodes - 1, Math.max(0, position / spacing));
  const first = Math.min(Math.floor(place), Math.max(0, nodes - 2));
  return [first, Math.min(first + 1, nodes - 1), place - first];
}

/** The left position plus the field's offset there, bilinear between nodes, as the crate's `OffsetField::at`. */
export function expectedPosition(field: OffsetField, [x, y]: [number, number]): [number, number] {
  const [left, right, u] = along(x, field.spacing_px, field.columns);
  const [top, bottom, v] = along(y, field.spacing_px, field.rows);
  const node = (column: number, row: number, axis: 0 | 1) => field.offsets[row * field.columns + column]?.[axis] ?? 0;
  const offset = (axis: 0 | 1) => {
    const above = node(left, top, axis) * (1 - u) + node(right, top, axis) * u;
    const below = node(left, bottom, axis) * (1 - u) + node(right, bottom, axis) * u;
    return above * (1 - v) + below * v;
  };
  return [x + offset(0), y + offset(1)];
}

/** The left position whose expected position is this right one: the field is smooth, so that a few repetitions settle. */
export function expectedOrigin(field: OffsetField, [x, y]: [number, number]): [number, number] {
  let at: [number, number] = [x - field.median_px[0], y - field.median_px[1]];
  for (let i = 0; i < 3; i++) {
    const [ex, ey] = expectedPosition(field, at);
    at = [at[0] + x - ex, at[1] + y - ey];
  }
  return at;
}
