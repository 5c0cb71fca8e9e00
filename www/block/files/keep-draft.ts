/** The point that is measured by hand, and the link of an image to an orthophoto, before they are accepted, as the browser keeps them. */
import type { Kept } from '../../shared/files/database';
import { likeOf, listOf, objectOf, orNull, positionFrom } from '../../shared/files/keepable';
import { remember } from '../../shared/state/remember';
import type { KeptDraft } from '../state/draft';
import type { Draft } from '../state/edited';
import type { Placing } from '../state/placing';
import type { LinkDraft } from '../state/steps';
import { placeFrom, sourceFrom } from './edit';

const DRAFT = 'block/draft';
const LINK = 'block/link';
/** About what a place takes, in bytes. */
const OF_PLACE = 60;

/** What is kept of it; nothing where none is measured. `images`: those that are shown. */
export function draftParts(draft: Draft | null, images: readonly number[]): Map<string, Kept> {
  return new Map(draft === null ? [] : [[DRAFT, keptDraft(draft, images)]]);
}

const keptDraft = remember(
  ({ of, places }: Draft, images: readonly number[]): Kept => ({
    value: { of, places: [...places], images },
    bytes: OF_PLACE * (1 + places.size),
  }),
);

/** What is kept of a link that is measured in the chosen image; nothing where none is. */
export function linkParts({ draft, chosen }: Placing): Map<string, Kept> {
  return new Map(draft === null || chosen.image === null ? [] : [[LINK, keptLink(draft, chosen.image)]]);
}

const keptLink = remember(({ at, place }: LinkDraft, image: number): Kept => ({ value: { image, at, place }, bytes: 2 * OF_PLACE }));

/** What is placed with the link that is measured on in its image; one of an image that is not there is given up. @throws Error naming what is damaged */
export function withLink(placing: Placing, parts: ReadonlyMap<string, unknown>): Placing {
  if (!parts.has(LINK)) return placing;
  const kept = objectOf(parts.get(LINK), 'link');
  const image = likeOf(kept.image, 0, 'link.image');
  const [at, place] = [orNull(kept.at, (own) => positionFrom(own, 'link.at')), orNull(kept.place, (own) => positionFrom(own, 'link.place'))];
  return placing.placed.has(image) ? { ...placing, draft: { at, place }, chosen: { image, link: null } } : placing;
}

/** `images`: so many the block has. Earlier releases kept none. @throws Error naming what is damaged */
export function draftFrom(parts: ReadonlyMap<string, unknown>, images: number): KeptDraft | null {
  if (!parts.has(DRAFT)) return null;
  const { of, places, images: shown } = objectOf(parts.get(DRAFT), 'draft');
  const placed = listOf(places, 'draft.places', (entry, name) => {
    const [image, place] = listOf(entry, name, (one) => one);
    const { at, by } = objectOf(place, name);
    const [x_px, y_px] = listOf(at, `${name}.at`, (one) => one);
    return placeFrom({ image, x_px, y_px, by }, name);
  });
  const isThere = (image: number) => image < images;
  return {
    of: orNull(of, ofFrom),
    places: new Map(placed.flatMap(({ image, x_px, y_px, by }) => (isThere(image) ? [[image, { at: [x_px, y_px], by }]] : []))),
    images: listOf(shown, 'draft.images', (image, name) => likeOf(image, 0, name)).filter(isThere),
  };
}

function ofFrom(of: object): NonNullable<Draft['of']> {
  return 'given' in of ? { given: likeOf<string>(of.given, '', 'draft.of.given') } : sourceFrom(of, 'draft.of');
}
