/** What a worker does for a block. */
import type { Handlers } from '../../shared/engine/messages';
import { jobs } from '../../../pkg/block/jobs.js';
import type { Jobs } from '../../../pkg/block/index.js';
import type { BlockCalls, JobAnswer, JobRequest } from './calls';
import { blockPhoto, blockPlan } from './photo';
import { blockExport, blockOpen, blockRun } from './session';

/** The crate's refusal of an image is an answer; what else goes wrong ends the call, and perhaps the worker. */
async function blockJob(job: JobRequest): Promise<JobAnswer> {
  try {
    return { made: await perform(job) };
  } catch (error) {
    if (!(error instanceof Error) || error.name !== 'TiepointError') throw error;
    const { message, code = '', usage = false } = error as Error & { code?: string; usage?: boolean };
    return { refusal: { message, code, usage } };
  }
}

function perform({ name, input }: JobRequest): Promise<Jobs[keyof Jobs]['output']> {
  const job = jobs[name];
  if (job === undefined) throw new Error(`there is no job ${name}`);
  // `JobRequest` pairs each name with its input.
  return job(input as never);
}

export const BLOCK_HANDLERS: Handlers<BlockCalls> = { blockJob, blockPlan, blockPhoto, blockRun, blockOpen, blockExport };
