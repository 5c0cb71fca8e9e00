/** What the page says of an image or a pair of a block. */
import { asFigure } from '../../shared/text/direction';
import { count, fixed } from '../../shared/text/format';
import { collectedOf } from './marks';
import type { WithMarks } from './marks';
import { surveyedAt } from './point-kinds';
import { keyOfPair, pointsOf } from './selection';
import type { Choice } from './selection';
import type { Listed } from './state';
import { coordinatesText, resultSystem } from './result-system';
import { inUnitOf } from './scale';
import type { BlockView, ViewConnection, ViewGeometry, ViewGiven } from './view';
import { message } from '../../shared/text/messages';
import { say } from '../../shared/text/words';

/** The connection of two images; undefined where they were not tried. */
export function connectionOf(view: BlockView, pair: readonly [number, number]): ViewConnection | undefined {
  return connectionsOf(view).get(keyOfPair(pair));
}

/** Why a pair is connected or is not, and whether it was rejected by hand. */
export function outcomeText({ reason, rejected }: ViewConnection): string {
  return rejected ? say('pair-rejected-by-hand', { reason }) : reason;
}

const CONNECTIONS = new WeakMap<BlockView, ReadonlyMap<string, ViewConnection>>();

/** All connections by their images. */
function connectionsOf(view: BlockView): ReadonlyMap<string, ViewConnection> {
  const known = CONNECTIONS.get(view);
  if (known !== undefined) return known;
  const made = new Map(view.connections.map((connection) => [keyOfPair(connection.images), connection]));
  CONNECTIONS.set(view, made);
  return made;
}

export function matchesOf({ outcome }: ViewConnection): number {
  return outcome.kind === 'connected' ? outcome.matches : 0;
}

/** Of the pair that has most. */
export function mostMatches({ connections }: BlockView): number {
  return connections.reduce((high, connection) => Math.max(high, matchesOf(connection)), 0);
}

/** `gsd`: the ground sample distance of the image that is chosen, in words. */
export function describe({ view, given }: Listed, choice: Choice, gsd = ''): string {
  switch (choice.kind) {
    case 'image':
      return describeImage(view, choice.image, gsd);
    case 'images':
      return describeImages(view, choice.images);
    case 'pair':
      return describePair(view, choice.images);
    case 'pairs':
      return describePairs(view, choice.pairs);
    case 'point':
      return describePoint(view, choice.point);
    case 'observation':
      return `${asFigure(view.images[choice.image]?.name ?? '')}, ${describePoint(view, choice.point)}`;
    case 'observations':
      return say('several-observations', { observations: choice.points.length, points: pointsOf(choice).length });
    case 'points':
      return describePoints(view, choice.points);
    case 'given':
      return describeGiven(view, given, choice.name);
  }
}

function describeImage(view: BlockView, index: number, gsd: string): string {
  const image = view.images[index];
  if (image === undefined) return '';
  const partners = view.connections.filter(({ images, outcome }) => images.includes(index) && outcome.kind === 'connected').length;
  const parts = [
    say('observations-4', {
      name: image.name,
      what: image.features === null ? '' : say('features-2', { features: image.features }),
      rays: image.rays,
      what_2: image.places === null ? '' : say('in-of-9-von-gruber', { places: image.places }),
    }),
    say('connected-with-of-images', { partners, images: view.images.length - 1 }),
    image.rmsePx === null ? '' : say('rmse-px-3', { rmse_px: image.rmsePx }),
    gsd,
    image.oriented ? say('oriented') : (image.why ?? say('not-oriented-yet')),
    // 1 is the usual one.
    image.exifOrientation === null || image.exifOrientation === 1 ? '' : say('used-as-stored-exif-orientation', { exif_orientation: image.exifOrientation }),
  ];
  return `${parts.filter((part) => part !== '').join('; ')}.`;
}

/** So many images are named. */
const MOST_NAMES = 6;

function describeImages({ images }: BlockView, chosen: readonly number[]): string {
  const names = chosen.slice(0, MOST_NAMES).map((image) => images[image]?.name ?? '');
  return say('several-images', { images: chosen.length, names: [...names, ...(chosen.length > MOST_NAMES ? ['…'] : [])].join(', ') });
}

const GEOMETRIES = new WeakMap<ViewGeometry, string>();

/** What relates two views, in words; empty where nothing does. */
export function geometryText(geometry: ViewGeometry | null): string {
  if (geometry === null) return '';
  const { kind, degenerate, sigmaPx } = geometry;
  const weak = degenerate === null ? null : message('degeneracy', degenerate, 'short');
  const text = GEOMETRIES.get(geometry) ?? say('geometry', { model: message('two_view_model', { kind }, 'short'), weak, sigma_px: sigmaPx });
  GEOMETRIES.set(geometry, text);
  return text;
}

function describePair(view: BlockView, images: readonly [number, number]): string {
  const names = nameOfPair(view, images);
  const connection = connectionOf(view, images);
  if (connection === undefined) return say('this-pair-was-not-tried', { names });
  const { geometry, shared, chosen } = connection;
  const parts = [outcomeText(connection).replace(/\.$/u, ''), geometryText(geometry), shared > 0 ? say('common-points-selected', { shared, chosen }) : ''];
  return `${asFigure(names)}: ${parts.filter((part) => part !== '').join('; ')}.`;
}

/** Both images of a pair by their names. */
export function nameOfPair({ images }: BlockView, pair: readonly [number, number]): string {
  return pair.map((image) => images[image]?.name ?? '').join(' – ');
}

function describePairs(view: BlockView, pairs: readonly (readonly [number, number])[]): string {
  const names = pairs.slice(0, MOST_NAMES).map((pair) => nameOfPair(view, pair));
  return say('several-pairs', { pairs: pairs.length, names: [...names, ...(pairs.length > MOST_NAMES ? ['…'] : [])].join(', ') });
}

/** As tables and views call it: of a surveyed point its name. */
export function nameOfPoint(view: BlockView, point: number): string {
  return surveyedAt(view, point)?.name ?? say('point-of-number', { number: view.points.numbers[point] ?? 0 });
}

function describePoint(view: BlockView, point: number): string {
  const { points } = view;
  const axes = [0, 1, 2].map((axis) => 3 * point + axis);
  const [x = NaN, y = NaN, z = NaN] = axes.map((at) => points.positions[at]);
  const errors = axes.map((at) => points.errors[at] ?? NaN);
  const parts = [
    say('rays-3', { name: nameOfPoint(view, point), rays: points.rays[point] ?? 0 }),
    known(points.rmsePx[point]) ? say('rmse-px-3', { rmse_px: points.rmsePx[point] ?? NaN }) : '',
    known(points.positions[3 * point]) ? coordinatesText(view, [x, y, z], 2) : say('not-intersected'),
    errors.every(known) ? inUnitOf(view, `± ${errors.map((error) => fixed(error, 3)).join(' ')}`) : '',
    point < points.taking ? '' : say(points.lost.has(point) ? 'too-few-rays' : 'rejected-by-hand-2'),
  ];
  return `${parts.filter((part) => part !== '').join('; ')}.`;
}

/** A point that was given and is not in the block. */
function describeGiven(view: BlockView, given: readonly ViewGiven[], name: string): string {
  const point = given.find((own) => own.name === name);
  if (point === undefined) return name;
  const place = point.place === null ? point.position : resultSystem(view).coordinates(Float64Array.from(point.place));
  const said = { name, place: Array.from(place, (value) => fixed(value, 3)).join(' '), use: givenUse(point) };
  return point.place === null ? say('given-point-of-file', said) : say('given-point', said);
}

/** Why control points take no part, and what they lack. */
export function controlText(state: WithMarks): string {
  const { twice, needed } = collectedOf(state);
  return say('control-waits', { twice, needed });
}

/** What a given point is for, and how far it is. */
export function givenUse({ role, images }: ViewGiven): string {
  return say('given-use', { role: role ?? 'none', images });
}

function describePoints(view: BlockView, chosen: Uint32Array): string {
  const { points } = view;
  let [least, most, squares, adjusted] = [Infinity, 0, 0, 0];
  for (const point of chosen) {
    const rays = points.rays[point] ?? 0;
    [least, most] = [Math.min(least, rays), Math.max(most, rays)];
    const rmse = points.rmsePx[point] ?? NaN;
    if (!known(rmse)) continue;
    squares += rays * rmse * rmse;
    adjusted += rays;
  }
  const gone = chosen.length - chosen.filter((point) => point < points.taking || points.lost.has(point)).length;
  const rays = least === most ? count(most) : say('to', { least, most });
  return say('tie-points-of-rays', {
    chosen: chosen.length,
    surveyed: chosen.filter((point) => surveyedAt(view, point) !== undefined).length,
    rays,
    what: adjusted > 0 ? say('rmse-px-5', { squares: Math.sqrt(squares / adjusted) }) : '',
    what_2: gone > 0 ? say('rejected-by-hand-3', { gone }) : '',
  });
}

function known(value: number | undefined): boolean {
  return value !== undefined && !Number.isNaN(value);
}
