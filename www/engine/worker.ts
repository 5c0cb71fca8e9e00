/** The worker: unpacks a call, asks the crate, packs the answer. It holds one image at most. */
import {
  Photo, candidates, constant_offset, estimate_offset, initSync, interior, match_points, matches_csv, observations, orient_fiducials,
  orient_relative, parse_camera, parse_fiducials, sample, scaled_interior,
} from '../../pkg/wasm/tiepoint.js';
import type { CallName, Calls, Input, Output, RequestMessage, StartMessage, WireFailure } from './calls';
import { bitmapOf, tileOf } from './tiles';

interface OpenPhoto {
  photo: Photo;
  /** A copy of the grey values for tiles, made when the first tile is wanted. */
  grey: Uint8Array | null;
}

let opened: OpenPhoto | null = null;

function photo(): OpenPhoto {
  if (opened === null) throw new Error('no image is open in this worker');
  return opened;
}

async function open({ source, overviewSide }: Input<'open'>): Promise<Output<'open'>> {
  opened?.photo.free();
  opened = null;
  const decoded =
    source.kind === 'file'
      ? Photo.decode(new Uint8Array(await source.file.arrayBuffer()))
      : Photo.from_grey(source.width, source.height, source.grey);
  opened = { photo: decoded, grey: null };
  const reduced = decoded.reduced(overviewSide);
  return {
    info: decoded.info(),
    overview: { bitmap: await bitmapOf(reduced.grey, reduced.width, reduced.height), halvings: reduced.halvings },
  };
}

function tile({ level, column, row, side }: Input<'tile'>): Promise<ImageBitmap> {
  const current = photo();
  current.grey ??= current.photo.grey();
  return tileOf(current.grey, current.photo.width, current.photo.height, level, column, row, side);
}

function interiorOf({ width, height, camera, pairFocalMm, fiducials, model, origin }: Input<'interior'>): Output<'interior'> {
  const own = interior(camera, { width, height, fiducials, model, origin });
  return {
    interior: scaled_interior(own, pairFocalMm / camera.focal_mm),
    fiducials: fiducials.length > 0 ? orient_fiducials(fiducials, model) : null,
  };
}

const HANDLERS: { [K in CallName]: (input: Input<K>) => Output<K> | Promise<Output<K>> } = {
  open,
  tile,
  reduced: ({ maxSide }) => photo().photo.reduced(maxSide),
  detect: (options) => photo().photo.detect(options),
  describe: ({ points, window, measure }) => photo().photo.describe(points, window, measure),
  moments: ({ col, row, window }) => photo().photo.window_moments(col, row, window),
  sample: ({ seed }) => sample(seed),
  offset: ({ left, right }) => estimate_offset(left, right),
  constantOffset: ({ dx, dy }) => constant_offset(dx, dy),
  match: (m) => match_points(m.leftPoints, m.leftDescriptors, m.rightPoints, m.rightDescriptors, m.offset, m.options),
  candidates: (m) => candidates(m.index, m.leftPoints, m.leftDescriptors, m.rightPoints, m.rightDescriptors, m.offset, m.options),
  interior: interiorOf,
  orient: ({ matches, left, right, focalMm, options }) => orient_relative(observations(matches, left, right), focalMm, options),
  parseFiducials: ({ text }) => parse_fiducials(text),
  parseCamera: ({ text }) => parse_camera(text),
  matchesCsv: ({ matches }) => matches_csv(matches),
};

/** Buffers and bitmaps of an answer, moved rather than copied. Every array the crate hands out is a copy of its own. */
function transferables(value: unknown): Transferable[] {
  if (value instanceof ImageBitmap) return [value];
  if (ArrayBuffer.isView(value)) return value.buffer instanceof ArrayBuffer ? [value.buffer] : [];
  if (typeof value !== 'object' || value === null || Array.isArray(value)) return [];
  return Object.values(value).flatMap(transferables);
}

function failureOf(error: unknown): WireFailure {
  const message = error instanceof Error ? error.message : String(error);
  const code = error instanceof Error && 'code' in error && typeof error.code === 'string' ? error.code : null;
  if (error instanceof WebAssembly.RuntimeError) return { kind: 'trap', code, message };
  if (error instanceof RangeError) return { kind: 'memory', code, message };
  return { kind: code === null ? 'other' : 'refused', code, message };
}

/** Runs one call. The correlated types of `request.call` and `request.input` are what `RequestMessage` guarantees. */
function run<K extends keyof Calls>(call: K, input: Input<K>): Output<K> | Promise<Output<K>> {
  return HANDLERS[call](input);
}

/** Why the module could not start here; every call is then answered with it. */
let startFailure: { error: unknown } | null = null;

function start(message: StartMessage): void {
  try {
    initSync({ module: message.module });
  } catch (error) {
    startFailure = { error };
  }
}

async function answer(request: RequestMessage): Promise<void> {
  try {
    if (startFailure !== null) throw startFailure.error;
    const output = await run(request.call, request.input);
    postMessage({ id: request.id, output }, { transfer: transferables(output) });
  } catch (error) {
    postMessage({ id: request.id, failure: failureOf(error) });
  }
}

// Calls are answered one after the other: `open` waits for the file, and what follows needs its image.
let queue: Promise<void> = Promise.resolve();

addEventListener('message', (event: MessageEvent<StartMessage | RequestMessage>) => {
  const message = event.data;
  if ('module' in message) start(message);
  else queue = queue.then(() => answer(message));
});
