/** Messages of the crate as the page writes them: parameters by their labels, a multiplication sign between the sides of an image. */
import type { Catalogue } from '../crate';
import { say } from './words';

/** What is no parameter of the crate's catalogue, but named in its messages. */
const OTHER: Readonly<Record<string, string>> = {
  'camera.focal_mm': say('focal-length'),
  'camera.pixel_mm': say('pixel-size'),
  'camera.principal_point_mm': say('principal-point'),
  'camera.radial_distortion': say('radial-distortion'),
  'camera.tangential_distortion': say('tangential-distortion'),
  focal_mm: say('focal-length'),
  origin: say('origin-in-the-scan-2'),
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
