/** How each stage is computed: which calls, on which worker, from which results. */
import type { GivenImage, PointWindow, Side, StageName, StageValues, State } from '../state/state';
import { comparesGreyValues, isCurrent, pairCameras } from '../state/keys';
import { readable } from '../state/names';
import { truthOf } from '../state/truth';
import type { PairInterior } from './wasm';
import type { MatchInput, Output } from './calls';
import { CallError } from './client';
import type { WorkerClient } from './client';
import type { WorkerName } from './stages';

/** Longest side of the copies from which the offset is estimated, in px. */
const OFFSET_SIDE = 1024;

export interface Workers {
  client(name: WorkerName): WorkerClient;
  /** Opens an image in the worker of a side. */
  open(side: Side, image: GivenImage): Promise<Output<'open'>>;
  /** The worker of a side, holding the image that the state has there. */
  withImage(side: Side, state: State): Promise<WorkerClient>;
  /** The pair's worker, holding the grey values of both images. */
  withPair(state: State): Promise<WorkerClient>;
}

type Run<Value> = (state: State, workers: Workers) => Promise<Value>;

/** A result that the stage graph promised. */
function needed<S extends StageName>(state: State, stage: S): StageValues[S] {
  const result = state.results[stage];
  if (result === undefined) throw new Error(`the stage ${stage} has no result`);
  return result.value as StageValues[S];
}

function settingsOf(state: State): NonNullable<State['settings']> {
  if (state.settings === null) throw new Error('the settings are not loaded');
  return state.settings;
}

function open(side: Side): Run<StageValues['openLeft']> {
  return async (state, workers) => {
    const image = state.images[side];
    if (image === null) throw new Error(`there is no ${side} image`);
    return workers.open(side, image);
  };
}

function points(side: Side): Run<StageValues['pointsLeft']> {
  return async (state, workers) => (await workers.withImage(side, state)).call('detect', settingsOf(state).points);
}

function descriptors(side: Side): Run<StageValues['descriptorsLeft']> {
  return async (state, workers) => {
    const found = needed(state, side === 'left' ? 'pointsLeft' : 'pointsRight');
    const { window, matching } = settingsOf(state);
    return (await workers.withImage(side, state)).call('describe', { points: found.points, window, strategy: matching.strategy });
  };
}

const offset: Run<StageValues['offset']> = async (state, workers) => {
  if (state.offset !== null) {
    const [dx, dy] = state.offset;
    return workers.client('pair').call('constantOffset', { dx, dy });
  }
  const reduced = async (side: Side) => (await workers.withImage(side, state)).call('reduced', { maxSide: OFFSET_SIDE });
  const [left, right] = await Promise.all([reduced('left'), reduced('right')]);
  return workers.client('pair').call('offset', { left, right }, [left.grey.buffer, right.grey.buffer]);
};

function matchInput(state: State): MatchInput {
  return {
    leftPoints: needed(state, 'pointsLeft').points,
    leftDescriptors: needed(state, 'descriptorsLeft'),
    rightPoints: needed(state, 'pointsRight').points,
    rightDescriptors: needed(state, 'descriptorsRight'),
    offset: needed(state, 'offset'),
  };
}

const match: Run<StageValues['match']> = async (state, workers) => {
  const settings = settingsOf(state);
  // Without epipolar lines the result does not depend on the camera, and must not wait for it.
  const ofPair = settings.matching.epipolar && isCurrent(state, 'interiorLeft') && isCurrent(state, 'interiorRight') ? interiorOfPair(state) : null;
  return (await workers.withPair(state)).call('match', { ...matchInput(state), interior: ofPair, settings });
};

function interiorOfPair(state: State): PairInterior {
  const cameras = pairCameras(state);
  if ('missing' in cameras) throw new Error(cameras.missing);
  return { left: needed(state, 'interiorLeft').interior, right: needed(state, 'interiorRight').interior, focal_mm: cameras.left.focal_mm };
}

function interior(side: Side): Run<StageValues['interiorLeft']> {
  return async (state, workers) => {
    const { info } = needed(state, side === 'left' ? 'openLeft' : 'openRight');
    const cameras = pairCameras(state);
    if ('missing' in cameras) throw new Error(cameras.missing);
    const { fiducials, origin } = state.photos[side];
    return workers.client('pair').call('interior', {
      width: info.width, height: info.height, camera: cameras[side], pairFocalMm: cameras.left.focal_mm, fiducials, model: state.fiducialModel, origin,
    });
  };
}

const orientation: Run<StageValues['orientation']> = async (state, workers) => {
  const { matches, fits } = needed(state, 'match');
  return workers.client('pair').call('orient', { matches, fits, interior: interiorOfPair(state), options: settingsOf(state).orientation });
};

const score: Run<StageValues['score']> = async (state, workers) => {
  const truth = truthOf(state);
  if (truth === null) throw new Error('these images have no truth');
  const { info } = needed(state, 'openRight');
  return workers.client('pair').call('score', {
    matches: needed(state, 'match').matches,
    leftPoints: needed(state, 'pointsLeft').points,
    rightPosition: truth.rightPosition,
    left: { width: truth.leftWidth, height: truth.leftHeight },
    right: { width: info.width, height: info.height },
  });
};

/** Where the best place of a left point lies in the right image; null where it has none. */
export function placeOf(places: Float64Array, index: number): Position | null {
  const [x = NaN, y = NaN] = places.subarray(2 * Math.max(0, index), 2 * index + 2);
  return Number.isNaN(x) || Number.isNaN(y) ? null : [x, y];
}

/** The left point that a selection is about: itself, or the one that has the selected right point as its best candidate. */
export function leftIndexOf(state: State, best: Int32Array, rules: Uint8Array): number {
  const { selection } = state;
  if (selection === null) return -1;
  if (selection.side === 'left') return selection.index;
  let found = -1;
  for (let i = 0; i < best.length; i++) {
    if (best[i] !== selection.index) continue;
    if (rules[i] === 0) return i;
    if (found < 0) found = i;
  }
  return found;
}

/** The window whose content decided: that of the moments, or that of the grey values. */
function comparedWindow(state: State): Partial<ReturnType<typeof settingsOf>['window']> {
  const settings = settingsOf(state);
  return comparesGreyValues(settings) ? { side: settings.matching.template, shape: 'square' } : settings.window;
}

/** A position of an image, as its points give it; null where there is no such point. */
function pointAt(state: State, side: Side, index: number): Position | null {
  const { points: at } = needed(state, side === 'left' ? 'pointsLeft' : 'pointsRight');
  const [x, y] = at.subarray(3 * index, 3 * index + 2);
  return x === undefined || y === undefined ? null : [x, y];
}

type Position = [number, number];

async function windowAt(workers: Workers, state: State, side: Side, [x, y]: Position): Promise<PointWindow> {
  const col = Math.floor(x);
  const row = Math.floor(y);
  const worker = await workers.withImage(side, state);
  try {
    return { col, row, report: await worker.call('moments', { col, row, window: comparedWindow(state) }), problem: null };
  } catch (error) {
    // A window that leaves the image or is constant is an answer, not a failure.
    if (error instanceof CallError && error.failure.kind === 'refused') return { col, row, report: null, problem: readable(state.catalogue, error.message) };
    throw error;
  }
}

const inspection: Run<StageValues['inspection']> = async (state, workers) => {
  const result = needed(state, 'match');
  const left = leftIndexOf(state, result.best, result.rules);
  const leftAt = left < 0 ? null : pointAt(state, 'left', left);
  const rightAt = state.selection?.side === 'right' ? pointAt(state, 'right', state.selection.index) : placeOf(result.places, left);
  const settings = settingsOf(state);
  const [ofLeft, ofRight, candidates] = await Promise.all([
    leftAt === null ? null : windowAt(workers, state, 'left', leftAt),
    rightAt === null ? null : windowAt(workers, state, 'right', rightAt),
    left < 0 || comparesGreyValues(settings)
      ? new Float64Array()
      : workers.client('pair').call('candidates', { ...matchInput(state), index: left, options: settings.matching }),
  ]);
  return { left: ofLeft, right: ofRight, candidates };
};

export const RUNS: { readonly [S in StageName]: Run<StageValues[S]> } = {
  openLeft: open('left'),
  openRight: open('right'),
  pointsLeft: points('left'),
  pointsRight: points('right'),
  descriptorsLeft: descriptors('left'),
  descriptorsRight: descriptors('right'),
  offset,
  match,
  interiorLeft: interior('left'),
  interiorRight: interior('right'),
  orientation,
  score,
  inspection,
};
