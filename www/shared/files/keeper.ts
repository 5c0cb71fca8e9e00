/** Keeps the project of this tab in the browser's storage as it changes, and shows it again. */
import { endsWhenWritten, isKept, makeKeeping } from '../state/keeping';
import type { Trouble } from '../state/keeping';
import { titleOf } from '../text/project';
import { Claims } from './claim';
import type { Claim } from './claim';
import { type Database, FORM, KeepError } from './database';
import type { KeepFailure, ProjectRow } from './database';
import { randomName } from './keepable';
import type { Keepable } from './keepable';
import { Leaving } from './leaving';
import type { Here } from './leaving';
import { ProjectReader } from './reading';
import type { Opening } from './reading';
import { breaksOff, countBreak, forgetBreaks, rememberedProject, rememberProject } from './remembered';
import { Written } from './written';
import { say } from '../text/words';
import { messageOf } from '../text/messages';

/** Changes are gathered for so long before they are written, in ms. */
const GATHER_MS = 200;
/** A page that lasts so long with a project, in ms, did not break off for it. */
const CALM_MS = 15_000;

/** The part of the page that is shown. */
export interface ModeSwitch {
  now: () => string;
  show: (mode: string) => void;
  /** Calls back whenever it is another. */
  watch: (changed: () => void) => void;
}

export class Keeper {
  readonly keeping = makeKeeping();
  private readonly tab = randomName();
  private readonly claims = new Claims(this.tab);
  private claim: Claim | null = null;
  private database: Database | null = null;
  private readonly reader: ProjectReader;
  private readonly written: Written;
  private timer: number | undefined;
  private saving: Promise<void> = Promise.resolve();
  private readonly leaving = new Leaving();

  constructor(
    private readonly keepables: readonly Keepable[],
    private readonly mode: ModeSwitch,
  ) {
    this.reader = new ProjectReader(keepables, this.claims, this.tab);
    this.written = new Written(keepables);
  }

  /** Opens the project that this tab had, else the one changed last. `ready`: called before anything is shown, in any case. */
  async start(opening: Promise<Database>, ready: () => Promise<void>): Promise<void> {
    let show = () => {};
    try {
      this.database = await opening;
      this.database.watch(() => this.closed());
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
    this.written.mode = this.mode.now();
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
    if (this.keeping.state.trouble?.kind === 'reading') return this.written.isChanged();
    return !isKept(this.keeping.state) && this.keepables.some((keepable) => keepable.parts().size > 0);
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
    this.written.mode = this.mode.now();
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
    if (this.written.isNew || !isKept(this.keeping.state)) return false;
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
      if (this.database !== null) await this.written.ensure(this.database, project, this.tab);
      await this.database?.separate(project, row, parts);
    } catch (error) {
      this.failed(error, project);
      return false;
    }
    this.written.forget(parts);
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
    await this.database?.rename(id, name);
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

  /** The storage was closed under the page, and may have been cleared: what is on the page must stand there again. */
  private closed(): void {
    this.written.doubt(this.tab);
    this.later();
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
    if (breaksOff(row.id)) {
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
    if (database === null) return null;
    const read = await this.reader.read(database, id, how, { held: () => this.claim, lost: () => this.lost(id) });
    if (read === null) return null;
    if ('kind' in read) {
      this.keeping.dispatch({ trouble: read });
      return null;
    }
    const { row, title, parts, claim, unnamed, shows } = read;
    const trouble = (kind: Trouble['kind']): Trouble => ({ kind, reason: unnamed?.message ?? '', project: { id, title } });
    const unwritten = unnamed === null ? null : trouble(unnamed.kind === 'full' ? 'no-room' : 'failed');
    return () => {
      if (this.claim !== claim) this.claim?.release();
      this.claim = claim;
      this.written.opened(parts, unnamed === null ? null : row.writer);
      this.keeping.dispatch({ project: id, name: row.name, trouble: claim === null ? trouble('reading') : unwritten });
      rememberProject(id);
      for (const show of shows) show();
      this.written.shown();
      this.mode.show(row.mode);
    };
  }

  /** Begins a project of which nothing is kept yet. */
  private async begin(): Promise<void> {
    const project = randomName();
    this.claim?.release();
    // No other tab can have it: nobody is asked.
    this.claim = await this.claims.take(project, true, () => this.lost(project));
    this.written.begin();
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

  /** Writes what has changed since it was written last. */
  private async save(): Promise<void> {
    const { database, keeping } = this;
    const { project, name, trouble } = keeping.state;
    if (database === null || project === '' || trouble?.kind === 'taken' || trouble?.kind === 'reading') return;
    const { put, drop } = this.written.changes();
    const mode = this.mode.now();
    const isSame = put.size === 0 && drop.length === 0 && (this.written.isNew || mode === this.written.mode);
    if (isSame && !this.written.isInDoubt) return;
    const row: ProjectRow = { id: project, form: FORM, name, images: this.images(), mode, changed: Date.now(), writer: this.tab };
    try {
      await this.written.ensure(database, project, this.tab);
      if (!isSame) await this.written.write(database, row, put, drop);
      this.written.mode = mode;
      if (endsWhenWritten(keeping.state)) keeping.dispatch({ trouble: null });
    } catch (error) {
      this.failed(error, project);
    }
  }

  private failed(error: unknown, id: string): void {
    const kind = error instanceof KeepError ? error.kind : 'other';
    if (kind === 'taken') {
      this.keeping.dispatch({ trouble: { kind: 'taken', reason: '', project: { id, title: this.title() } } });
      return;
    }
    if (kind === 'gone') {
      // The browser's storage was cleared, and with it what it remembered: what is on the page is kept as if it were new.
      this.written.gone();
      rememberProject(id);
      this.later();
      return;
    }
    this.keeping.dispatch({ trouble: { kind: this.unkept(kind), reason: messageOf(error), project: { id, title: this.title() } } });
  }

  /** What is said where something could not be written. */
  private unkept(failure: KeepFailure): Trouble['kind'] {
    if (this.written.isGone) return 'cleared';
    if (failure === 'closed') return 'closed';
    if (failure !== 'full') return 'failed';
    return this.written.isInDoubt && !this.written.isChanged() ? 'no-room' : 'full';
  }
}
