/** Steps beside the edits of a block as the browser keeps them: those that made images of scans name the files of both, which are kept by themselves. */
import { likeOf, listOf, objectOf, orNull } from '../../shared/files/keepable';
import { remember } from '../../shared/state/remember';
import type { History } from '../../shared/state/history';
import type { KeptFile } from '../state/kept';
import { isFramesStep } from '../state/marks';
import type { Framing, FramesStep, MarkStep } from '../state/marks';
import type { BlockFile } from '../state/state';
import { bytesOfMarks, markStepFrom } from './edit';
import { filmFrom, textFrom } from './keep-placing';

type KeptFraming = Omit<Framing, 'images' | 'masks' | 'steps'> & { images: readonly KeptFile[]; masks: readonly KeptFile[]; steps: readonly KeptMarkStep[] };

export type KeptMarkStep = Exclude<MarkStep, FramesStep> | (Omit<FramesStep, 'scans' | 'frames'> & { scans: KeptFraming; frames: KeptFraming });

/** About what the names of a file take, in bytes. */
const OF_FILE = 120;

/** The same of the same step. */
const keptSteps = new WeakMap<FramesStep, KeptMarkStep>();

/** What is kept of them. `keptFile`: names a file that is kept by itself. */
export function keptMarkSteps(keptFile: (file: BlockFile) => KeptFile): (steps: History<MarkStep>) => History<KeptMarkStep> {
  const framing = ({ images, masks, steps, ...texts }: Framing): KeptFraming => ({
    ...texts,
    images: images.map(keptFile),
    masks: masks.map(keptFile),
    steps: steps.map(kept),
  });
  const kept = (step: MarkStep): KeptMarkStep => {
    if (!isFramesStep(step)) return step;
    const own = keptSteps.get(step) ?? { ...step, scans: framing(step.scans), frames: framing(step.frames) };
    keptSteps.set(step, own);
    return own;
  };
  return remember(({ edits, done }) => ({ edits: edits.map(kept), done }));
}

/** The steps with their files. @throws Error where a file of theirs is not there */
export function markStepsFrom({ edits, done }: History<KeptMarkStep>, fileFrom: (file: KeptFile) => BlockFile): History<MarkStep> {
  const framing = ({ images, masks, steps, ...texts }: KeptFraming): Framing => ({
    ...texts,
    images: images.map(fileFrom),
    masks: masks.map(fileFrom),
    steps: steps.map(own),
  });
  const own = (kept: KeptMarkStep): MarkStep => {
    if (kept.kind !== 'make_frames') return kept;
    const step = { ...kept, scans: framing(kept.scans), frames: framing(kept.frames) };
    keptSteps.set(step, kept);
    return step;
  };
  return { edits: edits.map(own), done };
}

/** The files that steps have, whether these hold or not. */
export const filesOfSteps = remember(({ edits }: History<MarkStep>): readonly BlockFile[] =>
  edits.filter(isFramesStep).flatMap(({ scans, frames }) => [...scans.images, ...scans.masks, ...frames.images, ...frames.masks]),
);

export function bytesOfKept(step: KeptMarkStep): number {
  if (step.kind !== 'make_frames') return bytesOfMarks(step);
  return [step.scans, step.frames].reduce((sum, { images, masks, cameras, marks, film, steps }) => {
    const texts = [cameras, marks, film.camera, ...film.marks].reduce((length, text) => length + (text?.text.length ?? 0), 0);
    return sum + OF_FILE * (images.length + masks.length) + texts + steps.reduce((bytes, one) => bytes + bytesOfKept(one), 0);
  }, 0);
}

/** `fileOf`: reads what a file is named by. @throws Error naming the field that is damaged */
export function keptStepFrom(fileOf: (value: unknown, name: string) => KeptFile): (value: unknown, name: string) => KeptMarkStep {
  const framing = (value: unknown, name: string): KeptFraming => {
    const { images, masks, cameras, marks, film, steps } = objectOf(value, name);
    return {
      images: listOf(images, `${name}.images`, fileOf),
      masks: listOf(masks, `${name}.masks`, fileOf),
      cameras: orNull(cameras, (text) => textFrom(text, `${name}.cameras`)),
      marks: orNull(marks, (text) => textFrom(text, `${name}.marks`)),
      film: filmFrom(film),
      steps: listOf(steps, `${name}.steps`, stepFrom),
    };
  };
  const stepFrom = (value: unknown, name: string): KeptMarkStep => {
    const { kind, scans, frames, after } = objectOf(value, name);
    if (kind !== 'make_frames') return markStepFrom(value, name);
    return { kind, scans: framing(scans, `${name}.scans`), frames: framing(frames, `${name}.frames`), after: likeOf(after, 0, `${name}.after`) };
  };
  return stepFrom;
}
