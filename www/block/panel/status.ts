/** The status line of the block: what runs, how far it is, what went wrong, and what to do. */
import { button, fill, h } from '../../shared/panel/dom';
import { message } from '../../shared/crate';
import { refusedText, sentence } from '../../shared/text/format';
import { readable } from '../../shared/text/names';
import { page } from '../../shared/text/words';
import type { BlockEngine, BlockStore } from '../engine/engine';
import { duration, runText } from './progress';
import { isBusy, isOutdated } from '../state/state';
import type { BlockState, Shown } from '../state/state';
import type { BlockView } from '../state/view';

export function mountBlockStatus(store: BlockStore, engine: BlockEngine): HTMLElement {
  const line = h('p', { class: 'status', testid: 'block-status', role: 'status', aria: { live: 'polite' } });
  const run = button('Run', 'block-run', () => void engine.run());
  run.className = 'primary';
  const cancel = button('Cancel', 'block-cancel', () => engine.cancel());
  store.watch(
    (s) => [s] as const,
    ([state]) => {
      const { text, kind } = lineOf(state);
      line.dataset.kind = kind;
      // Each image and pair would be read out.
      line.setAttribute('aria-live', kind === 'busy' ? 'off' : 'polite');
      // Messages of the crate name parameters by their keys.
      fill(line, readable(state.catalogue?.labels ?? null, text));
      run.disabled = isBusy(state) || state.files.length < 2;
      run.textContent = state.running.kind === 'ended' ? 'Go on' : 'Run';
      cancel.disabled = !isBusy(state);
    },
  );
  return h('div', { class: 'status-bar' }, line, run, cancel);
}

function lineOf(state: BlockState): { text: string; kind: 'idle' | 'busy' | 'done' | 'partial' | 'problem' } {
  const { running, notice, shown, files } = state;
  if (running.kind === 'yes') return { text: runText(running.steps), kind: 'busy' };
  if (notice?.beside === true) {
    const line = lineOf({ ...state, notice: null });
    return { ...line, text: `${line.text} ${notice.text}` };
  }
  if (notice !== null) return { text: notice.text, kind: notice.kind === 'info' ? 'idle' : notice.kind };
  if (state.refused !== null) return { text: refusedText(state.refused), kind: 'problem' };
  if (running.kind === 'ended') {
    const former = shown !== null && !shown.view.partial ? ' The screen shows the former block.' : '';
    if (running.failure === null)
      return { text: `Cancelled.${former} The work done is ${former === '' ? 'shown and ' : ''}kept: Go on continues from there.`, kind: 'idle' };
    return { text: `The block was not finished: ${sentence(running.failure)}${former === '' ? ' The work done is kept.' : former}`, kind: 'problem' };
  }
  if (shown !== null && !shown.view.partial && !isOutdated(state)) return doneLine(shown);
  if (files.length >= 2)
    return {
      text: `${page('block_images', { images: files.length })} ${shown === null || shown.view.partial ? 'Press Run.' : 'Images or settings have changed: press Run.'}`,
      kind: 'idle',
    };
  return { text: 'Open the images of a block: files, a folder, or a simulated block.', kind: 'idle' };
}

function doneLine(shown: Shown): { text: string; kind: 'done' | 'partial' | 'problem' } {
  const { view, files } = shown;
  // A block that was opened may never have been oriented.
  if (view.oriented > 0 || files.length === 0) return { text: doneText(shown), kind: view.verdict?.kind === 'oriented' ? 'done' : 'partial' };
  const group = view.groups[0]?.length ?? 0;
  const figures = {
    why: view.warnings[0] ?? message('overview_warning', { kind: 'none_oriented' }),
    group: group < view.images.length ? group : null,
    images: view.images.length,
    pairs: connectedPairs(view),
    points: view.points.count,
  };
  return { text: page('block_not_oriented', figures), kind: 'problem' };
}

function connectedPairs({ connections }: BlockView): number {
  return connections.filter(({ outcome }) => outcome.kind === 'connected').length;
}

function doneText({ view, seconds }: Shown): string {
  return page('block_done', {
    images: view.images.length,
    verdict: view.verdict?.text ?? '',
    skipped: view.leftOut.length,
    pairs: connectedPairs(view),
    points: view.points.count,
    found: view.found?.points ?? null,
    time: seconds === 0 ? null : duration(seconds),
    warnings: view.warnings.length,
  });
}
