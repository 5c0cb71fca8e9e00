/** Positions in images, and what of an image a pane shows. */

/** Column and row in px; the centre of the top-left pixel is (0.5, 0.5). */
export type Position = [x: number, y: number];

/** Places that are measured are kept to so many parts of a px: nobody measures better. */
const STEPS_OF_PX = 100;

export const roundedPx = (value: number): number => Math.round(value * STEPS_OF_PX) / STEPS_OF_PX;

/** Where a pane looks: the image position at its centre and CSS px per image px. */
export interface PaneView {
  x: number;
  y: number;
  scale: number;
}
