/** What the view shows, gathered from the state once a drawing. */
import type { MatchResult } from '../../shared/crate';
import { withListed } from '../state/display';
import type { Shown } from '../state/display';
import { interiorInUse } from '../state/interior';
import { leftOut, listedPlaces, makeListed } from '../state/listed';
import { residualVectors } from '../state/residuals';
import { leftCodes, loosePlaces, matchCodes, rightCodes, shownPair } from '../state/select';
import type { Places } from '../state/select';
import { SIDES } from '../state/state';
import type { Side, State } from '../state/state';
import { wantedKeys } from '../state/keys';
import { fitView, inPane, transformOf } from '../../shared/view/panes';
import { panesOf } from './geometry';
import { contains, toPosition } from '../../shared/view/transform';
import type { Rect, Transform } from '../../shared/view/transform';
import type { Picture } from './picture';

export interface Pane {
  side: Side;
  rect: Rect;
  transform: Transform;
  picture: Picture | null;
  points: Float64Array | null;
  /** Scale and direction of each point, stride 2; empty for points of one scale. */
  frames: Float64Array | null;
  /** One a point; see `palette.ts`. */
  codes: Uint8Array;
  vectors: Float64Array | null;
}

/** What the marks over the pictures are made of. Each part is the same object for as long as it holds the same. */
interface Marks {
  points: Record<Side, Float64Array | null>;
  codes: Record<Side, Uint8Array>;
  match: MatchResult | null;
  matchCodes: Uint8Array;
  /** Matched places of the right image that are no interest points. */
  places: Places;
  /** Residuals, where they are shown. */
  vectors: Record<Side, Float64Array | null>;
  /** Which of them are shown. */
  shown: Shown;
}

export interface Scene extends Pick<Marks, 'match' | 'matchCodes' | 'places' | 'shown'> {
  panes: Record<Side, Pane>;
}

function pictureOf(state: State, side: Side): Picture | null {
  const stage = side === 'left' ? 'openLeft' : 'openRight';
  const image = state.images[side];
  const opened = state.results[stage];
  if (image === null || opened === undefined || opened.key !== wantedKeys(state)[stage]) return null;
  const { info, overview } = opened.value;
  return { imageId: image.id, width: info.width, height: info.height, overview };
}

const listed = { left: makeListed(), right: makeListed(), matches: makeListed() };

export function marksOf(state: State): Marks {
  const { left, right, match, orientation } = shownPair(state);
  const interior = state.display.vectors === 0 ? null : interiorInUse(state);
  const vectors = (side: Side) =>
    match === null || orientation === null || interior === null ? null : residualVectors[side](match, orientation, interior[side]);
  const ofMatches = matchCodes(match, orientation);
  const out = leftOut(state);
  return {
    points: { left, right },
    codes: {
      left: listed.left(leftCodes(left, match, orientation), out?.left ?? null),
      right: listed.right(rightCodes(right, match, orientation), out?.right ?? null),
    },
    match,
    matchCodes: listed.matches(ofMatches, out?.matches ?? null),
    places: listedPlaces(loosePlaces(match, ofMatches), out),
    vectors: { left: vectors('left'), right: vectors('right') },
    shown: out === null ? state.display : withListed(state.display),
  };
}

/** The scene on a canvas of `width` x `height` CSS px. A pane without a view shows its whole image. */
export function sceneOf(state: State, width: number, height: number): Scene {
  const rects = panesOf(state, width, height);
  const marks = marksOf(state);
  const pane = (side: Side): Pane => {
    const picture = pictureOf(state, side);
    const own = state.views[side];
    const whole = picture === null ? { x: 0, y: 0, scale: 1 } : fitView(rects[side], picture.width, picture.height);
    const view = own === null ? whole : inPane(own, rects[side]);
    return {
      side,
      rect: rects[side],
      transform: transformOf(rects[side], view),
      picture,
      points: picture === null ? null : marks.points[side],
      frames: state.results[side === 'left' ? 'pointsLeft' : 'pointsRight']?.value.frames ?? null,
      codes: marks.codes[side],
      vectors: marks.vectors[side],
    };
  };
  const { match, matchCodes: ofMatches, places, shown } = marks;
  return { panes: { left: pane('left'), right: pane('right') }, match, matchCodes: ofMatches, places, shown };
}

/** The pane at a canvas position. */
export function paneAt(scene: Scene, x: number, y: number): Pane | null {
  const side = SIDES.find((s) => contains(scene.panes[s].rect, x, y));
  return side === undefined ? null : scene.panes[side];
}

/** The position in the middle of a pane, where keys place what is measured. */
export const middleOf = ({ rect, transform }: Pick<Pane, 'rect' | 'transform'>): [x: number, y: number] =>
  toPosition(transform, rect.left + rect.width / 2, rect.top + rect.height / 2);
