/** The answer of a block: what came of it; while there is none what runs, how far it is, what went wrong, and what to do. */
import { button, h } from '../../shared/panel/dom';
import { answerCard } from '../../shared/panel/answer';
import type { Answer, Figure, Next } from '../../shared/panel/answer';
import { message } from '../../shared/crate';
import { count, fixed, refusedText, sentence } from '../../shared/text/format';
import { readable } from '../../shared/text/names';
import { page } from '../../shared/text/words';
import type { BlockEngine, BlockStore } from '../engine/engine';
import { duration, runText } from './progress';
import { isBusy, isOutdated } from '../state/state';
import type { BlockState, Shown } from '../state/state';
import type { BlockView } from '../state/view';

/** What the button beside the answer can do. */
export interface BlockAnswerActions {
  /** Shows what speaks against the result. */
  why: () => void;
  save: () => void;
  /** Opens photos of one's own. */
  open: () => void;
}

/** `details`: the button that shows them. */
export function mountBlockStatus(store: BlockStore, engine: BlockEngine, actions: BlockAnswerActions, details: HTMLElement): HTMLElement {
  const line = h('p', { class: 'status', testid: 'block-status', role: 'status', aria: { live: 'polite' } });
  const run = button('Run', 'block-run', () => void engine.run());
  const cancel = button('Cancel', 'block-cancel', () => engine.cancel());
  const buttons = h('div', { class: 'answer-actions' }, run, cancel, details);
  const card = h('div', { class: 'answer', testid: 'block-answer' }, line, buttons);
  const show = answerCard(card, line, buttons, 'block-');
  store.watch(
    (s) => [s] as const,
    ([state]) => {
      const answer = answerOf(state, actions);
      // Each image and pair would be read out.
      line.setAttribute('aria-live', answer.kind === 'busy' ? 'off' : 'polite');
      // Messages of the crate name parameters by their keys.
      show({ ...answer, text: readable(state.catalogue?.labels ?? null, answer.text) });
      run.disabled = isBusy(state) || state.files.length < 2;
      run.textContent = state.running.kind === 'ended' ? 'Go on' : 'Run';
      run.classList.toggle('primary', answer.next == null);
      cancel.disabled = !isBusy(state);
    },
  );
  return card;
}

function answerOf(state: BlockState, actions: BlockAnswerActions): Answer {
  const { running, notice, shown, files } = state;
  const line = (kind: Answer['kind'], text: string): Answer => ({ kind, text, verdict: null });
  if (running.kind === 'yes') return line('busy', runText(running.steps));
  if (notice?.beside === true) {
    const answer = answerOf({ ...state, notice: null }, actions);
    return { ...answer, more: `${answer.more ?? ''} ${notice.text}`.trimStart() };
  }
  if (notice !== null) return line(notice.kind === 'info' ? 'idle' : notice.kind, notice.text);
  if (state.refused !== null) return line('problem', refusedText(state.refused));
  if (running.kind === 'ended') {
    const former = shown !== null && !shown.view.partial ? ' The screen shows the former block.' : '';
    if (running.failure === null)
      return line('idle', `Cancelled.${former} The work done is ${former === '' ? 'shown and ' : ''}kept: Go on continues from there.`);
    return line('problem', `The block was not finished: ${sentence(running.failure)}${former === '' ? ' The work done is kept.' : former}`);
  }
  if (shown !== null && !shown.view.partial && !isOutdated(state)) return answered(state, shown, actions);
  if (files.length >= 2) {
    const why = shown === null || shown.view.partial ? 'Press Run.' : 'Images or settings have changed: press Run.';
    return line('idle', `${page('block_images', { images: files.length })} ${why}`);
  }
  return line('idle', 'Open the images of a block: files, a folder, or a simulated block.');
}

function answered(state: BlockState, shown: Shown, actions: BlockAnswerActions): Answer {
  const { view, files } = shown;
  const why: Next = { text: 'Show why', act: actions.why };
  // A block that was opened may never have been oriented.
  if (view.oriented > 0 || files.length === 0) {
    const sound = view.verdict?.kind === 'oriented';
    const next = state.truth === null ? { text: 'Save the project', act: actions.save } : { text: 'Open your photos …', act: actions.open };
    return {
      kind: sound ? 'done' : 'partial',
      verdict: view.verdict?.kind ?? 'weak',
      text: view.verdict?.text ?? '',
      more: countsOf(shown),
      figures: figuresOf(view),
      next: sound ? next : why,
    };
  }
  const group = view.groups[0]?.length ?? 0;
  const figures = {
    why: view.warnings[0] ?? message('overview_warning', { kind: 'none_oriented' }),
    group: group < view.images.length ? group : null,
    images: view.images.length,
    pairs: connectedPairs(view),
    points: view.points.count,
  };
  return { kind: 'problem', verdict: 'not_oriented', text: page('block_not_oriented', figures), next: why };
}

function figuresOf(view: BlockView): Figure[] {
  return [
    { value: `${count(view.oriented)} of ${count(view.images.length)}`, label: 'photos oriented' },
    { value: count(view.points.count), label: 'points on several photos' },
    ...(view.sigma0Px === null ? [] : [{ value: `${fixed(view.sigma0Px, 2)} px`, label: 'precision (σ₀)' }]),
  ];
}

function connectedPairs({ connections }: BlockView): number {
  return connections.filter(({ outcome }) => outcome.kind === 'connected').length;
}

/** What there is of it, after its verdict. */
function countsOf({ view, seconds }: Shown): string {
  return page('block_done', {
    images: view.images.length,
    verdict: '',
    skipped: view.leftOut.length,
    pairs: connectedPairs(view),
    points: view.points.count,
    found: view.found?.points ?? null,
    time: seconds === 0 ? null : duration(seconds),
    warnings: view.warnings.length,
  }).trim();
}
