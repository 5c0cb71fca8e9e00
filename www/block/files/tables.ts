/** What a table is for, told by its content: control and check points, where images show them, the fiducial marks of a scan of film, or none of these. */
import { parse_ground_control_points, parse_image_measurements } from '../../../pkg/wasm/tiepoint.js';
import { IMAGE_FILE } from '../../../pkg/block/image-files.js';
import { messageOf } from '../../shared/text/messages';
import { say } from '../../shared/text/words';

/** `why`: what is wrong with one that is neither. */
export type TableKind = { kind: 'marks' | 'control' | 'fiducials' } | { kind: 'neither'; why: string };

/** Columns that the results of a block have, and no table of control points: tie points are found, not surveyed. */
const OF_TIE_POINTS = ['confidence', 'rmse_px'];

/** The columns of a table of fiducial marks. */
const OF_FIDUCIALS = ['col', 'row', 'x_mm', 'y_mm'];

/** The names of its columns, where its first line has them. */
function columnsOf(text: string): string[] {
  const head = text.split(/\r?\n/u).find((line) => line.trim() !== '' && !line.startsWith('#')) ?? '';
  return head.split(/[,;\t]/u).map((column) => column.trim());
}

/** Whether it is one of fiducial marks; a slip in one of its lines is said of that. */
export function hasFiducials(text: string): boolean {
  const columns = columnsOf(text);
  return OF_FIDUCIALS.every((column) => columns.includes(column));
}

/** `images`: the names of those of the block, which are told from points by them. */
export function kindOfTable(text: string, images: ReadonlySet<string>): TableKind {
  if (hasFiducials(text)) return { kind: 'fiducials' };
  // A run knows images by their names without the ending, too.
  const stems = new Set([...images].map((name) => name.replace(/\.[^.]*$/u, '').toLowerCase()));
  const isImage = (name: string) => images.has(name) || IMAGE_FILE.test(name) || stems.has(name.toLowerCase());
  const areImages = (names: readonly string[]) => names.length > 0 && names.every(isImage);
  try {
    if (areImages(parse_image_measurements(text).map(({ image }) => image))) return { kind: 'marks' };
  } catch {
    // It says no image measurements: see below what else.
  }
  try {
    const names = parse_ground_control_points(text).map(({ name }) => name);
    if (names.length === 0) return { kind: 'neither', why: say('it-has-no-rows') };
    if (areImages(names)) return { kind: 'neither', why: say('its-rows-are-images') };
    if (OF_TIE_POINTS.every((column) => columnsOf(text).includes(column))) return { kind: 'neither', why: say('its-rows-are-tie-points') };
    return { kind: 'control' };
  } catch (error) {
    return { kind: 'neither', why: messageOf(error) };
  }
}
