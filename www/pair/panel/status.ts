/** The status line: what runs, how far it is, what went wrong, and what to do. */
import { message, pair_hint } from '../../shared/crate';
import { isCurrent } from '../state/keys';
import { whyNone } from '../state/project';
import { STAGES } from '../state/stages';
import { anyStale, currentFailure, progress } from '../state/select';
import type { StageName, State } from '../state/state';
import type { Store } from '../state/store';
import { summary } from './counts';
import { refusedText } from '../../shared/text/format';
import { page } from '../../shared/text/words';
import { whyNotOriented } from './orientation';
import { byId } from '../../shared/panel/dom';

/** A run shorter than this shows no bar: it would only flicker. */
const PATIENCE_MS = 250;

export interface StatusActions {
  cancel: () => void;
  run: () => void;
}

interface Line {
  text: string;
  /** `partial`: matched, but not oriented, or weakly. */
  kind: 'idle' | 'busy' | 'done' | 'partial' | 'problem';
}

export function mountStatus(store: Store, actions: StatusActions): void {
  const line = byId('status');
  const bar = byId('progress') as HTMLProgressElement;
  const cancel = byId('cancel') as HTMLButtonElement;
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
      run.hidden = !(state.paused && state.images.left !== null) && currentFailure(state)?.ended !== true;
      show(line, lineOf(state));
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

export function isBusy(state: State): boolean {
  return Object.keys(state.running).length > 0 || state.notice?.kind === 'busy';
}

function show(line: HTMLElement, { text, kind }: Line): void {
  line.dataset.kind = kind;
  if (line.textContent !== text) line.textContent = text;
}

function lineOf(state: State): Line {
  const failure = currentFailure(state);
  if (state.notice?.kind === 'problem') return { text: state.notice.text, kind: 'problem' };
  const { running, wanted, done } = progress(state);
  if (running.length > 0)
    return {
      text: page('step', { step: Math.min(done + 1, wanted), steps: wanted, stages: running.map((stage) => STAGES[stage].label).join('; ') }),
      kind: 'busy',
    };
  if (state.notice?.kind === 'busy') return { text: state.notice.text, kind: 'busy' };
  if (state.paused) return { text: 'Cancelled. Results on the screen are kept. Press Run, or change a setting, to go on.', kind: 'idle' };
  if (failure !== null && !isOrientation(failure)) return { text: `${failure.message} ${matchedAllTheSame(state, failure.stage)}`.trimEnd(), kind: 'problem' };
  const [refused] = Object.values(state.refused);
  if (refused !== undefined) return { text: refusedText(refused), kind: 'problem' };
  const line = resting(state, wanted, done);
  if (state.notice === null) return line;
  return line.kind === 'done' || line.kind === 'partial' ? { ...line, text: `${line.text} ${state.notice.text}` } : { text: state.notice.text, kind: 'idle' };
}

function resting(state: State, wanted: number, done: number): Line {
  if (state.catalogue === null) return { text: 'Loading the program …', kind: 'busy' };
  if (state.images.left === null && state.images.right === null) return { text: 'Ready. Open two overlapping images, or use the sample pair.', kind: 'idle' };
  if (state.images.left === null || state.images.right === null) {
    return { text: `One image is open. Open the ${state.images.left === null ? 'left' : 'right'} one.`, kind: 'idle' };
  }
  if (done < wanted) return { text: 'Waiting …', kind: 'busy' };
  const milliseconds = Object.entries(state.results).reduce(
    (sum, [stage, result]) => sum + (stage === 'inspection' || stage === 'line' ? 0 : result.milliseconds),
    0,
  );
  // A pair that was opened took none.
  const matched = milliseconds === 0 ? `${summary(state)}.` : page('worked', { matched: summary(state), seconds: milliseconds / 1000 });
  const reason = whyNotOriented(state);
  const verdict = isCurrent(state, 'orientation') ? state.results.orientation?.value.verdict : undefined;
  const hint = state.settings === null ? null : pair_hint(verdict ?? { kind: 'not_oriented', no_orientation: whyNone(state) }, state.settings);
  const more = hint === null ? '' : ` ${message('pair_hint', hint)}`;
  if (reason !== null || verdict === undefined) return { text: `${matched} ${reason ?? ''}`.trimEnd() + more, kind: 'partial' };
  return { text: `${message('pair_verdict', verdict)} ${matched}${more}`, kind: verdict.kind === 'oriented' ? 'done' : 'partial' };
}

/** Matches that determine no orientation are a result all the same. */
function isOrientation({ stage, ended }: { stage: StageName; ended: boolean }): boolean {
  return !ended && stage === 'orientation';
}

/** Without an interior orientation there are matches, but no more. */
function matchedAllTheSame(state: State, failed: StageName): string {
  const matches = summary(state);
  return (failed === 'interiorLeft' || failed === 'interiorRight') && matches !== '' ? `Not oriented: ${matches}.` : '';
}
