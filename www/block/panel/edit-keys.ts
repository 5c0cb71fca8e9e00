import { declare } from '../../shared/view/commands';
import type { Command } from '../../shared/view/commands';
import { listenKeys } from '../../shared/view/gestures';
import { byId } from '../../shared/panel/dom';
import { undoKeys } from '../../shared/panel/history';
import type { BlockStore } from '../engine/engine';
import type { Facts } from '../engine/facts';
import type { BlockState } from '../state/state';
import { takesPlaces } from '../state/places';
import { blockOnOrthophoto } from '../state/showing';
import { say } from '../../shared/text/words';
import { editOf, makeEdit, stepBy } from './edits';
import { lackOfBlock } from '../state/lacks';

/** Whether there is something to take back, or to make again; the places of a point that is measured, too. */
function hasSteps({ history, marks, draft }: BlockState): boolean {
  return history.edits.length + marks.edits.length > 0 || draft !== null;
}

/** The keys of edits: undo and redo wherever the block is shown, the others on the stage and in the tables. */
export function mountBlockEditKeys(store: BlockStore, facts: Facts, hosts: readonly HTMLElement[]): void {
  // Links of images that were placed by themselves have keys of their own.
  const isBlockSeen = () => store.state.onStage !== 'orthophoto' || blockOnOrthophoto(store.state) !== null || takesPlaces(store.state);
  undoKeys(
    () => byId('block-view').offsetParent !== null && hasSteps(store.state) && isBlockSeen(),
    (by) => stepBy(store, by),
  );
  const idle = () => store.state.draft === null && isBlockSeen();
  const lack = (kind: 'reject' | 'restore') => {
    const block = lackOfBlock(store.state);
    if (block !== '') return block;
    return editOf(store.state, facts, kind) === null ? say(kind === 'reject' ? 'nothing-to-reject-is-chosen' : 'nothing-rejected-is-chosen') : '';
  };
  const list: Command[] = [
    {
      keys: ['Delete', 'Backspace'],
      does: say('rejects-what-is-chosen-with'),
      can: idle,
      lacks: () => lack('reject'),
      run: (shift) => makeEdit(store, editOf(store.state, facts, 'reject', shift)),
    },
    {
      keys: ['r'],
      does: say('uses-what-is-chosen-again'),
      can: idle,
      lacks: () => lack('restore'),
      run: (shift) => makeEdit(store, editOf(store.state, facts, 'restore', shift)),
    },
  ];
  const edits = declare({ where: say('views-and-tables-of-a'), host: byId('block-view'), list });
  for (const host of hosts) listenKeys(host, edits);
}
