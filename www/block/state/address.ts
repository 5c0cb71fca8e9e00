/** The view and what is chosen in it, as the address of the page names them: `#view=map&point=12`. Images by their names, points by their numbers. */
import { remember } from '../../shared/state/remember';
import { choiceOfImages, choiceOfPairs, choiceOfPoints, pointsOf } from './selection';
import type { Choice } from './selection';
import type { BlockState, ViewName } from './state';
import type { BlockView } from './view';

const VIEWS: readonly ViewName[] = ['map', 'matrix', 'images', 'plots', 'orthophoto'];

/** An address names no more points than these: a brush over all would make it longer than programs take. */
const MOST_POINTS = 100;
const MOST_IMAGES = 50;
const MOST_PAIRS = 25;

const places = remember((numbers: Uint32Array): ReadonlyMap<number, number> => new Map([...numbers].map((number, point) => [number, point])));

/** What follows the `#`; empty where no block is shown. */
export function addressOf({ shown, onStage, selection: { chosen } }: Pick<BlockState, 'shown' | 'onStage' | 'selection'>): string {
  if (shown === null) return '';
  const named = new URLSearchParams({ view: onStage });
  const name = (image: number) => shown.view.images[image]?.name ?? '';
  const { numbers } = shown.view.points;
  // Several observations are no choice of their points: what is done to these would be done to all of each.
  const points = chosen?.kind === 'observations' ? new Uint32Array() : pointsOf(chosen);
  if (points.length > 0 && points.length <= MOST_POINTS) named.set('point', [...points].map((point) => String(numbers[point] ?? 0)).join(','));
  if (chosen?.kind === 'image' || chosen?.kind === 'observation') named.append('image', name(chosen.image));
  if (chosen?.kind === 'images' && chosen.images.length <= MOST_IMAGES) for (const image of chosen.images) named.append('images', name(image));
  if (chosen?.kind === 'pair') for (const image of chosen.images) named.append('image', name(image));
  // One image after the other, two by two.
  if (chosen?.kind === 'pairs' && chosen.pairs.length <= MOST_PAIRS) for (const image of chosen.pairs.flat()) named.append('pairs', name(image));
  return named.toString();
}

const PAIR = 'pair';

/** The same of a pair of the block, which the pair's part of the page shows. */
export function addressOfPair({ images }: BlockView, pair: readonly [number, number]): string {
  const named = new URLSearchParams({ view: PAIR });
  for (const image of pair) named.append('image', images[image]?.name ?? '');
  return named.toString();
}

/** Whether two addresses are pages of their own, with their view or their pair, whatever is chosen there. Other photos, which have no address, take the place of a pair. */
export function isOtherPage(address: string, other: string): boolean {
  const [a, b] = [address, other].map((one) => {
    const named = new URLSearchParams(one.replace(/^#/u, ''));
    const view = named.get('view') ?? '';
    return [view, ...(view === PAIR ? named.getAll('image') : [])];
  });
  const views = [a?.[0], b?.[0]];
  if (views.includes('') && views.includes(PAIR)) return false;
  return String(a) !== String(b);
}

/** The view that an address asks for, whatever block it is of. */
export function viewNamed(address: string): ViewName | undefined {
  const named = new URLSearchParams(address.replace(/^#/u, ''));
  return VIEWS.find((name) => name === named.get('view'));
}

/** The pair of the block that an address asks for; null where it asks for none, or the block does not have both images. */
export function askedPair(address: string, view: BlockView): [number, number] | null {
  const named = new URLSearchParams(address.replace(/^#/u, ''));
  const [a = -1, b = -1] = named.getAll('image').map((name) => view.images.findIndex((image) => image.name === name));
  return named.get('view') !== PAIR || a < 0 || b < 0 || a === b ? null : [a, b];
}

/** What an address asks for; null where it asks for no view of a block. What the block does not have is not chosen. */
export function asked(address: string, view: BlockView): { view: ViewName; choice: Choice | null } | null {
  const wanted = viewNamed(address);
  if (wanted === undefined) return null;
  const named = new URLSearchParams(address.replace(/^#/u, ''));
  const indexOf = (name: string) => view.images.findIndex((image) => image.name === name);
  const images = named.getAll('image').map(indexOf);
  const several = named
    .getAll('images')
    .map(indexOf)
    .filter((image) => image >= 0);
  const ofPairs = named.getAll('pairs').map(indexOf);
  const pairs = ofPairs.flatMap((a, at) => (at % 2 === 0 ? [[a, ofPairs[at + 1] ?? -1] as const] : [])).filter((pair) => !pair.includes(-1));
  const points = (named.get('point') ?? '')
    .split(',')
    .map((number) => places(view.points.numbers).get(Number(number)) ?? -1)
    .filter((point) => point >= 0);
  if (pairs.length > 0) return { view: wanted, choice: choiceOfPairs(pairs) };
  return { view: wanted, choice: several.length > 0 ? choiceOfImages(several) : choiceOf(images, points) };
}

function choiceOf(images: readonly number[], points: readonly number[]): Choice | null {
  const [image, other] = images;
  const [point] = points;
  if (images.includes(-1)) return null;
  if (point !== undefined && image !== undefined) return { kind: 'observation', point, image };
  if (point !== undefined) return choiceOfPoints(points);
  if (image === undefined) return null;
  return other === undefined ? { kind: 'image', image } : { kind: 'pair', images: [image, other] };
}
