/** What the map shows beside the images. */

/** What the colour of a tie point says. */
export type Colouring = 'residual' | 'rays' | 'height' | 'none';

export interface MapLook {
  /** `none`: no tie points. */
  colouring: Colouring;
  connections: boolean;
  footprints: boolean;
  photos: boolean;
  /** Shift and a drag draws freely, in place of a rectangle. */
  lasso: boolean;
  /** GNSS positions, and differences of control and check points. */
  offsets: boolean;
  /** The orthophoto that is given, under all else. */
  orthophoto: boolean;
}

export const FIRST_LOOK: MapLook = { colouring: 'residual', connections: true, footprints: false, photos: true, lasso: false, offsets: true, orthophoto: true };
