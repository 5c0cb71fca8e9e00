/** The line over the pair while it shows scans of the block: their fiducial marks are measured there, and become those of the block. */
import { arrange, button, fill, h } from '../../shared/panel/dom';
import { passFocus } from '../../shared/panel/focus';
import type { Modes } from '../../shared/state/mode';
import { say } from '../../shared/text/words';
import type { BlockStore } from '../engine/engine';
import type { TextFile } from '../state/file';
import { countedScans, lackOf, nextScans, tablesToTake } from '../state/scan-marks';
import type { MeasuredScan } from '../state/scan-marks';
import { isBusy } from '../state/state';
import type { BlockFile } from '../state/state';

/** What the line needs of the pair. */
export interface ScansBeside {
  /** The scans of the block that the pair shows. */
  shown: () => readonly MeasuredScan[];
  /** Calls back whenever they, or what is measured in them, may have changed. */
  watch: (changed: () => void) => void;
  /** Shows one scan, or two; resolves once they are there, or cannot be shown. */
  open: (scans: readonly BlockFile[]) => Promise<void>;
  /** Begins to measure the marks of one that is shown. */
  measure: (image: string) => void;
}

/** What the line does in the block. */
interface InBlock {
  take: (tables: readonly TextFile[]) => void;
  /** Shows where frames are made of the scans. */
  back: () => void;
}

export function mountScansLine(store: BlockStore, modes: Modes, pair: ScansBeside, block: InBlock): HTMLElement {
  const text = h('span', { testid: 'of-scans' });
  const back = button(say('back-to-the-block'), 'scans-to-block', () => {
    modes.dispatch('block');
    block.back();
    document.getElementById('block-view')?.focus({ preventScroll: true });
  });
  const measure = [0, 1].map((place) =>
    button('', `scan-marks-${String(place)}`, () => {
      const scan = pair.shown()[place];
      if (scan !== undefined) pair.measure(scan.image);
    }),
  );
  const take = button(say('use-marks-in-the-block'), 'marks-to-block', () => block.take(toTake()), say('the-tables-of-marks-become'));
  const next = button(say('next-scans'), 'next-scans', () => void pair.open(others()), say('next-scans-help'));
  const line = h('div', { class: 'of-block of-scans', role: 'region', aria: { label: say('marks-of-scans') } });
  const toTake = () => tablesToTake(store.state.placing.film, pair.shown());
  const others = () => {
    const names = pair.shown().map(({ image }) => image);
    return nextScans(store.state.placing.film, store.state.files, names);
  };
  const draw = () => {
    const shown = pair.shown();
    line.hidden = shown.length === 0 || modes.state.mode !== 'pair';
    if (line.hidden) return;
    const held = document.activeElement;
    const { film } = store.state.placing;
    fill(text, [say('marks-of-some-scans', countedScans(film, store.state.files)), lackOf(film, shown)].filter((said) => said !== '').join(' '));
    const presses = measure.filter((_, place) => shown[place] !== undefined);
    for (const [place, press] of presses.entries()) fill(press, say('marks-of-this-scan', { name: shown[place]?.image ?? '' }));
    take.hidden = toTake().length === 0;
    next.hidden = others().length === 0;
    // A pair of the block has its own way back.
    back.hidden = store.state.opened !== null;
    for (const press of [...presses, take, next]) press.disabled = isBusy(store.state);
    arrange(line, back, text, ...presses, take, next);
    passFocus(held, [next, back]);
  };
  store.watch(['placing', 'files', 'opened', 'running', 'notice'], draw);
  modes.watch(['mode'], draw);
  pair.watch(draw);
  return line;
}
