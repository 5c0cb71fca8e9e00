/** Reading and changing one setting by its key, `group.field`. */
import type { Value } from './control';

type Group = Record<string, unknown>;

/** The path of a key: groups of features lie a step deeper in a block's settings, and a group that stands alone has its fields at the top. */
function pathOf(settings: object, key: string): string[] {
  const [group = '', field = ''] = key.split('.');
  if (group in settings) return [group, field];
  // A flight has a number of features, and no groups.
  return typeof (settings as Group).features === 'object' ? ['features', group, field] : [field];
}

/** The value of a setting; null where it is absent. */
export function readSetting(settings: object, key: string): Value {
  const found = pathOf(settings, key).reduce<unknown>((at, name) => (at as Group | undefined)?.[name], settings);
  return (found ?? null) as Value;
}

/** The settings with one value changed. */
export function withSetting<T extends object>(settings: T, key: string, value: Value): T {
  return changed(settings, pathOf(settings, key), value) as T;
}

function changed(at: object, [name = '', ...rest]: string[], value: Value): object {
  const inside = (at as Record<string, object | undefined>)[name] ?? {};
  return { ...at, [name]: rest.length === 0 ? value : changed(inside, rest, value) };
}
