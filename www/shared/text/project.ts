/** What a project is called. */
import { say } from './words';

/** Called after its images, unless it was given a name. */
export function titleOf({ name, images }: { name: string | null; images: readonly string[] }): string {
  if (name !== null) return name;
  const [first, second] = images;
  if (first === undefined) return say('without-images');
  if (second === undefined) return first;
  return images.length === 2 ? say('two-names', { first, second }) : say('and-more-images', { first, images: images.length - 1 });
}

/** Bytes as a size in MB, or kB where there are few. */
export function sizeText(bytes: number): string {
  if (bytes < 1e6) return say('kb', { bytes: Math.ceil(bytes / 1e3) });
  if (bytes < 1e9) return `${(bytes / 1e6).toFixed(1)} MB`;
  return `${(bytes / 1e9).toFixed(1)} GB`;
}
