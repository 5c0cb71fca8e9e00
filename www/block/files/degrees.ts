/** A picture of the ground that lies at longitudes and latitudes, made one that can be looked at: in the UTM zone of its middle. */
import { system_coordinates, system_positions } from '../../../pkg/wasm/tiepoint.js';
import type { Georeference } from '../../../pkg/wasm/tiepoint.js';
import { byAffine, wholeOf } from '../state/cells';
import type { InDegrees, RasterFile } from '../state/placing';
import { affineOf, scaleOf } from '../state/under';
import { mapped } from '../../shared/state/plane-map';
import type { Place } from '../state/under';
import type { Affine } from '../../shared/state/plane-map';
import { GEO_KEYS, GEOGRAPHIC, geoKeys, MODEL_TYPE, SCALE, tiffDirectory, TIES, TRANSFORMATION } from '../../shared/files/tiff-directory';
import type { TiffDirectory } from '../../shared/files/tiff-directory';

/** Of OGC 19-008r4. */
const [RASTER_TYPE, GEOGRAPHIC_SYSTEM, ANGULAR_UNIT] = [1025, 2048, 2054];
const [PIXEL_IS_POINT, DEGREE, USER_DEFINED] = [2, 9102, 32767];
const [WIDTH, HEIGHT] = [256, 257];
/** What says no system is taken for GPS. */
const WGS84 = 'EPSG:4326';
/** A system in degrees leaves longitudes and latitudes where they are, but for the shift of its datum: by less than that. */
const MOST_SHIFT_DEG = 0.01;

const LARGEST_DEG = 1e-3;

/** What a file says of its place in degrees. */
interface Said {
  crs: string;
  georeference: Georeference;
  /** The same pixels without tags that say where they lie: a world file says it then. */
  file: Blob;
}

/** Null of what is not in degrees, or not in any that can be looked at. */
export async function projectedOf(raster: RasterFile): Promise<RasterFile | null> {
  const directory = await tiffDirectory(raster.file);
  const said = directory === null ? saidByWorld(raster) : await saidByTags(raster, directory);
  const size = said === null ? null : await sizeOf(raster.file, directory);
  if (said === null || size === null) return null;
  try {
    const degrees = utmOf(said, size);
    return degrees === null ? null : { ...raster, file: said.file, degrees };
  } catch {
    // A place that its system or the zone does not have: it stays refused as it was.
    return null;
  }
}

function utmOf({ crs, georeference }: Said, size: { width: number; height: number }): InDegrees | null {
  const toDegrees = affineOf(georeference);
  const [longitude, latitude] = mapped(toDegrees, size.width / 2, size.height / 2);
  if (!isInDegrees(crs, longitude, latitude)) return null;
  const zone = Math.min(60, Math.floor((longitude + 180) / 6) + 1);
  const shownIn = `EPSG:${String((latitude < 0 ? 32700 : 32600) + zone)}`;
  const sheet = wholeOf((pixels) => planeOf(system_coordinates(shownIn, system_positions(crs, withHeights(byAffine(toDegrees, pixels))))), size);
  return sheet === null ? null : { crs, georeference, shownIn, world: worldFileOf(sheet.whole), departs: sheet.departs };
}

/** Whether a place has the same numbers in a system and on the earth. */
function isInDegrees(crs: string, longitude: number, latitude: number): boolean {
  if (!(Math.abs(longitude) <= 180 && Math.abs(latitude) <= 90)) return false;
  const [east = NaN, north = NaN] = system_positions(crs, Float64Array.of(longitude, latitude, 0));
  return Math.hypot(east - longitude, north - latitude) < MOST_SHIFT_DEG;
}

function withHeights(places: readonly Place[]): Float64Array {
  return Float64Array.from(places.flatMap(([x, y]) => [x, y, 0]));
}

function planeOf(coordinates: Float64Array): Place[] {
  return Array.from({ length: coordinates.length / 3 }, (_, i) => [coordinates[3 * i] ?? NaN, coordinates[3 * i + 1] ?? NaN]);
}

/** World files name the middle of the first pixel. */
function worldFileOf(by: Affine): string {
  return `${[by.a, by.b, by.c, by.d, ...mapped(by, 0.5, 0.5)].map(String).join('\n')}\n`;
}

async function saidByTags(raster: RasterFile, directory: TiffDirectory): Promise<Said | null> {
  const valuesOf = (tag: number, most: number) => directory.entries.find((entry) => entry.tag === tag)?.values(most) ?? Promise.resolve([]);
  const keys = await geoKeys(directory);
  const kind = keys.get(MODEL_TYPE);
  const unit = keys.get(ANGULAR_UNIT) ?? DEGREE;
  if ((kind !== undefined && kind !== GEOGRAPHIC) || unit !== DEGREE) return null;
  const [matrix, scale, ties] = await Promise.all([valuesOf(TRANSFORMATION, 16), valuesOf(SCALE, 3), valuesOf(TIES, 6)]);
  const place = placeOf(matrix, scale, ties);
  const half = keys.get(RASTER_TYPE) === PIXEL_IS_POINT ? -0.5 : 0;
  const georeference = place === null ? placeOfWorld(raster) : { ...place, origin: mapped(affineOf(place), half, half) };
  const code = keys.get(GEOGRAPHIC_SYSTEM) ?? USER_DEFINED;
  const own = code === USER_DEFINED || code === 0 ? null : `EPSG:${String(code)}`;
  const crs = kind === undefined ? crsBeside(raster, georeference) : (own ?? WGS84);
  return georeference === null || crs === null ? null : { crs, georeference, file: withoutPlace(raster, directory) };
}

function placeOf(matrix: readonly number[], scale: readonly number[], ties: readonly number[]): Georeference | null {
  const [a, b, , x, d, e, , y] = matrix;
  if (a !== undefined && b !== undefined && x !== undefined && d !== undefined && e !== undefined && y !== undefined)
    return { origin: [x, y], by_column: [a, d], by_row: [b, e] };
  const [sx, sy] = scale;
  const [i, j, , u, v] = ties;
  if (sx === undefined || sy === undefined || i === undefined || j === undefined || u === undefined || v === undefined) return null;
  return { origin: [u - i * sx, v + j * sy], by_column: [sx, 0], by_row: [0, -sy] };
}

/** The tags of the place get numbers that no tag has, which leaves all else where it is, and the tags in their order. */
function withoutPlace({ file, name }: RasterFile, { little, entries }: TiffDirectory): Blob {
  const parts: BlobPart[] = [];
  let at = 0;
  const ofPlace: readonly number[] = [SCALE, TIES, TRANSFORMATION, GEO_KEYS];
  for (const { tag, from } of entries.filter((entry) => ofPlace.includes(entry.tag))) {
    const number = new DataView(new ArrayBuffer(2));
    number.setUint16(0, tag - 1, little);
    parts.push(file.slice(at, from), number);
    at = from + 2;
  }
  return new File([...parts, file.slice(at)], name, { type: file.type });
}

/** By the world file and the file of the system beside it. */
function saidByWorld(raster: RasterFile): Said | null {
  const georeference = placeOfWorld(raster);
  const crs = crsBeside(raster, georeference);
  return georeference === null || crs === null ? null : { crs, georeference, file: raster.file };
}

/** The system of a file beside it. Without any, pixels whose sides would be below a millimetre are in degrees: so the crate judges, too. */
function crsBeside({ projection }: RasterFile, georeference: Georeference | null): string | null {
  if (projection !== null) return projection.text.trim();
  return georeference !== null && scaleOf(affineOf(georeference)) < LARGEST_DEG ? WGS84 : null;
}

function placeOfWorld({ world }: RasterFile): Georeference | null {
  const numbers = (world?.text ?? '').trim().split(/\s+/u).map(Number);
  const [a = NaN, d = NaN, b = NaN, e = NaN, x = NaN, y = NaN] = numbers;
  if (!Number.isFinite(a + b + d + e + x + y)) return null;
  const origin: [number, number] = [x - (a + b) / 2, y - (d + e) / 2];
  return { origin, by_column: [a, d], by_row: [b, e] };
}

async function sizeOf(file: Blob, directory: TiffDirectory | null): Promise<{ width: number; height: number } | null> {
  if (directory === null) {
    const bitmap = await createImageBitmap(file, { imageOrientation: 'none' }).catch(() => null);
    const size = bitmap === null ? null : { width: bitmap.width, height: bitmap.height };
    bitmap?.close();
    return size;
  }
  const [width, height] = await Promise.all([WIDTH, HEIGHT].map(async (tag) => (await directory.entries.find((entry) => entry.tag === tag)?.values(1))?.[0]));
  return width === undefined || height === undefined ? null : { width, height };
}
