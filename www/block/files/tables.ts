/** What a table is for, told by its content: control and check points, where images show them, GNSS positions of images, the fiducial marks of a scan of film, or none of these. */
import { parse_fiducials, parse_ground_control_points, parse_image_measurements, parse_image_positions } from '../../../pkg/wasm/tiepoint.js';
import { IMAGE_FILE } from '../../../pkg/block/image-files.js';
import { messageOf } from '../../shared/text/messages';
import { say } from '../../shared/text/words';

/** `why`: what is wrong with one that is neither. */
export type TableKind = { kind: 'marks' | 'control' | 'positions' | 'fiducials' } | { kind: 'neither'; why: string };

/** Columns that the results of a block have, and no table of control points: tie points are found, not surveyed. */
const OF_TIE_POINTS = ['confidence', 'rmse_px'];

/** Columns that the images of a result have: where the adjustment has them, not a receiver. */
const OF_RESULT_IMAGES = ['image', 'name', 'camera'];

/** The columns of a table of fiducial marks. */
const OF_FIDUCIALS = ['col', 'row', 'x_mm', 'y_mm'];

/** A column that tables of control points do not have, and image measurements of many programs do. */
const OF_IMAGES = /^(?:image|img|photo|picture|frame|bild|foto)/iu;

/** The column of heights, which image measurements do not have. */
const OF_HEIGHTS = /^(?:z|h|up|height|alt|elev|hoehe|höhe)/iu;

/** The columns of places on the earth or in its plane and of their heights, which image measurements do not have. */
const OF_PLACES =
  /^(?:[xyz][/_ ]|(?:gps|utm|wgs|etrs|grid|local)\w*[ _-])?(?:gps)?(?:lon|lng|lat|alt|elev|east|north|rechts|hoch|ost\b|nord\b|öst|norr|höjd|länge|laenge|breite|höhe|hoehe|height|z\b)/iu;

/** A coordinate, as no point is named. */
const COORDINATE = /^[+-]?\d+[.,]\d/u;

/** Numbers in a line of a table. */
const LEAST_NUMBERS = 3;

function linesOf(text: string): string[] {
  return text.split(/\r?\n/u).filter((line) => line.trim() !== '' && !line.startsWith('#'));
}

/** The names of its columns, where its first line has them. */
function columnsOf(text: string): string[] {
  return (linesOf(text)[0] ?? '').split(/[,;\t]/u).map((column) => column.trim());
}

/** Whether most of its lines are rows of numbers, whatever stands between these: notes are no table. */
export function hasNumbers(text: string): boolean {
  const lines = linesOf(text);
  const rows = lines.filter((line) => line.split(/[\s,;]+/u).filter((cell) => cell !== '' && Number.isFinite(Number(cell))).length >= LEAST_NUMBERS);
  return 2 * rows.length > lines.length;
}

/** Whether it is one of fiducial marks, in the words of any language; a slip in one of its lines is said of that. */
export function hasFiducials(text: string): boolean {
  const columns = columnsOf(text);
  if (OF_FIDUCIALS.every((column) => columns.includes(column))) return true;
  try {
    return parse_fiducials(text).length > 0;
  } catch {
    return false;
  }
}

/** `images`: the names of those of the block, which are told from points by them. */
export function kindOfTable(text: string, images: ReadonlySet<string>): TableKind {
  if (hasFiducials(text)) return { kind: 'fiducials' };
  // A run knows images by their names without the ending, too.
  const stems = new Set([...images].map((name) => name.replace(/\.[^.]*$/u, '').toLowerCase()));
  const isImage = (name: string) => images.has(name) || IMAGE_FILE.test(name) || stems.has(name.toLowerCase());
  const areImages = (names: readonly string[]) => names.length > 0 && names.every(isImage);
  const marks = measurementsOf(text);
  const positions = positionsOf(text);
  const columns = columnsOf(text);
  if (OF_RESULT_IMAGES.every((column) => columns.includes(column))) return { kind: 'neither', why: say('its-rows-are-images') };
  const havePlaces = hasPlaces(columns, marks);
  if (!havePlaces && 'rows' in marks && areImages(marks.rows.map(({ image }) => image))) return { kind: 'marks' };
  if ('rows' in positions && areImages(positions.rows.map(({ image }) => image))) return { kind: 'positions' };
  try {
    const names = parse_ground_control_points(text).map(({ name }) => name);
    if (names.length === 0) return { kind: 'neither', why: say('it-has-no-rows') };
    if (areImages(names)) return { kind: 'neither', why: 'why' in positions ? positions.why : say('its-rows-are-images') };
    if (OF_TIE_POINTS.every((column) => columns.includes(column))) return { kind: 'neither', why: say('its-rows-are-tie-points') };
    return { kind: 'control' };
  } catch (error) {
    if (hasNumbers(text) && !/[,;\t]/u.test(text)) return { kind: 'neither', why: say('its-values-stand-between-spaces') };
    if (havePlaces && columns.some((column) => OF_IMAGES.test(column))) return { kind: 'neither', why: whyNoPositions(positions) };
    return { kind: 'neither', why: isOfImages(columns, marks) ? whyNoMarks(marks) : messageOf(error) };
  }
}

type Measurements = { rows: ReturnType<typeof parse_image_measurements> } | { why: string };

function measurementsOf(text: string): Measurements {
  try {
    return { rows: parse_image_measurements(text) };
  } catch (error) {
    return { why: messageOf(error) };
  }
}

type Positions = { rows: ReturnType<typeof parse_image_positions>['rows'] } | { why: string };

function positionsOf(text: string): Positions {
  try {
    return { rows: parse_image_positions(text).rows };
  } catch (error) {
    return { why: messageOf(error) };
  }
}

/** Whether a table says where images were taken, rather than what they show: by its columns or, without names of them, by its rows. */
function hasPlaces(columns: readonly string[], marks: Measurements): boolean {
  const areNames = columns.every((column) => !Number.isFinite(Number(column.replace(',', '.'))) || column === '');
  if (areNames && columns.some((column) => OF_PLACES.test(column))) return true;
  return 'rows' in marks && marks.rows.length > 0 && marks.rows.every(({ point }) => COORDINATE.test(point));
}

/** What is wrong with positions that were read, or not. */
function whyNoPositions(positions: Positions): string {
  return 'why' in positions ? positions.why : say('its-rows-name-no-images', { name: positions.rows[0]?.image ?? '' });
}

/** Whether a table that holds no control points is meant to hold image measurements: by its columns, or by its rows where no column is of heights. */
function isOfImages(columns: readonly string[], marks: Measurements): boolean {
  if (columns.some((column) => OF_IMAGES.test(column))) return true;
  const haveNames = 'rows' in marks && marks.rows.length > 0 && marks.rows.every(({ point }) => !COORDINATE.test(point));
  return haveNames && !columns.some((column) => OF_HEIGHTS.test(column));
}

/** What is wrong with image measurements that were read, or not. */
function whyNoMarks(marks: Measurements): string {
  return 'why' in marks ? marks.why : say('its-first-column-names-no-images', { name: marks.rows.find(({ image }) => !IMAGE_FILE.test(image))?.image ?? '' });
}
