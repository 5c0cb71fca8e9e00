/** Scanned film among the images that are placed on an orthophoto: its camera, and the fiducial marks of each scan. */
import type { Fiducial } from '../../../pkg/wasm/tiepoint.js';
import type { TextFile } from './file';

export interface GivenFilm {
  /** Of all scans. */
  camera: TextFile | null;
  /** One a scan, named as its image. */
  marks: readonly TextFile[];
  /** The user measures marks: all images are scans, whether anything is given of them or not. */
  areScans: boolean;
  /** What is measured in scans and not used yet, while others are shown. */
  begun: readonly BegunScan[];
}

/** Marks of a scan as far as they are measured; NaN stands for what is not known. */
export interface BegunScan {
  image: string;
  marks: readonly Fiducial[];
}

export const NO_FILM: GivenFilm = { camera: null, marks: [], areScans: false, begun: [] };

/** What a scan is placed by beside its pixels, as its files have it. */
export interface FilmTexts {
  camera: string | null;
  marks: string;
}

/** Of an image, by its name; null where it is no scan of film. */
export function filmOf({ camera, marks }: GivenFilm, image: string): FilmTexts | null {
  const own = marks.find(({ name }) => stemOf(name) === stemOf(image));
  return own === undefined ? null : { camera: camera?.text ?? null, marks: own.text };
}

/** Whether a pattern is that of the names of frames of a film, as the crate gives it: no image that is none fits it by chance. */
export const isOfFrames = (pattern: string): boolean => /^\*-film\d*\.png$/u.test(pattern);

/** Whether an image is the frame of a scan, by its name. */
const isFrame = (name: string): boolean => /-film\d*\.png$/u.test(name);

/** What the frame of a scan is called by the pattern of its film. */
export function frameName(scan: string, pattern: string): string {
  // A function: signs of dollar in names are no references.
  return pattern.replace('*', () => scan.replace(/\.[^.]*$/u, ''));
}

/** The images that may be scans: those that are no frames of some. */
export function possibleScans<T extends { name: string }>(images: readonly T[]): T[] {
  return images.filter(({ name }) => !isFrame(name));
}

/** The images that are scans, with marks or without: all that are no frames, where anything is given of film. */
export function scansOf<T extends { name: string }>(film: GivenFilm, images: readonly T[]): T[] {
  const isFilm = film.camera !== null || film.areScans || framesOf(film, images).length > 0;
  return isFilm ? possibleScans(images) : [];
}

/** The scans of which frames can be made: those that have marks. */
export function framesOf<T extends { name: string }>(film: GivenFilm, images: readonly T[]): T[] {
  return images.filter(({ name }) => filmOf(film, name) !== null);
}

/** Whether some images are scans of which frames are to be made first, before a block is. */
export function awaitsFrames(film: GivenFilm, images: readonly { name: string }[]): boolean {
  return scansOf(film, images).length > 0;
}

/** With these marks in place of those of the same scans. */
export function withMarks(film: GivenFilm, marks: readonly TextFile[]): GivenFilm {
  const byStem = new Map([...film.marks, ...marks].map((own) => [stemOf(own.name), own]));
  const given = new Set(marks.map(({ name }) => stemOf(name)));
  return { ...film, marks: [...byStem.values()], begun: film.begun.filter(({ image }) => !given.has(stemOf(image))) };
}

/** With what is begun of scans in place of what was begun of them before. */
export function withBegun(film: GivenFilm, shown: readonly string[], begun: readonly BegunScan[]): GivenFilm {
  const others = film.begun.filter(({ image }) => !shown.includes(image));
  return begun.length === 0 && others.length === film.begun.length ? film : { ...film, begun: [...others, ...begun] };
}

/** The names of marks that are of no image. */
export function marksOfNone({ marks }: GivenFilm, images: readonly { name: string }[]): string[] {
  const stems = new Set(images.map(({ name }) => stemOf(name)));
  return marks.map(({ name }) => name).filter((name) => !stems.has(stemOf(name)));
}

/** A name without its end. */
export function stemOf(name: string): string {
  return name.replace(/\.[^.]*$/u, '').toLowerCase();
}
