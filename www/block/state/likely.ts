/** Which images are looked at for a point, where nothing says in which of them it lies. Pure. */
import { MOST_PANES } from './panes';
import type { BlockView } from './view';
import { matchesOf } from './words';

/** All images: those that have most matches with one of them first, behind it; without one as they are. */
export function likeliest({ images, connections }: Pick<BlockView, 'images' | 'connections'>, near: number | undefined): readonly number[] {
  const all = images.map((_, image) => image);
  if (near === undefined) return all;
  const matches = new Map<number, number>([[near, Infinity]]);
  for (const connection of connections) {
    const [a, b] = connection.images;
    if (a === near || b === near) matches.set(a === near ? b : a, matchesOf(connection));
  }
  return all.sort((a, b) => (matches.get(b) ?? 0) - (matches.get(a) ?? 0) || a - b);
}

/** The next images of an order in place of those that are shown, or the ones before. Those of `kept` stay; where all do, one more is shown. */
export function turned(shown: readonly number[], order: readonly number[], kept: ReadonlySet<number>, by: 1 | -1): readonly number[] {
  const stay = shown.filter((image) => kept.has(image));
  const others = order.filter((image) => !stay.includes(image));
  const free = Math.min(Math.max(1, shown.length - stay.length), MOST_PANES - stay.length, others.length);
  const places = shown.map((image) => others.indexOf(image)).filter((place) => place >= 0);
  const first = by > 0 ? Math.max(-1, ...places) + 1 : Math.min(others.length, ...places) - free;
  const next = Array.from({ length: free }, (_, i) => others[(((first + i) % others.length) + others.length) % others.length] ?? 0);
  return [...stay, ...next];
}
