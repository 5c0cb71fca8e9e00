/** The browser's own storage: projects, each kept in named parts. A change is one transaction: it is there whole, or not at all. */
import { openDB } from 'idb';
import type { DBSchema, IDBPDatabase, IDBPObjectStore } from 'idb';
import { messageOf } from '../text/messages';
import { sizeText } from '../text/project';
import { say } from '../text/words';
import { Connection } from './connection';

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

/** `full`: no room is left; `taken`: another tab has the project; `gone`: the project is no longer there; `closed`: the storage cannot be opened. */
export type KeepFailure = 'full' | 'taken' | 'gone' | 'closed' | 'other';

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
  private readonly connection = new Connection<Schema>((lost) => opened(lost));

  private constructor() {}

  /** Rejects where the browser keeps nothing: in some private windows, where storage is blocked, or where a later version of the page wrote it. */
  static async open(): Promise<Database> {
    const database = new Database();
    await database.connection.ready();
    return database;
  }

  /** Calls back when the storage was closed under the page: what it held may be gone. */
  watch(lost: () => void): void {
    this.connection.lost = lost;
  }

  /** The one changed last comes first. */
  async projects(): Promise<ProjectRow[]> {
    const rows = await this.read((db) => db.getAll('projects'));
    return rows.sort((a, b) => b.changed - a.changed);
  }

  project(id: string): Promise<ProjectRow | undefined> {
    return this.read((db) => db.get('projects', id));
  }

  async parts(id: string): Promise<Map<string, unknown>> {
    const rows = await this.read((db) => db.getAll('parts', partsOf(id)));
    return new Map(rows.map(({ part, value }) => [part, value]));
  }

  /** About how much room a project takes: no part is read for that. */
  bytesOf(id: string): Promise<number> {
    return this.read(async (db) => {
      let sum = 0;
      let cursor = await db
        .transaction('parts')
        .store.index('sizes')
        .openKeyCursor(IDBKeyRange.bound([id], [id, []]));
      while (cursor !== null) {
        sum += cursor.key[1];
        cursor = await cursor.continue();
      }
      return sum;
    });
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

  /** Names the tab that may change a project from now on. `from`: another one than that must not have taken it. @throws KeepError, with nothing changed */
  async claim(id: string, writer: string, from?: string): Promise<void> {
    await this.change(async (projects) => {
      const there = await projects.get(id);
      if (there === undefined) throw new KeepError('gone', say('the-project-is-no-longer'));
      if (there.writer === writer) return;
      if (from !== undefined && there.writer !== from) throw new KeepError('taken', say('another-tab-has-taken-the'));
      await projects.put({ ...there, writer });
    });
  }

  /** @throws KeepError, with nothing changed */
  async rename(id: string, name: string | null): Promise<void> {
    await this.change(async (projects) => {
      const there = await projects.get(id);
      if (there === undefined) throw new KeepError('gone', say('the-project-is-no-longer'));
      await projects.put({ ...there, name });
    });
  }

  /** @throws KeepError, with nothing changed; where there is no room it says how much the copy needs */
  async duplicate(id: string, row: Pick<ProjectRow, 'id' | 'name' | 'changed'>): Promise<void> {
    let needed = 0;
    try {
      await this.change(async (projects, parts) => {
        const there = await projects.get(id);
        if (there === undefined) throw new KeepError('gone', say('the-project-is-no-longer'));
        const all = await parts.getAll(partsOf(id));
        needed = all.reduce((sum, { bytes }) => sum + bytes, 0);
        await projects.put({ ...there, ...row, writer: '' });
        for (const part of all) await parts.put({ ...part, project: row.id });
      });
    } catch (error) {
      if (!(error instanceof KeepError) || error.kind !== 'full') throw error;
      throw new KeepError('full', say('the-copy-needs-about', { size: sizeText(needed) }));
    }
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

  private async read<T>(work: (db: IDBPDatabase<Schema>) => Promise<T>): Promise<T> {
    try {
      return await this.connection.use(work);
    } catch (error) {
      throw keepError(error);
    }
  }

  private change(work: Work): Promise<void> {
    return this.read((db) => transacted(db, work));
  }
}

/** Opens the storage. @throws KeepError */
async function opened(lost: () => void): Promise<IDBPDatabase<Schema>> {
  // An answer that came while the page was busy is heard first.
  const late = new Promise<never>((_, reject) => setTimeout(() => setTimeout(() => reject(new Error(say('the-storage-does-not-answer')))), PATIENCE_MS));
  // Nobody may wait for it any more.
  late.catch(() => {});
  try {
    return await Promise.race([connected(lost), late]);
  } catch (error) {
    throw new KeepError('closed', reasonOf(error));
  }
}

function connected(lost: () => void): Promise<IDBPDatabase<Schema>> {
  return openDB<Schema>(NAME, VERSION, {
    upgrade: (db) => {
      db.createObjectStore('projects', { keyPath: 'id' });
      db.createObjectStore('parts', { keyPath: ['project', 'part'] }).createIndex('sizes', ['project', 'bytes']);
    },
    // A later version of the page in another tab goes first, and so does who deletes the storage.
    blocking: (_, __, event) => {
      (event.target as IDBDatabase).close();
      lost();
    },
    // The browser has cleared the storage, or it is damaged.
    terminated: lost,
  });
}

type Store<N extends 'projects' | 'parts'> = IDBPObjectStore<Schema, ['projects', 'parts'], N, 'readwrite'>;

type Work = (projects: Store<'projects'>, parts: Store<'parts'>) => Promise<void>;

/** One transaction, which is on the disk when this resolves. */
async function transacted(db: IDBPDatabase<Schema>, work: Work): Promise<void> {
  let done: Promise<void> | null = null;
  let abort = () => {};
  try {
    const transaction = db.transaction(['projects', 'parts'], 'readwrite', { durability: 'strict' });
    done = transaction.done;
    // It is waited for below, or another error says more.
    done.catch(() => {});
    abort = () => transaction.abort();
    await work(transaction.objectStore('projects'), transaction.objectStore('parts'));
    await done;
  } catch (error) {
    throw await ended(error, done, abort);
  }
}

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

function keepError(error: unknown): KeepError {
  if (error instanceof KeepError) return error;
  if (error instanceof DOMException && error.name === 'QuotaExceededError') return new KeepError('full', say('the-storage-is-full'));
  return new KeepError('other', reasonOf(error));
}

/** What the browser says of its storage is English, often for programmers alone, and sometimes nothing: the name of the error stands for it. */
function reasonOf(error: unknown): string {
  if (!(error instanceof DOMException)) return messageOf(error);
  return error.name === 'VersionError' ? say('a-later-version-of-this') : say('the-storage-failed', { name: error.name });
}
