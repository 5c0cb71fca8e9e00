/** Settings of one's own as a file: what differs from the defaults, and nothing else. */
import type { Parameter } from '../crate';
import type { Value } from './control';
import { readSetting, withSetting } from './settings';
import { fieldsOf, OWN_SETTINGS } from '../files/json';
import { say } from '../text/words';

/** What the settings are of. */
export type Subject = 'pair' | 'block';

interface OwnSettings {
  [OWN_SETTINGS]: Subject;
  changed: Readonly<Record<string, Value>>;
}

/** The file of settings. */
export function writeOwn(of: Subject, parameters: readonly Parameter[], defaults: object, settings: object): string {
  const own = parameters.map(({ key }) => [key, readSetting(settings, key)] as const).filter(([key, value]) => readSetting(defaults, key) !== value);
  return `${JSON.stringify({ [OWN_SETTINGS]: of, changed: Object.fromEntries(own) } satisfies OwnSettings, null, 2)}\n`;
}

/** The settings of a file: the defaults with what it changes. @throws Error where the file holds none of this kind, or a value that is not allowed */
export function readOwn<T extends object>(text: string, of: Subject, parameters: readonly Parameter[], defaults: T): T {
  const { [OWN_SETTINGS]: subject, changed } = fieldsOf(text);
  if (typeof changed !== 'object' || changed === null || Array.isArray(changed)) throw new Error(say('the-file-holds-no-settings'));
  if (subject !== of) throw new Error(say('the-file-holds-settings-of', { subject: String(subject), of }));
  return Object.entries(changed as Record<string, unknown>).reduce<T>((settings, [key, value]) => {
    const parameter = parameters.find((one) => one.key === key);
    if (parameter === undefined) throw new Error(say('there-is-no-setting', { key }));
    if (!isAllowed(parameter, value, readSetting(defaults, key) === null))
      throw new Error(say('is-not-allowed', { label: parameter.label, value: JSON.stringify(value) }));
    return withSetting(settings, key, value as Value);
  }, defaults);
}

/** By what the crate says of the parameter. `optional`: whether it may be absent. */
function isAllowed(parameter: Parameter, value: unknown, optional: boolean): boolean {
  if (value === null) return optional;
  switch (parameter.kind) {
    case 'flag':
      return typeof value === 'boolean';
    case 'choice':
      return typeof value === 'string' && parameter.values.includes(value);
    default: {
      if (!('min' in parameter)) return typeof value === 'string';
      if (typeof value !== 'number' || !(value >= parameter.min && value <= parameter.max)) return false;
      return parameter.kind === 'real' || (Number.isInteger(value) && (!parameter.odd || value % 2 !== 0));
    }
  }
}
