/** What is said of files that were given: what each of them became, or why it is not used. */
import { Cancelled } from '../../shared/engine/client';
import type { Here } from '../../shared/files/leaving';
import type { Choice, Notice } from '../../shared/state/notice';
import { sentence } from '../../shared/text/format';
import { messageOf } from '../../shared/text/messages';
import { readable } from '../../shared/text/names';
import { say } from '../../shared/text/words';
import { SIDES } from '../state/state';
import type { Store } from '../state/store';

/** What came of a file; null where the page shows it. */
export type Told = { kind: 'info' | 'problem'; text: string; choices?: readonly Choice[] } | null;

export const problem = (text: string): Told => ({ kind: 'problem', text });
export const info = (text: string): Told => ({ kind: 'info', text });
export const unchanged = () => info(say('cancelled-nothing-was-changed'));

export class Telling {
  constructor(private readonly store: Store) {}

  /** Says together what came of files that were given together; `before`: the images that were open then. */
  tell(told: readonly Told[], before = this.store.state.images): void {
    const said = [...this.saidMeanwhile(), ...told.filter((one) => one !== null)];
    const bad = said.some(({ kind }) => kind === 'problem');
    const { images } = this.store.state;
    // Where nothing was open there is nothing to be afraid for.
    const areKept = SIDES.every((side) => images[side] === before[side]) && SIDES.some((side) => before[side] !== null);
    const kept = bad && areKept ? say('the-open-images-are-kept') : '';
    const text = `${said.map((one) => one.text).join(' ')}${kept}`;
    const choices = said.flatMap((one) => one.choices ?? []);
    const notice: Notice = { kind: bad ? 'problem' : 'info', text, ...(choices.length > 0 && { choices }) };
    this.store.dispatch({ type: 'notice', notice: said.length === 0 ? null : notice });
  }

  /** What was said since the files were taken, as that the camera is not that of the new images. */
  private saidMeanwhile(): readonly { kind: 'info'; text: string; choices?: readonly Choice[] }[] {
    const { notice } = this.store.state;
    return notice?.kind !== 'info' || notice.choices !== undefined ? [] : [{ kind: 'info', text: notice.text }];
  }

  failed(what: string, error: unknown, here: Here): Told {
    here();
    if (error instanceof Cancelled) return unchanged();
    return problem(`${what}: ${sentence(readable(this.store.state.catalogue, messageOf(error)))}`);
  }
}
