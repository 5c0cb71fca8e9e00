/** Saving a block: its own file, everything, or what another program reads. */
import { button, fill, h } from '../../shared/panel/dom';
import { typed } from '../../shared/panel/numberfield';
import { Cancelled } from '../../shared/engine/client';
import { save } from '../../shared/files/save';
import type { ExportKind } from '../engine/calls';
import type { BlockEngine, BlockStore } from '../engine/engine';
import type { Facts } from '../engine/facts';
import type { PlacingEngine } from '../engine/placing';
import { editsInForce, isSameList } from '../state/editing';
import { pendingPoints } from '../state/given-points';
import { imagesOf } from '../state/selection';
import { isBusy } from '../state/state';
import { chosenOf } from './edits';
import { saveMosaic } from './mosaic';
import { say } from '../../shared/text/words';
import { messageOf } from '../../shared/text/messages';

const NAMES: Readonly<Record<ExportKind, string>> = {
  project: say('project-file'),
  everything: say('everything-zip'),
  colmap: 'COLMAP',
  micmac: 'MicMac',
  bundler: say('bundler'),
  nvm: say('nvm-visualsfm'),
  opensfm: 'OpenSfM',
  bingo: 'BINGO',
  isat: 'ISAT',
  agisoft: say('agisoft'),
  patb: 'PAT-B',
  csv: say('csv-tables'),
  json: 'JSON',
  geojson: 'GeoJSON',
};

/** Made of the images as well: of all, or of those that are chosen. */
const MOSAICS = { mosaic: say('orthomosaic-geotiff'), chosen: say('chosen-images-on-the-ground') } as const;

type Mosaic = keyof typeof MOSAICS;

const isMosaic = (kind: string): kind is Mosaic => kind in MOSAICS;

const EXPORT = 'block-export';

export function mountExports(host: HTMLElement, store: BlockStore, engine: BlockEngine, facts: Facts, placing: PlacingEngine): void {
  const select = h('select', { id: 'block-export-kind', testid: 'block-export-kind', aria: { label: say('format') } });
  const press = button(say('save'), EXPORT, () => {
    const { value } = select;
    if (isMosaic(value)) void saveMosaic(store, engine, placing, EXPORT, typed(pixel), value === 'chosen' ? chosenImages(store, facts) : null);
    else void saveAs(store, engine, value as ExportKind);
  });
  const pixel = h('input', { id: 'block-mosaic-pixel', type: 'number', testid: 'block-mosaic-pixel', aria: { label: say('pixel-of-the-orthomosaic') } });
  pixel.placeholder = say('pixel-as-the-images');
  pixel.title = say('pixel-of-the-orthomosaic');
  pixel.step = 'any';
  pixel.hidden = true;
  const offer = () => {
    const { shown, history } = store.state;
    pixel.hidden = !isMosaic(select.value);
    // A part of a block has no points yet.
    const whole = shown !== null && !shown.view.partial;
    const lacksImages = select.value === 'chosen' && chosenImages(store, facts).length === 0;
    // What is saved has all edits that were made: the last of them may still be on their way.
    press.disabled = !whole || isBusy(store.state) || lacksImages || !isSameList(editsInForce(history), shown.edits);
    press.title = lacksImages ? say('choose-one-or-more-images') : '';
    select.disabled = pixel.disabled = !whole;
  };
  select.addEventListener('change', offer);
  host.append(h('span', { class: 'group-label' }, say('export')), select, pixel, press);
  store.watch(['shown'], ([shown]) => {
    const formats = shown?.view.formats ?? [];
    const kinds: readonly (ExportKind | Mosaic)[] = [
      'project',
      'everything',
      ...((shown?.view.oriented ?? 0) > 0 ? (['mosaic', 'chosen'] as const) : []),
      ...formats,
    ];
    const { value } = select;
    fill(select, ...kinds.map((kind) => new Option(isMosaic(kind) ? MOSAICS[kind] : NAMES[kind], kind)));
    if (kinds.some((kind) => kind === value)) select.value = value;
  });
  store.watch(['shown', 'running', 'notice', 'history', 'placing', 'selection'], offer);
}

/** The names of the images that are chosen and listed. */
function chosenImages({ state }: BlockStore, facts: Facts): string[] {
  const { shown } = state;
  return imagesOf(chosenOf(state, facts)).flatMap((image) => shown?.view.images[image]?.name ?? []);
}

/** `near`: the `data-testid` of the button that was pressed, beside which a refusal is said. */
export async function saveAs(store: BlockStore, engine: BlockEngine, kind: ExportKind, near = EXPORT): Promise<void> {
  store.dispatch({ type: 'notice', notice: { kind: 'busy', text: say('writing', { names: NAMES[kind] }) } });
  try {
    const { name, type, bytes } = await engine.export(kind, 'block');
    save(new Blob([bytes], { type }), name);
    const pending = kind === 'project' || kind === 'everything' ? pendingPoints(store.state) : 0;
    const text = [say('was-saved', { name }), pending === 0 ? '' : say('measured-points-are-not-in-it', { points: pending })].join(' ').trimEnd();
    store.dispatch({ type: 'notice', notice: { kind: 'info', text, beside: true } });
  } catch (error) {
    if (error instanceof Cancelled) {
      store.dispatch({ type: 'notice', notice: { kind: 'info', text: say('cancelled-nothing-was-saved-the'), beside: true } });
      return;
    }
    const reason = messageOf(error);
    store.dispatch({ type: 'notice', notice: { kind: 'problem', text: say('was-not-written', { names: NAMES[kind], reason }), near } });
  }
}
