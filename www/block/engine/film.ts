/** Scans of film in a worker: what is known of one as the crate reads it, and its frame. */
import { film_frame, parse_camera, parse_fiducials } from '../../../pkg/wasm/tiepoint.js';
import type { CameraRule, FilmInput, Given } from '../../../pkg/wasm/tiepoint.js';
import type { FilmTexts } from '../state/film';

export interface FrameInput {
  file: Blob;
  film: FilmTexts;
  /** The name of the frame. */
  image: string;
  /** The side of its pixels; null: that of the scan. */
  pixelMm: number | null;
}

export interface Frame {
  /** PNG files. */
  image: Uint8Array<ArrayBuffer>;
  mask: Uint8Array<ArrayBuffer>;
  camera: CameraRule;
}

export function readFilm({ camera, marks }: FilmTexts): Given<FilmInput> {
  const scan = { fiducials: parse_fiducials(marks) };
  return camera === null ? { scan } : { camera: parse_camera(camera), scan };
}

/** The scan as an image of an ideal camera. */
export async function filmFrame({ file, film, image, pixelMm }: FrameInput): Promise<Frame> {
  const made = film_frame(new Uint8Array(await file.arrayBuffer()), readFilm(film), image, pixelMm ?? undefined);
  return { image: made.image as Uint8Array<ArrayBuffer>, mask: made.mask as Uint8Array<ArrayBuffer>, camera: made.camera };
}
