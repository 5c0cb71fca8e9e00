/** As many workers as the processor allows: each does one call at a time, the others wait in order. */
import { Cancelled, WorkerClient } from './client';
import type { Table } from './messages';

/** More workers than these would share memory bandwidth and take memory for an image each. */
const MOST_WORKERS = 8;

interface Task<C extends Table<C>> {
  start: (client: WorkerClient<C>) => Promise<void>;
  drop: () => void;
}

export class WorkerPool<C extends Table<C>> {
  readonly size = Math.min(MOST_WORKERS, Math.max(1, navigator.hardwareConcurrency || 1));
  private readonly idle: WorkerClient<C>[] = Array.from({ length: this.size }, (_, i) => new WorkerClient<C>(`pool ${String(i + 1)}`));
  private readonly all: readonly WorkerClient<C>[] = [...this.idle];
  private waiting: Task<C>[] = [];

  /** Rejects with `CallError` or `Cancelled`; no promise stays open. */
  call<K extends keyof C & string>(call: K, input: C[K]['input'], transfer: Transferable[] = []): Promise<C[K]['output']> {
    return new Promise((resolve, reject) => {
      const start = (client: WorkerClient<C>) => client.call(call, input, transfer).then(resolve, reject);
      this.waiting.push({ start, drop: () => reject(new Cancelled('cancelled')) });
      this.next();
    });
  }

  /** Ends all workers and what waits for them. The next call starts fresh ones. */
  cancel(): void {
    const { waiting } = this;
    this.waiting = [];
    for (const { drop } of waiting) drop();
    for (const client of this.all) client.cancel();
  }

  private next(): void {
    while (this.waiting.length > 0) {
      // The worker used last is warm.
      const client = this.idle.pop();
      const task = client === undefined ? undefined : this.waiting.shift();
      if (client === undefined || task === undefined) return;
      void task.start(client).finally(() => {
        this.idle.push(client);
        this.next();
      });
    }
  }
}
