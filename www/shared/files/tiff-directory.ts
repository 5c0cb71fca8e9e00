/** The directory of the first image of a TIFF or BigTIFF: what its tags hold, and where they stand in the file. */

/** One tag of a directory. */
interface TiffEntry {
  tag: number;
  /** Its kind of values, by the number that TIFF gives it. */
  type: number;
  /** How many values it has. */
  count: number;
  /** Where it stands in the file, from the number of the tag on. */
  from: number;
  /** Its values, so many at most; none of a kind that is not read here. */
  values: (most: number) => Promise<number[]>;
}

export interface TiffDirectory {
  little: boolean;
  entries: readonly TiffEntry[];
}

/** A directory has no more entries than these; what says more is damaged. */
const MOST_ENTRIES = 4096;

export const SHORT = 3;

/** Of TIFF 6.0 and BigTIFF: how many bytes a value takes, and how it is read. */
const KINDS: ReadonlyMap<number, readonly [number, (view: DataView, at: number, little: boolean) => number]> = new Map([
  [SHORT, [2, (view: DataView, at: number, little: boolean) => view.getUint16(at, little)]],
  [4, [4, (view: DataView, at: number, little: boolean) => view.getUint32(at, little)]],
  [12, [8, (view: DataView, at: number, little: boolean) => view.getFloat64(at, little)]],
  [16, [8, (view: DataView, at: number, little: boolean) => Number(view.getBigUint64(at, little))]],
]);

/** Null of what is no TIFF, or damaged. */
export async function tiffDirectory(file: Blob): Promise<TiffDirectory | null> {
  const read = async (from: number, length: number) => new DataView(await file.slice(from, from + length).arrayBuffer());
  try {
    const head = await read(0, 16);
    const order = head.getUint16(0);
    const little = order === 0x4949;
    const version = head.getUint16(2, little);
    if ((!little && order !== 0x4d4d) || (version !== 42 && version !== 43)) return null;
    const isBig = version === 43;
    const at = isBig ? Number(head.getBigUint64(8, little)) : head.getUint32(4, little);
    const [before, each, offset] = isBig ? [8, 20, 12] : [2, 12, 8];
    const start = await read(at, before);
    const entries = Math.min(MOST_ENTRIES, isBig ? Number(start.getBigUint64(0, little)) : start.getUint16(0, little));
    const directory = await read(at + before, entries * each);
    const entry = (index: number): TiffEntry => {
      const own = index * each;
      const type = directory.getUint16(own + 2, little);
      const count = isBig ? Number(directory.getBigUint64(own + 4, little)) : directory.getUint32(own + 4, little);
      const values = async (most: number): Promise<number[]> => {
        const kind = KINDS.get(type);
        const number = Math.min(most, count);
        if (kind === undefined || number === 0) return [];
        const [size, value] = kind;
        const isHere = size * count <= each - offset;
        const place = isBig ? Number(directory.getBigUint64(own + offset, little)) : directory.getUint32(own + offset, little);
        const view = isHere ? directory : await read(place, size * number);
        return Array.from({ length: number }, (_, i) => value(view, (isHere ? own + offset : 0) + size * i, little));
      };
      return { tag: directory.getUint16(own, little), type, count, from: at + before + own, values };
    };
    return { little, entries: Array.from({ length: entries }, (_, index) => entry(index)) };
  } catch {
    // The crate says what is wrong with it.
    return null;
  }
}

/** The keys of GeoTIFF that have one short number, of the tag of their directory. */
export async function geoKeys(directory: TiffDirectory): Promise<ReadonlyMap<number, number>> {
  const all = (await directory.entries.find(({ tag, type }) => tag === GEO_KEYS && type === SHORT)?.values(4 * MOST_ENTRIES)) ?? [];
  const keys = new Map<number, number>();
  // Each key has four numbers: itself, where its value stands, how many there are, and the value. The first four are of the directory.
  for (let at = 4; at + 4 <= all.length; at += 4) if (all[at + 1] === 0) keys.set(all[at] ?? 0, all[at + 3] ?? 0);
  return keys;
}

/** Of OGC 19-008r4: where the pixels lie, and in which system. */
export const GEO_KEYS = 34735;
export const [SCALE, TIES, TRANSFORMATION] = [33550, 33922, 34264] as const;
/** The key that says of which kind a system is. */
export const MODEL_TYPE = 1024;
export const GEOGRAPHIC = 2;
