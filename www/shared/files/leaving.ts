/** The project of the page is left for another one: one way at a time, and what was given for it is not of the next one. */

/** What was given is not of the project that is shown now. */
export class ProjectLeft extends Error {
  override readonly name = 'ProjectLeft';
}

/** Throws `ProjectLeft` once the project is left that was shown when it was asked for. */
export type Here = () => void;

export class Leaving {
  private turns: Promise<unknown> = Promise.resolve();
  /** How often a project was left. */
  count = 0;

  /** Begins once the ways before have ended, well or not. */
  inTurn<T>(way: () => Promise<T>): Promise<T> {
    const turn = this.turns.then(way);
    this.turns = turn.catch(() => undefined);
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
