/** What the answer says while nothing is answered yet: what runs, how far it is, what went wrong, and what to do. */
import { hasMarks } from '../state/kept';
import { isCurrent } from '../state/keys';
import { STAGES } from '../state/stages';
import { anyStale, currentFailure, isBusy, progress } from '../state/select';
import type { StageName, State } from '../state/state';
import type { Store } from '../state/store';
import { resting } from './answer';
import type { AnswerActions } from './answer';
import { summary } from './counts';
import { answerCard } from '../../shared/panel/answer';
import type { Answer } from '../../shared/panel/answer';
import { ofLine } from '../../shared/state/notice';
import type { Choice, Notice } from '../../shared/state/notice';
import { byId } from '../../shared/panel/dom';
import { refusedText, say } from '../../shared/text/words';
import { declareLack } from '../../shared/panel/lack';

/** A run shorter than this shows no bar: it would only flicker. */
const PATIENCE_MS = 250;

export interface StatusActions extends AnswerActions {
  cancel: () => void;
  run: () => void;
}

export function mountStatus(store: Store, actions: StatusActions): void {
  const show = answerCard(byId('answer'), byId('status'), byId('answer-actions'), '');
  const bar = byId('progress') as HTMLProgressElement;
  const cancel = byId('cancel') as HTMLButtonElement;
  declareLack([cancel], () => (cancel.disabled || cancel.hidden ? say('nothing-is-running') : ''));
  const run = byId('run') as HTMLButtonElement;
  cancel.addEventListener('click', actions.cancel);
  run.addEventListener('click', actions.run);
  let timer: number | undefined;
  store.watch(
    (s) => [s] as const,
    ([state]) => {
      const busy = isBusy(state);
      const { wanted, done } = progress(state);
      bar.max = Math.max(1, wanted);
      bar.value = done;
      cancel.disabled = !busy;
      run.hidden = !(state.paused && (state.images.left !== null || state.images.right !== null)) && currentFailure(state)?.ended !== true;
      show(answerOf(state, actions));
      document.body.classList.toggle('is-pending', anyStale(state));
      if (!busy) {
        window.clearTimeout(timer);
        timer = undefined;
        bar.classList.remove('is-on');
      } else {
        timer ??= window.setTimeout(() => bar.classList.add('is-on'), PATIENCE_MS);
      }
    },
  );
}

function answerOf(state: State, actions: AnswerActions): Answer {
  const notice = ofLine(state.notice);
  if (notice?.choices !== undefined) return question(notice.text, notice.choices, isBusy(state));
  if (notice?.kind !== 'problem') return answerWith(state, notice, actions);
  const answer = answerWith(state, null, actions);
  // What is open, and what is being computed, is not worth less for it.
  return answer.kind === 'idle' ? { ...answer, kind: 'problem', text: notice.text, more: '' } : { ...answer, problem: notice.text };
}

/** What runs meanwhile can be cancelled. */
function question(text: string, [next, ...others]: readonly Choice[], busy: boolean): Answer {
  return { kind: busy ? 'busy' : 'idle', verdict: null, text, next: next ?? null, others };
}

function answerWith(state: State, notice: Notice | null, actions: AnswerActions): Answer {
  const line = (kind: Answer['kind'], text: string): Answer => ({ kind, text, verdict: null });
  const failure = currentFailure(state);
  const { running, wanted, done } = progress(state);
  if (running.length > 0)
    return line('busy', say('step', { step: Math.min(done + 1, wanted), steps: wanted, stages: running.map((stage) => STAGES[stage].label).join('; ') }));
  if (notice?.kind === 'busy') return line('busy', notice.text);
  if (state.paused) {
    const { openLeft, openRight } = state.results;
    const opened = openLeft === undefined && openRight === undefined ? 'cancelled-the-images-stay' : 'cancelled-results-on-the-screen';
    return { ...line('idle', say(waitsForMarks(state) ? 'the-images-wait-for-run' : opened)), more: notice?.text ?? '' };
  }
  if (failure !== null && !isOrientation(failure)) return line('problem', `${failure.message} ${matchedAllTheSame(state, failure.stage)}`.trimEnd());
  const [refused] = Object.values(state.refused);
  if (refused !== undefined) return line('problem', refusedText(refused));
  const answer = resting(state, done < wanted, actions);
  if (notice === null) return answer;
  if (notice.beside === true) return { ...answer, said: notice.text };
  if (answer.verdict === null) return line('idle', notice.text);
  return { ...answer, more: `${answer.more ?? ''} ${notice.text}`.trimStart() };
}

/** Whether a pair waits with its marks, of which nothing was matched yet. */
function waitsForMarks(state: State): boolean {
  const isBegun = isCurrent(state, 'pointsLeft') || isCurrent(state, 'pointsRight');
  return !isBegun && (state.tool === 'fiducials' || hasMarks(state));
}

/** Matches that determine no orientation are a result all the same. */
function isOrientation({ stage, ended }: { stage: StageName; ended: boolean }): boolean {
  return !ended && stage === 'orientation';
}

/** Without an interior orientation there are matches, but no more. */
function matchedAllTheSame(state: State, failed: StageName): string {
  const matches = summary(state);
  return (failed === 'interiorLeft' || failed === 'interiorRight') && matches !== '' ? say('not-oriented-4', { matches }) : '';
}
