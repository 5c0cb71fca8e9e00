/** How each stage is computed: which calls, on which worker, from which results. */
import type { GivenImage, PointWindow, Side, StageName, StageValues, State } from '../state/state';
import { pairCameras } from '../state/keys';
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
    return (await workers.withImage(side, state)).call('describe', { points: found.points, window, measure: matching.measure });
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
    options: settingsOf(state).matching,
  };
}

const match: Run<StageValues['match']> = (state, workers) => workers.client('pair').call('match', matchInput(state));

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
  const cameras = pairCameras(state);
  if ('missing' in cameras) throw new Error(cameras.missing);
  return workers.client('pair').call('orient', {
    matches: needed(state, 'match').matches,
    left: needed(state, 'interiorLeft').interior,
    right: needed(state, 'interiorRight').interior,
    focalMm: cameras.left.focal_mm,
    options: settingsOf(state).orientation,
  });
};

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

async function windowAt(workers: Workers, state: State, side: Side, index: number): Promise<PointWindow> {
  const { points: at } = needed(state, side === 'left' ? 'pointsLeft' : 'pointsRight');
  const col = Math.floor(at[3 * index] ?? 0);
  const row = Math.floor(at[3 * index + 1] ?? 0);
  const worker = await workers.withImage(side, state);
  try {
    return { col, row, report: await worker.call('moments', { col, row, window: settingsOf(state).window }), problem: null };
  } catch (error) {
    // A window that leaves the image or is constant is an answer, not a failure.
    if (error instanceof CallError && error.failure.kind === 'refused') return { col, row, report: null, problem: error.message };
    throw error;
  }
}

const inspection: Run<StageValues['inspection']> = async (state, workers) => {
  const result = needed(state, 'match');
  const left = leftIndexOf(state, result.best, result.rules);
  const right = state.selection?.side === 'right' ? state.selection.index : (result.best[left] ?? -1);
  const [ofLeft, ofRight, candidates] = await Promise.all([
    left < 0 ? null : windowAt(workers, state, 'left', left),
    right < 0 ? null : windowAt(workers, state, 'right', right),
    left < 0 ? new Float64Array() : workers.client('pair').call('candidates', { ...matchInput(state), index: left }),
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
  inspection,
};
