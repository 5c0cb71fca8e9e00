/** Frames of scans of film, which a worker makes one after the other. */
import type { CameraRule } from '../../../pkg/wasm/tiepoint.js';
import type { WorkerClient } from '../../shared/engine/client';
import { say } from '../../shared/text/words';
import type { FilmTexts } from '../state/film';
import type { BlockFile } from '../state/state';
import type { BlockCalls } from './calls';
import type { Frame } from './film';

export interface Scan {
  file: BlockFile;
  film: FilmTexts;
  /** Its mask, in px of the scan. */
  mask: BlockFile | null;
}

/** The frame of a scan of film, with the id of the scan. */
export interface MadeFrame extends Frame {
  of: number;
}

/** Says how much is done. */
export type Tell = (done: number, total: number, text: string) => void;

/** All frames have one camera: what they have in common is found first. `given`: the cameras of frames that were made before. */
export async function makeFrames(worker: WorkerClient<BlockCalls>, scans: readonly Scan[], given: readonly CameraRule[], tell: Tell): Promise<MadeFrame[]> {
  const made: MadeFrame[] = [];
  const at = (name: string) => tell(made.length, scans.length, say('resampling-scan', { name }));
  at(scans[0]?.file.name ?? '');
  const plan = await worker.call('filmPlan', { films: scans.map(({ film }) => film), given });
  for (const { file, film, mask } of scans) {
    at(file.name);
    made.push({ ...(await worker.call('filmFrame', { file: file.file, film, plan, image: file.name, mask })), of: file.id });
  }
  return made;
}
