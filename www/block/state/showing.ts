/** What the orthophoto view shows: the block that was placed on the orthophoto, else the images that were placed by themselves. */
import { betweenSystems } from './between';
import { remember } from '../../shared/state/remember';
import { affineOf, SAME } from './under';
import { mapped, inverse } from '../../shared/state/plane-map';
import type { Affine } from '../../shared/state/plane-map';
import { placedFiles } from './placed';
import type { PlacedFile } from './placed';
import type { GivenOrthophoto } from './placing';
import { purposeOf } from './purpose';
import type { BlockState, Shown } from './state';
import type { BlockView } from './view';

type Given = Pick<BlockState, 'placing' | 'options' | 'files' | 'shown'>;

/** The block that lies in the system of the orthophoto, on its ground; null where none does, and where each image is placed by itself. */
export function blockOnOrthophoto(state: Given): Shown | null {
  const { shown, placing } = state;
  const { orthophoto } = placing;
  if (orthophoto === null || orthophoto.ofBlock !== null || shown === null || shown.view.partial) return null;
  if (!isInSystemOf(shown.view) || purposeOf(state) === 'images') return null;
  const toOrthophoto = toSystemOf(orthophoto, shown.view);
  return toOrthophoto !== null && hasPlaceOn(orthophoto, shown.view, toOrthophoto) ? shown : null;
}

/** Whether a block lies in the system of an orthophoto, or is adjusted by it in its own: by places that were found on it, or measured by hand. */
export function isInSystemOf({ orthophoto }: BlockView): boolean {
  return orthophoto?.kind === 'linked' || orthophoto?.kind === 'by_hand';
}

/** From the system of a block that is linked to an orthophoto to the system of that; null where nothing leads there. */
export function toSystemOf(orthophoto: GivenOrthophoto, view: BlockView): Affine | null {
  if (view.orthophoto?.inCrs !== true) return SAME;
  const between = betweenSystems(orthophoto, view);
  return between?.kind === 'affine' && between.isNear ? between.toOrthophoto : null;
}

/** Whether a control or check point of the block lies on an orthophoto: one of elsewhere may be given in its place. */
const hasPlaceOn = remember(({ info: { width, height, georeference } }: GivenOrthophoto, { surveyed }: BlockView, toOrthophoto: Affine): boolean => {
  const toPixels = inverse(affineOf(georeference));
  return surveyed.some(({ position: [x, y] }) => {
    const [column, row] = mapped(toPixels, ...mapped(toOrthophoto, x, y));
    return column >= 0 && row >= 0 && column <= width && row <= height;
  });
});

/** The image placed by itself that is chosen, where it was tried; null where the block is shown in its place. */
export function chosenPlaced(state: Given): PlacedFile | null {
  const { image } = state.placing.chosen;
  return image === null || blockOnOrthophoto(state) !== null ? null : (placedFiles(state).find(({ file }) => file.id === image) ?? null);
}
