/** Messages of the crate as the page writes them: parameters by their labels, a multiplication sign between the sides of an image. */
import type { Catalogue } from '../crate';

/** What is no parameter of the crate's catalogue, but named in its messages. */
const OTHER: Readonly<Record<string, string>> = {
  'camera.focal_mm': 'Focal length',
  'camera.pixel_mm': 'Pixel size',
  'camera.principal_point_mm': 'Principal point',
  'camera.radial_distortion': 'Radial distortion',
  'camera.tangential_distortion': 'Tangential distortion',
  focal_mm: 'Focal length',
  origin: 'Origin in the scan',
};

/** Parameters by whose labels their keys are replaced. */
export type Labels = Pick<Catalogue, 'parameters' | 'flightParameters'>;

/** A message with the labels of the parameters that it names by their keys. */
export function readable(catalogue: Labels | null, message: string): string {
  const labels = new Map(Object.entries(OTHER));
  for (const { key, label } of [...(catalogue?.parameters ?? []), ...(catalogue?.flightParameters ?? [])]) labels.set(key, label);
  return (
    message
      .replace(/[a-z]+\.[a-z0-9_]+/gu, (key) => quoted(labels.get(key)) ?? key)
      // Names of one word are words of sentences too: they are names where a message begins with them.
      .replace(/^(\w+)(?= is )/u, (key) => quoted(labels.get(key)) ?? key)
      .replace(/(\d) x (?=\d)/gu, '$1 × ')
  );
}

function quoted(label: string | undefined): string | undefined {
  return label === undefined ? undefined : `“${label}”`;
}
