/** What a worker does for a block. */
import type { Handlers } from '../../shared/engine/messages';
import { jobs } from '../../../pkg/block/jobs.js';
import type { BlockJob } from '../../../pkg/block/index.js';
import type { BlockCalls, JobAnswer } from './calls';
import { blockPhoto, blockPlan } from './photo';
import { blockExport, blockOpen, blockRun } from './session';

/** The crate's refusal of an image is an answer; what else goes wrong ends the call, and perhaps the worker. */
async function blockJob(job: BlockJob): Promise<JobAnswer> {
  try {
    return { made: await jobs.block(job) };
  } catch (error) {
    if (!(error instanceof Error) || error.name !== 'TiepointError') throw error;
    const { message, code = '', usage = false } = error as Error & { code?: string; usage?: boolean };
    return { refusal: { message, code, usage } };
  }
}

export const BLOCK_HANDLERS: Handlers<BlockCalls> = { blockJob, blockPlan, blockPhoto, blockRun, blockOpen, blockExport };
