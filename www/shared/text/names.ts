/** Messages of the crate as the page writes them: parameters by their labels, also where a message names the option of the command, a multiplication sign between the sides of an image. */
import { optionName } from '../../../pkg/block/option-name.js';
import type { Catalogue, Parameter } from '../crate';
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

/** Files that the page takes beside its settings, by the names of their options. */
const FILES: Readonly<Record<string, string>> = { geoid: say('geoid'), orthophoto: say('orthophoto') };

/** What stands between brackets and names an option. */
const IN_BRACKETS = /\(([^()]*--[a-z][^()]*)\)/gu;

/** An option, in a sentence from right to left with a mark of direction before it. */
const OPTION = /`?\u200f?--([a-z]+(?:-[a-z]+)*)`?/gu;

/** A key or an option. */
const NAME = /--[a-z]+(?:-[a-z]+)*|[a-z_]+\.[a-z0-9_]+/gu;

/** Parameters by whose labels their keys are replaced. */
export type Labels = Pick<Catalogue, 'parameters' | 'flightParameters'>;

/** A message with the labels of the parameters that it names by their keys. */
export function readable(catalogue: Labels | null, message: string): string {
  const labels = new Map(Object.entries(OTHER));
  for (const { key, label } of [...(catalogue?.parameters ?? []), ...(catalogue?.flightParameters ?? [])]) labels.set(key, label);
  return (
    withSettings(catalogue, message)
      .replace(/[a-z]+\.[a-z0-9_]+/gu, (key) => quoted(labels.get(key)) ?? key)
      // Names of one word are words of sentences too: they are names where a message begins with them.
      .replace(/^(\w+)(?= is )/u, (key) => quoted(labels.get(key)) ?? key)
      .replace(/(\d) x (?=\d)/gu, '$1 × ')
  );
}

/** A message with the labels of the settings whose options it names; options that are no settings of the page stay. */
function withSettings(catalogue: Labels | null, message: string): string {
  if (!message.includes('--')) return message;
  const labels = new Map(Object.entries(FILES));
  for (const parameter of catalogue?.parameters ?? []) labels.set(optionName(parameter), parameter.label);
  const labelled = (text: string) => text.replace(OPTION, (option, name: string) => quoted(labels.get(name)) ?? option);
  const inBrackets = (brackets: string, inner: string) => {
    const settings = labelled(inner);
    return settings === inner ? brackets : `(${say('named-settings', { settings })})`;
  };
  return labelled(message.replace(IN_BRACKETS, inBrackets));
}

/** The first of some parameters that a message names, by its key or its option, which say more than a label: several have the same. Null where it names none. */
export function firstNamed(parameters: readonly Parameter[], message: string): Parameter | null {
  const named = new Map(parameters.flatMap((parameter) => [parameter.key, `--${optionName(parameter)}`].map((name) => [name, parameter])));
  for (const [name] of message.matchAll(NAME)) {
    const parameter = named.get(name);
    if (parameter !== undefined) return parameter;
  }
  return null;
}

function quoted(label: string | undefined): string | undefined {
  return label === undefined ? undefined : `“${label}”`;
}
