/** The stages of a run, in the order in which they depend on each other. */
import type { StageName } from './state';

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
  openLeft: { label: 'decoding the left image', worker: 'left', needs: [] },
  openRight: { label: 'decoding the right image', worker: 'right', needs: [] },
  pointsLeft: { label: 'detecting points, left', worker: 'left', needs: ['openLeft'] },
  pointsRight: { label: 'detecting points, right', worker: 'right', needs: ['openRight'] },
  descriptorsLeft: { label: 'describing points, left', worker: 'left', needs: ['pointsLeft'] },
  descriptorsRight: { label: 'describing points, right', worker: 'right', needs: ['pointsRight'] },
  offset: { label: 'estimating the offset of the images', worker: 'pair', needs: ['openLeft', 'openRight'] },
  match: { label: 'matching', worker: 'pair', needs: ['descriptorsLeft', 'descriptorsRight', 'offset'], uses: ['interiorLeft', 'interiorRight'] },
  interiorLeft: { label: 'interior orientation, left', worker: 'pair', needs: ['openLeft'] },
  interiorRight: { label: 'interior orientation, right', worker: 'pair', needs: ['openRight'] },
  orientation: { label: 'relative orientation', worker: 'pair', needs: ['match', 'interiorLeft', 'interiorRight'] },
  score: { label: 'comparing with the truth', worker: 'pair', needs: ['match'] },
  line: { label: 'looking where the point may lie', worker: 'pair', needs: ['match'] },
  inspection: { label: 'loading the selected point', worker: 'pair', needs: ['match'] },
};

export const STAGE_NAMES = Object.keys(STAGES) as StageName[];
