/** The projects that this browser keeps: a dialog that opens, renames, duplicates and deletes them. */
import type { ProjectRow } from '../files/database';
import type { Keeper } from '../files/keeper';
import { archiveOf } from '../files/rescue';
import { save } from '../files/save';
import { sentence } from '../text/format';
import { LANGUAGE } from '../text/language';
import { sizeText, titleOf } from '../text/project';
import { button, byId, fill, h } from './dom';
import { mountKeeping } from './keeping';
import type { KeepingActions } from './keeping';
import { say } from '../text/words';
import { messageOf } from '../text/messages';

type Row = ProjectRow & { bytes: number };

const DATE = new Intl.DateTimeFormat(LANGUAGE === 'en' ? 'en-GB' : `${LANGUAGE}-u-nu-latn`, { dateStyle: 'medium', timeStyle: 'short' });

/** The buttons of the bar, the dialog, and the line that says what stands in the way of keeping, which saves what is on the page by `saveProject`. */
export function mountProjects(keeper: Keeper, saveProject: KeepingActions['saveProject']): void {
  const anew = byId('anew') as HTMLButtonElement;
  const press = byId('projects') as HTMLButtonElement;
  const list = new ProjectList(keeper);
  document.body.append(list.dialog);
  anew.addEventListener('click', () => {
    if (mayLeave(keeper)) void keeper.anew();
  });
  press.addEventListener('click', () => void list.open());
  mountKeeping(byId('keeping'), keeper, {
    projects: () => void list.open(),
    saveFiles: (project) => void saveFiles(keeper, project, 'tiepoint-project'),
    saveProject,
  });
  keeper.keeping.watch(['works', 'project'], ([works, project]) => {
    anew.disabled = project === '';
    press.disabled = !works || project === '';
  });
}

/** Asks before what could not be kept is lost. */
function mayLeave({ isLost }: Keeper): boolean {
  return !isLost || window.confirm(say('the-last-changes-on-the'));
}

async function saveFiles(keeper: Keeper, project: string, name: string): Promise<void> {
  save(await archiveOf(await keeper.partsOf(project)), `${name}.zip`);
}

class ProjectList {
  readonly dialog: HTMLDialogElement;
  private readonly rows = h('ul', { class: 'projects', testid: 'project-list' });
  private readonly room = h('p', { class: 'note', testid: 'project-room' });
  private readonly problem = h('p', { class: 'field-problem', role: 'alert', testid: 'project-problem' });
  private readonly stay = button(say('ask-the-browser-never-to'), 'project-persist', () => void this.attempt(() => this.persist()));

  constructor(private readonly keeper: Keeper) {
    const close = button(say('close-2'), 'projects-close', () => this.dialog.close());
    const anew = button(say('new-project'), 'project-new', () => void this.leave(() => keeper.anew()));
    anew.className = 'primary';
    const heading = h('h2', { id: 'projects-heading' }, say('projects-2'));
    const note = h('p', { class: 'note' }, say('this-browser-keeps-each-project'));
    const foot = h('div', { class: 'buttons' }, this.stay, close);
    this.dialog = h('dialog', { class: 'dialog', testid: 'projects-dialog', aria: { labelledby: heading.id } });
    this.dialog.append(h('div', { class: 'dialog-head' }, heading, anew), note, this.rows, this.problem, this.room, foot);
  }

  async open(): Promise<void> {
    this.problem.textContent = '';
    await this.attempt(() => this.show());
    if (!this.dialog.open) this.dialog.showModal();
  }

  /** Does something after which the list is no longer needed. */
  private async leave(action: () => Promise<void>): Promise<void> {
    if (mayLeave(this.keeper) && (await this.attempt(action))) this.dialog.close();
  }

  /** Does something, and says what went wrong. */
  private async attempt(action: () => Promise<void>): Promise<boolean> {
    this.problem.textContent = '';
    try {
      await action();
      return true;
    } catch (error) {
      this.problem.textContent = sentence(messageOf(error));
      return false;
    }
  }

  /** Does something that changes the list. The keyboard goes on to `focus`. */
  private async change(action: () => Promise<void>, focus: () => string): Promise<void> {
    await this.attempt(async () => {
      await action();
      await this.show(focus);
    });
  }

  /** `focus`: what has the keyboard among the new rows, at once: the next key is meant for it. */
  private async show(focus?: () => string): Promise<void> {
    const projects = await this.keeper.projects();
    const none = h('li', { class: 'note' }, say('nothing-is-kept-yet'));
    fill(this.rows, ...(projects.length === 0 ? [none] : projects.map((row) => this.row(row))));
    if (focus !== undefined) {
      const next = this.rows.querySelector<HTMLElement>(`[data-testid="${focus()}"]`) ?? this.dialog.querySelector<HTMLElement>('button');
      next?.focus();
    }
    await this.showRoom(projects);
  }

  private async showRoom(projects: readonly Row[]): Promise<void> {
    const own = projects.reduce((sum, { bytes }) => sum + bytes, 0);
    // Absent where the page comes by plain http from another machine.
    const storage = (navigator as { storage?: StorageManager }).storage;
    const { usage = 0, quota = 0 } = (await storage?.estimate().catch(() => undefined)) ?? {};
    const left = quota > usage ? say('about-are-left', { quota: sizeText(quota - usage) }) : '';
    const persisted = (await storage?.persisted?.().catch(() => false)) ?? false;
    this.stay.hidden = storage === undefined || persisted || projects.length === 0;
    const may = persisted ? '' : say('the-browser-may-clear-it');
    this.room.textContent = say('the-projects-take-about', { own: sizeText(own), left, may });
  }

  private async persist(): Promise<void> {
    if (!(await navigator.storage.persist())) throw new Error(say('the-browser-does-not-promise'));
    await this.show();
  }

  private row(row: Row): HTMLElement {
    const { id } = row;
    const title = titleOf(row);
    const current = id === this.keeper.keeping.state.project;
    const open = button(
      title,
      `project-open-${id}`,
      () => void this.leave(() => (current ? Promise.resolve() : this.keeper.open(id))),
      say('open-this-project'),
    );
    open.className = 'link';
    const images = say('so-many-images', { images: row.images.length });
    // Each by itself: figures beside each other run together from right to left.
    const parts = [images, sizeText(row.bytes), DATE.format(row.changed)].flatMap((text) => [' · ', h('bdi', {}, text)]).slice(1);
    const facts = h('span', { class: 'note' }, ...parts, current ? say('on-the-page') : '');
    const named = (text: string, what: string, action: () => void) => {
      const made = button(text, `project-${what}-${id}`, action);
      made.setAttribute('aria-label', `${text}: ${title}`);
      return made;
    };
    const element = h('li', { testid: 'project', ...(current ? { aria: { current: 'true' } } : {}) });
    const buttons = h(
      'div',
      { class: 'buttons' },
      named(say('rename'), 'rename', () => this.rename(element, row)),
      named(
        say('duplicate'),
        'duplicate',
        () =>
          void this.change(
            () => this.keeper.duplicate(id, say('copy', { title })),
            () => `project-duplicate-${id}`,
          ),
      ),
      named(say('save-files'), 'save', () => void this.attempt(() => saveFiles(this.keeper, id, 'tiepoint-project'))),
      named(say('delete'), 'delete', () => this.confirm(element, row)),
    );
    element.append(h('div', { class: 'project-name' }, open, facts), buttons);
    return element;
  }

  private rename(element: HTMLElement, { id, ...row }: Row): void {
    const input = h('input', { type: 'text', testid: 'project-name', aria: { label: say('new-name-of', { row: titleOf(row) }) } });
    input.value = titleOf(row);
    const take = () => {
      const name = input.value.trim();
      void this.change(
        () => this.keeper.rename(id, name === '' ? null : name),
        () => `project-rename-${id}`,
      );
    };
    const cancel = () =>
      void this.change(
        () => Promise.resolve(),
        () => `project-rename-${id}`,
      );
    input.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') take();
      if (event.key !== 'Escape') return;
      // The dialog stays.
      event.preventDefault();
      cancel();
    });
    fill(
      element,
      input,
      h('div', { class: 'buttons' }, button(say('rename'), 'project-name-take', take), button(say('cancel'), 'project-name-cancel', cancel)),
    );
    input.focus();
    input.select();
  }

  private confirm(element: HTMLElement, row: Row): void {
    const keep = button(
      say('keep'),
      'project-keep',
      () =>
        void this.change(
          () => Promise.resolve(),
          () => `project-delete-${row.id}`,
        ),
    );
    const remove = button(
      say('delete'),
      'project-delete',
      () =>
        void this.change(
          () => this.keeper.remove(row.id),
          () => '',
        ),
    );
    const question = h('p', { role: 'alert' }, say('delete-with-its-images-and', { row: titleOf(row) }));
    fill(element, question, h('div', { class: 'buttons' }, remove, keep));
    keep.focus();
  }
}
