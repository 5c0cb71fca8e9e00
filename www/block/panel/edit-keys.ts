import { declare } from '../../shared/view/commands';
import type { Command } from '../../shared/view/commands';
import { listenKeys } from '../../shared/view/gestures';
import { byId } from '../../shared/panel/dom';
import { undoKeys } from '../../shared/panel/history';
import type { BlockStore } from '../engine/engine';
import { takesPlaces } from '../state/places';
import { blockOnOrthophoto } from '../state/showing';
import { say } from '../../shared/text/words';
import { editOf, makeEdit, stepBy } from './edits';
import { lackOfBlock } from '../state/lacks';

/** The keys of edits: undo and redo wherever the block is shown, the others on the stage and in the tables. */
export function mountBlockEditKeys(store: BlockStore, hosts: readonly HTMLElement[]): void {
  // Links of images that were placed by themselves have keys of their own.
  const isBlockSeen = () => store.state.onStage !== 'orthophoto' || blockOnOrthophoto(store.state) !== null || takesPlaces(store.state);
  undoKeys(
    () => byId('block-view').offsetParent !== null && store.state.history.edits.length + store.state.marks.edits.length > 0 && isBlockSeen(),
    (by) => stepBy(store, by),
  );
  const idle = () => store.state.draft === null && isBlockSeen();
  const lack = (kind: 'reject' | 'restore') => {
    const block = lackOfBlock(store.state);
    if (block !== '') return block;
    return editOf(store.state, kind) === null ? say(kind === 'reject' ? 'nothing-to-reject-is-chosen' : 'nothing-rejected-is-chosen') : '';
  };
  const list: Command[] = [
    {
      keys: ['Delete', 'Backspace'],
      does: say('rejects-what-is-chosen-with'),
      can: idle,
      lacks: () => lack('reject'),
      run: (shift) => makeEdit(store, editOf(store.state, 'reject', shift)),
    },
    {
      keys: ['r'],
      does: say('uses-what-is-chosen-again'),
      can: idle,
      lacks: () => lack('restore'),
      run: (shift) => makeEdit(store, editOf(store.state, 'restore', shift)),
    },
  ];
  const edits = declare({ where: say('views-and-tables-of-a'), host: byId('block-view'), list });
  for (const host of hosts) listenKeys(host, edits);
}
