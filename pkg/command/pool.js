// @ts-check
/** Worker threads that run named jobs. */

import { Worker } from 'node:worker_threads';
import { breakdownOf } from '../block/faults.js';
import { errorOf } from '../block/wire.js';

/**
 * @typedef {{ name: string, input: unknown, transfer: readonly ArrayBufferLike[], resolve: (output: any) => void, reject: (error: Error) => void }} Job
 * @typedef {{ worker: Worker, job: Job | null }} Lane
 */

/** Jobs wait in line for the first thread that is free. A thread that broke down is replaced, and its job rejected. */
export class ThreadPool {
  /** @type {Lane[]} */
  #lanes = [];
  /** @type {Job[]} */
  #line = [];
  #closed = false;

  /** @param {number} size */
  constructor(size) {
    this.size = size;
  }

  /** @param {string} name @param {any} input @param {readonly ArrayBufferLike[]} [transfer] memory that moves to the worker @returns {Promise<any>} */
  run(name, input, transfer = []) {
    return new Promise((resolve, reject) => {
      this.#line.push({ name, input, transfer, resolve, reject });
      this.#start();
    });
  }

  /** Ends all threads; jobs that were not done are rejected. */
  async close() {
    this.#closed = true;
    for (const job of this.#line.splice(0)) job.reject(new Error('the workers were ended'));
    await Promise.all(this.#lanes.map(({ worker }) => worker.terminate()));
  }

  #start() {
    while (this.#line.length > 0) {
      let lane = this.#lanes.find(({ job }) => job === null);
      if (!lane && this.#lanes.length < this.size) lane = this.#open();
      const job = lane && this.#line.shift();
      if (!lane || !job) return;
      try {
        lane.worker.postMessage({ name: job.name, input: job.input }, /** @type {ArrayBuffer[]} */ ([...job.transfer]));
        lane.job = job;
      } catch (error) {
        // What cannot be copied to a worker is the fault of this job alone.
        job.reject(error instanceof Error ? error : new Error(String(error)));
      }
    }
  }

  #open() {
    /** @type {Lane} */
    const lane = { worker: new Worker(new URL('./worker.js', import.meta.url)), job: null };
    lane.worker.on('message', ({ output, error }) => {
      const job = lane.job;
      lane.job = null;
      if (error) job?.reject(errorOf(error));
      else job?.resolve(output);
      // The module is not to be trusted after a trap or a panic.
      if (error && breakdownOf(error) !== null) this.#drop(lane);
      this.#start();
    });
    lane.worker.on('messageerror', (error) => this.#broken(lane, `the answer of the worker cannot be read: ${error.message}`));
    lane.worker.on('error', (error) => this.#broken(lane, error.message));
    lane.worker.on('exit', (code) => this.#broken(lane, `the worker ended with code ${code}`));
    this.#lanes.push(lane);
    return lane;
  }

  /** @param {Lane} lane */
  #drop(lane) {
    this.#lanes = this.#lanes.filter((other) => other !== lane);
    void lane.worker.terminate();
  }

  /** @param {Lane} lane @param {string} reason */
  #broken(lane, reason) {
    this.#drop(lane);
    lane.job?.reject(Object.assign(new Error(reason), { name: 'WorkerError' }));
    lane.job = null;
    if (!this.#closed) this.#start();
  }
}
