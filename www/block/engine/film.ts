/** Scans of film in a worker: what is known of one as the crate reads it, and its frame. */
import { pixelOfFilm } from '../../../pkg/block/film.js';
import { film_frame, film_pixel_mm, parse_camera, parse_fiducials } from '../../../pkg/wasm/tiepoint.js';
import type { CameraRule, FilmInput, FilmScan, Given } from '../../../pkg/wasm/tiepoint.js';
import type { FilmTexts } from '../state/film';

/** What all frames of a film have in common. */
export interface FramePlan {
  /** The side of a pixel: the largest of the scans, or that of frames of the same film that were made before. */
  pixelMm: number;
  /** All marks of the film, those that a scan lacks included. */
  marksMm: [number, number][];
}

export interface PlanInput {
  films: readonly FilmTexts[];
  given: readonly CameraRule[];
}

export interface FrameInput {
  file: Blob;
  film: FilmTexts;
  plan: FramePlan;
  /** What the camera of the frame is named by. */
  image: string;
  /** What of the scan is left out. */
  mask: { name: string; file: Blob } | null;
}

export interface Frame {
  /** PNG files. */
  image: Blob;
  mask: Blob;
  /** Of this frame alone. */
  camera: CameraRule;
  /** How the scan lies to it. */
  scan: FilmScan;
}

export function readFilm({ camera, marks }: FilmTexts): Given<FilmInput> {
  const scan = { fiducials: parse_fiducials(marks) };
  return camera === null ? { scan } : { camera: parse_camera(camera), scan };
}

/** `given`: the cameras of frames that were made before. */
export function filmPlan({ films, given }: PlanInput): FramePlan {
  const marks = new Map<string, [number, number]>();
  for (const { x_mm: x, y_mm: y } of films.flatMap((film) => parse_fiducials(film.marks))) marks.set(`${String(x)},${String(y)}`, [x, y]);
  const largest = Math.max(...films.map((film) => film_pixel_mm(readFilm(film))));
  // All scans of a film have one camera.
  const focalMm = films.flatMap(({ camera }) => (camera === null ? [] : [parse_camera(camera).focal_mm]))[0];
  return { pixelMm: focalMm === undefined ? largest : pixelOfFilm(focalMm, largest, given), marksMm: [...marks.values()] };
}

/** The scan as an image of an ideal camera. */
export async function filmFrame({ file, film, plan, image, mask }: FrameInput): Promise<Frame> {
  const known = { ...readFilm(film), marks_mm: plan.marksMm };
  const bytes = async (of: Blob) => new Uint8Array(await of.arrayBuffer());
  const hidden = mask === null ? null : { name: mask.name, file: await bytes(mask.file) };
  const made = film_frame(await bytes(file), known, { image, pixel_mm: plan.pixelMm, mask: hidden });
  const png = (of: Uint8Array) => new Blob([of as Uint8Array<ArrayBuffer>], { type: 'image/png' });
  return { image: png(made.image), mask: png(made.mask), camera: made.camera, scan: made.scan };
}
