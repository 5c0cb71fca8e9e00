/** An orthophoto in a worker: its picture in tiles, and images that are placed on it. The worker opens it when another one is asked about, and keeps it. */
import { BlockScene, image_position, OrthoMosaic, OrthophotoReference, Photo } from '../../../pkg/wasm/tiepoint.js';
import type {
  BlockFlight,
  CountedFrom,
  ExifPosition,
  FileInParts,
  Georeference,
  GivenLink,
  GivenPosition,
  OrthophotoInfo,
  PlacedImage,
  Placement,
  PlacingOptions,
  Remark,
  Sidecars,
} from '../../../pkg/wasm/tiepoint.js';
import type { FilmTexts } from '../state/film';
import { readFilm } from './film';
import { inColumns } from '../state/links';
import type { AddedControl } from '../state/added';
import type { LinkedImage } from '../state/links';
import { TILE_SIDE } from '../state/under';

/** A file of pixels with what stands beside it. */
interface Raster {
  file: Blob;
  sidecars: Sidecars;
}

/** What a worker is asked about: files are opened by whoever is asked first. */
export interface Ground {
  picture: Raster;
  heights: number | Raster;
  /** Names of both. */
  keys: { picture: string; heights: string };
}

export interface TileInput {
  ground: Ground;
  /** Halved so many times. */
  level: number;
  /** Counted in tiles. */
  column: number;
  row: number;
}

export interface PlaceInput {
  ground: Ground;
  options: PlacingOptions;
  name: string;
  file: Blob;
  cameras: string | null;
  /** Of a scan of film. */
  film: FilmTexts | null;
  /** That of a table; null: what its file records. */
  position: GivenPosition | null;
}

export interface MosaicKind {
  /** In the system of the block's adjustment, though it has a coordinate reference system. */
  inAdjustment: boolean;
  /** The side of a pixel in units of that system; null: that of the images. */
  gsd: number | null;
  /** The names of the images that it is made of; null: all. */
  images: readonly string[] | null;
}

/** What is added to a mosaic, in this order, and what is to be said of it. */
export interface MosaicPlan {
  order: { name: string; index: number }[];
  remark: Remark | null;
}

/** As GeoTIFF. */
export interface MadeMosaic {
  picture: Blob;
  remark: Remark | null;
}

export interface MosaicInput extends MosaicKind {
  project: Blob;
  heights: Ground['heights'] | null;
  /** Of the images that will be added. */
  names: readonly string[];
}

export interface AdjustInput extends PlaceInput {
  links: readonly GivenLink[];
  /** Where it was placed; null: nowhere yet. */
  start: Placement | null;
  size: readonly [number, number];
}

/** One of both is given. */
export interface PredictInput {
  ground: Ground;
  placement: Placement;
  at: readonly [number, number] | null;
  place: readonly [number, number] | null;
}

export interface ElsewhereInput extends Pick<PlaceInput, 'ground' | 'options'> {
  positions: readonly ExifPosition[];
}

export interface ControlInput extends Pick<PlaceInput, 'ground' | 'options'> {
  /** X and Y in the system of the orthophoto. */
  place: readonly [number, number];
  /** Of the places by hand. */
  number: number;
  /** Of the block; null: none. */
  crs: string | null;
  /** Where its heights count from. */
  heights: CountedFrom;
}

export interface LaidInput {
  ground: Ground;
  file: Blob;
  placement: Placement;
  side: number;
}

/** A picture of the ground: `step` px of its own are one of the bitmap. */
export interface LaidPicture {
  bitmap: ImageBitmap;
  step: number;
  georeference: Georeference;
}

interface Held {
  keys: Ground['keys'];
  reference: OrthophotoReference;
  info: OrthophotoInfo;
  /** The options by which its points were found. */
  searched: string;
}

let held: Held | null = null;

async function opened({ picture, heights, keys }: Ground): Promise<Held> {
  if (held?.keys.picture !== keys.picture) {
    // Two of them might not fit.
    held?.reference.free();
    held = null;
    const reference = OrthophotoReference.open(inParts(picture.file), picture.sidecars);
    held = { keys: { picture: keys.picture, heights: '' }, reference, info: reference.info(), searched: '' };
  }
  if (held.keys.heights !== keys.heights) {
    const { reference } = held;
    // Where these are refused the former ones stay.
    if (typeof heights === 'number') reference.set_heights(heights);
    else reference.set_heights(inParts(heights.file), heights.sidecars);
    held = { keys, reference, info: reference.info(), searched: '' };
  }
  return held;
}

/** What the types of a page leave out: workers alone have it. */
declare class FileReaderSync {
  readAsArrayBuffer(file: Blob): ArrayBuffer;
}

/** A file of which the module reads what it needs: only in a worker is that answered at once. */
function inParts(file: Blob): FileInParts {
  const reader = new FileReaderSync();
  return { size: file.size, read: (at, length) => new Uint8Array(reader.readAsArrayBuffer(file.slice(at, at + length))) };
}

async function bytesOf(file: Blob): Promise<Uint8Array> {
  return new Uint8Array(await file.arrayBuffer());
}

/** Size, place and heights; refuses what is no orthophoto, or no heights. */
export async function orthoInfo(ground: Ground): Promise<OrthophotoInfo> {
  return (await opened(ground)).info;
}

export async function orthoTile({ ground, level, column, row }: TileInput): Promise<ImageBitmap> {
  const { info, reference } = await opened(ground);
  const step = 2 ** level;
  const [left, top] = [column * TILE_SIDE * step, row * TILE_SIDE * step];
  const width = Math.min(TILE_SIDE, Math.ceil((info.width - left) / step));
  const height = Math.min(TILE_SIDE, Math.ceil((info.height - top) / step));
  return bitmapOf(reference, [column * TILE_SIDE, row * TILE_SIDE], [width, height], level);
}

/** A part of its picture that was halved so many times, transparent where it shows nothing. */
function bitmapOf(
  reference: OrthophotoReference,
  [column, row]: readonly [number, number],
  [width, height]: readonly [number, number],
  halvings: number,
): Promise<ImageBitmap> {
  const colours = reference.colours(column, row, width, height, halvings);
  return createImageBitmap(new ImageData(new Uint8ClampedArray(colours.buffer as ArrayBuffer, colours.byteOffset, colours.length), width, height));
}

/** What is to be said of images that record these positions, before they are placed. Null where nothing is. */
export async function orthoElsewhere({ ground, options, positions }: ElsewhereInput): Promise<Remark | null> {
  return (await opened(ground)).reference.elsewhere(positions, options);
}

/** The GNSS position that an image records; null where it records none. */
export function imagePosition({ file }: { file: Blob }): ExifPosition | null {
  return image_position(inParts(file));
}

/** Finds the points among which images are sought; refuses options and heights with which none can be. */
export async function orthoSearch({ ground, options }: Pick<PlaceInput, 'ground' | 'options'>): Promise<number> {
  const now = await opened(ground);
  const points = now.reference.search(options);
  now.searched = JSON.stringify(options);
  return points;
}

/** The orthophoto with the points among which images are sought. */
export async function orthoReference(input: Pick<PlaceInput, 'ground' | 'options'>): Promise<OrthophotoReference> {
  const now = await opened(input.ground);
  if (now.searched !== JSON.stringify(input.options)) await orthoSearch(input);
  return now.reference;
}

export async function orthoPlace({ ground, options, name, file, cameras, film, position }: PlaceInput): Promise<LinkedImage> {
  const reference = await orthoReference({ ground, options });
  const bytes = await bytesOf(file);
  const placed = reference.place(name, bytes, cameras, film && readFilm(film), position);
  return inColumns(placed, sizeOf(placed, bytes));
}

/** Width and height of an image, placed or not. */
function sizeOf({ placement }: PlacedImage, file: Uint8Array): [number, number] {
  if (placement !== null) {
    const { width_px: width, height_px: height } = placement.film ?? placement.camera;
    return [width, height];
  }
  const photo = Photo.decode(file);
  const size: [number, number] = [photo.width, photo.height];
  photo.free();
  return size;
}

/** An image by links that are given; nothing is matched. */
export async function orthoAdjust({ ground, options, name, file, cameras, film, position, links, start, size }: AdjustInput): Promise<LinkedImage> {
  const { reference } = await opened(ground);
  const given = { links, placement: start, cameras, options, film: film && readFilm(film), position };
  return inColumns(reference.adjust(name, await bytesOf(file), given), size);
}

/** Where a position of a placed image is on the ground, or a place of the ground in the image: X, Y or px; null where it shows none. */
export async function orthoPredict({ ground, placement, at, place }: PredictInput): Promise<[number, number] | null> {
  const { reference } = await opened(ground);
  const found =
    at === null ? reference.image_positions(placement, Float64Array.from(place ?? [])) : reference.ground_positions(placement, Float64Array.from(at));
  const [x = NaN, y = NaN] = found;
  return Number.isNaN(x) ? null : [x, y];
}

/** The edit that adds a place of the orthophoto to a block. */
export async function orthoControl({ ground, options, place, number, crs, heights }: ControlInput): Promise<AddedControl> {
  const { reference } = await opened(ground);
  return reference.control_by_hand({ place, number, crs, ...heights, options });
}

/** A placed image on the ground, as GeoTIFF. */
export async function orthoRectified({ ground, file, placement }: { ground: Ground; file: Blob; placement: Placement }): Promise<Uint8Array> {
  const { reference } = await opened(ground);
  return reference.rectified(await bytesOf(file), placement);
}

/** A placed image on the ground as a picture, with where it lies: halved until its sides are no longer than so many px. */
export async function orthoLaid({ ground, file, placement, side }: LaidInput): Promise<LaidPicture> {
  const { reference } = await opened(ground);
  const laid = OrthophotoReference.open(reference.rectified(await bytesOf(file), placement));
  try {
    const { width, height, georeference } = laid.info();
    const halvings = Math.max(0, Math.ceil(Math.log2(Math.max(width, height) / side)));
    const step = 2 ** halvings;
    const [columns, rows] = [Math.floor(width / step), Math.floor(height / step)];
    return { bitmap: await bitmapOf(laid, [0, 0], [columns, rows], halvings), step, georeference };
  } finally {
    laid.free();
  }
}

let mosaic: OrthoMosaic | null = null;
/** What of its file is there: the browser keeps it, on the disk where memory is short. */
let written: Blob[] = [];

/** Lays out the orthomosaic of a project file; gives its images that will be added, by name and index. */
export async function mosaicOpen({ project, heights, inAdjustment, gsd, images, names }: MosaicInput): Promise<MosaicPlan> {
  mosaic?.free();
  mosaic = null;
  written = [];
  const model = typeof heights === 'object' && heights !== null ? inParts(heights.file) : heights;
  const sidecars = typeof heights === 'object' && heights !== null ? heights.sidecars : null;
  const made = OrthoMosaic.open(await bytesOf(project), model, sidecars, gsd ?? undefined, inAdjustment, images ?? undefined);
  mosaic = made;
  const own = made.names;
  const order = [...made.order()].map((index) => ({ name: own[index] ?? '', index }));
  for (const { index } of order.filter(({ name }) => !names.includes(name))) write(made.leave_out(index));
  return { order: order.filter(({ name }) => names.includes(name)), remark: made.remark() ?? null };
}

export async function mosaicAdd({ index, file }: { index: number; file: Blob }): Promise<null> {
  if (mosaic !== null) write(mosaic.add(index, await bytesOf(file)));
  return null;
}

function write(bytes: Uint8Array): void {
  if (bytes.length > 0) written.push(new Blob([bytes as Uint8Array<ArrayBuffer>]));
}

/** The mosaic as GeoTIFF. */
export function mosaicFinish(): Blob {
  const made = mosaic;
  mosaic = null;
  if (made === null) throw new Error('no mosaic is laid out');
  const { end, beginning } = made.finish();
  write(end);
  const rest = new Blob(written).slice(beginning.length);
  written = [];
  return new Blob([beginning as Uint8Array<ArrayBuffer>, rest], { type: 'image/tiff' });
}

/** The orthophoto of a simulated flight, and its heights. */
export function sceneOrthophoto({ flight, gsd }: { flight: BlockFlight; gsd: number }): { picture: Uint8Array<ArrayBuffer>; heights: Uint8Array<ArrayBuffer> } {
  const scene = new BlockScene(flight);
  try {
    return scene.orthophoto(gsd) as { picture: Uint8Array<ArrayBuffer>; heights: Uint8Array<ArrayBuffer> };
  } finally {
    scene.free();
  }
}
