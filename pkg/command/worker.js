// @ts-check
/** A worker of the command: takes jobs by name, one at a time, and answers with what they give or throw. */

import { parentPort } from 'node:worker_threads';
import '../node.js';
import { jobs } from '../block/jobs.js';
import * as pairJobs from './pair-jobs.js';
import { photoFile } from '../block/photo.js';
import { plainError } from '../block/wire.js';

/** @type {Record<string, (input: any) => Promise<any>>} */
const ALL = { ...jobs, ...pairJobs, photo: async (/** @type {any} */ job) => photoFile(job) };

parentPort?.on('message', async ({ name, input }) => {
  try {
    const job = ALL[name];
    if (!job) throw new Error(`there is no job ${name}`);
    const output = await job(input);
    parentPort?.postMessage({ output }, ArrayBuffer.isView(output) ? [/** @type {ArrayBuffer} */ (output.buffer)] : []);
  } catch (error) {
    fail(error);
  }
});
parentPort?.on('messageerror', fail);

/** @param {unknown} error */
function fail(error) {
  parentPort?.postMessage({ error: plainError(error) });
}
