/** The mark of a code as a small picture, for legends. */
import { SHAPES } from '../../shared/view/palette';
import { styleOf } from '../view/palette';
import { svg } from '../../shared/panel/dom';

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

/** On a dark ground as in the image, so that white and yellow show in the light theme too. */
export function swatch(code: number): SVGSVGElement {
  const style = styleOf(code);
  return svg(
    'svg',
    { viewBox: '0 0 16 16', width: 16, height: 16, class: 'swatch', 'aria-hidden': 'true' },
    svg('rect', { width: 16, height: 16, rx: 3, fill: '#3a3f44' }),
    svg('path', { d: OUTLINES[style.shape] ?? '', fill: style.shape === SHAPES.dot ? style.colour : 'none', stroke: style.colour, 'stroke-width': 1.6 }),
  );
}
