/** Colours and shapes of points. Okabe and Ito's colours, told apart with any colour vision; shapes differ as well. */
import { GROSS_ERROR, UNDECIDED } from '../state/select';

/** Shape codes of the crate's `draw_points`. */
export const SHAPES = { dot: 0, circle: 1, plus: 2, cross: 3, square: 4, triangleUp: 5, triangleDown: 6, diamond: 7 } as const;

export interface PointStyle {
  label: string;
  /** What the rule says, for a point of which it is true. */
  sentence: string;
  colour: string;
  shape: number;
}

/** By code: the crate's rules 0 to 6, then the page's own. */
export const STYLES: readonly PointStyle[] = [
  { label: 'Matched', sentence: 'Matched: no rule refused it.', colour: '#00c08b', shape: SHAPES.circle },
  {
    label: 'No descriptor', colour: '#b0b0b0', shape: SHAPES.dot,
    sentence: 'Refused: its window leaves the image or all its grey values are equal, so it has no moments.',
  },
  {
    label: 'No candidate', colour: '#ffffff', shape: SHAPES.plus,
    sentence: 'Refused: no right point with moments lies in its search window.',
  },
  { label: 'Threshold', colour: '#e69f00', shape: SHAPES.triangleUp, sentence: 'Refused: its best measure is not below the largest one allowed.' },
  { label: 'Ambiguous', colour: '#cc79a7', shape: SHAPES.square, sentence: 'Refused: its second best candidate is too nearly as good as its best.' },
  { label: 'Many to one', colour: '#f0e442', shape: SHAPES.cross, sentence: 'Refused: another left point matches the same right point better.' },
  { label: 'y-parallax', colour: '#0a84d6', shape: SHAPES.triangleDown, sentence: 'Refused: its y-parallax deviates from that of the nearest matches.' },
  {
    label: 'Gross error', colour: '#d55e00', shape: SHAPES.diamond,
    sentence: 'Matched, then left out of the relative orientation: its standardised residual exceeds the rejection limit.',
  },
  { label: 'Not matched', colour: '#56b4e9', shape: SHAPES.plus, sentence: 'No match uses this point.' },
];

export function styleOf(code: number): PointStyle {
  const style = STYLES[code];
  if (style === undefined) throw new Error(`no style for code ${String(code)}`);
  return style;
}

/** The codes in drawing order: the common ones below, matches on top. */
export const DRAWN: readonly number[] = [UNDECIDED, 1, 2, 3, 4, 5, 6, GROSS_ERROR, 0];

export const SELECTED = '#ffd400';
export const CANDIDATE = '#56b4e9';
export const LINE = 'rgb(0 222 160 / 0.5)';
export const LINE_REJECTED = 'rgb(255 110 20 / 0.85)';
