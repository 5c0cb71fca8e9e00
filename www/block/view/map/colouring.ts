/** Colours of tie points by what is known of them: Viridis, whose steps are seen with any colour vision and in grey. */
import { remember } from '../../../shared/state/remember';
import type { ViewPoints } from '../../state/view';
import type { Colouring } from './look';
import { say } from '../../../shared/text/words';

/** Nine of its colours, evenly spaced (Smith & van der Walt 2015). */
const VIRIDIS = ['#440154', '#472d7b', '#3b528b', '#2c728e', '#21918c', '#28ae80', '#5ec962', '#addc30', '#fde725'];

/** Shares of the points below and above those that the ends of the colours stand for. */
const [LOW, HIGH] = [0.02, 0.98];

/** What the colours mean. */
export interface Scale {
  /** Ends of the colours; further values have the colours of the ends. */
  from: number;
  to: number;
  unit: string;
  digits: number;
  title: string;
}

export interface Coloured {
  scale: Scale;
  /** Place of each point on the scale, 0..255. */
  steps: Uint8Array;
}

/** As a style of an element has them. */
export const GRADIENT = `linear-gradient(to right, ${VIRIDIS.join(', ')})`;

/** Red, green, blue, opaque, as bytes in memory: one word a step. */
export const WORDS = (() => {
  const parsed = VIRIDIS.map((colour) => [1, 3, 5].map((at) => Number.parseInt(colour.slice(at, at + 2), 16)));
  const words = new Uint32Array(256);
  const bytes = new Uint8Array(words.buffer);
  for (let step = 0; step < 256; step++) {
    const along = (step / 255) * (parsed.length - 1);
    const [low, high] = [parsed[Math.floor(along)] ?? [], parsed[Math.ceil(along)] ?? []];
    for (let band = 0; band < 3; band++) bytes[4 * step + band] = Math.round((low[band] ?? 0) + ((high[band] ?? 0) - (low[band] ?? 0)) * (along % 1));
    bytes[4 * step + 3] = 255;
  }
  return words;
})();

/** The colours of points; null where they have none of that kind. */
export const colouredPoints = remember((points: ViewPoints, colouring: Colouring): Coloured | null => {
  if (colouring === 'none' || points.count === 0) return null;
  const values = Float64Array.from({ length: points.count }, (_, i) => (i < points.taking ? figureOf(points, colouring, i) : NaN));
  const sorted = values.filter((value) => !Number.isNaN(value)).sort();
  if (sorted.length === 0) return null;
  const at = (share: number) => sorted[Math.round(share * (sorted.length - 1))] ?? NaN;
  const from = colouring === 'height' ? at(LOW) : colouring === 'rays' ? (sorted[0] ?? 2) : 0;
  const to = Math.max(at(HIGH), from + 1e-9);
  const steps = Uint8Array.from(values, (value) => Math.round(255 * Math.min(1, Math.max(0, (value - from) / (to - from)))));
  const named = {
    residual: { unit: 'px', digits: 2, title: say('rmse-of-the-residuals') },
    rays: { unit: '', digits: 0, title: say('rays-2') },
    height: { unit: '', digits: 1, title: 'Z' },
  }[colouring];
  return { scale: { from, to, ...named }, steps };
});

function figureOf({ rmsePx, rays, positions }: ViewPoints, colouring: Colouring, point: number): number {
  if (colouring === 'residual') return rmsePx[point] ?? NaN;
  return (colouring === 'rays' ? rays[point] : positions[3 * point + 2]) ?? NaN;
}
