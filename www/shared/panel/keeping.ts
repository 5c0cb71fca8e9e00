/** A line that says what stands in the way of keeping the project, with what can be done. */
import type { Keeper } from '../files/keeper';
import type { Trouble } from '../state/keeping';
import { button, byId, fill, h } from './dom';
import { say } from '../text/words';

export interface KeepingActions {
  projects: () => void;
  saveFiles: (project: string) => void;
  /** Saves what is on the page as a project file. `near`: the `data-testid` of the button, beside which a refusal is said. */
  saveProject: (near: string) => void;
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
      return say('this-browser-keeps-nothing-of', { reason });
    case 'no-room':
      return say('the-storage-is-full-and-is', { title });
    case 'full':
      return say('the-storage-of-this-browser');
    case 'failed':
      return say('the-last-changes-could-not', { reason });
    case 'closed':
      return say('the-browser-has-closed-its', { reason });
    case 'cleared':
      return say('what-this-browser-had-kept', { title, reason });
    case 'elsewhere':
      return say('is-open-in-another-tab', { title });
    case 'reading':
      return say('is-open-in-another-tab-this', { title });
    case 'taken':
      return say('another-tab-has-taken-over', { title });
    case 'unreadable':
      return say('cannot-be-restored-it-stays', { title, reason });
    case 'broke-off':
      return say('was-not-opened-the-page', { title });
  }
}

function buttonsFor({ kind, project }: Trouble, keeper: Keeper, { projects, saveFiles, saveProject }: KeepingActions): HTMLButtonElement[] {
  const id = project?.id ?? '';
  const take = () => void keeper.open(id, 'steal');
  const look = () => void keeper.open(id, 'look');
  const asNew = () => void keeper.keepAsNew();
  const list = button(say('projects'), 'keeping-projects', projects);
  const close = button(say('close-2'), 'keeping-close', () => keeper.dismiss());
  const asFile = button(say('save-the-project'), 'keeping-save-project', () => saveProject('keeping-save-project'));
  switch (kind) {
    case 'elsewhere':
      return [button(say('look-at-it'), 'keeping-look', look), button(say('take-it-over'), 'keeping-take', take), close];
    case 'reading':
      return [
        button(say('show-the-latest'), 'keeping-look', look, say('reads-again-what-the-other')),
        button(say('take-it-over'), 'keeping-take', take, say('goes-on-with-the-project')),
        button(say('keep-this-as-a-new'), 'keeping-new', asNew),
      ];
    case 'taken':
      return [button(say('take-it-back'), 'keeping-take', take, say('shows-the-project-as-the')), button(say('keep-this-as-a-new'), 'keeping-new', asNew)];
    case 'unreadable':
      return [button(say('save-its-files'), 'keeping-save', () => saveFiles(id)), list, close];
    case 'broke-off':
      return [button(say('open-it'), 'keeping-open', () => void keeper.open(id)), button(say('save-its-files'), 'keeping-save', () => saveFiles(id)), close];
    case 'no-room':
    case 'full':
      return [list, asFile, close];
    case 'failed':
    case 'closed':
    case 'cleared':
      return [asFile, close];
    default:
      return [close];
  }
}
