/** Which images of a block are shown side by side, where each pane looks, and how they are drawn. */
import { OWN_LIGHT } from '../../shared/state/light';
import type { Light } from '../../shared/state/light';
import type { PaneView } from '../../shared/state/pane';
import type { BlockView } from './view';

/** Images side by side at most. */
export const MOST_PANES = 9;

/** Images that are shown where none was asked for, and where nothing says which ones show a point: few, so that they are large. */
export const FEW_PANES = 4;

export interface Look extends Light {
  points: boolean;
  /** How much longer residuals are drawn than they are; 0: not at all. */
  vectors: number;
  /** All panes are moved together. */
  linked: boolean;
  loupe: boolean;
  /** A chosen point is shown where it is not measured too. */
  unmeasured: boolean;
}

export interface Panes {
  /** Indices of the images, in the order of the panes. */
  images: readonly number[];
  /** By image, of those that were moved. The others show their whole images. */
  views: ReadonlyMap<number, PaneView>;
  /** The image that keys move. */
  active: number | null;
  look: Look;
}

export type PanesAction =
  | { type: 'showImages'; images: readonly number[] }
  | { type: 'moveViews'; views: ReadonlyMap<number, PaneView> }
  | { type: 'wholeImages' }
  | { type: 'activeImage'; image: number }
  | { type: 'look'; look: Partial<Look> };

export const NO_PANES: Panes = {
  images: [],
  views: new Map(),
  active: null,
  look: { points: true, vectors: 0, linked: false, loupe: false, ...OWN_LIGHT, unmeasured: false },
};

export function reducePanes(panes: Panes, action: PanesAction): Panes {
  switch (action.type) {
    case 'showImages':
      return withImages(panes, action.images);
    case 'moveViews':
      return { ...panes, views: new Map([...panes.views, ...action.views].filter(([image]) => panes.images.includes(image))) };
    case 'wholeImages':
      return { ...panes, views: new Map() };
    case 'activeImage':
      return panes.active === action.image ? panes : { ...panes, active: action.image };
    case 'look':
      return { ...panes, look: { ...panes.look, ...action.look } };
  }
}

/** Others are shown; those that stay look where they looked. */
function withImages(panes: Panes, wanted: readonly number[]): Panes {
  const images = [...new Set(wanted)].slice(0, MOST_PANES);
  const views = new Map([...panes.views].filter(([image]) => images.includes(image)));
  const active = panes.active !== null && images.includes(panes.active) ? panes.active : (images[0] ?? null);
  return { ...panes, images, views, active };
}

/** The images that are shown; the first ones where none was asked for. */
export function shownImages(panes: Panes, view: BlockView): readonly number[] {
  if (panes.images.length > 0) return panes.images;
  return view.images.slice(0, FEW_PANES).map((_, image) => image);
}

/** The panes of another view of the same images: each image by its name. */
export function panesInOtherView(panes: Panes, before: BlockView | null, after: BlockView): Panes {
  if (before === null || panes.images.length === 0) return { ...NO_PANES, look: panes.look };
  const places = new Map(after.images.map(({ name }, image) => [name, image]));
  const place = (image: number) => places.get(before.images[image]?.name ?? '') ?? -1;
  const images = panes.images.map(place).filter((image) => image >= 0);
  const views = new Map([...panes.views].map(([image, looks]): [number, PaneView] => [place(image), looks]));
  const active = panes.active === null ? -1 : place(panes.active);
  return withImages({ ...panes, views, active: active < 0 ? null : active }, images);
}
