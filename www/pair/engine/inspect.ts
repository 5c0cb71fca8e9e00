/** What is looked up about the selected point: what was compared, the candidates, where it may be seen in the other image. */
import { CELLS, DESCRIPTOR_BYTES } from '../state/descriptor';
import { editedPair, isMeasured } from '../state/edited';
import { standingOf } from '../state/edits';
import { knownInterior } from '../state/interior';
import { comparesGradients, comparesGreyValues } from '../state/keys';
import { readable } from '../../shared/text/names';
import { leftIndexOf, placeOf } from '../state/selected';
import type { Position } from '../../shared/state/pane';
import { otherSide } from '../state/state';
import type { FeatureView, Inspection, PlaceView, PointWindow, SeenAt, Side, StageValues, State } from '../state/state';
import { CallError } from '../../shared/engine/client';
import { matchInput, needed, settingsOf } from './inputs';
import type { Run, Workers } from './inputs';

/** Samples a side of a patch that is shown. */
export const PATCH_SIDE = 112;
/** How much wider than the cells is what is shown of the image around them: turned by an eighth they still fit. */
export const SURROUNDINGS = 1.5;
/** Candidates by gradients that are looked up. */
const MOST_CANDIDATES = 50;

/** The window whose content decided: that of the moments, or that of the grey values. */
function comparedWindow(state: State): Partial<ReturnType<typeof settingsOf>['window']> {
  const settings = settingsOf(state);
  return comparesGreyValues(settings) ? { side: settings.matching.template, shape: 'square' } : settings.window;
}

/** The matches with what was done to them by hand. */
function matchOf(state: State): StageValues['match'] {
  return editedPair(state)?.match ?? needed(state, 'match');
}

function pointsOf(state: State, side: Side): StageValues['pointsLeft'] {
  return needed(state, side === 'left' ? 'pointsLeft' : 'pointsRight');
}

/** A position of an image, as its points give it; null where there is no such point. */
function pointAt(state: State, side: Side, index: number): Position | null {
  if (index < 0) return null;
  const points = side === 'left' ? editedPair(state)?.left : undefined;
  const [x, y] = (points ?? pointsOf(state, side).points).subarray(3 * index, 3 * index + 2);
  return x === undefined || y === undefined ? null : [x, y];
}

async function windowAt(workers: Workers, state: State, side: Side, at: Position | null): Promise<PointWindow | null> {
  if (at === null) return null;
  const col = Math.floor(at[0]);
  const row = Math.floor(at[1]);
  const worker = await workers.withImage(side, state);
  try {
    return { col, row, report: await worker.call('moments', { col, row, window: comparedWindow(state) }), problem: null };
  } catch (error) {
    // A window that leaves the image or is constant is an answer, not a failure.
    if (error instanceof CallError && error.failure.kind === 'refused') return { col, row, report: null, problem: readable(state.catalogue, error.message) };
    throw error;
  }
}

async function featureAt(workers: Workers, state: State, side: Side, index: number): Promise<FeatureView | null> {
  const at = pointAt(state, side, index);
  if (at === null) return null;
  const { frames, gradients } = pointsOf(state, side);
  // What was measured by hand has no descriptor.
  if (DESCRIPTOR_BYTES * index >= gradients.length) return null;
  const [scale = 1, direction = 0] = frames.subarray(2 * index, 2 * index + 2);
  const reach = reachOf(state, scale);
  const worker = await workers.withImage(side, state);
  const patch = (factor: number, turn: number) => worker.call('patch', { x: at[0], y: at[1], direction: turn, reach: factor * reach, side: PATCH_SIDE });
  const [turned, upright] = await Promise.all([patch(1, direction), patch(SURROUNDINGS, 0)]);
  return { descriptor: gradients.slice(DESCRIPTOR_BYTES * index, DESCRIPTOR_BYTES * (index + 1)), scale, direction, reach, turned, upright };
}

/** The side of the cells of a point of this scale, px. */
function reachOf(state: State, scale: number): number {
  return CELLS * settingsOf(state).gradient.cell * scale;
}

/** What an image shows where no interest point is; `like`: as much of it as of that point. */
async function placeAt(workers: Workers, state: State, side: Side, at: Position | null, like: FeatureView | null, byHand: boolean): Promise<PlaceView | null> {
  if (at === null) return null;
  const worker = await workers.withImage(side, state);
  const reach = SURROUNDINGS * (like?.reach ?? reachOf(state, 1));
  return { descriptor: null, byHand, upright: await worker.call('patch', { x: at[0], y: at[1], direction: 0, reach, side: PATCH_SIDE }) };
}

/** The epipolar line of the selected point in the other image, where a geometry of the two views is known. */
async function lineOf(workers: Workers, state: State): Promise<SeenAt | null> {
  const { selection } = state;
  const at = selection === null ? null : pointAt(state, selection.side, selection.index);
  return selection === null || at === null ? null : seenFrom(workers, state, selection.side, at);
}

/** Where a place of one image may be seen in the other one; null where no geometry of the two views is known. */
async function seenFrom(workers: Workers, state: State, from: Side, at: Position): Promise<SeenAt | null> {
  const { geometry } = needed(state, 'match');
  if (geometry === null) return null;
  const side = otherSide(from);
  const { width, height } = needed(state, side === 'left' ? 'openLeft' : 'openRight').info;
  const positions = await workers.client('pair').call('epipolarLine', {
    from,
    x: at[0],
    y: at[1],
    model: geometry.model,
    interior: knownInterior(state),
    width,
    height,
  });
  return { side, positions };
}

async function candidatesOf(workers: Workers, state: State, left: number): Promise<Float64Array> {
  const settings = settingsOf(state);
  if (left < 0 || 3 * left >= pointsOf(state, 'left').points.length || comparesGreyValues(settings)) return new Float64Array();
  const worker = workers.client('pair');
  if (!comparesGradients(settings)) return worker.call('candidates', { ...matchInput(state), index: left, options: settings.matching });
  const [of, among] = [pointsOf(state, 'left').gradients, pointsOf(state, 'right').gradients];
  return worker.call('gradientCandidates', { index: left, left: of, right: among, most: MOST_CANDIDATES });
}

/** Its y-parallax beside those of its nearest matches, where the strategy has that rule. */
async function parallaxOf(workers: Workers, state: State, left: number): Promise<Inspection['parallax']> {
  const { matching } = settingsOf(state);
  const { points } = pointsOf(state, 'left');
  const offset = comparesGradients(settingsOf(state)) ? null : (state.results.offset?.value ?? null);
  if (left < 0 || 3 * left >= points.length || offset === null) return null;
  // As the rule had it: what was rejected by hand stood then.
  const { rules, places } = needed(state, 'match');
  return (await workers.client('pair').call('parallaxDeviation', { index: left, points, match: { rules, places }, offset, options: matching })) ?? null;
}

/** Windows of moments or grey values; for gradients the features. */
async function comparedOf(workers: Workers, state: State, left: number): Promise<Pick<Inspection, 'left' | 'right' | 'features'>> {
  const { best, places } = matchOf(state);
  const { selection } = state;
  const right = selection?.side === 'right' ? selection.index : (best[left] ?? -1);
  if (comparesGradients(settingsOf(state))) {
    const [ofLeft, ofRight] = await Promise.all([featureAt(workers, state, 'left', left), featureAt(workers, state, 'right', right)]);
    const edited = editedPair(state);
    const byHand = edited !== null && isMeasured(edited, standingOf(state.history.edits, state.history.done), left);
    const features = {
      left: ofLeft ?? (await placeAt(workers, state, 'left', pointAt(state, 'left', left), ofRight, byHand)),
      right: ofRight ?? (await placeAt(workers, state, 'right', placeOf(places, left), ofLeft, byHand)),
    };
    return { left: null, right: null, features };
  }
  const rightAt = selection?.side === 'right' ? pointAt(state, 'right', selection.index) : placeOf(places, left);
  const [ofLeft, ofRight] = await Promise.all([windowAt(workers, state, 'left', pointAt(state, 'left', left)), windowAt(workers, state, 'right', rightAt)]);
  return { left: ofLeft, right: ofRight, features: null };
}

export const inspection: Run<Inspection> = async (state, workers) => {
  const { best, rules } = matchOf(state);
  const left = leftIndexOf(state, best, rules);
  const [compared, candidates, parallax, line] = await Promise.all([
    comparedOf(workers, state, left),
    candidatesOf(workers, state, left),
    parallaxOf(workers, state, left),
    lineOf(workers, state),
  ]);
  return { ...compared, candidates, parallax, line };
};

/** Where the point that is measured may lie. */
export const line: Run<SeenAt | null> = async (state, workers) => {
  const { draft } = state;
  const from = draft === null ? null : otherSide(draft.side);
  const at = from === null ? null : draft?.places[from];
  return from === null || at == null ? null : seenFrom(workers, state, from, [at[0], at[1]]);
};
