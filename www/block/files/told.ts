/** What is said of files that are given to a block, and of what is done with it. */
import { Cancelled } from '../../shared/engine/client';
import type { Here } from '../../shared/files/leaving';
import type { Notice } from '../../shared/state/notice';
import { messageOf } from '../../shared/text/messages';
import { say } from '../../shared/text/words';
import type { BlockStore } from '../engine/engine';
import { isOutdated } from '../state/state';

export class Telling {
  constructor(private readonly store: BlockStore) {}

  tell(kind: 'info' | 'busy' | 'problem', text: string): void {
    this.store.dispatch({ type: 'notice', notice: { kind, text } });
  }

  /** Says what was taken: of a block that was made without it beside what is to be done then. */
  tellTaken(text: string): void {
    this.store.dispatch({ type: 'notice', notice: { kind: 'info', text, beside: isOutdated(this.store.state) } });
  }

  /** Says that nothing that was given is read; while something runs, beside that. */
  tellUnread(text: string): void {
    this.store.dispatch({ type: 'notice', notice: { kind: 'problem', text, beside: this.runsNow() } });
  }

  /** Whether the block is run, or images are placed. */
  runsNow(): boolean {
    const { running, placing } = this.store.state;
    return running.kind === 'yes' || placing.running !== null;
  }

  failed(what: string, error: unknown, here: Here): void {
    here();
    if (error instanceof Cancelled) this.tell('info', say('cancelled-nothing-was-changed'));
    else this.tell('problem', say('the-block-is-unchanged', { what, error: messageOf(error) }));
  }

  /** Says more than what was said of the same files; where that is nothing, beside what is said of the block. */
  tellBeside(said: Notice | null, text: string): void {
    const notice: Notice = said === null ? { kind: 'info', text, beside: true } : { ...said, text: `${said.text} ${text}` };
    this.store.dispatch({ type: 'notice', notice });
  }
}
