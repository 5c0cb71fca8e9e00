/** A line that says what stands in the way of keeping the project, with what can be done. */
import type { Keeper, Trouble } from '../files/keeper';
import { button, byId, fill, h } from './dom';

export interface KeepingActions {
  projects: () => void;
  saveFiles: (project: string) => void;
}

export function mountKeeping(host: HTMLElement, keeper: Keeper, actions: KeepingActions): void {
  keeper.keeping.watch(['trouble'], ([trouble]) => {
    const held = host.contains(document.activeElement);
    host.hidden = trouble === null;
    fill(host, ...(trouble === null ? [] : [h('p', {}, textOf(trouble)), ...buttonsFor(trouble, keeper, actions)]));
    // The keyboard was on a button that is no more.
    if (held) byId('projects').focus();
  });
}

function textOf({ kind, reason, project }: Trouble): string {
  const title = `“${project?.title ?? ''}”`;
  switch (kind) {
    case 'absent':
      return `This browser keeps nothing of the page (a private window, or its storage is blocked): save the project as a file before you leave. ${reason}`;
    case 'full':
      return 'The storage of this browser is full: the last changes are not kept. What was kept before is whole. Delete projects that you no longer need, or save this one as a file.';
    case 'failed':
      return `The last changes could not be kept: ${reason}. What was kept before is whole. Save the project as a file before you leave.`;
    case 'elsewhere':
      return `${title} is open in another tab. This tab has a project of its own.`;
    case 'taken':
      return `Another tab has taken ${title} over. What is changed here is no longer kept.`;
    case 'unreadable':
      return `${title} cannot be restored: ${reason}. It stays in the storage as it is.`;
    case 'broke-off':
      return `${title} was not opened: the page broke off the last times that it was. This is a new project.`;
  }
}

function buttonsFor({ kind, project }: Trouble, keeper: Keeper, { projects, saveFiles }: KeepingActions): HTMLButtonElement[] {
  const id = project?.id ?? '';
  const list = button('Projects …', 'keeping-projects', projects);
  const close = button('Close', 'keeping-close', () => keeper.dismiss());
  switch (kind) {
    case 'elsewhere':
      return [button('Take it over', 'keeping-take', () => void keeper.open(id, true)), close];
    case 'taken':
      return [
        button('Take it back', 'keeping-take', () => void keeper.open(id, true), 'Shows the project as the other tab has kept it'),
        button('Keep this as a new project', 'keeping-new', () => void keeper.keepAsNew()),
      ];
    case 'unreadable':
      return [button('Save its files', 'keeping-save', () => saveFiles(id)), list, close];
    case 'broke-off':
      return [button('Open it', 'keeping-open', () => void keeper.open(id)), button('Save its files', 'keeping-save', () => saveFiles(id)), close];
    case 'full':
      return [list, close];
    default:
      return [close];
  }
}
