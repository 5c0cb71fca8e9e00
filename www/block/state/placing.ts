/** Images on an orthophoto: what was given for them, what came of it, and what of it is looked at. */
import type { BlockPlaces, Georeference, LinkUse, OrthophotoInfo, PlacingOptions, PlacingVerdict } from '../../../pkg/wasm/tiepoint.js';
import type { BlockFile, TextFile } from './file';
import { NO_FILM } from './film';
import type { GivenFilm } from './film';
import type { LinkDraft, LinkStep } from './steps';
import type { LinkedImage } from './links';

/** A picture of the ground or its heights, with the world file that says where it lies, and the file that says in which system. */
export interface RasterFile extends BlockFile {
  world: TextFile | null;
  projection: TextFile | null;
  /** Absent of one in a projected system, and of earlier releases. */
  degrees?: InDegrees | null;
}

/** That a picture lies at longitudes and latitudes: it is looked at in a projected system, into which an affine map leads from its pixels, and nothing is matched with it. */
export interface InDegrees {
  crs: string;
  /** From its pixels to degrees. */
  georeference: Georeference;
  /** The projected system, and the world file that places it there. */
  shownIn: string;
  world: string;
  /** How far that is off at most, px. */
  departs: number;
}

/** Whether an orthophoto is looked at alone. */
export function isLookedAtAlone(orthophoto: GivenOrthophoto | null): boolean {
  return (orthophoto?.raster.degrees ?? null) !== null;
}

/** `by`: who said the height of level ground; absent where nobody did, and of earlier releases. */
export type GivenHeights = { kind: 'level'; height: number; by?: 'hand' | 'block' } | { kind: 'model'; model: RasterFile };

export interface GivenOrthophoto {
  raster: RasterFile;
  info: OrthophotoInfo;
  /** The key of the block that it was made of, in whose system it lies; null: of none. */
  ofBlock: string | null;
}

/** What is done with an orthophoto: the block is placed on it, each image by itself, or it only lies under the map. */
export type Purpose = 'block' | 'images' | 'map';

/** How a block was placed on an orthophoto. */
export interface OnGround {
  /** Names what it was placed by. */
  key: string;
  /** The project file of the block before that: it can be placed again, and taken off. */
  before: Blob;
  /** Where images show its places of the orthophoto as it was found; null where an earlier release did not keep it. */
  places: BlockPlaces | null;
  /** What came of each image that was sought on it. */
  verdicts: readonly ImageVerdict[];
}

/** What came of an image of a block on the orthophoto. */
export interface ImageVerdict {
  name: string;
  verdict: PlacingVerdict;
}

/** What came of an image. */
export interface Placed {
  /** Names what it was made from. */
  key: string;
  /** Null where the image cannot be read. */
  result: LinkedImage | null;
  /** Why it cannot; empty elsewhere. */
  problem: string;
  /** What was found without the steps by hand. */
  found: LinkedImage | null;
  /** Steps by hand; those from `done` on are undone. */
  steps: readonly LinkStep[];
  done: number;
}

/** A placed image and one of its links; null: none. */
export interface Looked {
  image: number | null;
  link: number | null;
}

export interface Placing {
  orthophoto: GivenOrthophoto | null;
  heights: GivenHeights;
  film: GivenFilm;
  options: PlacingOptions | null;
  /** Null: what suits what else is given (see `purposeOf`). */
  purpose: Purpose | null;
  /** By the number of the image's file. */
  placed: ReadonlyMap<number, Placed>;
  running: { done: number; total: number; text: string } | null;
  /** That the images record positions elsewhere than the orthophoto; empty where nothing says so. */
  elsewhere: string;
  chosen: Looked;
  pointed: Looked;
  /** The next press on the orthophoto says near where images were taken. */
  picks: boolean;
  /** The next press on the orthophoto adds a place of it to the block. */
  adds: boolean;
  /** The link that is being measured. */
  draft: LinkDraft | null;
  /** Images whose links are adjusted now. */
  adjusting: number | null;
  /** The links that are drawn. */
  uses: ReadonlySet<LinkUse>;
}

export const NOTHING_LOOKED_AT: Looked = { image: null, link: null };

/** Without a model the ground is level. */
const LEVEL: GivenHeights = { kind: 'level', height: 0 };

export const NO_PLACING: Placing = {
  orthophoto: null,
  heights: LEVEL,
  film: NO_FILM,
  options: null,
  purpose: null,
  placed: new Map(),
  running: null,
  elsewhere: '',
  chosen: NOTHING_LOOKED_AT,
  pointed: NOTHING_LOOKED_AT,
  picks: false,
  adds: false,
  draft: null,
  adjusting: null,
  uses: new Set<LinkUse>(['used', 'check', 'rejected']),
};

export type PlacingAction =
  /** In place of the former one, its heights and what was placed on it; null: none. */
  | { type: 'orthophoto'; orthophoto: GivenOrthophoto | null }
  /** `info`: the orthophoto with them. */
  | { type: 'heights'; heights: GivenHeights; info: OrthophotoInfo }
  | { type: 'film'; film: GivenFilm }
  | { type: 'placingOptions'; options: Partial<PlacingOptions> }
  | { type: 'purpose'; purpose: Purpose }
  | { type: 'placing'; running: Placing['running'] }
  | { type: 'elsewhere'; text: string }
  | { type: 'placed'; image: BlockFile; placed: Placed }
  | { type: 'choosePlaced'; looked: Looked }
  | { type: 'pointPlaced'; looked: Looked }
  | { type: 'picksPlace'; picks: boolean }
  | { type: 'addsPlace'; adds: boolean }
  | { type: 'linkDraft'; draft: LinkDraft | null }
  | { type: 'adjustsLinks'; image: number | null }
  | { type: 'showLinks'; use: LinkUse; on: boolean };

export function reducePlacing(placing: Placing, action: PlacingAction): Placing {
  switch (action.type) {
    case 'orthophoto':
      // Heights of another one may lie elsewhere.
      return { ...NO_PLACING, options: placing.options, film: placing.film, orthophoto: action.orthophoto };
    case 'heights':
      return {
        ...placing,
        heights: action.heights,
        orthophoto: placing.orthophoto === null ? null : { ...placing.orthophoto, info: action.info },
      };
    case 'film':
      return { ...placing, film: action.film };
    case 'placingOptions':
      return placing.options === null ? placing : { ...placing, options: { ...placing.options, ...action.options }, picks: false };
    case 'purpose':
      // What is measured or pressed is of images that are placed by themselves.
      return placing.purpose === action.purpose ? placing : { ...placing, purpose: action.purpose, draft: null, picks: false, adds: false };
    case 'placing':
      return { ...placing, running: action.running };
    case 'elsewhere':
      return placing.elsewhere === action.text ? placing : { ...placing, elsewhere: action.text };
    case 'placed':
      return { ...placing, placed: new Map([...placing.placed, [action.image.id, action.placed]]) };
    case 'choosePlaced':
      if (isSameLooked(placing.chosen, action.looked)) return placing;
      // A link is measured in one image.
      return { ...placing, chosen: action.looked, draft: placing.chosen.image === action.looked.image ? placing.draft : null };
    case 'pointPlaced':
      return isSameLooked(placing.pointed, action.looked) ? placing : { ...placing, pointed: action.looked };
    case 'picksPlace':
      return { ...placing, picks: action.picks, draft: null, adds: false };
    case 'addsPlace':
      return { ...placing, adds: action.adds, draft: null, picks: false };
    case 'linkDraft':
      return { ...placing, draft: action.draft, picks: false };
    case 'adjustsLinks':
      return { ...placing, adjusting: action.image };
    case 'showLinks': {
      const uses = new Set(placing.uses);
      if (action.on) uses.add(action.use);
      else uses.delete(action.use);
      return { ...placing, uses };
    }
  }
}

function isSameLooked(a: Looked, b: Looked): boolean {
  return a.image === b.image && a.link === b.link;
}
