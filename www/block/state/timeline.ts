/** Edits of a block and the steps beside it, which are measurements of control points and images taken out, as one history: in the order in which they are undone. Pure. */
import type { History } from '../../shared/state/history';
import { remember } from '../../shared/state/remember';
import type { EditStep } from './edits';
import type { MarkStep } from './marks';
import type { BlockState } from './state';

/** A step by its place in its own history. */
export interface TimedStep {
  of: 'edits' | 'marks';
  at: number;
}

type Both = Pick<BlockState, 'history' | 'marks'>;

const timeline = remember((history: History<EditStep>, marks: History<MarkStep>): History<TimedStep> => {
  const steps: TimedStep[] = [];
  let next = 0;
  const editsUpTo = (end: number) => {
    for (; next < Math.min(end, history.edits.length); next += 1) steps.push({ of: 'edits', at: next });
  };
  marks.edits.forEach(({ after }, at) => {
    editsUpTo(after);
    steps.push({ of: 'marks', at });
  });
  editsUpTo(Infinity);
  const holds = ({ of, at }: TimedStep) => at < (of === 'edits' ? history : marks).done;
  // A step that was made after others were undone stands before them.
  return { edits: [...steps.filter(holds), ...steps.filter((step) => !holds(step))], done: history.done + marks.done };
});

/** All steps, and how many of them hold: undo takes the last of these back, redo makes the next one again. */
export function timelineOf({ history, marks }: Both): History<TimedStep> {
  return timeline(history, marks);
}

/** How many edits and how many steps beside them hold. */
export interface Held {
  edits: number;
  marks: number;
}

/** Those that do where so many of all do. */
export function heldAt(both: Both, place: number): Held {
  const first = timelineOf(both).edits.slice(0, Math.max(0, place));
  const marks = first.filter(({ of }) => of === 'marks').length;
  return { edits: first.length - marks, marks };
}
