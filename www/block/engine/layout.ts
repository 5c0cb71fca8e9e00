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

/** Gives each image without a place the mean of those it is connected with, or one at the lower left. */
function completed(places: readonly (number[] | null)[], connections: readonly ViewConnection[]): Float64Array {
  const known = places.filter((place) => place !== null);
  const least = [0, 1].map((axis) => known.reduce((low, place) => Math.min(low, place[axis] ?? 0), Infinity));
  const flat = new Float64Array(2 * places.length);
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
  places.forEach((place, i) => {
    const { x, y, count } = sums[i] ?? { x: 0, y: 0, count: 0 };
    flat.set(place ?? (count > 0 ? [x / count, y / count] : least), 2 * i);
  });
  return flat;
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
