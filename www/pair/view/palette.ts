/** Colours and shapes of points. Okabe and Ito's colours, told apart with any colour vision; shapes differ as well. */
import { CODES, GROSS_ERROR, MATCHED, REFUSALS, UNDECIDED, codeOf } from '../state/codes';
import type { CodeName } from '../state/codes';

/** Shape codes of the crate's `draw_points`. */
export const SHAPES = { dot: 0, circle: 1, plus: 2, cross: 3, square: 4, triangleUp: 5, triangleDown: 6, diamond: 7 } as const;

export interface PointStyle {
  label: string;
  /** What the rule says, for a point of which it is true. */
  sentence: string;
  colour: string;
  shape: number;
}

const STYLE_OF: Readonly<Record<CodeName, PointStyle>> = {
  matched: { label: 'Matched', sentence: 'Matched: no rule refused it.', colour: '#00c08b', shape: SHAPES.circle },
  no_descriptor: {
    label: 'No window', colour: '#b0b0b0', shape: SHAPES.dot,
    sentence: 'Refused: its window leaves the image or all its grey values are equal, so there is nothing to compare.',
  },
  no_candidate: { label: 'No candidate', sentence: 'Refused: there is nothing in reach that could be compared with it.', colour: '#ffffff', shape: SHAPES.plus },
  threshold: { label: 'Threshold', sentence: 'Refused: its best candidate is not like enough.', colour: '#e69f00', shape: SHAPES.triangleUp },
  ambiguous: {
    label: 'Ambiguous', colour: '#cc79a7', shape: SHAPES.square,
    sentence: 'Refused: its second best candidate is too nearly as good as its best.',
  },
  many_to_one: { label: 'Many to one', sentence: 'Refused: another left point matches the same place better.', colour: '#f0e442', shape: SHAPES.cross },
  parallax: {
    label: 'y-parallax', colour: '#0a84d6', shape: SHAPES.triangleDown,
    sentence: 'Refused: its y-parallax deviates from that of the nearest matches, or it does not fit the geometry of the two views.',
  },
  border: {
    label: 'Border', colour: '#e69f00', shape: SHAPES.square,
    sentence: 'Refused: the best place lies on the border of its search window, so a better one may lie beyond.',
  },
  left_right: {
    label: 'Left-right', colour: '#cc79a7', shape: SHAPES.cross,
    sentence: 'Refused: from the right image back, another place of the left image is like it more.',
  },
  not_converged: {
    label: 'Not converged', colour: '#56b4e9', shape: SHAPES.diamond,
    sentence: 'Refused: least squares matching did not settle within its limits of shape, distance and iterations.',
  },
  imprecise: {
    label: 'Imprecise', colour: '#f0e442', shape: SHAPES.triangleUp,
    sentence: 'Refused: the standard error of its right position is too large, as on an edge along which it can slide.',
  },
  frame: {
    label: 'Frame', colour: '#b0b0b0', shape: SHAPES.square,
    sentence: 'Refused: it lies at the same place of both frames, as the border of the film, fiducial marks and data strips do.',
  },
  gross_error: {
    label: 'Gross error', colour: '#d55e00', shape: SHAPES.diamond,
    sentence: 'Matched, then left out of the relative orientation: its standardised residual exceeds the limit that α₀ sets.',
  },
  undecided: { label: 'Not matched', sentence: 'No match uses this point.', colour: '#56b4e9', shape: SHAPES.plus },
};

/** By code. */
export const STYLES: readonly PointStyle[] = CODES.map((name) => STYLE_OF[name]);

export function styleOf(code: number): PointStyle {
  const style = STYLES[code];
  if (style === undefined) throw new Error(`no style for code ${String(code)}`);
  return style;
}

/** The codes in drawing order: the common ones below, matches on top. */
export const DRAWN: readonly number[] = [UNDECIDED, ...REFUSALS.map(codeOf), GROSS_ERROR, MATCHED];

export const SELECTED = '#ffd400';
export const CANDIDATE = '#56b4e9';
export const EPIPOLAR = '#ff9ee0';
export const LINE = 'rgb(0 222 160 / 0.5)';
export const LINE_REJECTED = 'rgb(255 110 20 / 0.85)';
