/** What the page says of an image or a pair of a block. */
import { count, fixed } from '../../shared/text/format';
import type { Choice } from './state';
import type { BlockView, ViewConnection } from './view';

/** The connection of two images; undefined where they were not tried. */
export function connectionOf(view: BlockView, [a, b]: readonly [number, number]): ViewConnection | undefined {
  return connectionsOf(view).get(pairKey(a, b));
}

function pairKey(a: number, b: number): string {
  return a < b ? `${String(a)},${String(b)}` : `${String(b)},${String(a)}`;
}

const CONNECTIONS = new WeakMap<BlockView, ReadonlyMap<string, ViewConnection>>();

/** All connections by their images. */
export function connectionsOf(view: BlockView): ReadonlyMap<string, ViewConnection> {
  const known = CONNECTIONS.get(view);
  if (known !== undefined) return known;
  const made = new Map(view.connections.map((connection) => [pairKey(...connection.images), connection]));
  CONNECTIONS.set(view, made);
  return made;
}

export function matchesOf({ outcome }: ViewConnection): number {
  return outcome.kind === 'connected' ? outcome.matches : 0;
}

export function describe(view: BlockView, choice: Choice): string {
  return choice.kind === 'image' ? describeImage(view, choice.image) : describePair(view, choice.images);
}

function describeImage(view: BlockView, index: number): string {
  const image = view.images[index];
  if (image === undefined) return '';
  const partners = view.connections.filter(({ images, outcome }) => images.includes(index) && outcome.kind === 'connected').length;
  const parts = [
    `${image.name}: ${image.features === null ? '' : `${count(image.features)} features, `}${count(image.rays)} observations${image.places === null ? '' : ` in ${String(image.places)} of 9 von Gruber positions`}`,
    `connected with ${count(partners)} of ${count(view.images.length - 1)} images`,
    image.rmsePx === null ? '' : `RMSE ${fixed(image.rmsePx, 2)} px`,
    image.oriented ? 'oriented' : image.why,
    // 1 is the usual one.
    image.exifOrientation === null || image.exifOrientation === 1 ? '' : `used as stored, EXIF orientation ${String(image.exifOrientation)}`,
  ];
  return `${parts.filter((part) => part !== '').join('; ')}.`;
}

function describePair(view: BlockView, images: readonly [number, number]): string {
  const names = images.map((image) => view.images[image]?.name ?? '').join(' – ');
  const connection = connectionOf(view, images);
  if (connection === undefined) return `${names}: this pair was not tried (the choice of pairs skips it).`;
  const { reason, geometry, shared, chosen } = connection;
  const parts = [reason.replace(/\.$/u, ''), geometry, shared > 0 ? `${count(shared)} common points, ${count(chosen)} selected` : ''];
  return `${names}: ${parts.filter((part) => part !== '').join('; ')}.`;
}
