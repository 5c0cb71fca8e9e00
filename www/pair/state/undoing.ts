/** Steps of a tool on what the images of a pair have, masks or marks: taken back and made again as long as nothing else has changed that. */
import { NO_HISTORY, recorded, wentTo } from '../../shared/state/history';
import type { History } from '../../shared/state/history';
import type { Side, State } from './state';

/** What an image had before a step, and what it had after it. */
export interface Step<V> {
  /** The image, wherever it is in the pair. */
  imageId: number;
  name: string;
  before: V;
  after: V;
}

/** The side of an image; undefined where it is no longer in the pair. */
export function sideOf({ images: { left, right } }: Pick<State, 'images'>, imageId: number): Side | undefined {
  return left?.id === imageId ? 'left' : right?.id === imageId ? 'right' : undefined;
}

export class Undoing<V, S extends Step<V> = Step<V>> {
  private all: History<S> = NO_HISTORY;

  constructor(
    private readonly state: () => State,
    /** What an image has now. */
    private readonly now: (side: Side) => V,
    private readonly isSame: (a: V, b: V) => boolean,
    /** Steps that can be taken back. */
    private readonly most: number,
  ) {}

  /** The steps that can be taken back and made again; those whose image has something else by now are gone. */
  get history(): History<S> {
    let { edits, done } = this.all;
    for (let last = edits[done - 1]; last !== undefined && !this.isAt(last, last.after); last = edits[done - 1]) {
      edits = without(edits, done - 1);
      done -= 1;
    }
    for (let next = edits[done]; next !== undefined && !this.isAt(next, next.before); next = edits[done]) edits = without(edits, done);
    if (edits !== this.all.edits) this.all = { edits, done };
    return this.all;
  }

  /** The step that was made last. */
  get last(): S | undefined {
    const { edits, done } = this.history;
    return edits[done - 1];
  }

  /** Takes a step that is about to be made. */
  record(step: S): void {
    this.keep(this.history, step);
  }

  /** Takes a step in place of the one that was made last. */
  amend(step: S): void {
    const { history } = this;
    this.keep(wentTo(history, history.done - 1), step);
  }

  private keep(history: History<S>, step: S): void {
    const edits = recorded(history, step).edits.slice(-this.most);
    this.all = { edits, done: edits.length };
  }

  /** Goes a step back or on: gives it with the side and what its image has then; null where there is none. */
  go(by: 1 | -1): { step: S; side: Side; value: V } | null {
    const { edits, done } = this.history;
    const step = edits[by < 0 ? done - 1 : done];
    const side = step === undefined ? undefined : sideOf(this.state(), step.imageId);
    if (step === undefined || side === undefined) return null;
    this.all = wentTo(this.all, done + by);
    return { step, side, value: by < 0 ? step.before : step.after };
  }

  private isAt({ imageId }: S, value: V): boolean {
    const side = sideOf(this.state(), imageId);
    return side !== undefined && this.isSame(this.now(side), value);
  }
}

function without<T>(all: readonly T[], index: number): readonly T[] {
  return all.filter((_, i) => i !== index);
}
