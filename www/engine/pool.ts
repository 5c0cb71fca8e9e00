/** As many workers as the processor allows: each does one call at a time, the others wait in order. */
import type { CallName, Input, Output } from './calls';
import { Cancelled, WorkerClient } from './client';

/** More workers than these would share memory bandwidth and take memory for an image each. */
const MOST_WORKERS = 8;

interface Task {
  start: (client: WorkerClient) => Promise<void>;
  drop: () => void;
}

export class WorkerPool {
  readonly size = Math.min(MOST_WORKERS, Math.max(1, navigator.hardwareConcurrency || 1));
  private readonly idle: WorkerClient[] = Array.from({ length: this.size }, (_, i) => new WorkerClient(`pool ${String(i + 1)}`));
  private readonly all: readonly WorkerClient[] = [...this.idle];
  private waiting: Task[] = [];

  /** Rejects with `CallError` or `Cancelled`; no promise stays open. */
  call<K extends CallName>(call: K, input: Input<K>, transfer: Transferable[] = []): Promise<Output<K>> {
    return new Promise((resolve, reject) => {
      const start = (client: WorkerClient) => client.call(call, input, transfer).then(resolve, reject);
      this.waiting.push({ start, drop: () => { reject(new Cancelled('cancelled')); } });
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
