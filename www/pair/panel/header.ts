/** The bar of the page as the pair uses it: what opens, exchanges and exports its images. */
import { byId } from '../../shared/panel/dom';
import { mountMenu } from '../../shared/panel/menu';
import type { Engine } from '../engine/engine';
import { exportEverything, exportMatches, exportPicture } from '../files/export';
import type { Files } from '../files/open';
import { exportProject } from '../files/project';
import { exportEpipolar } from '../files/epipolar';
import { exportReport } from '../files/report';
import { EXPORTS, savable } from '../state/savable';
import type { Side } from '../state/state';
import type { Store } from '../state/store';
import { truthOf } from '../state/truth';
import type { View } from '../view/view';
import { say } from '../../shared/text/words';
import { declareLack } from '../../shared/panel/lack';
import { lackOfMatches } from '../state/choice';
import { SIDES } from '../state/state';

/** Opens the file dialog for a side, or for any files; or for the mask of a side. */
export type Pick = (side: Side | null, what?: 'any' | 'mask') => void;

export function pickerOf(files: Files): Pick {
  const input = byId('file-input') as HTMLInputElement;
  let wanted: { side: Side | null; what: 'any' | 'mask' } = { side: null, what: 'any' };
  input.addEventListener('change', () => {
    if (!files.isReady) return;
    const given = [...(input.files ?? [])];
    const [first] = given;
    if (wanted.what === 'mask' && wanted.side !== null && first !== undefined) void files.takeMask(first, wanted.side);
    else
      void files.give(
        given.map((file) => ({ file, path: '' })),
        wanted.side,
      );
    input.value = '';
    input.multiple = true;
    wanted = { side: null, what: 'any' };
  });
  // What was chosen while the program loaded.
  void files.ready.then(() => {
    if ((input.files?.length ?? 0) > 0) input.dispatchEvent(new Event('change'));
  });
  return (side, what = 'any') => {
    wanted = { side, what };
    input.multiple = side === null;
    input.click();
  };
}

/** Gives the name of the file; null where it says itself what came of it. */
type Writing = () => string | null | Promise<string | null>;

/** `near`: the `data-testid` of the button. */
export type Saving = (near: string, write: Writing) => Promise<void>;

export interface HeaderParts {
  store: Store;
  engine: Engine;
  view: View;
  files: Files;
  pick: Pick;
  attempt: (action: () => void | Promise<void>) => Promise<void>;
  /** Saves something, and says what was saved, or beside a button what stands in the way. */
  saving: Saving;
  /** Photographs a block and runs it. */
  sampleBlock: () => void;
}

/** What changes which results are wanted, before there are any. */
const WANTED = ['settings', 'camera', 'photos', 'masks', 'fiducialModel', 'offset', 'failures', 'history'] as const;

export function mountHeader({ store, engine, view, files, pick, attempt, saving, sampleBlock }: HeaderParts): void {
  const on = (id: string, action: () => void | Promise<void>) => {
    byId(id).addEventListener('click', () => void attempt(action));
  };
  const onExport = (id: string, write: Writing) => {
    byId(id).addEventListener('click', () => void saving('export-menu', write));
  };
  for (const id of ['open', 'open-first']) on(id, () => pick(null));
  for (const id of ['sample', 'sample-first']) on(id, () => files.takeSample());
  on('sample-block-first', sampleBlock);
  mountMenu(byId('export-menu'), byId('exports'));
  declareLack([byId('swap')], () => (SIDES.every((side) => store.state.images[side] === null) ? say('needs-two-photos') : ''));
  declareLack([byId('exports')], () => lackOfMatches(store.state));
  on('swap', () => swap(store, engine));
  onExport('export-csv', () => exportMatches(store.state, engine));
  onExport('export-json', () => exportEverything(store.state));
  onExport('export-project', () => exportProject(store, engine));
  onExport('export-report', () => exportReport(store, engine));
  onExport('export-epipolar', () => exportEpipolar(store, engine));
  onExport('export-png', () => exportPicture(store.state, view));
  store.watch(['images', 'results', 'catalogue', 'notice', 'running', ...WANTED], ([images, , catalogue]) => {
    const none = images.left === null && images.right === null;
    const set = (id: string, disabled: boolean) => {
      (byId(id) as HTMLButtonElement).disabled = disabled;
    };
    set('swap', none);
    set('sample', catalogue === null);
    set('sample-first', catalogue === null);
    set('sample-block-first', catalogue === null);
    const now = savable(store.state);
    for (const what of EXPORTS) set(`export-${what}`, !now[what]);
    leaveWelcome(!none);
  });
}

/** What is known of the truth says where left pixels are seen in the right image: it holds in the simulated order alone. */
function swap(store: Store, engine: Engine): void {
  const known = truthOf(store.state) !== null;
  engine.swap();
  if (known) store.dispatch({ type: 'notice', notice: { kind: 'info', text: say('the-truth-of-the-simulated-pair') } });
}

/** Hides the welcome; the keyboard goes on to the images where it was in there, or on the button that gave them. */
function leaveWelcome(left: boolean): void {
  const welcome = byId('welcome');
  const { activeElement } = document;
  const focused = welcome.contains(activeElement) || (!welcome.hidden && [byId('open'), byId('sample'), byId('menu')].some((press) => press === activeElement));
  welcome.hidden = left;
  if (left && focused) byId('view').focus({ preventScroll: true });
}
