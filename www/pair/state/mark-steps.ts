/** Steps on the fiducial marks of a pair: each is undone by what it took away. */
import { recorded, wentTo } from '../../shared/state/history';
import type { History } from '../../shared/state/history';
import { say } from '../../shared/text/words';
import type { MarkStep, State } from './state';

type Marked = Pick<State, 'photos' | 'markSteps'>;

/** The state after one more step. */
export function withMarkStep({ photos, markSteps }: Marked, step: MarkStep): Marked {
  return { photos: stepped(photos, step), markSteps: isFirst(markSteps, step) ? markSteps : recordedStep(markSteps, step) };
}

/** The state after the first `done` of the steps. */
export function withMarkStepsDone({ photos, markSteps }: Marked, done: number): Marked {
  const next = wentTo(markSteps, done);
  const { edits } = markSteps;
  const again = edits.slice(markSteps.done, next.done);
  const back = edits.slice(next.done, markSteps.done).reverse();
  const all = [...back.map((step) => ({ ...step, out: step.put, put: step.out })), ...again];
  return { photos: all.reduce(stepped, photos), markSteps: next };
}

function stepped(photos: State['photos'], { side, at, out, put }: MarkStep): State['photos'] {
  const { fiducials } = photos[side];
  return { ...photos, [side]: { ...photos[side], fiducials: [...fiducials.slice(0, at), ...put, ...fiducials.slice(at + out.length)] } };
}

/** Marks of a file that a photo has first are what was given. */
function isFirst({ edits }: History<MarkStep>, { side, deed, out }: MarkStep): boolean {
  return deed === 'given' && out.length === 0 && edits.every((step) => step.side !== side);
}

/** A mark that is moved by many presses of a key is moved once. */
function recordedStep(history: History<MarkStep>, step: MarkStep): History<MarkStep> {
  const last = history.edits[history.done - 1];
  const goesOn = step.deed === 'nudged' && last?.deed === 'nudged' && last.side === step.side && last.at === step.at;
  return goesOn ? recorded(wentTo(history, history.done - 1), { ...step, out: last.out }) : recorded(history, step);
}

/** What a step did, as in "Undo: measure fiducial mark 3 of right.png". */
export function nameOfMarkStep({ deed, at, side }: MarkStep, images: State['images']): string {
  return say('step-of-mark', { deed, number: at + 1, image: images[side]?.name ?? say(side === 'left' ? 'left-image' : 'right-image') });
}
