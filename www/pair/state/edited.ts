/** The pair with the edits by hand: a pure function of what the matching found and of what stands after the edits. */
import type { MatchResult } from '../../shared/crate';
import { remember } from '../../shared/state/remember';
import { BY_HAND, MATCHED, UNDECIDED } from './codes';
import type { MatchesInUse } from './data';
import { isNothing, keyOfTarget, standingOf } from './edits';
import type { Place, Standing, Target } from './edits';
import type { State } from './state';
import { say } from '../../shared/text/words';

/** Stands for the right point of a match whose place is none. */
export const NO_POINT = 0xffffffff;

/** The measure of a match whose place was measured by hand: nothing was compared. Others are 0 or more. */
export const MANUAL_MEASURE = -1;

/** A new run finds the place of an edit again where a left point lies this near, px. */
const SAME_PLACE_PX = 0.5;

/** Matches with the left points that they refer to. */
export interface Edited extends MatchesInUse {
  /** Left points, stride 3: those that were found, then those that were measured by hand. */
  left: Float64Array;
  /** The targets of the left points beyond the found ones. */
  appended: readonly Target[];
  /** Rejections whose match is not there any more. */
  lost: number;
}

/** Whether the place of a match was measured by hand. */
export function isManual({ matches }: Pick<MatchResult, 'matches'>, row: number): boolean {
  return matches[5 * row + 4] === MANUAL_MEASURE;
}

/** Whether the match of a left point was measured by hand, or was until it was rejected. */
export function isMeasured(edited: Edited, { placed }: Standing, left: number): boolean {
  const row = rowOfEdited(edited.match)[left] ?? -1;
  if (row >= 0) return isManual(edited.match, row);
  const target = targetOfLeft(edited, left);
  return target !== null && placed.has(keyOfTarget(target));
}

/** Rows of matches by the whole px that holds their left position. */
const rowsByPixel = remember((matches: Float64Array): ReadonlyMap<number, readonly number[]> => {
  const cells = new Map<number, number[]>();
  for (let row = 0; 5 * row < matches.length; row++) {
    const cell = pixelOf(matches[5 * row] ?? NaN, matches[5 * row + 1] ?? NaN);
    const rows = cells.get(cell);
    if (rows === undefined) cells.set(cell, [row]);
    else rows.push(row);
  }
  return cells;
});

/** More columns than any image has. */
const COLUMNS = 2 ** 24;

function pixelOf(x: number, y: number): number {
  return Math.floor(y) * COLUMNS + Math.floor(x);
}

const HERE = [[0, 0]] as const;
const AROUND = [-1, 0, 1].flatMap((dy) => [-1, 0, 1].map((dx) => [dx, dy] as const));

/** Squares of the distances of a match from a place, in the left and in the right image. */
function distances(matches: Float64Array, row: number, [xl, yl, xr, yr]: Place): [number, number] {
  const [ul = NaN, vl = NaN, ur = NaN, vr = NaN] = matches.subarray(5 * row, 5 * row + 4);
  return [(ul - xl) ** 2 + (vl - yl) ** 2, (ur - xr) ** 2 + (vr - yr) ** 2];
}

/** The row of each target that has one: the very match where it is there, else the nearest one at the same place of the left image. */
function rowsOf(matches: Float64Array, targets: ReadonlyMap<string, Place>): Map<string, number> {
  const cells = rowsByPixel(matches);
  const taken = new Set<number>();
  const rows = new Map<string, number>();
  const claim = (key: string, place: Place, around: readonly (readonly [number, number])[], accepts: (left: number, right: number) => boolean) => {
    let best: [row: number, left: number, right: number] | null = null;
    for (const [dx, dy] of around) {
      for (const row of cells.get(pixelOf(place[0] + dx, place[1] + dy)) ?? []) {
        const [left, right] = distances(matches, row, place);
        if (taken.has(row) || !accepts(left, right)) continue;
        if (best === null || left < best[1] || (left === best[1] && right < best[2])) best = [row, left, right];
      }
    }
    if (best === null) return;
    taken.add(best[0]);
    rows.set(key, best[0]);
  };
  for (const [key, place] of targets) claim(key, place, HERE, (left, right) => left === 0 && right === 0);
  for (const [key, place] of targets) if (!rows.has(key)) claim(key, place, AROUND, (left) => left <= SAME_PLACE_PX ** 2);
  return rows;
}

/** Rows of matches that are gathered. */
class Rows {
  private readonly matches: Float64Array;
  private readonly fits: Float64Array;
  private readonly indices: Uint32Array;
  private count = 0;

  constructor(
    private readonly found: MatchResult,
    most: number,
  ) {
    this.matches = new Float64Array(5 * most);
    this.fits = new Float64Array(5 * most);
    this.indices = new Uint32Array(2 * most);
  }

  keep(row: number): void {
    for (let k = 0; k < 5; k++) {
      this.matches[5 * this.count + k] = this.found.matches[5 * row + k] ?? NaN;
      this.fits[5 * this.count + k] = this.found.fits[5 * row + k] ?? NaN;
    }
    this.indices[2 * this.count] = this.found.indices[2 * row] ?? 0;
    this.indices[2 * this.count + 1] = this.found.indices[2 * row + 1] ?? NO_POINT;
    this.count += 1;
  }

  place(left: number, at: Place): void {
    this.matches.set([...at, MANUAL_MEASURE], 5 * this.count);
    this.fits.fill(NaN, 5 * this.count, 5 * this.count + 5);
    this.indices.set([left, NO_POINT], 2 * this.count);
    this.count += 1;
  }

  get all(): Pick<MatchResult, 'matches' | 'fits' | 'indices'> {
    const { matches, fits, indices, count } = this;
    return { matches: matches.slice(0, 5 * count), fits: fits.slice(0, 5 * count), indices: indices.slice(0, 2 * count) };
  }
}

/** An array with room for more at its end. */
function longer<A extends Uint8Array | Int32Array | Float64Array>(values: A, more: number): A {
  const copy = new (values.constructor as new (length: number) => A)(values.length + more);
  copy.set(values);
  return copy;
}

/** What each edit did to the matches that were found. The same objects where nothing stands. */
export function applied(left: Float64Array, found: MatchResult, standing: Standing): Edited {
  return isNothing(standing) ? { left, match: found, found, appended: [], lost: 0 } : new Applying(left, found, standing).edited();
}

/** The places by which the matches of edits are found. */
function placesOf({ rejected, placed }: Standing): ReadonlyMap<string, Place> {
  const places = new Map<string, Place>();
  for (const [key, { target }] of placed) if (typeof target !== 'number') places.set(key, target);
  for (const [key, target] of rejected) if (typeof target !== 'number') places.set(key, target);
  // A match measured by hand stands in place of one that was found of the same point.
  for (const [key, { target, at }] of placed) if (typeof target === 'number' && !rejected.has(key)) places.set(key, at);
  return places;
}

/** Goes through the matches that were found, then through those that have a place of their own. */
class Applying {
  private readonly count: number;
  private readonly rows: Rows;
  private readonly points: Float64Array;
  private readonly rules: Uint8Array;
  private readonly best: Int32Array;
  private readonly places: Float64Array;
  private readonly measures: Float64Array;
  private readonly appended: Target[] = [];

  constructor(
    private readonly left: Float64Array,
    private readonly found: MatchResult,
    private readonly standing: Standing,
  ) {
    this.count = left.length / 3;
    // As many places of their own in the left image as there can be.
    const most = standing.placed.size;
    this.rows = new Rows(found, found.matches.length / 5 + most);
    this.points = longer(left, 3 * most);
    this.rules = longer(found.rules, most);
    this.best = longer(found.best, most);
    this.places = longer(found.places, 2 * most);
    this.measures = longer(found.measures, 2 * most);
  }

  edited(): Edited {
    const { found, left, standing, appended } = this;
    const rowOf = rowsOf(found.matches, placesOf(standing));
    const keyOfRow = new Map([...rowOf].map(([key, row]) => [row, key]));
    const handled = new Set<string>();
    for (let row = 0; 5 * row < found.matches.length; row++) {
      const key = keyOfRow.get(row);
      if (key === undefined) this.rows.keep(row);
      else if (this.change(row, key)) handled.add(key);
    }
    for (const [key, { target, at }] of standing.placed) if (!handled.has(key)) this.append(key, target, at);
    const lost = [...standing.rejected.keys()].filter((key) => !rowOf.has(key) && !standing.placed.has(key)).length;
    const all = this.count + appended.length;
    return { left: appended.length === 0 ? left : this.points.slice(0, 3 * all), match: this.match(all), found, appended, lost };
  }

  /** Does to a match that was found what stands of it; false where its place is another one in the left image, which is appended. */
  private change(row: number, key: string): boolean {
    const { found, standing } = this;
    const own = found.indices[2 * row] ?? 0;
    const { target, at } = standing.placed.get(key) ?? {};
    const stays = at === undefined || (typeof target !== 'number' && at[0] === found.matches[5 * row] && at[1] === found.matches[5 * row + 1]);
    if (!stays) {
      this.rules[own] = UNDECIDED;
      this.decide(own, NaN, NaN);
      return false;
    }
    if (at !== undefined) this.decide(own, at[2], at[3]);
    if (standing.rejected.has(key)) this.rules[own] = BY_HAND;
    else if (at === undefined) this.rows.keep(row);
    else this.rows.place(own, at);
    return true;
  }

  /** A left point of its own, with the verdict on it. */
  private append(key: string, target: Target, at: Place): void {
    const index = this.count + this.appended.length;
    const rejected = this.standing.rejected.has(key);
    this.appended.push(target);
    this.points.set([at[0], at[1], 0], 3 * index);
    this.rules[index] = rejected ? BY_HAND : MATCHED;
    this.decide(index, at[2], at[3]);
    if (!rejected) this.rows.place(index, at);
  }

  /** Of a left point of which nothing was compared, where it lies in the right image. */
  private decide(index: number, x: number, y: number): void {
    this.best[index] = -1;
    this.places.set([x, y], 2 * index);
    this.measures.fill(Infinity, 2 * index, 2 * index + 2);
  }

  /** `all`: so many left points. */
  private match(all: number): MatchResult {
    const used = this.rows.all;
    return {
      ...this.found,
      ...used,
      counts: { ...this.found.counts, matches: used.matches.length / 5 },
      rules: this.rules.slice(0, all),
      best: this.best.slice(0, all),
      places: this.places.slice(0, 2 * all),
      measures: this.measures.slice(0, 2 * all),
    };
  }
}

/** How many matches were rejected and measured by hand. */
export function countsByHand(match: Pick<MatchResult, 'matches' | 'rules'>): { rejected: number; manual: number } {
  let manual = 0;
  for (let row = 0; 5 * row < match.matches.length; row++) manual += Number(isManual(match, row));
  return { rejected: match.rules.reduce((sum, rule) => sum + Number(rule === BY_HAND), 0), manual };
}

/** What a run of the matching has of the edits by hand; null where there are none. */
export function keptText({ match, found, lost }: Edited): string | null {
  if (match === found && lost === 0) return null;
  const { rejected, manual } = countsByHand(match);
  const of = (number: number, what: string) => (number === 0 ? [] : [say('matches-by-hand', { number, what })]);
  const kept = [...of(rejected, 'rejected'), ...of(manual, 'measured')];
  const none = lost === 0 ? '' : say('of-more-there-is-no', { lost });
  return `${kept.length === 0 ? say('no-edits-by-hand-apply') : say('kept', { join: kept.join(', ') })}${none}`;
}

const remembered = remember(applied);

/** The pair with its edits; null while there are no matches of the points that are there. */
export function editedPair({ results, history }: Pick<State, 'results' | 'history'>): Edited | null {
  const left = results.pointsLeft?.value.points;
  const match = results.match?.value;
  if (left === undefined || match === undefined || match.rules.length * 3 !== left.length) return null;
  return remembered(left, match, standingOf(history.edits, history.done));
}

/** What an edit of the match at a left point is about; null where there is no match. */
export function targetOfLeft({ found, match, appended }: Edited, left: number): Target | null {
  const rule = match.rules[left];
  if (rule !== MATCHED && rule !== BY_HAND) return null;
  const count = found.rules.length;
  if (left >= count) return appended[left - count] ?? null;
  const row = rowOfLeft(found)[left] ?? -1;
  if (row < 0) return null;
  const [xl = NaN, yl = NaN, xr = NaN, yr = NaN] = found.matches.subarray(5 * row, 5 * row + 4);
  return [xl, yl, xr, yr];
}

/** The row of the match of each left point; -1 where it has none. */
export function rowsOfLefts(match: Pick<MatchResult, 'rules' | 'indices'>): Int32Array {
  const rows = new Int32Array(match.rules.length).fill(-1);
  for (let i = 0; i < match.indices.length; i += 2) rows[match.indices[i] ?? NO_POINT] = i / 2;
  return rows;
}

const rowOfLeft = remember(rowsOfLefts);

/** The left points that have a match, or had one that was rejected by hand, by the keys of its target. */
export const leftsByTarget = remember((edited: Edited): ReadonlyMap<string, number> => {
  const lefts = new Map<string, number>();
  edited.match.rules.forEach((rule, left) => {
    if (rule !== MATCHED && rule !== BY_HAND) return;
    const target = targetOfLeft(edited, left);
    if (target !== null) lefts.set(keyOfTarget(target), left);
  });
  return lefts;
});

/** Where the match of a left point lies, or lay until it was rejected by hand. */
export function placeOfLeft({ left, match }: Edited, index: number): Place {
  const [x = NaN, y = NaN] = left.subarray(3 * index, 3 * index + 2);
  const row = rowOfEdited(match)[index] ?? -1;
  const [xr = NaN, yr = NaN] = row >= 0 ? match.matches.subarray(5 * row + 2, 5 * row + 4) : match.places.subarray(2 * index, 2 * index + 2);
  return [x, y, xr, yr];
}

const rowOfEdited = remember(rowsOfLefts);
