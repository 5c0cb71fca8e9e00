/** Affine maps of one plane to another, and the one that fits places best. Pure. */

/** (x, y) becomes (a x + c y + e, b x + d y + f), as a canvas has it. */
export interface Affine {
  a: number;
  b: number;
  c: number;
  d: number;
  e: number;
  f: number;
}

/** Where a point lies in one plane, then in the other. */
export type Twice = readonly [number, number, number, number];

export function mapped({ a, b, c, d, e, f }: Affine, x: number, y: number): [number, number] {
  return [a * x + c * y + e, b * x + d * y + f];
}

export function inverse({ a, b, c, d, e, f }: Affine): Affine {
  const determinant = a * d - b * c;
  const turned = { a: d / determinant, b: -b / determinant, c: -c / determinant, d: a / determinant, e: 0, f: 0 };
  const [x, y] = mapped(turned, e, f);
  return { ...turned, e: -x, f: -y };
}

/**
 * The map that brings so many points nearest to their places in the other plane, by least squares; null where they lie on one line. `least`: they do where 1 minus
 * the squared correlation of x and y is not above that.
 */
export function fitted(count: number, place: (i: number) => Twice, least: number): Affine | null {
  const [mx, my, mu, mv] = middle(count, place);
  let [xx, xy, yy, xu, yu, xv, yv] = [0, 0, 0, 0, 0, 0, 0];
  for (let i = 0; i < count; i++) {
    const [px, py, pu, pv] = place(i);
    const [x, y, u, v] = [px - mx, py - my, pu - mu, pv - mv];
    xx += x * x;
    xy += x * y;
    yy += y * y;
    xu += x * u;
    yu += y * u;
    xv += x * v;
    yv += y * v;
  }
  const determinant = xx * yy - xy * xy;
  if (!(determinant > least * xx * yy)) return null;
  const [a, c] = [(yy * xu - xy * yu) / determinant, (xx * yu - xy * xu) / determinant];
  const [b, d] = [(yy * xv - xy * yv) / determinant, (xx * yv - xy * xv) / determinant];
  return { a, b, c, d, e: mu - a * mx - c * my, f: mv - b * mx - d * my };
}

function middle(count: number, place: (i: number) => Twice): [number, number, number, number] {
  const sum: [number, number, number, number] = [0, 0, 0, 0];
  for (let i = 0; i < count; i++) for (const [k, value] of place(i).entries()) sum[k] = (sum[k] ?? 0) + value;
  return [sum[0] / count, sum[1] / count, sum[2] / count, sum[3] / count];
}
