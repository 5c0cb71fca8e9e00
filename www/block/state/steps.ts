/** What a user does to the links of an image by hand: a list of steps that is applied to the links that were found. */
import type { GivenLink, LinkUse } from '../../../pkg/wasm/tiepoint.js';
import { remember } from '../../shared/state/remember';
import { linkOf } from './links';
import type { LinkedImage, Links } from './links';
import { say } from '../../shared/text/words';

type Place = [number, number];

export type LinkStep =
  | { kind: 'reject' | 'restore'; link: number }
  /** A new link: where the image has it, and where the ground. */
  | { kind: 'add'; at: Place; place: Place };

/** Steps of an image; those from `done` on are undone. */
export interface Handled {
  steps: readonly LinkStep[];
  done: number;
}

/** A link that is being measured. */
export interface LinkDraft {
  at: Place | null;
  place: Place | null;
}

/** So many links orient an image that was not placed. */
export const LEAST_LINKS = 4;

/** All links, those that were found and then the added ones, as they are to be used after these steps. */
export function givenLinks(found: LinkedImage | null, steps: readonly LinkStep[]): GivenLink[] {
  const links = found?.placement?.links ?? null;
  const given: GivenLink[] = Array.from({ length: links?.count ?? 0 }, (_, i): GivenLink => {
    const { at, place, role } = linkOf(links as NonNullable<typeof links>, i);
    // What data snooping rejected is judged anew each time, together with the others.
    return { at, place: [place[0], place[1]], use: role === 'check' ? 'check' : 'used', by_hand: false };
  });
  for (const step of steps) {
    if (step.kind === 'add') given.push({ at: step.at, place: step.place, use: 'used', by_hand: true });
    else {
      const link = given[step.link];
      const isCheck = links !== null && step.link < links.count && linkOf(links, step.link).role === 'check';
      if (link !== undefined) link.use = step.kind === 'reject' ? 'rejected' : isCheck ? 'check' : 'used';
    }
  }
  return given;
}

/** The links of an image as they are drawn: those of its orientation; of an image without one those that were added. */
export function shownLinks({ result, steps, done }: Handled & { result: LinkedImage | null }): Links | null {
  return result?.placement?.links ?? addedLinks(steps, done);
}

const addedLinks = remember((steps: readonly LinkStep[], done: number): Links | null => {
  const added = steps.slice(0, done).filter((step) => step.kind === 'add');
  if (added.length === 0) return null;
  return {
    count: added.length,
    at: Float64Array.from(added.flatMap(({ at }) => at)),
    places: Float64Array.from(added.flatMap(({ place: [x, y] }) => [x, y, NaN])),
    residuals: new Float64Array(2 * added.length).fill(NaN),
    sigmas: new Float64Array(added.length).fill(NaN),
    uses: new Uint8Array(added.length),
    byHand: new Uint8Array(added.length).fill(1),
  };
});

/** How a link is used; of one that is left out also who left it out, the user or data snooping. `byHand`: says that it was measured by hand, too. */
export function useWord({ steps, done }: Handled, link: number, use: LinkUse, byHand = false): string {
  const last = steps.slice(0, done).findLast((step) => step.kind !== 'add' && step.link === link);
  const isByUser = last?.kind === 'reject';
  if (byHand) return say('link-measured-by-hand', { use: use !== 'rejected' ? use : isByUser ? 'by_hand' : 'gross_error' });
  if (use !== 'rejected') return say('link-use', { use });
  return isByUser ? say('rejected-by-hand-2') : say('rejected-as-a-gross-error');
}

/** What a step is called. */
export function stepName(step: LinkStep): string {
  return step.kind === 'add' ? say('add-a-link') : say('link-2', { kind: step.kind, link: step.link + 1 });
}
