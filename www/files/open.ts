/** Takes files in: dropped, pasted, opened. A file that cannot be used changes nothing. */
import { CallError, Cancelled } from '../engine/client';
import type { Engine } from '../engine/engine';
import type { Flight } from '../engine/wasm';
import { readable } from '../state/names';
import type { GivenImage, Side } from '../state/state';
import type { Store } from '../state/store';
import { sortFiles } from './sort';

/** Longest side of the copy of a mask that is shown, px. */
const MASK_SIDE = 1024;

/** Beyond this a file is refused before it is read, in bytes: a browser tab cannot hold it and its decoded copy. */
const MOST_BYTES = 2 ** 30;

let nextId = 1;

/** Masks named "right", or the second of two, belong right. */
function sideOfMask(mask: File, index: number): Side {
  if (/right/iu.test(mask.name)) return 'right';
  return /left/iu.test(mask.name) || index === 0 ? 'left' : 'right';
}

export class Files {
  constructor(private readonly store: Store, private readonly engine: Engine) {}

  /** Takes files of any kind; `side` says where a single one belongs. */
  async take(files: readonly File[], side: Side | null): Promise<void> {
    if (files.length === 0) return;
    this.store.dispatch({ type: 'notice', notice: null });
    const { images, masks, tables, cameras } = sortFiles(files);
    if (images.length > 2) {
      this.problem(`${String(images.length)} images were given: give one or two. Nothing was changed.`);
      return;
    }
    const camera = cameras[0];
    if (camera !== undefined) await this.takeCamera(camera);
    for (const [i, table] of tables.entries()) await this.takeFiducials(table, side ?? this.sideOfTable(table, i));
    if (images.length > 0) await this.takeImages(images, side);
    for (const [i, mask] of masks.entries()) await this.takeMask(mask, masks.length === 1 && side !== null ? side : sideOfMask(mask, i));
  }

  /** Takes an image whose zeros say where no points are wanted; it has to be as large as the image that is open. */
  async takeMask(file: File, side: Side): Promise<void> {
    const opened = this.store.state.images[side];
    if (opened === null) {
      this.problem(`${file.name} is a mask of the ${side} image, which is not open. Open that first.`);
      return;
    }
    try {
      const { info } = await this.engine.open(side, opened);
      const mask = await this.engine.client('pair').call('mask', { file, overlaySide: MASK_SIDE });
      if (mask.width !== info.width || mask.height !== info.height) {
        this.problem(`${file.name} has ${String(mask.width)} × ${String(mask.height)} px, the ${side} image ${String(info.width)} × ${String(info.height)} px: a mask is as large as its image. Nothing was changed.`);
        return;
      }
      this.store.dispatch({ type: 'mask', side, mask: { ...mask, id: nextId++, name: file.name } });
      this.store.dispatch({ type: 'notice', notice: { kind: 'info', text: `${file.name} leaves out ${(100 * mask.leftOut).toFixed(1)} % of the ${side} image.` } });
    } catch (error) {
      this.failed(`${file.name} cannot be used as a mask`, error);
    }
  }

  /** Renders the pair of a flight in a worker and opens it. */
  async takeFlight(name: string, flight: Flight): Promise<void> {
    this.store.dispatch({ type: 'notice', notice: { kind: 'busy', text: 'Rendering the pair: a simulated flight over a made landscape …' } });
    try {
      const pair = await this.engine.client('pair').call('simulate', flight);
      const given = (side: Side): GivenImage => ({ id: nextId++, name: `${name} ${side}`, source: { kind: 'grey', ...pair[side] } });
      this.store.dispatch({ type: 'simulated', left: given('left'), right: given('right'), pair });
      this.store.dispatch({ type: 'notice', notice: null });
    } catch (error) {
      this.failed('The pair could not be rendered', error);
    }
  }

  /** The built-in pair. */
  async takeSample(): Promise<void> {
    const sample = this.store.state.catalogue?.flights.find(({ name }) => name === 'sample');
    if (sample !== undefined) await this.takeFlight(sample.name, sample.flight);
  }

  private problem(text: string): void {
    this.store.dispatch({ type: 'notice', notice: { kind: 'problem', text } });
  }

  private failed(what: string, error: unknown): void {
    if (error instanceof Cancelled) {
      this.store.dispatch({ type: 'notice', notice: { kind: 'info', text: 'Cancelled. Nothing was changed.' } });
      return;
    }
    this.problem(`${what}: ${readable(this.store.state.catalogue, error instanceof Error ? error.message : String(error))}. What was open is kept.`);
  }

  /** Fiducials named "right", or the second of two tables, belong right. */
  private sideOfTable(table: File, index: number): Side {
    if (/right/iu.test(table.name)) return 'right';
    if (/left/iu.test(table.name)) return 'left';
    return index > 0 || this.store.state.photos.left.fiducials.length > 0 ? 'right' : 'left';
  }

  private async takeFiducials(file: File, side: Side): Promise<void> {
    try {
      const fiducials = await this.engine.client('pair').call('parseFiducials', { text: await file.text() });
      this.store.dispatch({ type: 'photo', side, photo: { fiducials } });
      this.store.dispatch({ type: 'notice', notice: { kind: 'info', text: `${String(fiducials.length)} fiducial ${fiducials.length === 1 ? 'mark' : 'marks'} of the ${side} image from ${file.name}.` } });
    } catch (error) {
      this.failed(`${file.name} holds no fiducial marks`, error);
    }
  }

  private async takeCamera(file: File): Promise<void> {
    try {
      const camera = await this.engine.client('pair').call('parseCamera', { text: await file.text() });
      this.store.dispatch({ type: 'camera', camera });
      this.store.dispatch({ type: 'notice', notice: { kind: 'info', text: `Camera data from ${file.name}.` } });
    } catch (error) {
      this.failed(`${file.name} holds no camera data`, error);
    }
  }

  /** Opens one or two images; each is decoded first, and replaces what is there only if it can be read. */
  private async takeImages(files: readonly File[], side: Side | null): Promise<void> {
    const tooLarge = files.find((file) => file.size > MOST_BYTES);
    if (tooLarge !== undefined) {
      this.problem(`${tooLarge.name} has ${String(Math.round(tooLarge.size / 2 ** 20))} MB; up to 1,024 MB are read. What was open is kept.`);
      return;
    }
    const sides = files.length === 2 ? (['left', 'right'] as const) : [side ?? this.freeSide()];
    const images: Partial<Record<Side, GivenImage>> = {};
    for (const [i, file] of files.entries()) {
      const target = sides[i];
      if (target !== undefined) images[target] = { id: nextId++, name: file.name, source: { kind: 'file', file } };
    }
    this.store.dispatch({ type: 'notice', notice: { kind: 'busy', text: `Reading ${files.map((file) => file.name).join(' and ')} …` } });
    await this.check(images);
  }

  private async check(images: Partial<Record<Side, GivenImage>>): Promise<void> {
    const entries = Object.entries(images) as [Side, GivenImage][];
    const outcomes = await Promise.allSettled(entries.map(([side, image]) => this.engine.open(side, image)));
    const bad = outcomes.findIndex((outcome) => outcome.status === 'rejected');
    if (bad < 0) {
      this.store.dispatch({ type: 'images', images });
      this.store.dispatch({ type: 'notice', notice: null });
      return;
    }
    const name = entries[bad]?.[1].name ?? 'the file';
    const outcome = outcomes[bad];
    this.failedImage(name, outcome?.status === 'rejected' ? (outcome.reason as unknown) : null);
  }

  private failedImage(name: string, error: unknown): void {
    if (error instanceof CallError && error.ended) {
      this.problem(`${name} could not be opened: the worker ran out of memory (${error.message}). What was open is kept. Try a smaller image, or close other tabs.`);
    } else {
      this.failed(`${name} cannot be opened`, error);
    }
  }

  /** Where a single image goes: an empty place, else the active one. */
  private freeSide(): Side {
    const { images, activeSide } = this.store.state;
    if (images.left === null) return 'left';
    return images.right === null ? 'right' : activeSide;
  }
}

