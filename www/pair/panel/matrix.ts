/** Pictures of the precision: the matrix of correlations, and the error ellipse of the base components. */
import type { ErrorEllipse, RelativeOrientation } from '../../shared/crate';
import { h, svg } from '../../shared/panel/dom';
import { fixed, significant } from '../../shared/text/format';
import { UNKNOWNS } from './unknowns';
import { say } from '../../shared/text/words';

const CELL = 44;
const HEAD = 26;

/** The part of a cell that the number takes, below the square: a small square would strike it through. */
const FOOT = 12;

/** The matrix of correlations: the larger the square the stronger, filled where positive and hatched by its outline where negative. */
export function correlationPicture({ correlations }: RelativeOrientation): HTMLElement {
  const size = HEAD + CELL * UNKNOWNS.length;
  const words = UNKNOWNS.flatMap(({ symbol }, i) =>
    UNKNOWNS.slice(i + 1).map((other, k) => say('and', { symbol, symbol_2: other.symbol, correlations: correlations[i]?.[i + 1 + k] })),
  );
  const heads = UNKNOWNS.flatMap(({ symbol }, i) => [
    svg('text', { x: HEAD + CELL * (i + 0.5), y: HEAD - 8, class: 'matrix-name' }, symbol),
    svg('text', { x: HEAD / 2, y: HEAD + CELL * (i + 0.5) + 4, class: 'matrix-name' }, symbol),
  ]);
  const cells = UNKNOWNS.flatMap((_, i) => UNKNOWNS.map((__, j) => cellOf(correlations[i]?.[j] ?? NaN, i, j)));
  return h(
    'figure',
    { testid: 'correlations' },
    h('figcaption', { title: say('from-the-inverse-of-the') }, say('correlations-of-the-unknowns')),
    svg(
      'svg',
      { viewBox: `0 0 ${String(size)} ${String(size)}`, class: 'correlations', role: 'img', 'aria-label': say('correlations', { join: words.join(', ') }) },
      ...heads,
      ...cells,
    ),
  );
}

/** The area of the square stands for the magnitude. */
function cellOf(value: number, row: number, column: number): SVGGElement {
  const side = (CELL - FOOT - 4) * Math.sqrt(Math.min(1, Math.abs(value)));
  const x = HEAD + CELL * (column + 0.5);
  const y = HEAD + CELL * (row + 0.5);
  const middle = y - FOOT / 2;
  return svg(
    'g',
    { 'data-testid': `correlation-${String(row)}-${String(column)}` },
    svg('rect', { x: x - CELL / 2, y: y - CELL / 2, width: CELL, height: CELL, class: 'matrix-cell' }),
    svg('rect', { x: x - side / 2, y: middle - side / 2, width: side, height: side, class: value < 0 ? 'negative' : 'positive' }),
    svg('text', { x, y: y + CELL / 2 - 3, class: 'matrix-value' }, fixed(value, 2)),
  );
}

const PLOT = 150;

/** The standard error ellipse of by and bz, dashed that of 95 %, with the truth where it is known. */
export function ellipsePicture(ellipse: ErrorEllipse, of95: ErrorEllipse | undefined, deviation: [number, number] | null): HTMLElement {
  const { semi_major: major, semi_minor: minor, bearing_deg: angle } = ellipse;
  const reach = Math.max((of95 ?? ellipse).semi_major, ...(deviation ?? []).map((d) => 1.15 * Math.abs(d)));
  const scale = PLOT / 2 / reach;
  const words = say('standard-error-ellipse-of-by', { major: significant(major), minor: significant(minor), angle });
  // The truth lies where the deviation is undone.
  const truth = deviation === null ? [] : [svg('path', { d: cross(-deviation[0] * scale, deviation[1] * scale), class: 'truth' })];
  const half = PLOT / 2;
  return h(
    'figure',
    { testid: 'ellipse' },
    h(
      'figcaption',
      { title: words },
      say('by-bz-ellipse-m', {
        major: significant(1000 * major),
        minor: significant(1000 * minor),
        what: [of95 ? say('dashed-95') : '', deviation === null ? '' : say('cross-truth')].join(''),
      }),
    ),
    svg(
      'svg',
      { viewBox: `${String(-half)} ${String(-half)} ${String(PLOT)} ${String(PLOT)}`, class: 'ellipse', role: 'img', 'aria-label': words },
      svg('path', { d: `M${String(-half)} 0h${String(PLOT)}M0 ${String(-half)}v${String(PLOT)}`, class: 'axis' }),
      svg('ellipse', { ...axesOf(ellipse, scale), class: 'outline' }),
      ...(of95 ? [svg('ellipse', { ...axesOf(of95, scale), class: 'outline faint' })] : []),
      ...truth,
      svg('text', { x: half - 16, y: -5, class: 'matrix-name' }, 'by'),
      svg('text', { x: 12, y: -half + 12, class: 'matrix-name' }, 'bz'),
    ),
  );
}

const axesOf = ({ semi_major: major, semi_minor: minor, bearing_deg: angle }: ErrorEllipse, scale: number) => ({
  rx: major * scale,
  ry: minor * scale,
  transform: `rotate(${String(-angle)})`,
});

function cross(x: number, y: number): string {
  return `M${String(x - 5)} ${String(y - 5)}l10 10M${String(x + 5)} ${String(y - 5)}l-10 10`;
}
