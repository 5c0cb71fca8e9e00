/** Least squares matching of a place in one image to another one: by windows of both, the second turned and scaled as the first. */
import { defaults, match_photos, Photo } from '../../../pkg/wasm/tiepoint.js';
import { fitInput, placeOfFit } from '../../shared/engine/fit';
import { greyAt } from '../../shared/engine/tiles';
import type { Position } from '../../shared/state/pane';

/** Side of a window, px. */
const SIDE = 81;

/** How a step in the first image lies in the second: across and down, columns of a matrix. */
export type Turn = readonly [ax: number, ay: number, bx: number, by: number];

export interface Window {
  grey: Uint8Array;
  /** The place in the window. */
  at: Position;
}

/** The grey values around a place, a px a sample, along a step across and a step down. */
export function blockWindow({ file, at, turn }: { file: Blob; at: Position; turn: Turn | null }): Promise<Window> {
  return file.arrayBuffer().then((bytes) => {
    const photo = Photo.decode(new Uint8Array(bytes));
    const { width, height } = photo;
    const grey = photo.grey();
    photo.free();
    // Samples of the first image lie at the middles of its pixels: none is made of several.
    const shift: Position = turn === null ? [at[0] - Math.floor(at[0]) - 0.5, at[1] - Math.floor(at[1]) - 0.5] : [0, 0];
    const [ax, ay, bx, by] = turn ?? [1, 0, 0, 1];
    const half = (SIDE - 1) / 2;
    const values = Uint8Array.from({ length: SIDE * SIDE }, (_, i) => {
      const [u, v] = [(i % SIDE) - half - shift[0], Math.floor(i / SIDE) - half - shift[1]];
      return Math.round(greyAt(grey, width, height, at[0] + u * ax + v * bx, at[1] + u * ay + v * by));
    });
    return { grey: values, at: [half + 0.5 + shift[0], half + 0.5 + shift[1]] };
  });
}

/** How far, in steps of the second window, the place of the first one lies from the place of the second; null where no match is confirmed. */
export function blockFit({ left, right }: { left: Window; right: Window }): Position | null {
  const [first, second] = [left, right].map(({ grey }) => Photo.from_grey(SIDE, SIDE, grey));
  if (first === undefined || second === undefined) return null;
  try {
    const { left: point, offset, settings } = fitInput(left.at, right.at, defaults());
    const none = { points: new Float64Array() };
    const found = placeOfFit(match_photos(first, second, { points: point }, none, offset, null, settings, undefined).matches);
    return found === null ? null : [found[0] - right.at[0], found[1] - right.at[1]];
  } finally {
    first.free();
    second.free();
  }
}
