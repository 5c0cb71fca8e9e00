/** Where the images of a block are drawn: from above where their poses or recorded positions are known, else by who is connected with whom. */
import { local_positions } from '../../../pkg/wasm/tiepoint.js';
import type { ExifPosition } from '../../../pkg/wasm/tiepoint.js';
import type { Layout, ViewConnection } from '../state/view';

/** Steps of the arrangement by connections, times images squared: more take too long. */
const MOST_STEPS = 2e8;

/** Poses where any image has one, recorded positions where most have one, else connections. Images without a place stand beside their neighbours. */
export function layoutOf(
  centres: readonly (readonly number[] | null)[],
  recordings: readonly (ExifPosition | null)[],
  connections: readonly ViewConnection[],
): Layout {
  const oriented = centres.map((centre) => centre?.slice(0, 2) ?? null);
  if (oriented.some((place) => place !== null)) return { kind: 'oriented', places: completed(oriented, connections) };
  const recorded = recordedPlaces(recordings);
  if (2 * recorded.filter((place) => place !== null).length > centres.length) return { kind: 'recorded', places: completed(recorded, connections) };
  return { kind: 'connections', places: arranged(centres.length, connections) };
}

/** In m, east and north. */
function recordedPlaces(recordings: readonly (ExifPosition | null)[]): (number[] | null)[] {
  const geographic = recordings.flatMap((position) =>
    position === null ? [NaN, NaN, NaN] : [position.longitude_deg, position.latitude_deg, position.height_m ?? 0],
  );
  const local = local_positions(Float64Array.from(geographic));
  return recordings.map((_, i) => {
    const place = [...local.subarray(3 * i, 3 * i + 2)];
    return place.every(Number.isFinite) ? place : null;
  });
}

/** Gives each image without a place the mean of those it is connected with, or one outside of their extent, at the lower left. */
function completed(places: readonly (readonly number[] | null)[], connections: readonly ViewConnection[]): Float64Array {
  const step = usualStep(places);
  const means = meansOfNeighbours(places, connections);
  const taken = new Set(places.flatMap((place) => (place === null ? [] : [cellOf(place, step)])));
  // No image lies on another: a place is taken beside the one that is wanted.
  const found = places.map((place, i) => place ?? (means[i] == null ? null : freePlace(means[i], step, taken)));
  const apart = placesApart(found, step);
  return Float64Array.from(found.flatMap((place) => place ?? apart.next().value ?? [0, 0]));
}

/** About as far as images are from their neighbours, in the unit of the places. */
function usualStep(places: readonly (readonly number[] | null)[]): number {
  const { low, high, count } = extentOf(places);
  const span = Math.max(high[0] - low[0], high[1] - low[1]);
  return span > 0 ? span / Math.ceil(Math.sqrt(count)) : 1;
}

function extentOf(places: readonly (readonly number[] | null)[]): { low: [number, number]; high: [number, number]; count: number } {
  const low: [number, number] = [Infinity, Infinity];
  const high: [number, number] = [-Infinity, -Infinity];
  let count = 0;
  for (const place of places) {
    if (place === null) continue;
    count += 1;
    for (const axis of [0, 1] as const) {
      low[axis] = Math.min(low[axis], place[axis] ?? 0);
      high[axis] = Math.max(high[axis], place[axis] ?? 0);
    }
  }
  return { low, high, count };
}

/** Of each image the mean of the places of those it is connected with; null where none of them has one. */
function meansOfNeighbours(places: readonly (readonly number[] | null)[], connections: readonly ViewConnection[]): ([number, number] | null)[] {
  const sums = places.map(() => ({ x: 0, y: 0, count: 0 }));
  for (const {
    images: [a, b],
    outcome,
  } of connections) {
    if (outcome.kind !== 'connected') continue;
    for (const [of, from] of [
      [a, b],
      [b, a],
    ] as const) {
      const [place, sum] = [places[from], sums[of]];
      if (place == null || sum === undefined) continue;
      sum.x += place[0] ?? 0;
      sum.y += place[1] ?? 0;
      sum.count += 1;
    }
  }
  return sums.map(({ x, y, count }) => (count === 0 ? null : [x / count, y / count]));
}

/** Cells of a third of the usual distance: two places in one of them would cover each other. */
const CELLS = 3;

const cellOf = ([x = 0, y = 0]: readonly number[], step: number) => `${String(Math.round((CELLS * x) / step))} ${String(Math.round((CELLS * y) / step))}`;

/** The first free place from the one that is wanted towards the lower left; it is taken from then on. */
function freePlace([x, y]: readonly [number, number], step: number, taken: Set<string>): [number, number] {
  let place: [number, number] = [x, y];
  for (let k = 1; taken.has(cellOf(place, step)); k++) place = [x - (k * step) / CELLS, y - (k * step) / CELLS];
  taken.add(cellOf(place, step));
  return place;
}

/** So many images without a place stand one below the other before another column of them begins. */
const LEAST_COLUMN = 4;

/** Places to the left of all that are known, from under their lower end downwards: beside it their names would cover each other. */
function* placesApart(known: readonly (readonly number[] | null)[], step: number): Generator<[number, number], never> {
  const { low } = extentOf(known);
  const rows = Math.max(LEAST_COLUMN, Math.ceil(Math.sqrt(known.filter((place) => place === null).length)));
  for (let k = 0; ; k++) yield [low[0] - (1 + Math.floor(k / rows)) * step, low[1] - (0.5 + (k % rows)) * step];
}

/**
 * Connected images attract, all repel each other (Fruchterman & Reingold 1991, Software: Practice and Experience 21), from a circle: the
 * same connections give the same picture.
 */
function arranged(count: number, connections: readonly ViewConnection[]): Float64Array {
  const places = Float64Array.from({ length: 2 * count }, (_, i) => {
    const angle = (2 * Math.PI * Math.floor(i / 2)) / Math.max(1, count);
    return (i % 2 === 0 ? Math.cos(angle) : Math.sin(angle)) * Math.sqrt(count);
  });
  const edges = connections.filter(({ outcome }) => outcome.kind === 'connected');
  const rounds = Math.min(300, Math.floor(MOST_STEPS / (count * count + edges.length + 1)));
  const moves = new Float64Array(2 * count);
  for (let round = 0; round < rounds; round++) {
    moves.fill(0);
    for (let a = 0; a < count; a++) for (let b = a + 1; b < count; b++) push(places, moves, a, b, (d) => 1 / Math.max(d, 1e-3));
    for (const {
      images: [a, b],
      shared,
      outcome,
    } of edges) {
      const strength = Math.min(1, Math.max(shared, 'matches' in outcome ? outcome.matches : 0) / 200);
      push(places, moves, a, b, (d) => -strength * d * d);
    }
    const heat = 0.3 * Math.sqrt(count) * (1 - round / rounds);
    for (let i = 0; i < count; i++) {
      const [x = 0, y = 0] = moves.subarray(2 * i, 2 * i + 2);
      const share = Math.min(1, heat / Math.max(Math.hypot(x, y), 1e-9));
      places[2 * i] = (places[2 * i] ?? 0) + share * x;
      places[2 * i + 1] = (places[2 * i + 1] ?? 0) + share * y;
    }
  }
  return places;
}

/** Adds the force between two images to the moves of both. */
function push(places: Float64Array, moves: Float64Array, a: number, b: number, force: (distance: number) => number): void {
  const x = (places[2 * a] ?? 0) - (places[2 * b] ?? 0);
  const y = (places[2 * a + 1] ?? 0) - (places[2 * b + 1] ?? 0);
  const distance = Math.hypot(x, y);
  const by = force(distance) / Math.max(distance, 1e-3);
  moves[2 * a] = (moves[2 * a] ?? 0) + by * x;
  moves[2 * a + 1] = (moves[2 * a + 1] ?? 0) + by * y;
  moves[2 * b] = (moves[2 * b] ?? 0) - by * x;
  moves[2 * b + 1] = (moves[2 * b + 1] ?? 0) - by * y;
}
