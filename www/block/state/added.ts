/** Control points that edits by hand add to a block, places of an orthophoto among them, and where images measure them. Pure. */
import type { BlockEdit, PointSource } from '../../../pkg/wasm/tiepoint.js';
import type { History } from '../../shared/state/history';
import type { Position } from '../../shared/state/pane';
import { remember } from '../../shared/state/remember';
import { standingOf } from './edits';
import type { EditStep } from './edits';

export type AddedControl = Extract<BlockEdit, { kind: 'add_control' }>;

/** A control point that edits add. */
export interface AddedPoint {
  edit: AddedControl;
  /** Its number among the surveyed points. */
  control: number;
  /** Where images show it, by their indices: what was rejected takes no part. */
  places: ReadonlyMap<number, Position>;
}

const NONE: ReadonlyMap<string, AddedPoint> = new Map();

/** The control points that edits add, by their names. `given`: how many surveyed points the block was found with. */
export const addedPoints = remember((edits: readonly BlockEdit[], given: number): ReadonlyMap<string, AddedPoint> => {
  if (!edits.some(({ kind }) => kind === 'add_control')) return NONE;
  const points: (AddedPoint & { places: Map<number, Position> })[] = [];
  const find = (point: PointSource) => ('ground_control' in point ? points[point.ground_control - given] : undefined);
  for (const edit of edits) {
    if (edit.kind === 'add_control') points.push({ edit, control: given + points.length, places: new Map() });
    else if (edit.kind === 'measure') find(edit.point)?.places.set(edit.image, [edit.x_px, edit.y_px]);
  }
  const { observations, images } = standingOf(edits);
  for (const { point, image } of observations.values()) find(point)?.places.delete(image);
  for (const image of images) for (const { places } of points) places.delete(image);
  return new Map(points.map((point) => [point.edit.name, point]));
});

const BY_HAND = /^orthophoto_hand_(\d+)$/u;

/** Whether a point is a place of an orthophoto that was measured by hand, as the crate names these. */
export const isPlaceByHand = (name: string): boolean => BY_HAND.test(name);

/** The number of the next place: of those that were undone none is used again. */
export function nextPlace({ edits }: History<EditStep>): number {
  const numbers = edits.flat().map((edit) => (edit.kind === 'add_control' ? Number(BY_HAND.exec(edit.name)?.[1] ?? 0) : 0));
  return 1 + Math.max(0, ...numbers);
}
