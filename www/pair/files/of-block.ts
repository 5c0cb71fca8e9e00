/** Tables that a block takes, and a pair does not: control points, image measurements, GNSS positions of images. */
import { parse_ground_control_points, parse_image_measurements, parse_image_positions } from '../../../pkg/wasm/tiepoint.js';
import { IMAGE_FILE } from '../../../pkg/block/image-files.js';

/** How they are read. Rows without names of images in their first column can be read as image measurements and positions, and are none. */
const READERS: readonly ((text: string) => boolean)[] = [
  (text) => parse_ground_control_points(text).length > 0,
  (text) => areImages(parse_image_measurements(text)),
  (text) => areImages(parse_image_positions(text).rows),
];

function areImages(rows: readonly { image: string }[]): boolean {
  return rows.length > 0 && rows.every(({ image }) => IMAGE_FILE.test(image));
}

/** Whether a table that holds no fiducial marks is one of these. */
export function isOfBlock(text: string): boolean {
  return READERS.some((reads) => {
    try {
      return reads(text);
    } catch {
      return false;
    }
  });
}
