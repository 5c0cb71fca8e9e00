/** Colours and shapes of points. Okabe and Ito's colours, told apart with any colour vision; shapes differ as well. */
import { BY_HAND, CODES, GROSS_ERROR, MANUAL, MATCHED, REFUSALS, UNDECIDED, codeOf } from '../state/codes';
import type { CodeName } from '../state/codes';
import { ACCEPTED, MEASURED, REJECTED, REJECTED_BY_HAND, SHAPES } from '../../shared/view/palette';
import type { PointStyle } from '../../shared/view/palette';

const STYLE_OF: Readonly<Record<CodeName, PointStyle>> = {
  matched: ACCEPTED,
  no_descriptor: { colour: '#b0b0b0', shape: SHAPES.dot },
  no_candidate: { colour: '#ffffff', shape: SHAPES.plus },
  threshold: { colour: '#e69f00', shape: SHAPES.triangleUp },
  ambiguous: { colour: '#cc79a7', shape: SHAPES.square },
  many_to_one: { colour: '#f0e442', shape: SHAPES.cross },
  parallax: { colour: '#0a84d6', shape: SHAPES.triangleDown },
  border: { colour: '#e69f00', shape: SHAPES.square },
  left_right: { colour: '#cc79a7', shape: SHAPES.cross },
  not_converged: { colour: '#56b4e9', shape: SHAPES.diamond },
  imprecise: { colour: '#f0e442', shape: SHAPES.triangleUp },
  frame: { colour: '#b0b0b0', shape: SHAPES.square },
  gross_error: REJECTED,
  undecided: { colour: '#56b4e9', shape: SHAPES.plus },
  rejected_by_hand: REJECTED_BY_HAND,
  manual: MEASURED,
};

/** By code. */
export const STYLES: readonly PointStyle[] = CODES.map((name) => STYLE_OF[name]);

export function styleOf(code: number): PointStyle {
  const style = STYLES[code];
  if (style === undefined) throw new Error(`no style for code ${String(code)}`);
  return style;
}

/** The codes in drawing order: the common ones below, matches on top. */
export const DRAWN: readonly number[] = [UNDECIDED, ...REFUSALS.map(codeOf), BY_HAND, GROSS_ERROR, MATCHED, MANUAL];

export const LINE = 'rgb(0 222 160 / 0.5)';
export const LINE_REJECTED = 'rgb(255 110 20 / 0.85)';
