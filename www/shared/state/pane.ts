/** Positions in images, and what of an image a pane shows. */

/** Column and row in px; the centre of the top-left pixel is (0.5, 0.5). */
export type Position = [x: number, y: number];

/** Where a pane looks: the image position at its centre and CSS px per image px. */
export interface PaneView {
  x: number;
  y: number;
  scale: number;
}
