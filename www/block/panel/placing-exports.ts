/** Saving what was placed on an orthophoto: tables, all of it, and images on the ground. */
import { Archive } from '../../shared/engine/archive';
import { Cancelled } from '../../shared/engine/client';
import { button, fill, h } from '../../shared/panel/dom';
import { save } from '../../shared/files/save';
import type { Notice } from '../../shared/state/notice';
import { sentence } from '../../shared/text/format';
import type { BlockStore } from '../engine/engine';
import type { PlacingEngine } from '../engine/placing';
import { placedCsv } from '../files/placed';
import { inRows } from '../state/links';
import { chosenPlaced } from '../state/showing';
import { placedFiles } from '../state/placed';
import { isBusy } from '../state/state';
import { say } from '../../shared/text/words';
import { messageOf } from '../../shared/text/messages';

const EXPORT = 'placed-export';

export type PlacedExport = 'placed' | 'links' | 'result' | 'rectified' | 'all';

const NAMES: Readonly<Record<PlacedExport, string>> = {
  placed: say('positions-placed-csv'),
  links: say('links-links-csv'),
  result: say('all-results-result-json'),
  rectified: say('chosen-image-on-the-ground'),
  all: say('all-images-on-the-ground'),
};

export function placingExports(store: BlockStore, engine: PlacingEngine): HTMLElement {
  const select = h('select', { testid: 'placed-export-kind', aria: { label: say('what-of-the-placed-images') } });
  const kinds = Object.keys(NAMES) as PlacedExport[];
  fill(select, ...kinds.map((kind) => new Option(NAMES[kind], kind)));
  const press = button(say('save'), EXPORT, () => void savePlaced(store, engine, select.value as PlacedExport));
  const show = () => {
    const needsChosen = select.value === 'rectified';
    const has = placedFiles(store.state).some(({ result }) => result !== null && (result.placement !== null || !needsChosen));
    press.disabled = isBusy(store.state) || !has || (needsChosen && (chosenPlaced(store.state)?.result?.placement ?? null) === null);
  };
  select.addEventListener('change', show);
  store.watch(['placing', 'files', 'running', 'notice'], show);
  return h('span', { class: 'placed-exports', role: 'group', aria: { label: say('export-of-the-placed-images') } }, select, press);
}

/** `near`: the `data-testid` of the button that was pressed, beside which a refusal is said. */
export async function savePlaced(store: BlockStore, engine: PlacingEngine, kind: PlacedExport, near = EXPORT): Promise<void> {
  const tell = (sort: Notice['kind'], text: string, where: Pick<Notice, 'beside' | 'near'> = {}) =>
    store.dispatch({ type: 'notice', notice: { kind: sort, text, ...where } });
  tell('busy', say('writing', { names: NAMES[kind] }));
  try {
    const [content, name] = await made(store, engine, kind, (text) => tell('busy', text));
    save(content, name);
    tell('info', say('was-saved', { name }), { beside: true });
  } catch (error) {
    if (error instanceof Cancelled) tell('info', say('cancelled-nothing-was-saved'), { beside: true });
    else tell('problem', say('nothing-was-saved', { sentence: sentence(messageOf(error)) }), { near });
  }
}

async function made(store: BlockStore, engine: PlacingEngine, kind: PlacedExport, tell: (text: string) => void): Promise<[Blob, string]> {
  const tried = placedFiles(store.state).flatMap(({ file, result }) => (result === null ? [] : [{ file, result }]));
  const tables = () =>
    placedCsv(
      tried.map(({ file }) => file.name),
      tried.map(({ result }) => inRows(result)),
    );
  const tiff = (bytes: Uint8Array<ArrayBuffer>) => new Blob([bytes], { type: 'image/tiff' });
  switch (kind) {
    case 'placed':
      return [new Blob([tables().placed], { type: 'text/csv' }), 'placed.csv'];
    case 'links':
      return [new Blob([tables().links], { type: 'text/csv' }), 'links.csv'];
    case 'result': {
      const { orthophoto } = store.state.placing;
      const all = {
        orthophoto: { name: orthophoto?.raster.name ?? '', ...orthophoto?.info },
        images: tried.map(({ file, result }) => ({ name: file.name, ...inRows(result) })),
      };
      return [new Blob([`${JSON.stringify(all, null, 1)}\n`], { type: 'application/json' }), 'result.json'];
    }
    case 'rectified': {
      const chosen = chosenPlaced(store.state);
      if (chosen === null) throw new Error(say('no-image-is-chosen-2'));
      return [tiff(await engine.rectified(chosen.file)), rectifiedName(chosen.file.name)];
    }
    case 'all': {
      const placed = tried.filter(({ result }) => result.placement !== null);
      const archive = new Archive();
      for (const [i, { file }] of placed.entries()) {
        tell(say('resampling-to-the-ground-of', { name: file.name, i: i + 1, placed: placed.length }));
        archive.add(rectifiedName(file.name), await engine.rectified(file), true);
      }
      return [archive.end(), 'rectified.zip'];
    }
  }
}

export function rectifiedName(name: string): string {
  return `${(name.split('/').at(-1) ?? name).replace(/\.[^.]*$/u, '')}-rectified.tif`;
}
