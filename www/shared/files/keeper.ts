/** Keeps the project of this tab in the browser's storage as it changes, and shows it again. */
import { Holder } from '../state/store';
import { titleOf } from '../text/project';
import { Claims } from './claim';
import type { Claim } from './claim';
import { type Database, FORM, KeepError } from './database';
import type { Kept, ProjectRow } from './database';
import { randomName } from './keepable';
import type { Keepable } from './keepable';
import { Leaving } from './leaving';
import type { Here } from './leaving';
import { say } from '../text/words';
import { messageOf } from '../text/messages';

/** Changes are gathered for so long before they are written, in ms. */
const GATHER_MS = 200;
/** A tab that loses its project has so long to write its last changes, in ms. */
const HANDOVER_MS = 400;
/** So much of files is written in one go. */
const PORTION_BYTES = 32e6;
/** The project of this tab, which a reload opens again. */
const TAB_PROJECT = 'tiepoint-project';
/** How often in a row the page broke off with a project; then it is opened only when the user asks. */
const BROKE_OFF = 'tiepoint-broke-off';
const MOST_BREAKS = 2;
/** A page that lasts so long with a project, in ms, did not break off for it. */
const CALM_MS = 15_000;

/** What stands in the way of keeping. `project`: the one that it is about, with its title. */
export interface Trouble {
  kind: 'absent' | 'full' | 'failed' | 'elsewhere' | 'reading' | 'taken' | 'unreadable' | 'broke-off';
  reason: string;
  project: { id: string; title: string } | null;
}

/** Where one of these stands in the way what is on the page is not kept; the others are about another project. */
const NOT_KEPT: readonly Trouble['kind'][] = ['absent', 'full', 'failed', 'reading', 'taken'];

/** As its one writer, where no other tab is that; in the place of that tab; or only to look at what is kept. */
export type Opening = 'claim' | 'steal' | 'look';

export interface Keeping {
  /** The project of this tab. */
  project: string;
  name: string | null;
  trouble: Trouble | null;
  /** Whether the browser keeps anything. */
  works: boolean;
  /** The title of the project that a start is reading. */
  opening: string | null;
}

/** The part of the page that is shown. */
export interface ModeSwitch {
  now: () => string;
  show: (mode: string) => void;
  /** Calls back whenever it is another. */
  watch: (changed: () => void) => void;
}

export class Keeper {
  readonly keeping = new Holder<Keeping, Partial<Keeping>>({ project: '', name: null, trouble: null, works: false, opening: null }, (state, changed) => ({
    ...state,
    ...changed,
  }));
  private readonly tab = randomName();
  private readonly claims = new Claims(this.tab);
  private claim: Claim | null = null;
  private database: Database | null = null;
  /** What stands in the storage, by the names of the parts. */
  private written = new Map<string, unknown>();
  private writtenMode = '';
  /** Nothing of the project is in the storage yet. */
  private isNew = true;
  private timer: number | undefined;
  private saving: Promise<void> = Promise.resolve();
  private readonly leaving = new Leaving();

  constructor(
    private readonly keepables: readonly Keepable[],
    private readonly mode: ModeSwitch,
  ) {}

  /** Opens the project that this tab had, else the one changed last. `ready`: called before anything is shown, in any case. */
  async start(opening: Promise<Database>, ready: () => Promise<void>): Promise<void> {
    let show = () => {};
    try {
      this.database = await opening;
      this.keeping.dispatch({ works: true });
      show = await this.first(this.database);
    } catch (error) {
      this.database = null;
      this.keeping.dispatch({ works: false, trouble: { kind: 'absent', reason: messageOf(error), project: null } });
    }
    await ready();
    await this.shown(show);
    this.keeping.dispatch({ opening: null });
    if (this.claim === null) await this.begin();
    this.writtenMode = this.mode.now();
    for (const keepable of this.keepables) keepable.watch(() => this.later());
    this.mode.watch(() => this.later());
    // A tab that is left may never get the time that it would still need.
    document.addEventListener('visibilitychange', () => {
      if (document.visibilityState === 'hidden') void this.flush();
    });
    window.addEventListener('pagehide', () => {
      forgetBreaks();
      void this.flush();
    });
  }

  /** Whether something on the page would be lost if it were left now. */
  get isLost(): boolean {
    if (this.keeping.state.trouble?.kind === 'reading') return this.isChanged();
    return !this.isKept && this.keepables.some((keepable) => keepable.parts().size > 0);
  }

  /** Whether what is on the page is kept. */
  private get isKept(): boolean {
    const { works, trouble } = this.keeping.state;
    return works && (trouble === null || !NOT_KEPT.includes(trouble.kind));
  }

  /** All projects that are kept, the one changed last first. */
  async projects(): Promise<(ProjectRow & { bytes: number })[]> {
    const { database } = this;
    if (database === null) return [];
    await this.flush();
    const rows = await database.projects();
    return Promise.all(rows.map(async (row) => ({ ...row, bytes: await database.bytesOf(row.id) })));
  }

  /** Opens a kept project in place of the present one, which stays in the list; where it cannot be opened nothing changes. */
  open(id: string, how: Opening = 'claim'): Promise<void> {
    return this.leaving.inTurn(() => this.opened(id, how));
  }

  private async opened(id: string, how: Opening): Promise<void> {
    await this.settle();
    const show = await this.read(id, how);
    if (show === null) return;
    this.leaving.leave();
    // What was changed while it was read.
    await this.settle();
    for (const keepable of this.keepables) keepable.clear();
    await this.shown(show);
    this.writtenMode = this.mode.now();
  }

  /** Shows what was read. What was read well and still cannot be shown must not stop the page, and stays in the storage as it is. */
  private async shown(show: () => void): Promise<void> {
    try {
      show();
    } catch (error) {
      const { project } = this.keeping.state;
      // Nothing is written while the page has no project.
      this.keeping.dispatch({ project: '' });
      for (const keepable of this.keepables) keepable.clear();
      await this.begin();
      this.keeping.dispatch({ trouble: { kind: 'unreadable', reason: messageOf(error), project: { id: project, title: say('the-project') } } });
    }
  }

  /** Puts the present project aside and begins a new one. */
  anew(): Promise<void> {
    return this.leaving.inTurn(() => this.begun());
  }

  /** Waits for the project that is being left: what is given meanwhile belongs to the next one. */
  left(): Promise<Here> {
    return this.leaving.left();
  }

  /** Waits as `left` does; what is to be done with the project that is shown now is nothing for the next one. */
  stays(): Promise<Here> {
    return this.leaving.stays();
  }

  private async begun(): Promise<void> {
    this.leaving.leave();
    await this.settle();
    await this.begin();
    for (const keepable of this.keepables) keepable.clear();
    this.keeping.dispatch({ trouble: null });
  }

  /**
   * Leaves a part of the page in the list of projects and goes on with the same in another one; false where that is not kept. What the other
   * parts of the page have stays in the present project: nothing is kept twice.
   */
  putAside(part: Keepable): Promise<boolean> {
    const { count } = this.leaving;
    // With its project the part was left in the list, too.
    return this.leaving.inTurn(async () => count !== this.leaving.count || this.putsAside(part));
  }

  private async putsAside(part: Keepable): Promise<boolean> {
    await this.settle();
    if (this.isNew || !this.isKept) return false;
    const others = this.keepables.some((keepable) => keepable.mode !== part.mode && keepable.parts().size > 0);
    if (others) return this.separate(part);
    await this.begin();
    return true;
  }

  /** Makes a project of its own of a part of the present one, whose name a block takes. */
  private async separate(part: Keepable): Promise<boolean> {
    const { project, name } = this.keeping.state;
    const { mode } = part;
    const parts = [...part.parts().keys()];
    const takesName = mode === 'block';
    const row = { id: randomName(), form: FORM, name: takesName ? name : null, images: part.images(), mode, changed: Date.now(), writer: this.tab };
    try {
      await this.database?.separate(project, row, parts);
    } catch (error) {
      this.failed(error, project);
      return false;
    }
    for (const gone of parts) this.written.delete(gone);
    if (takesName) this.keeping.dispatch({ name: null });
    this.later();
    return true;
  }

  /** Keeps what is on the page as a project of its own. */
  keepAsNew(): Promise<void> {
    return this.leaving.inTurn(async () => {
      await this.begin();
      this.keeping.dispatch({ trouble: null });
      await this.flush();
    });
  }

  async rename(id: string, name: string | null): Promise<void> {
    await this.database?.edit(id, { name });
    if (id === this.keeping.state.project) this.keeping.dispatch({ name });
  }

  async duplicate(id: string, name: string): Promise<void> {
    await this.flush();
    await this.database?.duplicate(id, { id: randomName(), name, changed: Date.now() });
  }

  /** Deletes a project; of the one on the page nothing is left there either. @throws Error where another tab has it open */
  async remove(id: string): Promise<void> {
    if (await this.claims.elsewhere(id)) throw new Error(say('another-tab-has-this-project'));
    if (id === this.keeping.state.project) await this.anew();
    await this.database?.remove(id);
  }

  /** The parts of a project as they stand in the storage. */
  async partsOf(id: string): Promise<ReadonlyMap<string, unknown>> {
    return (await this.database?.parts(id)) ?? new Map();
  }

  /** What was said is known. */
  dismiss(): void {
    this.keeping.dispatch({ trouble: null });
  }

  /** Resolves when all that there is is written, or could not be. */
  private async settle(): Promise<void> {
    await Promise.all(this.keepables.map((keepable) => keepable.settled?.()));
    await this.flush();
  }

  /** Resolves when all changes so far are written, or could not be. */
  flush(): Promise<void> {
    window.clearTimeout(this.timer);
    this.timer = undefined;
    this.saving = this.saving.then(() => this.save());
    return this.saving;
  }

  private later(): void {
    this.timer ??= window.setTimeout(() => void this.flush(), GATHER_MS);
  }

  /** Reads the project that a start shows. */
  private async first(database: Database): Promise<() => void> {
    const remembered = rememberedProject();
    const rows = await database.projects();
    const row = remembered === null ? rows[0] : rows.find(({ id }) => id === remembered);
    const nothing = () => {};
    if (row === undefined) return nothing;
    if (breaks(row.id) >= MOST_BREAKS) {
      this.keeping.dispatch({ trouble: { kind: 'broke-off', reason: '', project: { id: row.id, title: titleOf(row) } } });
      return nothing;
    }
    countBreak(row.id);
    window.setTimeout(forgetBreaks, CALM_MS);
    this.keeping.dispatch({ opening: titleOf(row) });
    return (await this.read(row.id, 'claim')) ?? nothing;
  }

  /** Claims and reads a project; gives what shows it, or null where it cannot be opened, for which there is then a trouble. */
  private async read(id: string, how: Opening): Promise<(() => void) | null> {
    const { database } = this;
    const row = await database?.project(id);
    if (database === null || row === undefined) return null;
    const project = { id, title: titleOf(row) };
    const refuse = (kind: Trouble['kind'], reason: string) => {
      this.keeping.dispatch({ trouble: { kind, reason, project } });
      return null;
    };
    if (row.form > FORM) return refuse('unreadable', say('a-later-version-of-this-page'));
    const looks = how === 'look';
    const claim = looks ? null : await this.claims.take(id, how === 'steal', () => this.lost(id));
    if (claim === null && !looks) return refuse('elsewhere', '');
    try {
      if (how === 'steal') await new Promise((resolve) => setTimeout(resolve, HANDOVER_MS));
      // From now on what another tab would still write is refused.
      if (!looks) await database.edit(id, { writer: this.tab });
      const parts = await database.parts(id);
      const shows = await Promise.all(this.keepables.map((keepable) => keepable.read(parts)));
      return () => {
        if (this.claim !== claim) this.claim?.release();
        this.claim = claim;
        this.isNew = false;
        this.written = new Map(parts);
        this.keeping.dispatch({ project: id, name: row.name, trouble: looks ? { kind: 'reading', reason: '', project } : null });
        rememberProject(id);
        for (const show of shows) show();
        this.mode.show(row.mode);
      };
    } catch (error) {
      if (claim !== null && this.claim !== claim) claim.release();
      return refuse('unreadable', messageOf(error));
    }
  }

  /** Begins a project of which nothing is kept yet. */
  private async begin(): Promise<void> {
    const project = randomName();
    this.claim?.release();
    // No other tab can have it: nobody is asked.
    this.claim = await this.claims.take(project, true, () => this.lost(project));
    this.isNew = true;
    this.written = new Map();
    this.keeping.dispatch({ project, name: null });
    // Without a storage a reload may find again what was remembered before.
    if (this.database !== null) rememberProject(project);
  }

  private lost(id: string): void {
    if (id !== this.keeping.state.project) return;
    const taken = () => this.keeping.dispatch({ trouble: { kind: 'taken', reason: '', project: { id, title: this.title() } } });
    // The last changes are written while the other tab waits for them.
    void this.flush().then(taken);
  }

  private title(): string {
    return titleOf({ name: this.keeping.state.name, images: this.images() });
  }

  private images(): readonly string[] {
    return this.keepables.map((keepable) => keepable.images()).find((images) => images.length > 0) ?? [];
  }

  /** What is other than in the storage. */
  private changes(): { put: Map<string, Kept>; drop: string[] } {
    const parts = new Map(this.keepables.flatMap((keepable) => [...keepable.parts()]));
    const put = new Map([...parts].filter(([part, { value }]) => !this.written.has(part) || this.written.get(part) !== value));
    return { put, drop: [...this.written.keys()].filter((part) => !parts.has(part)) };
  }

  private isChanged(): boolean {
    const { put, drop } = this.changes();
    // What the page makes again by itself is no change of the user's.
    return drop.length > 0 || [...put.values()].some(({ again }) => again !== true);
  }

  /** Writes what has changed since it was written last. */
  private async save(): Promise<void> {
    const { database, keeping } = this;
    const { project, name, trouble } = keeping.state;
    if (database === null || project === '' || trouble?.kind === 'taken' || trouble?.kind === 'reading') return;
    const { put, drop } = this.changes();
    const mode = this.mode.now();
    if (put.size === 0 && drop.length === 0 && (this.isNew || mode === this.writtenMode)) return;
    const row: ProjectRow = { id: project, form: FORM, name, images: this.images(), mode, changed: Date.now(), writer: this.tab };
    try {
      await this.write(database, row, put, drop);
      this.writtenMode = mode;
      if (trouble?.kind === 'full' || trouble?.kind === 'failed') keeping.dispatch({ trouble: null });
    } catch (error) {
      this.failed(error, project);
    }
  }

  /** Files go first, in portions; what names them goes last, all at once. Where there is no room for all, what can be made again is left out. */
  private async write(database: Database, row: ProjectRow, put: ReadonlyMap<string, Kept>, drop: readonly string[]): Promise<void> {
    const write = async (some: ReadonlyMap<string, Kept>, gone: readonly string[]) => {
      await database.write(row, { put: some, drop: gone }, this.isNew);
      this.isNew = false;
      for (const [part, { value }] of some) this.written.set(part, value);
      for (const part of gone) this.written.delete(part);
    };
    for (const portion of portionsOf(put)) await write(portion, []);
    const rest = new Map([...put].filter(([part]) => this.written.get(part) !== put.get(part)?.value || !this.written.has(part)));
    try {
      await write(rest, drop);
    } catch (error) {
      const needed = new Map([...rest].filter(([, { again }]) => again !== true));
      if (!(error instanceof KeepError) || error.kind !== 'full' || needed.size === rest.size) throw error;
      await write(needed, drop);
      throw error;
    }
  }

  private failed(error: unknown, id: string): void {
    const kind = error instanceof KeepError ? error.kind : 'other';
    if (kind === 'taken') {
      this.keeping.dispatch({ trouble: { kind: 'taken', reason: '', project: { id, title: this.title() } } });
      return;
    }
    if (kind === 'gone') {
      // The browser's storage was cleared: what is on the page is kept as if it were new.
      this.isNew = true;
      this.written = new Map();
      this.later();
      return;
    }
    const project = { id, title: this.title() };
    this.keeping.dispatch({ trouble: { kind: kind === 'full' ? 'full' : 'failed', reason: messageOf(error), project } });
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

/** Runs what may be forbidden to a page: its storage of words. */
function allowed<T>(action: () => T, otherwise: T): T {
  try {
    return action();
  } catch {
    return otherwise;
  }
}

const rememberedProject = () => allowed(() => sessionStorage.getItem(TAB_PROJECT), null);
const rememberProject = (id: string) => allowed(() => sessionStorage.setItem(TAB_PROJECT, id), undefined);

/** How often in a row the page broke off with this project. */
function breaks(id: string): number {
  const [project, count] = (allowed(() => localStorage.getItem(BROKE_OFF), null) ?? '').split(' ');
  return project === id ? Number(count) || 0 : 0;
}

const countBreak = (id: string) => allowed(() => localStorage.setItem(BROKE_OFF, `${id} ${String(breaks(id) + 1)}`), undefined);
const forgetBreaks = () => allowed(() => localStorage.removeItem(BROKE_OFF), undefined);
