/** The stages of a run, in the order in which they depend on each other. */
import type { StageName } from './state';
import { say } from '../../shared/text/words';

export type WorkerName = 'left' | 'right' | 'pair' | 'preview' | 'report';

export interface StageInfo {
  /** What the status line says while it runs. */
  label: string;
  worker: WorkerName;
  /** Stages whose current results it needs, where they are wanted at all: a strategy without an expected place has no offset. */
  needs: readonly StageName[];
  /** Stages that it waits for where they are wanted, and does without where they failed. */
  uses?: readonly StageName[];
}

export const STAGES: Readonly<Record<StageName, StageInfo>> = {
  openLeft: { label: say('decoding-the-left-image'), worker: 'left', needs: [] },
  openRight: { label: say('decoding-the-right-image'), worker: 'right', needs: [] },
  pointsLeft: { label: say('detecting-points-left'), worker: 'left', needs: ['openLeft'] },
  pointsRight: { label: say('detecting-points-right'), worker: 'right', needs: ['openRight'] },
  descriptorsLeft: { label: say('describing-points-left'), worker: 'left', needs: ['pointsLeft'] },
  descriptorsRight: { label: say('describing-points-right'), worker: 'right', needs: ['pointsRight'] },
  offset: { label: say('estimating-the-offset-of-the'), worker: 'pair', needs: ['openLeft', 'openRight'] },
  match: { label: say('matching-2'), worker: 'pair', needs: ['descriptorsLeft', 'descriptorsRight', 'offset'], uses: ['interiorLeft', 'interiorRight'] },
  interiorLeft: { label: say('interior-orientation-left'), worker: 'pair', needs: ['openLeft'] },
  interiorRight: { label: say('interior-orientation-right'), worker: 'pair', needs: ['openRight'] },
  orientation: { label: say('relative-orientation-2'), worker: 'pair', needs: ['match', 'interiorLeft', 'interiorRight'] },
  score: { label: say('comparing-with-the-truth'), worker: 'pair', needs: ['match'] },
  difference: { label: say('comparing-how-the-photos-lie'), worker: 'pair', needs: ['openLeft', 'openRight'] },
  line: { label: say('looking-where-the-point-may'), worker: 'pair', needs: ['match'] },
  inspection: { label: say('loading-the-selected-point'), worker: 'pair', needs: ['match'] },
};

export const STAGE_NAMES = Object.keys(STAGES) as StageName[];
