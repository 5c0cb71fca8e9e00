/** How each stage is computed: which calls, on which worker, from which results. */
import { wholeMarks } from '../state/marks';
import type { Side, StageName, StageValues, State } from '../state/state';
import { editedPair } from '../state/edited';
import type { Edited } from '../state/edited';
import { interiorInUse, knownInterior } from '../state/interior';
import { pairCameras } from '../state/cameras';
import { comparesGradients, comparesMoments, isCurrent } from '../state/keys';
import { truthOf } from '../state/truth';
import { matchInput, needed, settingsOf } from './inputs';
import type { Run } from './inputs';
import { inspection, line } from './inspect';
import { message } from '../../shared/text/messages';

/** Longest side of the copies from which the offset is estimated, in px. */
const OFFSET_SIDE = 1024;

function open(side: Side): Run<StageValues['openLeft']> {
  return async (state, workers) => {
    const image = state.images[side];
    if (image === null) throw new Error(`there is no ${side} image`);
    return workers.open(side, image);
  };
}

const NONE = { moments: new Float64Array(), gradients: new Uint8Array() };

/** Gradients are described where the points are found: both come from the same pyramid. */
function points(side: Side): Run<StageValues['pointsLeft']> {
  return async (state, workers) => {
    const settings = settingsOf(state);
    const input = { settings, mask: state.masks[side]?.grey ?? null };
    const worker = await workers.withImage(side, state);
    if (comparesGradients(settings)) return worker.call('features', input);
    return { ...(await worker.call('detect', input)), gradients: NONE.gradients };
  };
}

function descriptors(side: Side): Run<StageValues['descriptorsLeft']> {
  return async (state, workers) => {
    const found = needed(state, side === 'left' ? 'pointsLeft' : 'pointsRight');
    const settings = settingsOf(state);
    if (!comparesMoments(settings)) return { ...NONE, gradients: found.gradients };
    const { window, matching } = settings;
    const worker = await workers.withImage(side, state);
    return { ...NONE, moments: await worker.call('describe', { points: found.points, window, strategy: matching.strategy }) };
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

const match: Run<StageValues['match']> = async (state, workers) => {
  const settings = settingsOf(state);
  // Without epipolar lines or a geometry the result does not depend on the camera, and must not wait for it.
  const asks = settings.matching.epipolar || comparesGradients(settings);
  const ofPair = asks && isCurrent(state, 'interiorLeft') && isCurrent(state, 'interiorRight') ? knownInterior(state) : null;
  const input = matchInput(state);
  const { gradients: ofLeft = NONE.gradients } = input.left;
  const { gradients: ofRight = NONE.gradients } = input.right;
  const [worker, nearest] = await Promise.all([workers.withPair(state), comparesGradients(settings) ? workers.nearest(ofLeft, ofRight) : null]);
  return worker.call('match', { ...input, interior: ofPair, settings, nearest });
};

function interior(side: Side): Run<StageValues['interiorLeft']> {
  return async (state, workers) => {
    const { info } = needed(state, side === 'left' ? 'openLeft' : 'openRight');
    const cameras = pairCameras(state);
    if ('missing' in cameras) throw new Error(message('no_orientation', cameras.missing));
    const { origin } = state.photos[side];
    return workers.client('pair').call('interior', {
      width: info.width,
      height: info.height,
      camera: cameras[side],
      pairFocalMm: cameras.left.focal_mm,
      fiducials: wholeMarks(state.photos[side]),
      model: state.fiducialModel,
      origin,
    });
  };
}

/** The matches with what was done to them by hand. */
function edited(state: State): Edited {
  const pair = editedPair(state);
  if (pair === null) throw new Error('the matches are of other points');
  return pair;
}

const orientation: Run<StageValues['orientation']> = async (state, workers) => {
  const { left, match: used } = edited(state);
  const { matches, fits } = used;
  const ofPair = interiorInUse(state);
  if (ofPair === null) throw new Error('no interior orientation is known');
  const points: [number, number] = [left.length / 3, needed(state, 'pointsRight').points.length / 3];
  return workers.client('pair').call('orient', { matches, fits, interior: ofPair, options: settingsOf(state).orientation, points });
};

const score: Run<StageValues['score']> = async (state, workers) => {
  const truth = truthOf(state);
  if (truth === null) throw new Error('these images have no truth');
  const { info } = needed(state, 'openRight');
  return workers.client('pair').call('score', {
    matches: edited(state).match.matches,
    leftPoints: edited(state).left,
    rightPosition: truth.rightPosition,
    left: { width: truth.leftWidth, height: truth.leftHeight },
    right: { width: info.width, height: info.height },
  });
};

const difference: Run<StageValues['difference']> = async (state, workers) => (await workers.withPair(state)).call('difference', null);

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
  difference,
  inspection,
  line,
};
