/** What a worker does for a pair: unpacks a call, asks the crate, packs the answer. It holds the image opened last, the grey values of a pair, or a report in the making. */
import { zipSync } from 'fflate';
import {
  EpipolarPair,
  Photo,
  Report,
  candidates,
  constant_offset,
  epipolar_line,
  estimate_offset,
  gradient_candidates,
  grey_png,
  interior,
  match_photos,
  matches_csv,
  nearest_piece,
  open_pair_project,
  orient_fiducials,
  orient_matches,
  parallax_deviation,
  parse_camera,
  parse_fiducials,
  photo_difference,
  scaled_interior,
  score_matches,
  sha256,
  simulate,
  write_pair_project,
} from '../../../pkg/wasm/tiepoint.js';
import type { EpipolarFiles } from '../../../pkg/wasm/tiepoint.js';
import type { SampleImage } from '../../shared/crate';
import type { Handlers } from '../../shared/engine/messages';
import type { ImageSource } from '../state/data';
import type { Input, Output, PairCalls } from './calls';
import { ARCHIVE_TIME } from '../../shared/engine/archive';
import { decodeColour } from '../../shared/engine/colour';
import { bitmapOf, tileOf } from '../../shared/engine/tiles';
import { LANGUAGE } from '../../shared/text/language';
import { colourTile, reducedColour } from './colour';
import { fill, overlayOf, shareLeftOut } from './mask';
import { patchOf } from './patch';

interface OpenPhoto {
  photo: Photo;
  /** A copy of the grey values for tiles, made when the first tile is wanted. */
  grey: Uint8Array | null;
  /** Null where it has no colours to be shown. */
  colour: ImageBitmap | null;
}

let opened: OpenPhoto | null = null;

function photo(): OpenPhoto {
  if (opened === null) throw new Error('no image is open in this worker');
  return opened;
}

async function decode(source: ImageSource): Promise<Photo> {
  switch (source.kind) {
    case 'file':
      return Photo.decode(await bytesOf(source.file));
    case 'grey':
      return Photo.from_grey(source.width, source.height, source.grey);
    case 'project':
      throw new Error('a project does not hold its images');
  }
}

async function open({ source, overviewSide }: Input<'open'>): Promise<Output<'open'>> {
  opened?.photo.free();
  opened?.colour?.close();
  opened = null;
  const bytes = source.kind === 'file' ? new Uint8Array(await source.file.arrayBuffer()) : null;
  // The browser decodes beside the crate.
  const coming = bytes === null ? null : decodeColour(bytes);
  const decoded = bytes === null ? await decode(source) : Photo.decode(bytes);
  opened = { photo: decoded, grey: null, colour: null };
  const reduced = decoded.reduced(overviewSide);
  const colour = await coming;
  const coloured = colour == null ? null : reducedColour(colour, reduced, decoded.width, decoded.height);
  if (coloured === null) colour?.close();
  else opened.colour = colour;
  return {
    info: decoded.info(),
    overview: { bitmap: coloured ?? (await bitmapOf(reduced.grey, reduced.width, reduced.height)), halvings: reduced.halvings },
  };
}

/** The grey values of the image that is open, copied once. */
function greyOf(current: OpenPhoto): Uint8Array {
  current.grey ??= current.photo.grey();
  return current.grey;
}

function tile({ level, column, row, side }: Input<'tile'>): ImageBitmap | Promise<ImageBitmap> {
  const current = photo();
  if (current.colour !== null) return colourTile(current.colour, level, column, row, side);
  return tileOf(greyOf(current), current.photo.width, current.photo.height, level, column, row, side);
}

async function decodedGrey(file: Blob): Promise<SampleImage> {
  const decoded = await decode({ kind: 'file', file });
  const { width, height } = decoded;
  const grey = decoded.grey();
  decoded.free();
  return { width, height, grey };
}

async function mask({ file, overlaySide }: Input<'mask'>): Promise<Output<'mask'>> {
  const decoded = await decodedGrey(file);
  const { width, height, grey } = decoded;
  return { ...decoded, leftOut: shareLeftOut(grey), overlay: await overlayOf(grey, width, height, overlaySide) };
}

async function paintMask({ over, width, height, areas, overlaySide }: Input<'paintMask'>): Promise<Output<'paintMask'>> {
  const before = over instanceof Blob ? (await decodedGrey(over)).grey : over;
  const grey = before ?? new Uint8Array(width * height).fill(0xff);
  for (const { corners, masked } of areas) fill(grey, width, height, corners, masked ? 0 : 0xff);
  const png = grey_png(width, height, grey) as Uint8Array<ArrayBuffer>;
  return { width, height, grey, leftOut: shareLeftOut(grey), overlay: await overlayOf(grey, width, height, overlaySide), png };
}

/** The pair whose grey values this worker compares. */
let held: { left: Photo; right: Photo } | null = null;

function hold({ left, right }: Input<'hold'>): null {
  held?.left.free();
  held?.right.free();
  held = null;
  held = {
    left: Photo.from_grey(left.width, left.height, left.grey),
    right: Photo.from_grey(right.width, right.height, right.grey),
  };
  return null;
}

function match(m: Input<'match'>): Output<'match'> {
  if (held === null) throw new Error('no pair is held in this worker');
  const { left, right } = held;
  return match_photos(left, right, m.left, m.right, m.offset, m.interior, m.settings, m.nearest ?? undefined);
}

/** How the photos of the pair that is held lie to each other. */
function difference(): Output<'difference'> {
  if (held === null) throw new Error('no pair is held in this worker');
  return photo_difference(held.left, held.right);
}

function candidatesOf({ left, right, offset, index, options }: Input<'candidates'>): Float64Array {
  if (offset === null) throw new Error('these candidates lie around an expected place');
  const none = new Float64Array();
  return candidates(index, left.points, left.moments ?? none, right.points, right.moments ?? none, offset, options);
}

/** SHA-256 in hexadecimal digits. */
const digestOf = (bytes: Uint8Array): string => Array.from(sha256(bytes), (byte) => byte.toString(16).padStart(2, '0')).join('');

/** The report in the making. */
let report: Report | null = null;

function reportInHand(): Report {
  if (report === null) throw new Error('no report is begun in this worker');
  return report;
}

async function reportOpen({ images, names, input, settings, truth, masks: [ofLeft, ofRight], edits }: Input<'reportOpen'>): Promise<string[]> {
  report?.free();
  report = null;
  const left = await decode(images[0]);
  const right = await decode(images[1]);
  report = new Report(left, right, names, input, settings, truth, ofLeft, ofRight, edits);
  left.free();
  right.free();
  return report.steps(LANGUAGE);
}

async function epipolar({ project, images: [ofLeft, ofRight] }: Input<'epipolar'>): Promise<Output<'epipolar'>> {
  const encoder = new TextEncoder();
  const pair = EpipolarPair.open(encoder.encode(project));
  const [first, second] = pair.is_swapped ? [ofRight, ofLeft] : [ofLeft, ofRight];
  try {
    const { left, right, anaglyph, parameters } = await resampled(pair, first, second);
    const files = { 'left.png': left, 'right.png': right, 'anaglyph.png': anaglyph, 'epipolar.json': encoder.encode(parameters) };
    // Pictures are compressed already.
    return { archive: zipSync(files, { level: 0, mtime: ARCHIVE_TIME }), geometry: pair.geometry };
  } finally {
    pair.free();
  }
}

/** In the colours of their files; what was simulated is grey. */
async function resampled(pair: EpipolarPair, left: ImageSource, right: ImageSource): Promise<EpipolarFiles> {
  if (left.kind === 'file' && right.kind === 'file') return pair.resample_files(await bytesOf(left.file), await bytesOf(right.file));
  const photos = [await decode(left), await decode(right)] as const;
  try {
    return pair.resample(...photos);
  } finally {
    for (const held of photos) held.free();
  }
}

async function bytesOf(file: Blob): Promise<Uint8Array> {
  return new Uint8Array(await file.arrayBuffer());
}

function interiorOf({ width, height, camera, pairFocalMm, fiducials, model, origin }: Input<'interior'>): Output<'interior'> {
  const own = interior(camera, { width, height, fiducials, model, origin });
  return {
    interior: scaled_interior(own, pairFocalMm / camera.focal_mm),
    fiducials: fiducials.length > 0 ? orient_fiducials(fiducials, model) : null,
  };
}

export const PAIR_HANDLERS: Handlers<PairCalls> = {
  open,
  tile,
  reduced: ({ maxSide }) => photo().photo.reduced(maxSide),
  detect: ({ settings, mask: left }) => photo().photo.detect(settings, left),
  features: ({ settings, mask: left }) => photo().photo.describe_points(settings, left),
  describe: ({ points, window, strategy }) => photo().photo.describe(points, window, strategy),
  grey: () => ({ width: photo().photo.width, height: photo().photo.height, grey: photo().photo.grey() }),
  patch: (input) => patchOf(greyOf(photo()), photo().photo.width, photo().photo.height, input),
  moments: ({ col, row, window }) => photo().photo.window_moments(col, row, window),
  simulate: (flight) => simulate(flight),
  hold,
  offset: ({ left, right }) => estimate_offset(left, right),
  constantOffset: ({ dx, dy }) => constant_offset(dx, dy),
  match,
  nearest: ({ left, first, end, right }) => nearest_piece(left, first, end, right),
  difference,
  candidates: candidatesOf,
  parallaxDeviation: ({ index, points, match: { rules, places }, offset, options }) => parallax_deviation(index, points, rules, places, offset, options),
  gradientCandidates: ({ index, left, right, most }) => gradient_candidates(index, left, right, most),
  epipolarLine: ({ from, x, y, model, interior: ofPair, width, height }) => epipolar_line(from, x, y, model, ofPair, width, height),
  score: (s) => score_matches(s.matches, s.leftPoints, s.rightPosition, s.left.width, s.left.height, s.right.width, s.right.height),
  interior: interiorOf,
  orient: ({ matches, fits, interior: ofPair, options, points }) => orient_matches(matches, fits, ofPair, options, points),
  reportOpen,
  reportStep: () => reportInHand().step(),
  reportPage: () => reportInHand().html(LANGUAGE),
  epipolar,
  parseFiducials: ({ text }) => parse_fiducials(text),
  orientMarks: ({ fiducials, model }) => {
    try {
      return orient_fiducials(fiducials, model);
    } catch {
      // Marks on one line, or one mark twice.
      return null;
    }
  },
  parseCamera: ({ text }) => parse_camera(text),
  mask,
  paintMask,
  digest: async ({ file }) => digestOf(new Uint8Array(await file.arrayBuffer())),
  projectOpen: ({ bytes }) => open_pair_project(bytes),
  projectWrite: (project) => write_pair_project(project),
  matchesCsv: ({ matches, rejected }) => matches_csv(matches, rejected),
};
