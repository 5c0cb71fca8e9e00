/** A point that is measured by hand, before it is accepted. */
import { roundedPx } from '../../shared/state/pane';
import type { Position } from '../../shared/state/pane';
import type { Draft, Placed } from './edited';
import type { BlockEdit, HandMeasurement, PointSource } from '../../../pkg/wasm/tiepoint.js';

/** A draft without places yet: of a point that is there, or of a new one. */
export function begun(of: PointSource | null): Draft {
  return { of, places: new Map() };
}

/** The draft with its place in an image, within it. */
export function placed(draft: Draft, image: number, [x, y]: Position, { width, height }: { width: number; height: number }, by: Placed['by'] = 'hand'): Draft {
  const at: Position = [roundedPx(Math.min(width, Math.max(0, x))), roundedPx(Math.min(height, Math.max(0, y)))];
  return { ...draft, places: new Map([...draft.places, [image, { at, by }]]) };
}

/** What the draft becomes; null while too little of it is placed. */
export function editsOfDraft({ of, places }: Draft): BlockEdit[] | null {
  const observations = [...places].map(([image, { at, by }]): HandMeasurement => ({ image, x_px: at[0], y_px: at[1], by }));
  if (of !== null) return observations.length === 0 ? null : observations.map((one) => ({ kind: 'measure', point: of, ...one }));
  return observations.length < 2 ? null : [{ kind: 'add_point', observations }];
}
