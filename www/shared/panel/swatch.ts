/** What is drawn on pictures as small pictures, for legends. */
import { SHAPES } from '../view/palette';
import type { PointStyle } from '../view/palette';
import { svg } from './dom';

const OUTLINES: Readonly<Record<number, string>> = {
  [SHAPES.dot]: 'M6 6h4v4h-4z',
  [SHAPES.circle]: 'M12 8a4 4 0 1 0-8 0a4 4 0 1 0 8 0z',
  [SHAPES.plus]: 'M8 4v8M4 8h8',
  [SHAPES.cross]: 'M4.5 4.5l7 7M11.5 4.5l-7 7',
  [SHAPES.square]: 'M4.5 4.5h7v7h-7z',
  [SHAPES.triangleUp]: 'M8 4l4 7h-8z',
  [SHAPES.triangleDown]: 'M8 12l4-7h-8z',
  [SHAPES.diamond]: 'M8 3.5l4.5 4.5l-4.5 4.5l-4.5-4.5z',
};

/** The mark of a point. */
export function swatch({ shape, colour }: PointStyle): SVGSVGElement {
  return drawn({ d: OUTLINES[shape] ?? '', fill: shape === SHAPES.dot ? colour : 'none', stroke: colour });
}

/** A line, or what consists of lines, within 16 × 16; `dashes` as SVG has them. */
export function lineSwatch(d: string, colour: string, dashes = 'none'): SVGSVGElement {
  return drawn({ d, fill: 'none', stroke: colour, 'stroke-dasharray': dashes });
}

/** On a dark ground as in the image, so that white and yellow show in the light theme too. */
function drawn(path: Record<string, string>): SVGSVGElement {
  return svg(
    'svg',
    { viewBox: '0 0 16 16', width: 16, height: 16, class: 'swatch', 'aria-hidden': 'true' },
    svg('rect', { width: 16, height: 16, rx: 3, fill: '#3a3f44' }),
    svg('path', { ...path, 'stroke-width': 1.6 }),
  );
}
