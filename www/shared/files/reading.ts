/** Claims a kept project and reads it. */
import type { Trouble } from '../state/keeping';
import { messageOf } from '../text/messages';
import { titleOf } from '../text/project';
import { say } from '../text/words';
import type { Claim, Claims } from './claim';
import { type Database, FORM, KeepError } from './database';
import type { ProjectRow } from './database';
import type { Keepable } from './keepable';

/** A tab that loses its project has so long to write its last changes, in ms. */
const HANDOVER_MS = 400;

/** As its one writer, where no other tab is that; in the place of that tab; or only to look at what is kept. */
export type Opening = 'claim' | 'steal' | 'look';

export interface ReadProject {
  row: ProjectRow;
  title: string;
  parts: ReadonlyMap<string, unknown>;
  /** Null where it is only looked at. */
  claim: Claim | null;
  /** Why the storage does not name this tab as its writer, where it could not be written there; then it still names the one of the row. */
  unnamed: KeepError | null;
  /** What shows it, each part of the page by itself. */
  shows: readonly (() => void)[];
}

/** The project that the tab has meanwhile. */
interface Tab {
  held: () => Claim | null;
  /** Another tab takes the project that is read. */
  lost: () => void;
}

export class ProjectReader {
  constructor(
    private readonly keepables: readonly Keepable[],
    private readonly claims: Claims,
    /** The name of this tab. */
    private readonly tab: string,
  ) {}

  /** What stands in the way where it cannot be opened; null where there is no such project. */
  async read(database: Database, id: string, how: Opening, { held, lost }: Tab): Promise<ReadProject | Trouble | null> {
    const row = await database.project(id);
    if (row === undefined) return null;
    const title = titleOf(row);
    const refused = (kind: Trouble['kind'], reason: string): Trouble => ({ kind, reason, project: { id, title } });
    if (row.form > FORM) return refused('unreadable', say('a-later-version-of-this-page'));
    const looks = how === 'look';
    const claim = looks ? null : await this.claims.take(id, how === 'steal', lost);
    if (claim === null && !looks) return refused('elsewhere', '');
    try {
      if (how === 'steal') await new Promise((resolve) => setTimeout(resolve, HANDOVER_MS));
      // From now on what another tab would still write is refused.
      const unnamed = looks ? null : await this.named(database, id);
      const parts = await database.parts(id);
      const shows = await Promise.all(this.keepables.map((keepable) => keepable.read(parts, looks)));
      return { row, title, parts, claim, unnamed, shows };
    } catch (error) {
      if (claim !== null && held() !== claim) claim.release();
      return refused('unreadable', messageOf(error));
    }
  }

  /** Names this tab as the writer. A full storage still gives what it has: what could not be written is no reason not to show it. */
  private async named(database: Database, id: string): Promise<KeepError | null> {
    try {
      await database.claim(id, this.tab);
      return null;
    } catch (error) {
      if (error instanceof KeepError && (error.kind === 'full' || error.kind === 'other')) return error;
      throw error;
    }
  }
}
