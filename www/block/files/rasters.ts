/** What a file of pixels is, told by its content: an orthophoto, the heights of its ground, or a photograph. */
import type { FoundFile } from '../../shared/files/drop';

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

/** Of TIFF 6.0 and OGC 19-008r4. */
const [BITS, SAMPLES, FORMAT, SCALE, TIES, TRANSFORMATION, KEYS] = [258, 277, 339, 33550, 33922, 34264, 34735];
const UNSIGNED = 1;
/** The key that says of which kind a system is, which stands among the tags here: no tag has its number. */
const MODEL_TYPE = 1024;
const GEOGRAPHIC = 2;

/** Numbers below 0 or with decimals are heights; so is one band of more than 16 bits. */
export function kindOfTiff(tags: ReadonlyMap<number, number>, hasWorld: boolean): Kind {
  const isPlaced = hasWorld || tags.has(TRANSFORMATION) || (tags.has(SCALE) && tags.has(TIES)) || tags.has(KEYS);
  const isOne = (tags.get(SAMPLES) ?? 1) === 1;
  if (isOne && isPlaced && ((tags.get(FORMAT) ?? UNSIGNED) !== UNSIGNED || (tags.get(BITS) ?? 1) > 16))
    return tags.get(MODEL_TYPE) === GEOGRAPHIC ? 'degrees' : 'heights';
  return isPlaced ? 'orthophoto' : 'photograph';
}

/** A directory has no more entries than these; what says more is damaged. */
const MOST_ENTRIES = 4096;

/** The tags of the first image of a TIFF or BigTIFF with their first values, where these stand in the directory itself (0 elsewhere); none where it is damaged. */
async function tiffTags(file: Blob): Promise<ReadonlyMap<number, number>> {
  const read = async (from: number, length: number) => new DataView(await file.slice(from, from + length).arrayBuffer());
  const tags = new Map<number, number>();
  try {
    const head = await read(0, 16);
    const little = head.getUint16(0) === 0x4949;
    const isBig = head.getUint16(2, little) === 43;
    const at = isBig ? Number(head.getBigUint64(8, little)) : head.getUint32(4, little);
    const [before, each] = isBig ? [8, 20] : [2, 12];
    const start = await read(at, before);
    const entries = Math.min(MOST_ENTRIES, isBig ? Number(start.getBigUint64(0, little)) : start.getUint16(0, little));
    const directory = await read(at + before, entries * each);
    for (let entry = 0; entry < entries; entry++) {
      const from = entry * each;
      const values = isBig ? Number(directory.getBigUint64(from + 4, little)) : directory.getUint32(from + 4, little);
      const isShort = directory.getUint16(from + 2, little) === 3 && values <= (isBig ? 4 : 2);
      if (directory.getUint16(from, little) === KEYS) await keys(from, values);
      tags.set(directory.getUint16(from, little), isShort ? directory.getUint16(from + (isBig ? 12 : 8), little) : await first(from, values));
    }
    /** Each key has four numbers: itself, where its value stands, how many there are, and the value. */
    async function keys(from: number, values: number): Promise<void> {
      const offset = isBig ? Number(directory.getBigUint64(from + 12, little)) : directory.getUint32(from + 8, little);
      const all = await read(offset, 2 * Math.min(values, 4 * MOST_ENTRIES));
      for (let at = 8; at + 8 <= all.byteLength; at += 8)
        if (all.getUint16(at, little) === MODEL_TYPE && all.getUint16(at + 2, little) === 0) tags.set(MODEL_TYPE, all.getUint16(at + 6, little));
    }
    /** Three bands say their bits elsewhere. */
    async function first(from: number, values: number): Promise<number> {
      const isFar = directory.getUint16(from + 2, little) === 3 && values < 64;
      if (!isFar) return 0;
      const offset = isBig ? Number(directory.getBigUint64(from + 12, little)) : directory.getUint32(from + 8, little);
      return (await read(offset, 2)).getUint16(0, little);
    }
  } catch {
    // The crate says what is wrong with it.
  }
  return tags;
}
