/** Edits of the blocks that were found before the present one, as the browser keeps them: which of them nothing was edited since is told by what their lists are. */
import type { BlockPlaces } from '../../../pkg/wasm/tiepoint.js';
import type { Kept } from '../../shared/files/database';
import { doneFrom } from '../../shared/files/journal';
import { likeOf, listOf, nameOf, objectOf, orNull } from '../../shared/files/keepable';
import type { History } from '../../shared/state/history';
import { remember } from '../../shared/state/remember';
import { say } from '../../shared/text/words';
import type { EditStep } from '../state/edits';
import type { Former } from '../state/former';
import type { Names } from '../state/naming';
import { bytesOfStep, stepFrom } from './edit';

const FORMER = 'block/former';

/** About what a place takes in one of the images that show it, in bytes. */
const SPOT = 60;

type Edits = History<EditStep>['edits'];

/** With the names of its lists: where two are one list, nothing was edited between. */
interface KeptFormer extends Former {
  historyName: string;
  keptName: string;
}

interface KeptFormers {
  /** The name of the present list; none where it is none of theirs. */
  now: string;
  former: readonly KeptFormer[];
}

/** What is kept of them; nothing where there are none. */
export function formerParts(former: readonly Former[], { edits }: History<EditStep>): Map<string, Kept> {
  if (former.length === 0) return new Map();
  // Once something was edited since they are written no more.
  const isOfThem = former.some(({ history, kept }) => history.edits === edits || kept.edits === edits);
  return new Map([[FORMER, keptFormers(former, isOfThem ? edits : null)]]);
}

/** `now`: the present list where it is one of theirs. */
const keptFormers = remember((former: readonly Former[], now: Edits | null): Kept & { value: KeptFormers } => ({
  value: {
    now: now === null ? '' : nameOf(now),
    former: former.map((one) => ({ ...one, historyName: nameOf(one.history.edits), keptName: nameOf(one.kept.edits) })),
  },
  bytes: former.reduce((sum, one) => sum + bytesOf(one), 0),
}));

function bytesOf({ history, kept, spots }: Former): number {
  const places = spots?.places.reduce((sum, { seen }) => sum + SPOT * seen.length, 0) ?? 0;
  return [...history.edits, ...kept.edits].reduce((sum, step) => sum + bytesOfStep(step), places);
}

/** `history`: the present one as it was read. Earlier releases kept none. @throws Error naming what is damaged */
export function formerFrom(parts: ReadonlyMap<string, unknown>, history: History<EditStep>): readonly Former[] {
  if (!parts.has(FORMER)) return [];
  const value = objectOf(parts.get(FORMER), 'former');
  const now = likeOf(value.now, '', 'former.now');
  const lists = new Map<string, Edits>(now === '' ? [] : [[now, history.edits]]);
  if (now !== '') nameOf(history.edits, now);
  /** One list for one name. */
  const historyFrom = (own: unknown, called: unknown, name: string): History<EditStep> => {
    const { edits, done } = objectOf(own, name);
    const list = likeOf(called, '', `${name}.name`);
    const read = lists.get(list) ?? listOf(edits, `${name}.edits`, stepFrom);
    lists.set(list, read);
    nameOf(read, list);
    return { edits: read, done: doneFrom(done, read.length, `${name}.done`) };
  };
  return listOf(value.former, 'former', (one, name) => {
    const { tiePoints, names, history: own, kept: left, left: counts, places, spots, historyName, keptName } = objectOf(one, name);
    return {
      tiePoints: likeOf(tiePoints, '', `${name}.tiePoints`),
      names: namesFrom(names, `${name}.names`),
      history: historyFrom(own, historyName, `${name}.history`),
      kept: historyFrom(left, keptName, `${name}.kept`),
      left: listOf(counts, `${name}.left`, (count, at) => likeOf(count, 0, at)),
      places: listOf(places, `${name}.places`, (place, at) => likeOf(place, 0, at)),
      // Earlier releases kept none.
      spots: orNull(spots ?? null, (own) => placesFrom(own, `${name}.spots`)),
    };
  });
}

function namesFrom(value: unknown, name: string): Names {
  const { images, surveyed, connected, givenControl, system } = objectOf(value, name);
  if (!(surveyed instanceof Map && connected instanceof Set)) throw new Error(say('the-field-is-damaged', { name }));
  return {
    images: listOf(images, `${name}.images`, (image, at) => likeOf(image, '', at)),
    surveyed: new Map([...surveyed].map(([point, called]) => [likeOf(point, 0, `${name}.surveyed`), likeOf(called, '', `${name}.surveyed`)])),
    connected: new Set([...connected].map((pair) => likeOf(pair, '', `${name}.connected`))),
    givenControl: likeOf(givenControl, 0, `${name}.givenControl`),
    // Earlier releases kept none.
    system: orNull(system ?? null, (own) => likeOf(own, '', `${name}.system`)),
  };
}

/** @throws Error naming the field that is damaged */
export function placesFrom(value: unknown, name: string): BlockPlaces {
  const places = objectOf(value, name);
  const { images, given, places: all } = places;
  listOf(images, `${name}.images`, (image, at) => likeOf(image, '', at));
  likeOf(given, 0, `${name}.given`);
  listOf(all, `${name}.places`, (place, at) => listOf(objectOf(place, at).seen, `${at}.seen`, objectOf));
  return places as unknown as BlockPlaces;
}
