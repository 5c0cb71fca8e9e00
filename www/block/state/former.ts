/**
 * Edits that a block found anew could not take over, and has again when it is found as it was: when an image that was taken out comes back, say. Pure.
 */
import type { History } from '../../shared/state/history';
import type { EditStep } from './edits';
import type { BlockView } from './view';

/** A block that was found, and its edits before another one took its place. */
export interface Former {
  /** Names it. */
  found: string;
  history: History<EditStep>;
  /** What was left of them, and of the first so many steps. */
  kept: History<EditStep>;
  left: readonly number[];
  /** After how many of its steps each step beside them came. */
  places: readonly number[];
}

/** So many are remembered. */
const MOST = 20;

/** Names a block by its images and its points: another one with the same has the same tie points. */
export function nameOfFound({ images, points }: BlockView): string {
  let code = 0x811c9dc5;
  const add = (value: number) => {
    code = Math.imul(code ^ (value & 0xffff), 0x01000193);
    code = Math.imul(code ^ Math.floor(value / 0x10000), 0x01000193) >>> 0;
  };
  points.sources.forEach(add);
  points.rays.forEach(add);
  return JSON.stringify([images.map(({ name, features }) => [name, features]), points.count, code]);
}

/** With one more. */
export function withFormer(former: readonly Former[], one: Former): readonly Former[] {
  return [...former.filter(({ found }) => found !== one.found), one].slice(-MOST);
}

/** The one that a block was, where nothing was edited since: null of any other. */
export function formerOf(former: readonly Former[], found: string, { edits, done }: History<EditStep>): Former | null {
  return former.find((one) => one.found === found && one.kept.edits === edits && one.kept.done === done) ?? null;
}

/** After how many of its steps the steps beside them come: where they were, or after those that were left. */
export function placesBefore({ left, places }: Former, now: readonly { after: number }[]): readonly number[] {
  return now.length === places.length ? places : now.map(({ after }) => Math.max(0, left.lastIndexOf(after)));
}
