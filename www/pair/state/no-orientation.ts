/** Why the pair on the screen has no orientation. */
import { few_matches } from '../../shared/crate';
import type { NoOrientation } from '../../shared/crate';
import { pairCameras } from './cameras';
import { interiorInUse } from './interior';
import { isCurrent, wantedKeys } from './keys';
import { oneImage } from './one-image';
import { shownPair } from './select';
import type { StageFailure, State } from './state';

/**
 * Why there is none for what is wanted now, in the order in which the crate's `match_pair` asks; null where there is one, or one to come.
 */
export function whyNone(state: State): NoOrientation | null {
  const { results } = state;
  const cameras = pairCameras(state);
  const areOpen = results.openLeft !== undefined && results.openRight !== undefined;
  // Matches of other settings say nothing; and before there are any, cameras may still be told by them.
  const keys = wantedKeys(state);
  const match = isCurrent(state, 'match') ? results.match?.value : undefined;
  const isMissing = areOpen && 'missing' in cameras && (match === undefined ? keys.orientation === null : interiorInUse(state) === null);
  const missing = isMissing ? cameras.missing : null;
  if (missing?.kind === 'panorama') return missing;
  // No camera helps photos that have no geometry.
  if (match?.no_geometry != null) return { kind: 'no_geometry', no_geometry: match.no_geometry };
  const one = match === undefined ? null : oneImage(state);
  if (one !== null) return one;
  const few = match === undefined ? null : few_matches((shownPair(state).match ?? match).counts.matches);
  if (few !== null) return few;
  if (missing !== null) return missing;
  if (match?.geometry?.degenerate === 'pure-rotation') return { kind: 'pure_rotation' };
  const error = failureOf(state)?.error ?? null;
  return error === null ? null : { kind: 'refused', error };
}

/** What failed of the orientation that is wanted now; null where nothing did. */
export function failureOf(state: State): StageFailure | null {
  const keys = wantedKeys(state);
  const stage = (['interiorLeft', 'interiorRight', 'orientation'] as const).find((own) => state.failures[own]?.key === keys[own]);
  return stage === undefined ? null : (state.failures[stage] ?? null);
}
