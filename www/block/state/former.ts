/**
 * Edits that a block found anew could not take over, and has again when it is found as it was: when an image that was taken out comes back, say. Pure.
 */
import type { BlockPlaces } from '../../../pkg/wasm/tiepoint.js';
import type { History } from '../../shared/state/history';
import type { EditStep } from './edits';
import type { Names } from './naming';
import type { BlockView } from './view';

/** A block that was found, and its edits before another one took its place. */
export interface Former {
  /** Names it. */
  tiePoints: string;
  /** Of what its edits are about. */
  names: Names;
  history: History<EditStep>;
  /** What was left of them, and of the first so many steps. */
  kept: History<EditStep>;
  left: readonly number[];
  /** After how many of its steps each step beside them came. */
  places: readonly number[];
  /** Where its images show its places of an orthophoto; null where it lay on none. */
  spots: BlockPlaces | null;
}

/** Edits of a block that was found anew and is to lie on an orthophoto: which of its places lie where they lay is known once it lies there. */
export interface Awaiting extends Former {
  /** Whether its tie points are those of the block that has them. */
  sameTiePoints: boolean;
  /** So many edits in force wait for its places. */
  ofPlaces: number;
}

/** Null once something was edited since. */
export function awaitedOf({ awaiting, history }: { awaiting: Awaiting | null; history: History<EditStep> }): Awaiting | null {
  return awaiting?.kept.edits === history.edits && awaiting.kept.done === history.done ? awaiting : null;
}

/** So many are remembered. */
const MOST = 20;

/** Names the tie points of a block by its images and the points that its adjustment has. */
export function nameOfTiePoints({ images, points }: BlockView): string {
  let code = 0x811c9dc5;
  const add = (value: number) => {
    code = Math.imul(code ^ (value & 0xffff), 0x01000193);
    code = Math.imul(code ^ Math.floor(value / 0x10000), 0x01000193) >>> 0;
  };
  points.sources.forEach(add);
  points.rays.forEach(add);
  return JSON.stringify([images.map(({ name, features }) => [name, features]), points.count, code]);
}

/** The same blocks, once what was left of the latest was carried to another one of its tie points. `left`: of its first so many steps. */
export function formerOf(former: readonly Former[], before: History<EditStep>, after: History<EditStep>, left: readonly number[]): readonly Former[] {
  const last = former.at(-1);
  if (last === undefined || last.kept.edits !== before.edits || last.kept.done !== before.done) return former;
  return [...former.slice(0, -1), { ...last, kept: after, left: last.left.map((count) => left[count] ?? after.edits.length) }];
}

/** With one more. */
export function withFormer(former: readonly Former[], one: Former): readonly Former[] {
  return [...former.filter(({ tiePoints }) => tiePoints !== one.tiePoints), one].slice(-MOST);
}

/** The blocks from the present one back to one with these tie points, the latest first, where nothing was edited since: none where there is no such one. */
export function wayBack(former: readonly Former[], tiePoints: string, history: History<EditStep>): readonly Former[] {
  const way: Former[] = [];
  let now = history;
  for (const one of [...former].reverse()) {
    if (one.kept.edits !== now.edits || one.kept.done !== now.done) continue;
    way.push(one);
    if (one.tiePoints === tiePoints) return way;
    now = one.history;
  }
  return [];
}

/** After how many of its steps the steps beside them come: where they were, or after those that were left. */
export function placesBefore({ left, places }: Former, now: readonly { after: number }[]): readonly number[] {
  return now.length === places.length ? places : now.map(({ after }) => Math.max(0, left.lastIndexOf(after)));
}
