/** A point that is measured by hand, before it is accepted. */
import { roundedPx } from '../../shared/state/pane';
import { say } from '../../shared/text/words';
import { indexOfSource } from './edits';
import type { Choice } from './selection';
import type { BlockView } from './view';
import { nameOfPoint } from './words';
import type { History } from '../../shared/state/history';
import type { Position } from '../../shared/state/pane';
import type { Draft, GivenPoint, Placed } from './edited';
import type { MarkStep } from './marks';
import type { AddedPoint } from './added';
import type { BlockEdit, HandMeasurement } from '../../../pkg/wasm/tiepoint.js';

/** With the images that were shown when it was left. */
export interface KeptDraft extends Draft {
  images: readonly number[];
}

/** The measured point as it is chosen; null for a new one, and while the block has none such. */
export function choiceOfDraft({ of }: Draft, view: BlockView): Choice | null {
  if (of === null) return null;
  if (isGiven(of)) return { kind: 'given', name: of.given };
  const point = indexOfSource(view, of);
  return point < 0 ? null : { kind: 'point', point };
}

/** A new point that is measured, in another view of the images; null where it is placed in none of them, and of other points, which that view may not have. */
export function draftInOtherView(draft: Draft | null, before: BlockView | undefined, after: BlockView): Draft | null {
  if (draft === null || draft.of !== null || before === undefined) return null;
  const indices = new Map(after.images.map(({ name }, image) => [name, image]));
  const places = [...draft.places].flatMap(([image, place]): [number, Placed][] => {
    const index = indices.get(before.images[image]?.name ?? '');
    return index === undefined ? [] : [[index, place]];
  });
  return places.length === 0 ? null : { of: null, places: new Map(places) };
}

/** A draft without places yet: of a point that is there, or of a new one. */
export function begun(of: Draft['of']): Draft {
  return { of, places: new Map() };
}

/** The draft with its place in an image, within it. */
export function placed(draft: Draft, image: number, [x, y]: Position, { width, height }: { width: number; height: number }, by: Placed['by'] = 'hand'): Draft {
  const at: Position = [roundedPx(Math.min(width, Math.max(0, x))), roundedPx(Math.min(height, Math.max(0, y)))];
  return { ...draft, places: new Map([...draft.places, [image, { at, by }]]) };
}

/** What the measured point is called. */
export function nameOfDraft({ of }: Draft, view: BlockView): string {
  if (of === null) return say('new-point');
  return isGiven(of) ? of.given : nameOfPoint(view, indexOfSource(view, of));
}

/** The draft without its latest place; null where it has none. */
export function withoutLast({ of, places }: Draft): Draft | null {
  return places.size === 0 ? null : { of, places: new Map([...places].slice(0, -1)) };
}

/** The places as they are taken back, which is before any step of the block; none can be made again. */
export function placesAsSteps({ places }: Draft): History<number> {
  return { edits: [...places.keys()], done: places.size };
}

export function isGiven(of: Draft['of']): of is GivenPoint {
  return of !== null && 'given' in of;
}

/**
 * What the draft becomes, which is done at once; null while too little of it is placed. `names`: of the images; `after`: so many edits hold; `added`: the points
 * that edits add, which edits measure.
 */
export function stepOfDraft(
  draft: Draft,
  names: readonly string[],
  after: number,
  added: ReadonlyMap<string, Pick<AddedPoint, 'control'>>,
): { type: 'edit'; edits: BlockEdit[] } | { type: 'mark'; step: MarkStep } | null {
  const { of, places } = draft;
  if (!isGiven(of)) {
    const edits = editsOfDraft(draft);
    return edits === null ? null : { type: 'edit', edits };
  }
  const own = added.get(of.given);
  if (own !== undefined) {
    const edits = editsOfDraft({ of: { ground_control: own.control }, places });
    return edits === null ? null : { type: 'edit', edits };
  }
  const marks = [...places].flatMap(([image, { at }]) => {
    const name = names[image];
    return name === undefined ? [] : [{ image: name, point: of.given, x_px: at[0], y_px: at[1] }];
  });
  return marks.length === 0 ? null : { type: 'mark', step: { kind: 'measure', marks, after } };
}

/** The edits that the draft of a point of the block becomes; null while too little of it is placed. */
export function editsOfDraft({ of, places }: Draft): BlockEdit[] | null {
  if (isGiven(of)) return null;
  const observations = [...places].map(([image, { at, by }]): HandMeasurement => ({ image, x_px: at[0], y_px: at[1], by }));
  if (of !== null) return observations.length === 0 ? null : observations.map((one) => ({ kind: 'measure', point: of, ...one }));
  return observations.length < 2 ? null : [{ kind: 'add_point', observations }];
}
