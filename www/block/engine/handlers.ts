/** What a worker does for a block. */
import type { Handlers } from '../../shared/engine/messages';
import { jobs } from '../../../pkg/block/jobs.js';
import { plainError } from '../../../pkg/block/wire.js';
import type { BlockJob } from '../../../pkg/block/index.js';
import type { BlockCalls, JobAnswer } from './calls';
import { linksFinish, linksOpen, linksPlace } from './block-links';
import { blockFit, blockWindow } from './match';
import { blockPhoto, blockPlan } from './photo';
import { filmFrame, filmPlan } from './film';
import { blockGrey } from './grey';
import {
  imagePosition,
  mosaicAdd,
  mosaicFinish,
  mosaicOpen,
  orthoAdjust,
  orthoControl,
  orthoElsewhere,
  orthoInfo,
  orthoLaid,
  orthoPlace,
  orthoPredict,
  orthoRectified,
  orthoSearch,
  orthoTile,
  sceneOrthophoto,
} from './orthophoto';
import {
  blockEdited,
  blockExport,
  blockGround,
  blockImagePoints,
  blockLine,
  blockObservations,
  blockOpen,
  blockPlaces,
  blockPlacesAgain,
  blockPoint,
  blockRun,
} from './session';

/** The crate's refusal of an image is an answer; what else goes wrong ends the call, and perhaps the worker. */
async function blockJob(job: BlockJob): Promise<JobAnswer> {
  try {
    return { made: await jobs.block(job) };
  } catch (error) {
    if (!(error instanceof Error) || error.name !== 'TiepointError') throw error;
    return { refusal: plainError(error) };
  }
}

export const BLOCK_HANDLERS: Handlers<BlockCalls> = {
  blockJob,
  blockPlan,
  blockPhoto,
  blockGrey,
  blockWindow,
  blockFit,
  blockRun,
  blockOpen,
  blockPlaces,
  blockPlacesAgain,
  blockEdited,
  blockImagePoints,
  blockObservations,
  blockGround,
  blockPoint,
  blockLine,
  blockExport,
  imagePosition,
  orthoInfo,
  orthoTile,
  orthoElsewhere,
  orthoSearch,
  orthoPlace,
  orthoRectified,
  orthoAdjust,
  orthoControl,
  orthoPredict,
  orthoLaid,
  linksOpen,
  linksPlace,
  linksFinish,
  filmPlan,
  filmFrame,
  mosaicOpen,
  mosaicAdd,
  mosaicFinish,
  sceneOrthophoto,
};
