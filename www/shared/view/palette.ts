/** Shapes of points, and the colours of what is marked on images: Okabe and Ito's, told apart with any colour vision. */

/** Shape codes of the crate's `draw_points`. */
export const SHAPES = { dot: 0, circle: 1, plus: 2, cross: 3, square: 4, triangleUp: 5, triangleDown: 6, diamond: 7 } as const;

export interface PointStyle {
  colour: string;
  shape: number;
}

/** Of what was matched and holds, of what an adjustment or the user rejected, and of what was measured by hand. */
export const ACCEPTED: PointStyle = { colour: '#00c08b', shape: SHAPES.circle };
export const REJECTED: PointStyle = { colour: '#d55e00', shape: SHAPES.diamond };
export const REJECTED_BY_HAND: PointStyle = { colour: '#ff3b30', shape: SHAPES.cross };
export const MEASURED: PointStyle = { colour: '#9cff57', shape: SHAPES.square };

export const SELECTED = '#ffd400';
export const CANDIDATE = '#56b4e9';
export const EPIPOLAR = '#ff9ee0';
/** Of residual vectors. */
export const RESIDUAL = '#f0e442';
export const RESIDUAL_REJECTED = '#ff7a1a';
