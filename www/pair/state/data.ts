/** What passes between the stages of a pair. */
import type { FiducialOrientation, Interior, MatchResult, SampleImage } from '../../shared/crate';

/**
 * Where an image comes from. It is kept by the page, so that a fresh worker can open it again. Of an image of a project that was opened only
 * its digest is there until its file is given too; of one that was simulated not even that.
 */
export type ImageSource = { kind: 'file'; file: Blob } | ({ kind: 'grey' } & SampleImage) | { kind: 'project'; content: string | null };

/** A reduced copy for display: one pixel of it is 2^halvings pixels of the image. */
export interface Overview {
  bitmap: ImageBitmap;
  halvings: number;
}

/** Matches as they are used, with the edits by hand, beside those that were found. */
export interface MatchesInUse {
  match: MatchResult;
  found: MatchResult;
}

/** Matches that something was made of. A matching of the same key finds the same ones, in objects of its own. */
export interface MatchesOf extends MatchesInUse {
  key: string;
}

/** A grey image of the size of another: where it is 0, no points are wanted. */
export interface MaskImage {
  width: number;
  height: number;
  grey: Uint8Array;
  /** Share of the pixels that are left out. */
  leftOut: number;
  /** These pixels in colour, reduced for display. */
  overlay: ImageBitmap;
}

export interface InteriorOutput {
  interior: Interior;
  /** Absent without fiducials. */
  fiducials: FiducialOrientation | null;
}
