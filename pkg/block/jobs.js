// @ts-check
/** What a worker does for a block, of whatever kind it is, on the module that its host has initialised. */

import { execute_job } from '../wasm/tiepoint.js';

/** @type {import('./jobs.js').Jobs} */
export const jobs = { block: async ({ task, inputs }) => execute_job(task, inputs) };
