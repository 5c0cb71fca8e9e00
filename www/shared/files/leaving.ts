/** The project of the page is left for another one: one way at a time, and what was given for it, or is done with it, is not of the next one. */
import { breath } from '../engine/breath';

/** What was given, or is to be done, is not of the project that is shown now. */
export class ProjectLeft extends Error {
  override readonly name = 'ProjectLeft';
}

/** Throws `ProjectLeft` once the project is left that was shown when it was asked for. */
export type Here = () => void;

/** Takes what has these names for the project that is shown, and says so where that is left before all of it is there. */
export type TakeHere = (names: readonly string[], take: (here: Here) => Promise<void>) => Promise<void>;

export class Leaving {
  private turns: Promise<unknown> = Promise.resolve();
  /** How often a project was left. */
  count = 0;

  /** Begins once the ways before have ended, well or not, and who waited for them has gone on. */
  inTurn<T>(way: () => Promise<T>): Promise<T> {
    const turn = this.turns.then(way);
    this.turns = turn.catch(() => undefined).then(breath);
    return turn;
  }

  /** From now on what was given before comes too late. */
  leave(): void {
    this.count += 1;
  }

  /** Waits until no project is being left: what is given meanwhile belongs to the next one. */
  async left(): Promise<Here> {
    for (let turns: unknown = null; turns !== this.turns; ) {
      turns = this.turns;
      await turns;
    }
    return this.here();
  }

  /** Waits as `left` does, with what is to be done with the project that is shown now. @throws ProjectLeft once that is left */
  async stays(): Promise<Here> {
    const here = this.here();
    await this.left();
    here();
    return here;
  }

  private here(): Here {
    const { count } = this;
    return () => {
      if (this.count !== count) throw new ProjectLeft();
    };
  }
}

/** Takes something for the project that is shown. Where that is left before all of it is there the rest is not taken: `tell` says so in the next one. */
export async function takeHere(left: () => Promise<Here>, take: (here: Here) => Promise<void>, tell: () => void): Promise<void> {
  const here = await left();
  try {
    await take(here);
  } catch (error) {
    if (!(error instanceof ProjectLeft)) throw error;
    await left();
    tell();
  }
}

/** Does something with the project that is shown. Where that is left first the rest is not done, and there is nothing to say of it in the next one. */
export function doHere(stays: () => Promise<Here>, act: (here: Here) => Promise<void>): Promise<void> {
  return unlessLeft(stays().then(act));
}

/** What goes on ends without a word where its project is left. */
export async function unlessLeft(action: Promise<void>): Promise<void> {
  try {
    await action;
  } catch (error) {
    if (!(error instanceof ProjectLeft)) throw error;
  }
}
