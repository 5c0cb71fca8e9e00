/** The browser's own storage: projects, each kept in named parts. A change is one transaction: it is there whole, or not at all. */
import { openDB } from 'idb';
import type { DBSchema, IDBPDatabase, IDBPObjectStore } from 'idb';
import { say } from '../text/words';

const NAME = 'tiepoint';
/** Of the database itself; what projects look like inside has a number of its own (`FORM`). */
const VERSION = 1;
/** How projects are kept. A later form is refused, an earlier one is brought forward where it is read. */
export const FORM = 1;
/** Storage that does not answer in this time, in ms, counts as absent. */
const PATIENCE_MS = 5000;

/** What the list of projects shows of one. */
export interface ProjectRow {
  id: string;
  form: number;
  /** Given by the user; null where the project is called after its images. */
  name: string | null;
  images: readonly string[];
  /** The part of the page that it was shown by. */
  mode: string;
  /** In ms since 1970. */
  changed: number;
  /** The tab that may change it: any other one is refused. */
  writer: string;
}

interface PartRow {
  project: string;
  part: string;
  bytes: number;
  value: unknown;
}

interface Schema extends DBSchema {
  projects: { key: string; value: ProjectRow };
  parts: { key: [string, string]; value: PartRow; indexes: { sizes: [string, number] } };
}

/**
 * A part of a project and about how much room it takes. `again`: it can be made again, and is left out where there is no room. `alone`: its
 * name is its own for ever, so that it may be written before the parts that name it.
 */
export interface Kept {
  value: unknown;
  bytes: number;
  again?: boolean;
  alone?: boolean;
}

export interface Change {
  put: ReadonlyMap<string, Kept>;
  drop: readonly string[];
}

/** `full`: no room is left; `taken`: another tab has the project; `gone`: the project is no longer there. */
export type KeepFailure = 'full' | 'taken' | 'gone' | 'other';

export class KeepError extends Error {
  override readonly name = 'KeepError';
  constructor(
    readonly kind: KeepFailure,
    message: string,
  ) {
    super(message);
  }
}

/** All parts of a project, in the order of their names. */
const partsOf = (project: string) => IDBKeyRange.bound([project], [project, []]);

export class Database {
  private constructor(private readonly db: IDBPDatabase<Schema>) {}

  /** Rejects where the browser keeps nothing: in some private windows, where storage is blocked, or where a later version of the page wrote it. */
  static async open(): Promise<Database> {
    const opening = openDB<Schema>(NAME, VERSION, {
      upgrade: (db) => {
        db.createObjectStore('projects', { keyPath: 'id' });
        db.createObjectStore('parts', { keyPath: ['project', 'part'] }).createIndex('sizes', ['project', 'bytes']);
      },
      // A later version of the page in another tab goes first.
      blocking: (_, __, event) => (event.target as IDBDatabase).close(),
    });
    // An answer that came while the page was busy is heard first.
    const late = new Promise<never>((_, reject) => setTimeout(() => setTimeout(() => reject(new Error(say('the-storage-does-not-answer')))), PATIENCE_MS));
    return new Database(await Promise.race([opening, late]));
  }

  /** The one changed last comes first. */
  async projects(): Promise<ProjectRow[]> {
    const rows = await this.db.getAll('projects');
    return rows.sort((a, b) => b.changed - a.changed);
  }

  project(id: string): Promise<ProjectRow | undefined> {
    return this.db.get('projects', id);
  }

  async parts(id: string): Promise<Map<string, unknown>> {
    const rows = await this.db.getAll('parts', partsOf(id));
    return new Map(rows.map(({ part, value }) => [part, value]));
  }

  /** About how much room a project takes: no part is read for that. */
  async bytesOf(id: string): Promise<number> {
    let sum = 0;
    let cursor = await this.db
      .transaction('parts')
      .store.index('sizes')
      .openKeyCursor(IDBKeyRange.bound([id], [id, []]));
    while (cursor !== null) {
      sum += cursor.key[1];
      cursor = await cursor.continue();
    }
    return sum;
  }

  /** Writes what has changed of a project. `isNew`: it need not be there. @throws KeepError, with nothing changed */
  async write(row: ProjectRow, { put, drop }: Change, isNew: boolean): Promise<void> {
    await this.change(async (projects, parts) => {
      const there = await projects.get(row.id);
      if (there !== undefined && there.writer !== row.writer) throw new KeepError('taken', say('another-tab-has-taken-the'));
      if (there !== undefined && there.form > row.form) throw new KeepError('other', say('a-later-version-of-this'));
      if (there === undefined && !isNew) throw new KeepError('gone', say('the-project-is-no-longer'));
      await Promise.all([
        projects.put(row),
        ...[...put].map(([part, { value, bytes }]) => parts.put({ project: row.id, part, bytes, value })),
        ...drop.map((part) => parts.delete([row.id, part])),
      ]);
    });
  }

  /** Changes what the list says of a project. */
  async edit(id: string, changed: Partial<ProjectRow>): Promise<void> {
    await this.change(async (projects) => {
      const there = await projects.get(id);
      if (there === undefined) throw new KeepError('gone', say('the-project-is-no-longer'));
      await projects.put({ ...there, ...changed });
    });
  }

  async duplicate(id: string, row: Pick<ProjectRow, 'id' | 'name' | 'changed'>): Promise<void> {
    await this.change(async (projects, parts) => {
      const there = await projects.get(id);
      if (there === undefined) throw new KeepError('gone', say('the-project-is-no-longer'));
      await projects.put({ ...there, ...row, writer: '' });
      for (const part of await parts.getAll(partsOf(id))) await parts.put({ ...part, project: row.id });
    });
  }

  /** Makes some parts of a project one of their own. @throws KeepError, with nothing changed */
  async separate(id: string, row: ProjectRow, names: readonly string[]): Promise<void> {
    await this.change(async (projects, parts) => {
      const there = await projects.get(id);
      if (there === undefined) throw new KeepError('gone', say('the-project-is-no-longer'));
      if (there.writer !== row.writer) throw new KeepError('taken', say('another-tab-has-taken-the'));
      await projects.put({ ...row, writer: '' });
      for (const name of names) {
        const part = await parts.get([id, name]);
        if (part === undefined) continue;
        await parts.put({ ...part, project: row.id });
        await parts.delete([id, name]);
      }
    });
  }

  async remove(id: string): Promise<void> {
    await this.change(async (projects, parts) => {
      await Promise.all([projects.delete(id), parts.delete(partsOf(id))]);
    });
  }

  /** One transaction, which is on the disk when this resolves. */
  private async change(work: (projects: Store<'projects'>, parts: Store<'parts'>) => Promise<void>): Promise<void> {
    let done: Promise<void> | null = null;
    let abort = () => {};
    try {
      const transaction = this.db.transaction(['projects', 'parts'], 'readwrite', { durability: 'strict' });
      done = transaction.done;
      // It is waited for below, or another error says more.
      done.catch(() => {});
      abort = () => transaction.abort();
      await work(transaction.objectStore('projects'), transaction.objectStore('parts'));
      await done;
    } catch (error) {
      const reason = await ended(error, done, abort);
      if (reason instanceof KeepError) throw reason;
      throw new KeepError(isFull(reason) ? 'full' : 'other', reason instanceof Error ? reason.message : String(reason));
    }
  }
}

type Store<N extends 'projects' | 'parts'> = IDBPObjectStore<Schema, ['projects', 'parts'], N, 'readwrite'>;

/** Ends a transaction that failed; gives what is to blame for it: requests of a transaction that broke off say only that it did. */
async function ended(error: unknown, done: Promise<void> | null, abort: () => void): Promise<unknown> {
  try {
    abort();
    return error;
  } catch {
    // It had ended by itself.
    return done === null
      ? error
      : done.then(
          () => error,
          (reason: unknown) => reason ?? error,
        );
  }
}

function isFull(error: unknown): boolean {
  return error instanceof DOMException && error.name === 'QuotaExceededError';
}
