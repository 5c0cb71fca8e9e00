/** Fiducial marks of scans of the block that are measured in the pair's part of the page: which scans come next, and what of the marks the block takes. */
import { interior, orient_fiducials, parse_camera, parse_fiducials } from '../../../pkg/wasm/tiepoint.js';
import type { Fiducial } from '../../../pkg/wasm/tiepoint.js';
import { sentence } from '../../shared/text/format';
import { messageOf } from '../../shared/text/messages';
import { say } from '../../shared/text/words';
import type { TextFile } from './file';
import { remember } from '../../shared/state/remember';
import { filmOf, NO_FILM, scansOf } from './film';
import type { BegunScan, GivenFilm } from './film';
import { poorMarks } from './poor-marks';

/** A scan in the pair's part of the page. */
export interface MeasuredScan {
  /** Its name. */
  image: string;
  /** All marks, in px of the image; NaN stands for what is not known. */
  all: readonly Fiducial[];
  /** Those of them that are measured and have photo coordinates. */
  marks: readonly Fiducial[];
  /** How many are measured and have no photo coordinates. */
  withoutMm: number;
  /** Width and height in px, once it is open. */
  size: readonly [number, number] | null;
}

/** Fewer marks say nothing of each other. */
const LEAST_MARKS = 4;

/** So many scans are measured beside each other. */
const TOGETHER = 2;

const COLUMNS = ['col', 'row', 'x_mm', 'y_mm'] as const;

/** The table of marks of a scan, as it would be given as a file. */
export function tableOfMarks(image: string, marks: readonly Fiducial[]): TextFile {
  const rows = marks.map((mark) => COLUMNS.map((column) => String(mark[column])));
  return { name: `${image.replace(/\.[^.]*$/u, '')}.csv`, text: [COLUMNS, ...rows].map((row) => `${row.join(',')}\n`).join('') };
}

/** The marks that the block has of a scan. */
export function marksOfScan(film: GivenFilm, image: string): Fiducial[] {
  const own = filmOf(film, image);
  return own === null ? [] : parse_fiducials(own.marks);
}

/** What is measured in scans that the block has not, to go on with when they are shown again. */
export function begunIn(film: GivenFilm, scans: readonly MeasuredScan[]): BegunScan[] {
  return scans.filter((scan) => !isInBlock(film, scan)).map(({ image, all }) => ({ image, marks: all }));
}

/** The marks with which measuring a scan begins: those that were begun, or that the block has, else those of the scan that has most, of which the positions are to be measured. */
export function marksToMeasure(film: GivenFilm, image: string): Fiducial[] {
  const begun = film.begun.find((scan) => scan.image === image);
  if (begun !== undefined) return [...begun.marks];
  const own = marksOfScan(film, image);
  if (own.length > 0) return own;
  const most = film.marks.map(({ text }) => parse_fiducials(text)).reduce<Fiducial[]>((best, marks) => (marks.length > best.length ? marks : best), []);
  return most.map(({ x_mm, y_mm }) => ({ col: NaN, row: NaN, x_mm, y_mm }));
}

/** The scans that are measured next, beside those that are shown; once all have marks they are gone through again. */
export function nextScans<T extends { name: string }>(film: GivenFilm, images: readonly T[], shown: readonly string[] = []): T[] {
  const scans = scansOf(film, images);
  const isOther = ({ name }: T) => !shown.includes(name);
  const lacking = scans.filter(({ name }) => filmOf(film, name) === null);
  if (lacking.length > 0) return lacking.filter(isOther).slice(0, TOGETHER);
  const after = scans.findLastIndex(({ name }) => shown.includes(name)) + 1;
  return [...scans.slice(after), ...scans.slice(0, after)].filter(isOther).slice(0, TOGETHER);
}

/** How many scans there are, and how many of them have marks. */
export function countedScans(film: GivenFilm, images: readonly { name: string }[]): { measured: number; scans: number } {
  const scans = scansOf(film, images);
  return { measured: scans.filter(({ name }) => filmOf(film, name) !== null).length, scans: scans.length };
}

/** Whether the block has all that is measured in a scan. */
export function isInBlock(film: GivenFilm, { image, marks, withoutMm }: MeasuredScan): boolean {
  return withoutMm === 0 && (marks.length === 0 || !differs(film, image, marks));
}

function differs(film: GivenFilm, image: string, marks: readonly Fiducial[]): boolean {
  // What a file has in other words may be the same.
  return tableOfMarks(image, marks).text !== tableOfMarks(image, marksOfScan(film, image)).text;
}

/** The tables that the block can take of the scans: of those whose marks suffice, and are others than the block has. */
export function tablesToTake(film: GivenFilm, scans: readonly MeasuredScan[]): TextFile[] {
  return scans.flatMap((scan) => {
    const { image, marks } = scan;
    return marks.length > 0 && differs(film, image, marks) && faultOf(film, scan) === '' ? [tableOfMarks(image, marks)] : [];
  });
}

/** What the marks of scans lack, for which the block does not take them, or not all of them, and which of those that it takes lie far off; nothing of a scan without any. */
export function lackOf(film: GivenFilm, scans: readonly MeasuredScan[]): string {
  const said = scans.flatMap((scan) => {
    const { image, marks, all, withoutMm } = scan;
    const lone = withoutMm === 0 ? '' : say('marks-without-mm', { name: image, marks: withoutMm });
    const fault = marks.length === 0 ? '' : faultOf(film, scan);
    const off = marks.length === 0 || fault !== '' ? '' : farOff(image, marks, all);
    return [lone, fault === '' ? '' : `${image}: ${fault}`, off].filter((text) => text !== '');
  });
  return said.join(' ');
}

/** Which of the marks lie far off; empty where none does. `all`: with those that are not measured, by which they are numbered. */
function farOff(name: string, marks: readonly Fiducial[], all: readonly Fiducial[]): string {
  const poor = poorMarks(marks);
  return poor === null ? '' : say('marks-far-off', { name, px: poor.sigmaPx, worst: poor.worst === null ? 0 : all.indexOf(poor.worst) + 1 });
}

/** So many scans are named whose marks lie far off. */
const NAMED = 3;

/** Of the scans that have marks, those whose marks lie far off: images that are made of them are bent. */
export const marksFarOff = remember((marks: GivenFilm['marks'], images: readonly { name: string }[]): string => {
  const said = images.map(({ name }) => {
    const own = marksOfScan({ ...NO_FILM, marks }, name);
    return own.length < LEAST_MARKS ? '' : farOff(name, own, own);
  });
  const off = said.filter((text) => text !== '');
  const more = off.length - NAMED;
  return [...off.slice(0, NAMED), ...(more > 0 ? [say('marks-of-more-far-off', { scans: more })] : [])].join(' ');
});

/** Why the marks of a scan give no interior orientation. */
function faultOf({ camera }: GivenFilm, { marks, size }: MeasuredScan): string {
  try {
    if (camera === null || size === null) orient_fiducials([...marks], 'affine');
    else interior(parse_camera(camera.text), { width: size[0], height: size[1], fiducials: [...marks] });
    return '';
  } catch (error) {
    return sentence(messageOf(error));
  }
}
