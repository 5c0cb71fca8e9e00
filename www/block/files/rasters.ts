/** What a file of pixels is, told by its content: an orthophoto, the heights of its ground, or a photograph. */
import type { FoundFile } from '../../shared/files/drop';
import { GEO_KEYS, GEOGRAPHIC, geoKeys, MODEL_TYPE, SCALE, SHORT, tiffDirectory, TIES, TRANSFORMATION } from '../../shared/files/tiff-directory';

/** An orthophoto or heights, with the world file that says where it lies, and the file that says in which system. */
export interface FoundRaster {
  file: File;
  world: File | null;
  projection: File | null;
}

export interface Sorted {
  orthophotos: FoundRaster[];
  heights: FoundRaster[];
  /** Grids of numbers at longitudes and latitudes: geoids, or heights that are in degrees. */
  degrees: FoundRaster[];
  /** World files without a picture. */
  worlds: File[];
  /** Files that say a system, without a picture. */
  projections: File[];
  others: FoundFile[];
}

const WORLD = /\.(?:tfw|jgw|pgw|bpw|gfw|tifw|tiffw|jpgw|jpegw|pngw|wld)$/iu;
const PROJECTION = /\.prj$/iu;
const TIFF = /\.tiff?$/iu;
const PICTURE = /\.(?:jpe?g|png|bmp|webp|p[gpn]m)$/iu;
const GRID = /\.(?:asc|grd|txt|agr)$/iu;

/** Sorts what was given; files whose names say that they are neither stay with the others. */
export async function sortRasters(found: readonly FoundFile[]): Promise<Sorted> {
  const sorted: Sorted = { orthophotos: [], heights: [], degrees: [], worlds: [], projections: [], others: [] };
  const worlds = found.filter(({ file }) => WORLD.test(file.name));
  const projections = found.filter(({ file }) => PROJECTION.test(file.name));
  const used = new Set<File>();
  for (const one of found) {
    const { file } = one;
    if (WORLD.test(file.name) || PROJECTION.test(file.name)) continue;
    const [world = null, projection = null] = [worlds, projections].map((beside) => beside.find((other) => stemOf(other) === stemOf(one))?.file ?? null);
    const kind = await kindOf(file, world !== null);
    if (kind === 'photograph') {
      sorted.others.push(one);
      continue;
    }
    for (const beside of [world, projection]) if (beside !== null) used.add(beside);
    sorted[LISTS[kind]].push({ file, world, projection });
  }
  sorted.projections = projections.map(({ file }) => file).filter((file) => !used.has(file));
  sorted.worlds = worlds.map(({ file }) => file).filter((file) => !used.has(file));
  return sorted;
}

/** Several pictures that say where they lie are photographs: nothing says which of them is the orthophoto. */
export function asGiven(sorted: Sorted): Sorted & { taken: number } {
  const { orthophotos } = sorted;
  if (orthophotos.length < 2) return { ...sorted, taken: 0 };
  return { ...sorted, orthophotos: [], others: [...sorted.others, ...orthophotos.map(({ file }) => ({ file, path: '' }))], taken: orthophotos.length };
}

/** Whether photographs are to be placed on an orthophoto: it is among them, or its heights are. */
export async function hasGround(found: readonly FoundFile[]): Promise<boolean> {
  const { orthophotos, heights, degrees, others } = await sortRasters(found);
  const [picture] = orthophotos;
  const stands = orthophotos.length === 1 && (others.length > 0 || picture?.world !== null || picture.projection !== null);
  return heights.length > 0 || degrees.length > 0 || stands;
}

/** Folder and name without its end. */
function stemOf({ file, path }: FoundFile): string {
  return (path === '' ? file.name : path).replace(/\.[^./]*$/u, '').toLowerCase();
}

type Kind = 'orthophoto' | 'heights' | 'degrees' | 'photograph';

const LISTS = { orthophoto: 'orthophotos', heights: 'heights', degrees: 'degrees' } as const;

async function kindOf(file: File, hasWorld: boolean): Promise<Kind> {
  if (GRID.test(file.name)) return /^\s*(?:ncols|nrows)\s/iu.test(await file.slice(0, 64).text()) ? 'heights' : 'photograph';
  if (TIFF.test(file.name) || file.type === 'image/tiff') return kindOfTiff(await tiffTags(file), hasWorld);
  return hasWorld && (file.type.startsWith('image/') || PICTURE.test(file.name)) ? 'orthophoto' : 'photograph';
}

/** Of TIFF 6.0. */
const [BITS, SAMPLES, FORMAT] = [258, 277, 339];
const UNSIGNED = 1;

/** Numbers below 0 or with decimals are heights; so is one band of more than 16 bits. */
export function kindOfTiff(tags: ReadonlyMap<number, number>, hasWorld: boolean): Kind {
  const isPlaced = hasWorld || tags.has(TRANSFORMATION) || (tags.has(SCALE) && tags.has(TIES)) || tags.has(GEO_KEYS);
  const isOne = (tags.get(SAMPLES) ?? 1) === 1;
  if (isOne && isPlaced && ((tags.get(FORMAT) ?? UNSIGNED) !== UNSIGNED || (tags.get(BITS) ?? 1) > 16))
    return tags.get(MODEL_TYPE) === GEOGRAPHIC ? 'degrees' : 'heights';
  return isPlaced ? 'orthophoto' : 'photograph';
}

/** So many values of a tag are no table. */
const FEW = 64;

/**
 * The tags of the first image of a TIFF or BigTIFF with their first values, where these are short numbers (0 elsewhere), and among them the key that says of which
 * kind its system is: no tag has its number. None where it is damaged.
 */
async function tiffTags(file: Blob): Promise<ReadonlyMap<number, number>> {
  const tags = new Map<number, number>();
  const directory = await tiffDirectory(file);
  if (directory === null) return tags;
  try {
    for (const { tag, type, count, values } of directory.entries) tags.set(tag, type === SHORT && count < FEW ? ((await values(1))[0] ?? 0) : 0);
    const kind = (await geoKeys(directory)).get(MODEL_TYPE);
    if (kind !== undefined) tags.set(MODEL_TYPE, kind);
  } catch {
    // The crate says what is wrong with it.
  }
  return tags;
}
