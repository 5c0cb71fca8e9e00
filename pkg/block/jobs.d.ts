/// <reference path="../libs.d.ts" />
import type { BlockJob } from './types.js';

/** What a worker does: jobs by name. Its host has initialised the module, takes `{ name, input }` of `Pool.run` and answers with the output. */
export interface Jobs {
  block: (input: BlockJob) => Promise<Uint8Array>;
}

export const jobs: Jobs;
