/** What of the project of this tab stands in the browser's storage; what is other on the page is written. */
import { type Database, KeepError } from './database';
import type { Kept, ProjectRow } from './database';
import type { Keepable } from './keepable';

/** So much of files is written in one go. */
const PORTION_BYTES = 32e6;

export class Written {
  /** By the names of the parts. */
  private parts = new Map<string, unknown>();
  /** The part of the page that was shown. */
  mode = '';
  /** Nothing of the project is in the storage yet. */
  isNew = true;
  /** It was in the storage, was deleted there by others, and is not whole there again. */
  isGone = false;
  /** It is to be made sure of that the project is there and names this tab as its writer, in place of this one. */
  private former: string | null = null;

  constructor(private readonly keepables: readonly Keepable[]) {}

  /** Of a project of which nothing is kept yet. */
  begin(): void {
    this.isNew = true;
    this.isGone = false;
    this.former = null;
    this.parts = new Map();
  }

  /** Of a project that was read. `former`: the writer that the storage still names, in place of this tab. */
  opened(parts: ReadonlyMap<string, unknown>, former: string | null): void {
    this.isNew = false;
    this.isGone = false;
    this.former = former;
    this.parts = new Map(parts);
  }

  /** What was read is shown, as objects of the page's own: these stand in the storage as long as they are not changed. */
  shown(): void {
    for (const [part, { value }] of this.present()) if (this.parts.has(part)) this.parts.set(part, value);
  }

  /** Of a project that is no longer in the storage: all of it is to be written. */
  gone(): void {
    this.begin();
    this.isGone = true;
  }

  /** The storage was closed, and may be empty. `writer`: this tab. */
  doubt(writer: string): void {
    if (!this.isNew) this.former ??= writer;
  }

  get isInDoubt(): boolean {
    return this.former !== null;
  }

  /** Makes sure that the project is in the storage, and that this tab may write it. @throws KeepError where it is not so */
  async ensure(database: Database, id: string, writer: string): Promise<void> {
    if (this.former === null) return;
    await database.claim(id, writer, this.former);
    this.former = null;
  }

  /** These are no longer in the project. */
  forget(parts: readonly string[]): void {
    for (const gone of parts) this.parts.delete(gone);
  }

  /** All parts of the project on the page. */
  private present(): Map<string, Kept> {
    return new Map(this.keepables.flatMap((keepable) => [...keepable.parts()]));
  }

  /** What is other than in the storage. */
  changes(): { put: Map<string, Kept>; drop: string[] } {
    const parts = this.present();
    const put = new Map([...parts].filter(([part, { value }]) => !this.parts.has(part) || this.parts.get(part) !== value));
    return { put, drop: [...this.parts.keys()].filter((part) => !parts.has(part)) };
  }

  /** Whether the user changed something since it was written last. */
  isChanged(): boolean {
    const { put, drop } = this.changes();
    // What the page makes again by itself is no change of the user's.
    return drop.length > 0 || [...put.values()].some(({ again }) => again !== true);
  }

  /** Files go first, in portions; what names them goes last, all at once. Where there is no room for all, what can be made again is left out. */
  async write(database: Database, row: ProjectRow, put: ReadonlyMap<string, Kept>, drop: readonly string[]): Promise<void> {
    const write = async (some: ReadonlyMap<string, Kept>, gone: readonly string[]) => {
      await database.write(row, { put: some, drop: gone }, this.isNew);
      this.isNew = false;
      for (const [part, { value }] of some) this.parts.set(part, value);
      for (const part of gone) this.parts.delete(part);
    };
    for (const portion of portionsOf(put)) await write(portion, []);
    const rest = new Map([...put].filter(([part]) => this.parts.get(part) !== put.get(part)?.value || !this.parts.has(part)));
    try {
      await write(rest, drop);
    } catch (error) {
      const needed = new Map([...rest].filter(([, { again }]) => again !== true));
      if (!(error instanceof KeepError) || error.kind !== 'full' || needed.size === rest.size) throw error;
      await write(needed, drop);
      this.isGone = false;
      throw error;
    }
    this.isGone = false;
  }
}

/** Files that may be written before the rest, in portions that take a moment each. */
function portionsOf(put: ReadonlyMap<string, Kept>): Map<string, Kept>[] {
  const portions: Map<string, Kept>[] = [];
  let room = 0;
  for (const [part, kept] of put) {
    if (kept.alone !== true) continue;
    if (room < kept.bytes) {
      portions.push(new Map());
      room = PORTION_BYTES;
    }
    portions.at(-1)?.set(part, kept);
    room -= kept.bytes;
  }
  return portions;
}
