/** A connection to a database of the browser, which is made anew where it was closed under the page. */
import type { DBSchema, IDBPDatabase } from 'idb';

/** Opens the database. `lost`: the connection was closed, by the browser or for another page. */
export type Open<S extends DBSchema> = (lost: () => void) => Promise<IDBPDatabase<S>>;

type Opening<S extends DBSchema> = Promise<IDBPDatabase<S>>;

export class Connection<S extends DBSchema> {
  /** Calls back when a connection was lost: what the database held may be gone. */
  lost: () => void = () => undefined;
  private opening: Opening<S> | null = null;

  constructor(private readonly open: Open<S>) {}

  /** The open connection. What could not be opened is tried again the next time. */
  ready(): Opening<S> {
    if (this.opening !== null) return this.opening;
    const opening: Opening<S> = this.open(() => this.lose(opening));
    this.opening = opening;
    opening.catch(() => {
      if (this.opening === opening) this.opening = null;
    });
    return opening;
  }

  /** Does something with the database. A connection that turns out to be closed has done nothing of it: the next one does it. */
  async use<T>(work: (db: IDBPDatabase<S>) => Promise<T>): Promise<T> {
    const opening = this.ready();
    const db = await opening;
    try {
      return await work(db);
    } catch (error) {
      if (!isClosed(error)) throw error;
      this.lose(opening);
      return work(await this.ready());
    }
  }

  private lose(opening: Opening<S>): void {
    if (this.opening !== opening) return;
    this.opening = null;
    this.lost();
  }
}

/** A closed connection refuses to begin a transaction. */
function isClosed(error: unknown): boolean {
  return error instanceof DOMException && error.name === 'InvalidStateError';
}
