/** What of a part of the page is kept in the browser's storage, and shown again. */
import type { Mode } from '../state/mode';
import type { Kept } from './database';
import { say } from '../text/words';

export interface Keepable {
  /** The part of the page. */
  mode: Mode;
  /** Calls back whenever something that is kept has changed. */
  watch: (changed: () => void) => void;
  /** Resolves when `parts` has all that there is, as far as it can be made now. */
  settled?: () => Promise<void>;
  /** All that is kept, by names that begin with the part's own. What has not changed is the same value as before. Empty where there is nothing. */
  parts: () => ReadonlyMap<string, Kept>;
  /** The names of its images. */
  images: () => readonly string[];
  /** Reads what was kept; rejects, with nothing changed, where it cannot be read. What it gives shows it, in place of nothing. `looks`: it is another tab's. */
  read: (parts: ReadonlyMap<string, unknown>, looks: boolean) => Promise<() => void>;
  /** Forgets all of it on the page. */
  clear: () => void;
}

const names = new WeakMap<object, string>();

/** A name of a value for its part of a project: the same as long as it is the same object. `kept`: the name that it has in the storage. */
export function nameOf(value: object, kept?: string): string {
  const name = names.get(value) ?? kept ?? randomName();
  names.set(value, name);
  return name;
}

/** No two are the same, on plain http too. */
export function randomName(): string {
  return Array.from(crypto.getRandomValues(new Uint8Array(12)), (byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** A field of what was kept is not as it should be. */
function wrong(name: string): Error {
  return new Error(say('the-field-is-damaged', { name }));
}

/** A kept object. @throws Error where it is none */
export function objectOf(value: unknown, name: string): Record<string, unknown> {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) throw wrong(name);
  return value as Record<string, unknown>;
}

/** A kept value of one of the types of `like`. @throws Error where it is of another */
export function likeOf<T extends string | number | boolean>(value: unknown, like: T, name: string): T {
  if (typeof value !== typeof like || (typeof value === 'number' && Number.isNaN(value))) throw wrong(name);
  return value as T;
}

/** @throws Error where it is no list, or one of its elements is not as `element` reads it */
export function listOf<T>(value: unknown, name: string, element: (value: unknown, name: string) => T): T[] {
  if (!Array.isArray(value)) throw wrong(name);
  return value.map((one, i) => element(one, `${name}[${String(i)}]`));
}

/** Two numbers. @throws Error where it is something else */
export function positionFrom(value: unknown, name: string): [number, number] {
  const [x, y, ...more] = listOf(value, name, (number, at) => likeOf(number, 0, at));
  if (x === undefined || y === undefined || more.length > 0) throw wrong(name);
  return [x, y];
}

/** Null stays null. */
export function orNull<V, T>(value: V, read: (value: NonNullable<V>) => T): T | null {
  return value == null ? null : read(value);
}

/**
 * The values of a kept object in the shape of another: fields that a later version added have their default, fields that it dropped are left
 * out. Where the default is null, or is a list, what was kept stands. @throws Error where a field is of another type
 */
export function fitted<T extends object>(value: unknown, defaults: T, name: string): T {
  const kept = objectOf(value, name);
  const fields = Object.entries(defaults as Record<string, unknown>).map(([field, normal]) => {
    const own = kept[field];
    const path = `${name}.${field}`;
    if (own === undefined) return [field, normal];
    if (own === null || normal === null || Array.isArray(normal)) return [field, own];
    if (typeof normal === 'object') return [field, fitted(own, normal, path)];
    return [field, likeOf(own, normal as string, path)];
  });
  return Object.fromEntries(fields) as T;
}
