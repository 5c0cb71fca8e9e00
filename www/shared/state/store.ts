/** Holds a state and tells who asked when a part of it changed. */

/** A state `S` that changes by actions `A` alone. */
export class Holder<S, A> {
  private readonly listeners: ((state: S) => void)[] = [];
  private dispatching = false;
  private readonly waiting: A[] = [];

  constructor(
    private current: S,
    private readonly reduce: (state: S, action: A) => S,
  ) {}

  get state(): S {
    return this.current;
  }

  /** Applies an action, then tells the listeners. An action dispatched by a listener follows after all have been told. */
  dispatch(action: A): void {
    this.waiting.push(action);
    if (this.dispatching) return;
    this.dispatching = true;
    try {
      for (let next = this.waiting.shift(); next !== undefined; next = this.waiting.shift()) {
        this.current = this.reduce(this.current, next);
        for (const listener of this.listeners) listener(this.current);
      }
    } finally {
      this.dispatching = false;
    }
  }

  /** Calls back now and whenever one of the watched values is another than before: parts of the state by their names, or what is selected of it. */
  watch<const K extends readonly (keyof S)[]>(names: K, callback: (values: { [I in keyof K]: S[K[I]] }) => void): void;
  watch<T extends readonly unknown[]>(select: (state: S) => T, callback: (values: T) => void): void;
  watch(what: readonly (keyof S)[] | ((state: S) => readonly unknown[]), callback: (values: never) => void): void {
    const select = typeof what === 'function' ? what : (state: S) => what.map((name) => state[name]);
    let seen = select(this.current);
    this.listeners.push((state) => {
      const values = select(state);
      if (values.every((value, i) => Object.is(value, seen[i]))) return;
      seen = values;
      callback(values as never);
    });
    callback(seen as never);
  }
}
