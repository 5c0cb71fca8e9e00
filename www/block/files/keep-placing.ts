/** Keeps what was given to place images on an orthophoto and what came of it, and reads it again. */
import type { Fiducial, Georeference, OrthophotoInfo } from '../../../pkg/wasm/tiepoint.js';
import { fitted, likeOf, listOf, nameOf, objectOf, orNull } from '../../shared/files/keepable';
import type { KeptFile, KeptPlacing, KeptRaster } from '../state/kept';
import type { TextFile } from '../state/file';
import { NO_FILM } from '../state/film';
import type { BegunScan, GivenFilm } from '../state/film';
import { NO_PLACING } from '../state/placing';
import type { GivenHeights, GivenOrthophoto, InDegrees, Placed, Placing, Purpose, RasterFile } from '../state/placing';
import type { BlockCatalogue, BlockFile } from '../state/state';

const PURPOSES: readonly Purpose[] = ['block', 'images', 'map'];

/** About the room of a link, in bytes. */
const LINK = 57;
const SMALL = 2048;

/** The files of an orthophoto and its heights. */
export function rastersOf({ orthophoto, heights }: Placing): readonly RasterFile[] {
  return [...(orthophoto === null ? [] : [orthophoto.raster]), ...(heights.kind === 'model' ? [heights.model] : [])];
}

/** What was given, without the files. */
export function keptPlacing(
  orthophoto: GivenOrthophoto | null,
  heights: GivenHeights,
  film: GivenFilm,
  options: Placing['options'],
  purpose: Purpose | null,
): KeptPlacing {
  return {
    orthophoto: orNull(orthophoto, ({ raster, info, ofBlock }) => ({ raster: keptRaster(raster), info, ofBlock })),
    heights: heights.kind === 'level' ? heights : { kind: 'model', model: keptRaster(heights.model) },
    film,
    options,
    purpose,
  };
}

function keptRaster({ id, name, file, world, projection, degrees = null }: RasterFile): KeptRaster {
  return { id, name, file: nameOf(file), world, projection, degrees };
}

/** About how much room what came of an image takes, in bytes. */
export function sizeOfPlaced({ result }: Placed): number {
  return SMALL + LINK * (result?.placement?.links.count ?? 0);
}

/** @throws Error naming the field that is damaged. Projects of earlier versions have none of it. */
export function placingFrom(
  given: unknown,
  placed: ReadonlyMap<number, unknown>,
  catalogue: BlockCatalogue,
  readFile: (value: unknown, name: string) => KeptFile,
  open: (file: KeptFile) => BlockFile,
): Placing {
  const none: Placing = { ...NO_PLACING, options: catalogue.placing };
  if (given === undefined) return none;
  const kept = objectOf(given, 'placing');
  const raster = (value: unknown, name: string): RasterFile => {
    const { world, projection, degrees } = objectOf(value, name);
    return {
      ...open(readFile(value, name)),
      world: orNull(world, (text) => textFrom(text, `${name}.world`)),
      // Earlier releases kept none.
      projection: orNull(projection ?? null, (text) => textFrom(text, `${name}.projection`)),
      degrees: orNull(degrees ?? null, (own) => degreesFrom(own, `${name}.degrees`)),
    };
  };
  const orthophoto = orNull(kept.orthophoto, (value): GivenOrthophoto => {
    const { raster: picture, info, ofBlock } = objectOf(value, 'placing.orthophoto');
    return {
      raster: raster(picture, 'placing.orthophoto.raster'),
      info: objectOf(info, 'placing.orthophoto.info') as unknown as OrthophotoInfo,
      ofBlock: orNull(ofBlock, (key) => likeOf(key, '', 'placing.orthophoto.ofBlock')),
    };
  });
  const { kind, height, by, model } = objectOf(kept.heights, 'placing.heights');
  const heights: GivenHeights =
    kind === 'model'
      ? { kind, model: raster(model, 'placing.heights.model') }
      : { kind: 'level', height: likeOf(height, 0, 'placing.heights.height'), ...(by === 'hand' || by === 'block' ? { by } : {}) };
  const options = orNull(kept.options, (value) => fitted(value, catalogue.placing, 'placing.options')) ?? catalogue.placing;
  const purpose = PURPOSES.find((one) => one === kept.purpose) ?? null;
  return { ...none, orthophoto, heights, options: same(options, catalogue), purpose, film: filmFrom(kept.film), placed: placedFrom(placed) };
}

/** Projects of earlier versions have none. */
export function filmFrom(given: unknown): GivenFilm {
  if (given === undefined) return NO_FILM;
  const { camera, marks, areScans, begun = [] } = objectOf(given, 'placing.film');
  return {
    camera: orNull(camera, (text) => textFrom(text, 'placing.film.camera')),
    marks: listOf(marks, 'placing.film.marks', textFrom),
    // Earlier releases kept none of these.
    areScans: areScans === true,
    begun: listOf(begun, 'placing.film.begun', begunFrom),
  };
}

function begunFrom(given: unknown, name: string): BegunScan {
  const { image, marks } = objectOf(given, name);
  return { image: likeOf(image, '', `${name}.image`), marks: listOf(marks, `${name}.marks`, markFrom) };
}

function markFrom(given: unknown, name: string): Fiducial {
  const mark = objectOf(given, name);
  // What is not known is null where numbers are written as JSON.
  const number = (value: unknown) => (typeof value === 'number' ? value : NaN);
  return { col: number(mark.col), row: number(mark.row), x_mm: number(mark.x_mm), y_mm: number(mark.y_mm) };
}

export function textFrom(given: unknown, name: string): TextFile {
  const { name: called, text } = objectOf(given, name);
  return { name: likeOf(called, '', `${name}.name`), text: likeOf(text, '', `${name}.text`) };
}

function degreesFrom(given: unknown, name: string): InDegrees {
  const { crs, georeference, shownIn, world, departs } = objectOf(given, name);
  return {
    crs: likeOf(crs, '', `${name}.crs`),
    georeference: objectOf(georeference, `${name}.georeference`) as unknown as Georeference,
    shownIn: likeOf(shownIn, '', `${name}.shownIn`),
    world: likeOf(world, '', `${name}.world`),
    departs: likeOf(departs, 0, `${name}.departs`),
  };
}

/** Defaults are the catalogue's own, by which they are known. */
function same(options: Placing['options'], { placing }: BlockCatalogue): Placing['options'] {
  return JSON.stringify(options) === JSON.stringify(placing) ? placing : options;
}

function placedFrom(parts: ReadonlyMap<number, unknown>): Placing['placed'] {
  return new Map(
    [...parts].map(([id, value]): [number, Placed] => {
      const name = `placed ${String(id)}`;
      const { key, result, problem } = objectOf(value, name);
      // The same object: what is kept already is not written again.
      likeOf(key, '', `${name}.key`);
      likeOf(problem, '', `${name}.problem`);
      orNull(result, (found) => objectOf(found, `${name}.result`));
      const placed = value as Placed;
      likeOf(placed.done, 0, `${name}.done`);
      listOf(placed.steps, `${name}.steps`, objectOf);
      return [id, placed];
    }),
  );
}
