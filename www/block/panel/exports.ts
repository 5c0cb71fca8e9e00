/** Saving a block: its own file, everything, or what another program reads. */
import { button, fill, h } from '../../shared/panel/dom';
import { Cancelled } from '../../shared/engine/client';
import { save } from '../../shared/files/save';
import type { ExportKind } from '../engine/calls';
import type { BlockEngine, BlockStore } from '../engine/engine';
import { isBusy } from '../state/state';
import { messageOf } from '../../shared/text/format';

const NAMES: Readonly<Record<ExportKind, string>> = {
  project: 'Project file',
  everything: 'Everything (.zip)',
  colmap: 'COLMAP',
  micmac: 'MicMac',
  bundler: 'Bundler',
  nvm: 'NVM (VisualSFM)',
  opensfm: 'OpenSfM',
  bingo: 'BINGO',
  isat: 'ISAT',
  agisoft: 'Agisoft',
  patb: 'PAT-B',
  csv: 'CSV tables',
  json: 'JSON',
  geojson: 'GeoJSON',
};

export function mountExports(host: HTMLElement, store: BlockStore, engine: BlockEngine): void {
  const select = h('select', { id: 'block-export-kind', testid: 'block-export-kind', aria: { label: 'Format' } });
  const press = button('Save', 'block-export', () => void saveAs(store, engine, select.value as ExportKind));
  host.append(h('span', { class: 'group-label' }, 'Export'), select, press);
  store.watch(['shown', 'running', 'notice'], ([shown]) => {
    // A part of a block has no points yet.
    const whole = shown !== null && !shown.view.partial;
    press.disabled = !whole || isBusy(store.state);
    select.disabled = !whole;
  });
  store.watch(['shown'], ([shown]) => {
    const formats = shown?.view.formats ?? [];
    const kinds: ExportKind[] = ['project', 'everything', ...formats];
    const { value } = select;
    fill(select, ...kinds.map((kind) => new Option(NAMES[kind], kind)));
    if (kinds.includes(value as ExportKind)) select.value = value;
  });
}

export async function saveAs(store: BlockStore, engine: BlockEngine, kind: ExportKind): Promise<void> {
  store.dispatch({ type: 'notice', notice: { kind: 'busy', text: `Writing ${NAMES[kind]} …` } });
  try {
    const { name, type, bytes } = await engine.export(kind, 'block');
    save(new Blob([bytes], { type }), name);
    store.dispatch({ type: 'notice', notice: { kind: 'info', text: `${name} was saved.` } });
  } catch (error) {
    if (error instanceof Cancelled) {
      store.dispatch({ type: 'notice', notice: { kind: 'info', text: 'Cancelled: nothing was saved. The block is unchanged.' } });
      return;
    }
    const reason = messageOf(error);
    store.dispatch({ type: 'notice', notice: { kind: 'problem', text: `${NAMES[kind]} was not written: ${reason}.` } });
  }
}
