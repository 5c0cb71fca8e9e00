/** The texts of one language, as its catalogues have them (Project Fluent). */
import { FluentBundle, FluentNumber, FluentResource } from '@fluent/bundle';
import type { FluentFunction, FluentVariable } from '@fluent/bundle';
import { count, fixed, plain } from './format';

/** What a text writes; null where there is nothing to write. */
export type Figures = Readonly<Record<string, number | string | boolean | null | undefined>>;

/** A number that is written with all of its digits, and chooses among plurals. */
class Figure extends FluentNumber {
  override toString(): string {
    return plain(this.value);
  }
}

/** A function of the catalogues; a dash where there is no number, as those of the crate write it. */
const written =
  (write: (value: number, digits: number) => string): FluentFunction =>
  ([figure], { digits }) =>
    figure instanceof FluentNumber ? write(figure.value, digits instanceof FluentNumber ? digits.value : 0) : '–';

const FUNCTIONS = { COUNT: written((value) => count(value)), FIXED: written(fixed) };

export class Catalogue {
  private readonly bundle: FluentBundle;
  /** Each text as it is written. It is read when it is first said: all of them would take longer than the rest of the start. */
  private readonly unread = new Map<string, string>();

  /** `isolating`: marks of direction set apart what a text writes, as names and numbers with their signs among words from right to left. */
  constructor(language: string, isolating: boolean) {
    this.bundle = new FluentBundle(language, { useIsolating: isolating, functions: FUNCTIONS });
  }

  /** Takes the texts of files into it. */
  add(files: readonly string[]): void {
    for (const file of files) for (const entry of file.split(/\n(?=[a-z])/u)) this.unread.set(entry.slice(0, entry.indexOf(' ')), entry);
  }

  /** The text of a name, or what belongs to it by another; null where there is none. Numbers that are not finite are none. */
  text(name: string, figures: Figures = {}, attribute: string | null = null): string | null {
    this.read(name);
    const message = this.bundle.getMessage(name);
    const pattern = (attribute === null ? message?.value : message?.attributes[attribute]) ?? null;
    if (pattern === null) return null;
    return this.bundle.formatPattern(pattern, Object.fromEntries(Object.entries(figures).map(([key, value]) => [key, figureOf(value)])), []);
  }

  private read(name: string): void {
    const entry = this.unread.get(name);
    if (entry === undefined) return;
    this.unread.delete(name);
    this.bundle.addResource(new FluentResource(entry));
    // Texts that stand in it.
    for (const [, other = ''] of entry.matchAll(/\{ ([a-z][a-z0-9-]*) \}/gu)) this.read(other);
  }
}

function figureOf(value: Figures[string]): FluentVariable {
  if (value === null || value === undefined) return 'none';
  if (typeof value === 'number') return Number.isFinite(value) ? new Figure(value) : 'none';
  return String(value);
}
