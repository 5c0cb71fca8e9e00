/** Where the ground at a place of one image lies in the other, so that linked panes show the same: by the offset, or by the matches. */
import { comparesGradients, isCurrent } from './keys';
import { expectedOrigin, expectedPosition } from './offset';
import { remember } from '../../shared/state/remember';
import type { Position } from '../../shared/state/pane';
import type { Side, State } from './state';

/** x' = a x + b y + c, y' = d x + e y + f. */
type Affine = readonly [a: number, b: number, c: number, d: number, e: number, f: number];

/** Matches below which a map is not trusted. */
const LEAST_MATCHES = 10;

/** The affine map from left to right that fits all matches best (stride 5); null where they are few or lie along a line. */
const affineOf = remember((matches: Float64Array): Affine | null => {
  const count = matches.length / 5;
  if (count < LEAST_MATCHES) return null;
  const mean = [0, 1, 2, 3].map((k) => {
    let sum = 0;
    for (let i = k; i < matches.length; i += 5) sum += matches[i] ?? 0;
    return sum / count;
  });
  const [mx = NaN, my = NaN, mu = NaN, mv = NaN] = mean;
  let [xx, xy, yy, xu, yu, xv, yv] = [0, 0, 0, 0, 0, 0, 0];
  for (let i = 0; i < matches.length; i += 5) {
    const [x, y] = [(matches[i] ?? 0) - mx, (matches[i + 1] ?? 0) - my];
    const [u, v] = [(matches[i + 2] ?? 0) - mu, (matches[i + 3] ?? 0) - mv];
    xx += x * x;
    xy += x * y;
    yy += y * y;
    xu += x * u;
    yu += y * u;
    xv += x * v;
    yv += y * v;
  }
  const determinant = xx * yy - xy * xy;
  if (!(determinant > 1e-6 * xx * yy)) return null;
  const [a, b] = [(yy * xu - xy * yu) / determinant, (xx * yu - xy * xu) / determinant];
  const [d, e] = [(yy * xv - xy * yv) / determinant, (xx * yv - xy * xv) / determinant];
  return [a, b, mu - a * mx - b * my, d, e, mv - d * mx - e * my];
});

function mapped([a, b, c, d, e, f]: Affine, [x, y]: Position): Position {
  return [a * x + b * y + c, d * x + e * y + f];
}

function mappedBack([a, b, c, d, e, f]: Affine, [x, y]: Position): Position {
  const determinant = a * e - b * d;
  return [(e * (x - c) - b * (y - f)) / determinant, (a * (y - f) - d * (x - c)) / determinant];
}

/** The place in the other image of what lies at a place of one; null where nothing tells it yet. */
export function sameGround(state: State, side: Side, at: Position): Position | null {
  const { settings, results } = state;
  if (settings !== null && comparesGradients(settings)) {
    const map = results.match !== undefined && isCurrent(state, 'match') ? affineOf(results.match.value.matches) : null;
    if (map === null) return null;
    return side === 'left' ? mapped(map, at) : mappedBack(map, at);
  }
  const field = isCurrent(state, 'offset') ? results.offset?.value : undefined;
  if (field === undefined) return null;
  return side === 'left' ? expectedPosition(field, at) : expectedOrigin(field, at);
}
