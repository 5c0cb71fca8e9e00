/** Leaves the pair in the list of projects before another one takes its place. */
import type { Here } from '../../shared/files/leaving';
import { titleOf } from '../../shared/text/project';
import { say } from '../../shared/text/words';
import { isWorthKeeping } from '../state/kept';
import { SIDES } from '../state/state';
import type { Store } from '../state/store';
import { info } from './told';
import type { Told } from './told';

export class PairAside {
  constructor(
    private readonly store: Store,
    /** Leaves the project in the list; false where it cannot. */
    private readonly putAside: () => Promise<boolean>,
  ) {}

  /**
   * Before another pair takes the place of one that is worth keeping: it stays in the list of projects, which is said; null where it cannot, and the user keeps
   * it. `marksGo`: so do images whose marks go with them.
   */
  async leave(marksGo: boolean, here: Here): Promise<readonly Told[] | null> {
    here();
    if (!marksGo && !isWorthKeeping(this.store.state)) return [];
    const names = SIDES.flatMap((side) => this.store.state.images[side]?.name ?? []);
    const stays = await this.putAside();
    here();
    if (stays) return [info(say('stay-under-projects', { title_of: titleOf({ name: null, images: names }) }))];
    const question = say('cannot-be-kept-in-this', { edits: say('the-pair-with-its-marks'), step: say('open-the-other-pair'), length: 1 });
    return window.confirm(question) ? [] : null;
  }
}
