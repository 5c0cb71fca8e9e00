/** The status line of the block: what runs, how far it is, what went wrong, and what to do. */
import { button, fill, h } from '../../shared/panel/dom';
import { count, refusedText, sentence } from '../../shared/text/format';
import { readable } from '../../shared/text/names';
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

function lineOf(state: BlockState): { text: string; kind: 'idle' | 'busy' | 'done' | 'problem' } {
  const { running, notice, shown, files } = state;
  if (running.kind === 'yes') return { text: runText(running.steps), kind: 'busy' };
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
      text: `${count(files.length)} images. ${shown === null || shown.view.partial ? 'Press Run.' : 'Images or settings have changed: press Run.'}`,
      kind: 'idle',
    };
  return { text: 'Open the images of a block: files, a folder, or a simulated block.', kind: 'idle' };
}

function doneLine(shown: Shown): { text: string; kind: 'done' | 'problem' } {
  const { view, files } = shown;
  // A block that was opened may never have been oriented.
  if (view.oriented > 0 || files.length === 0) return { text: doneText(shown), kind: 'done' };
  const why = view.warnings[0] ?? 'No image could be oriented.';
  const group = view.groups[0]?.length ?? 0;
  const apart =
    group < view.images.length ? ` The largest group of connected images has ${count(group)} of ${count(view.images.length)}: do they overlap?` : '';
  const connected = view.connections.filter(({ outcome }) => outcome.kind === 'connected').length;
  return {
    text: `${why}${apart} Kept: ${count(view.images.length)} images with their features, ${counted(connected, 'connected pair')}, ${counted(view.points.count, 'tie point')}.`,
    kind: 'problem',
  };
}

function doneText({ view, seconds }: Shown): string {
  const connected = view.connections.filter(({ outcome }) => outcome.kind === 'connected').length;
  const left = view.leftOut.length === 0 ? '' : `, ${count(view.leftOut.length)} skipped`;
  const time = seconds === 0 ? '' : ` ${duration(seconds)}.`;
  const oriented = view.oriented === 0 ? '' : `, ${view.oriented === view.images.length ? 'all' : count(view.oriented)} oriented`;
  const weak = view.warnings.length === 0 ? '' : ` ${counted(view.warnings.length, 'warning', 'warnings')}, see Results.`;
  return `Done: ${counted(view.images.length, 'image')}${oriented}${left}, ${counted(connected, 'pair')} connected, ${pointsText(view)}.${time}${weak}`;
}

function pointsText({ points, found }: BlockView): string {
  return found === null ? counted(points.count, 'tie point') : `${count(points.count)} of ${counted(found.points, 'tie point')} selected`;
}

function counted(number: number, one: string, many = `${one}s`): string {
  return `${count(number)} ${number === 1 ? one : many}`;
}
