/** What the runs of stages work with: the workers, and results of earlier stages. */
import { comparesGradients } from '../state/keys';
import type { GivenImage, Side, StageName, StageValues, State } from '../state/state';
import type { MatchInput, Output, PairClient } from './calls';
import type { WorkerName } from '../state/stages';
import type { GivenPoints, NearestPiece } from '../../shared/crate';

export interface Workers {
  client(name: WorkerName): PairClient;
  /** Opens an image in the worker of a side. */
  open(side: Side, image: GivenImage): Promise<Output<'open'>>;
  /** The worker of a side, holding the image that the state has there. */
  withImage(side: Side, state: State): Promise<PairClient>;
  /** The pair's worker, holding the grey values of both images. */
  withPair(state: State): Promise<PairClient>;
  /** The nearest right descriptors of all left ones, in pieces; null where one worker has them as soon. */
  nearest(left: Uint8Array, right: Uint8Array): Promise<NearestPiece[]> | null;
}

export type Run<Value> = (state: State, workers: Workers) => Promise<Value>;

/** A result that the stage graph promised. */
export function needed<S extends StageName>(state: State, stage: S): StageValues[S] {
  const result = state.results[stage];
  if (result === undefined) throw new Error(`the stage ${stage} has no result`);
  return result.value as StageValues[S];
}

export function settingsOf(state: State): NonNullable<State['settings']> {
  if (state.settings === null) throw new Error('the settings are not loaded');
  return state.settings;
}

function given(state: State, side: Side): GivenPoints {
  const { points: at, frames } = needed(state, side === 'left' ? 'pointsLeft' : 'pointsRight');
  return { points: at, frames, ...needed(state, side === 'left' ? 'descriptorsLeft' : 'descriptorsRight') };
}

export function matchInput(state: State): MatchInput {
  const placed = !comparesGradients(settingsOf(state));
  return { left: given(state, 'left'), right: given(state, 'right'), offset: placed ? needed(state, 'offset') : null };
}
