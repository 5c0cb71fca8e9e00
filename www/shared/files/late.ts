/** What is kept of a part of the page that is loaded when it is first needed. */
import type { Mode } from '../state/mode';
import type { Kept } from './database';
import type { Keepable } from './keepable';

export class LateKeepable implements Keepable {
  private part: Keepable | null = null;
  private changed: (() => void) | null = null;

  /** `mode`: the part of the page, which the names of its parts begin with; `load` has the part `arrive`. */
  constructor(
    readonly mode: Mode,
    private readonly load: () => Promise<unknown>,
  ) {}

  arrive(part: Keepable): void {
    this.part = part;
    if (this.changed !== null) part.watch(this.changed);
  }

  watch(changed: () => void): void {
    this.changed = changed;
    this.part?.watch(changed);
  }

  settled(): Promise<void> {
    return this.part?.settled?.() ?? Promise.resolve();
  }

  parts(): ReadonlyMap<string, Kept> {
    return this.part?.parts() ?? new Map();
  }

  images(): readonly string[] {
    return this.part?.images() ?? [];
  }

  async read(parts: ReadonlyMap<string, unknown>, looks: boolean): Promise<() => void> {
    if ([...parts.keys()].some((name) => name.startsWith(this.mode))) await this.load();
    return (await this.part?.read(parts, looks)) ?? (() => undefined);
  }

  clear(): void {
    this.part?.clear();
  }
}
