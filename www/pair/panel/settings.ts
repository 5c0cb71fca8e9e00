/** Reading and changing one setting by its key, `group.field`. */
import type { Settings } from '../../shared/crate';
import type { Value } from '../../shared/panel/control';

type Group = Record<string, Value | undefined>;

function groupOf(settings: Settings, key: string): [string, string, Group] {
  const [group = '', field = ''] = key.split('.');
  const found = new Map<string, object>(Object.entries(settings)).get(group);
  if (found === undefined) throw new Error(`there is no setting ${key}`);
  return [group, field, found as Group];
}

/** The value of a setting; null where the operator's own default is to be taken. */
export function readSetting(settings: Settings, key: string): Value {
  const [, field, group] = groupOf(settings, key);
  return group[field] ?? null;
}

/** A threshold and a fraction of candidates exclude each other: setting one clears the other. */
const EXCLUSIVE: Readonly<Record<string, string>> = { threshold: 'fraction', fraction: 'threshold' };

/** The settings with one value changed. */
export function withSetting(settings: Settings, key: string, value: Value): Settings {
  const [group, field, before] = groupOf(settings, key);
  const other = value === null ? undefined : EXCLUSIVE[field];
  return { ...settings, [group]: { ...before, ...(other === undefined ? {} : { [other]: null }), [field]: value } };
}
