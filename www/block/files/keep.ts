/** Keeps the block in the browser's storage, and reads it from there. */
import type { BlockModel } from '../../../pkg/wasm/tiepoint.js';
import type { Kept } from '../../shared/files/database';
import { fitted, likeOf, listOf, nameOf, objectOf, orNull } from '../../shared/files/keepable';
import type { Keepable } from '../../shared/files/keepable';
import { remember } from '../../shared/state/remember';
import { titleOf } from '../../shared/text/project';
import type { BlockEngine, BlockStore } from '../engine/engine';
import { isBlank } from '../state/kept';
import type { KeptBlock, KeptFile, KeptShown } from '../state/kept';
import type { BlockCatalogue, BlockFile, BlockState, Shown, TextFile } from '../state/state';
import { passIds } from './files';

const GIVEN = 'block';
const SHOWN = 'block/shown';
const FILE = 'block/file/';
const RECORD = 'block/record/';

/** Room of what is small and not counted, in bytes. */
const SMALL = 4096;

export class KeptBlocks implements Keepable {
  /** The finished block on the screen as it is kept; null until its file is written. */
  private made: { shown: Shown; kept: KeptShown } | null = null;
  private making = false;
  private changed: () => void = () => undefined;

  constructor(
    private readonly store: BlockStore,
    private readonly engine: BlockEngine,
    private readonly catalogue: BlockCatalogue,
  ) {}

  watch(changed: () => void): void {
    this.changed = changed;
    this.engine.watchRecords(changed);
    this.store.watch(['files', 'options', 'flight', 'truth', 'shown', 'opened', 'mode', 'running'], () => {
      changed();
      void this.make();
    });
  }

  images(): readonly string[] {
    const { files, shown } = this.store.state;
    return (files.length > 0 ? files : (shown?.view.images ?? [])).map(({ name }) => name);
  }

  parts(): ReadonlyMap<string, Kept> {
    const { state } = this.store;
    const parts = new Map<string, Kept>();
    if (isBlank(state)) return parts;
    const { files, options, flight, truth, opened, shown } = state;
    parts.set(GIVEN, { value: given(files, options, flight, truth, opened), bytes: SMALL });
    if (truth !== null) parts.set(FILE + nameOf(truth), { value: truth, bytes: SMALL, alone: true });
    for (const { file } of [...files, ...options.masks, ...(shown?.files ?? [])])
      parts.set(FILE + nameOf(file), { value: file, bytes: file.size, alone: true });
    const { made } = this;
    if (made !== null && made.shown === shown) parts.set(SHOWN, { value: made.kept, bytes: SMALL + made.kept.project.size });
    // Of images that were all removed nothing is left to go on with.
    if (files.length > 0) {
      for (const [key, record] of this.engine.records) parts.set(RECORD + key, { value: record, bytes: record.size, again: true });
    }
    return parts;
  }

  async read(parts: ReadonlyMap<string, unknown>): Promise<() => void> {
    if (!parts.has(GIVEN)) return () => undefined;
    const kept = givenFrom(parts.get(GIVEN), this.catalogue);
    const files = kept.files.map((file) => fileFrom(parts, file));
    const masks = kept.masks.map((file) => fileFrom(parts, file));
    const finished = await this.finished(parts);
    const truth = orNull(kept.truth, (name) => truthFrom(parts, name));
    const records = new Map(
      [...parts].flatMap(([part, record]) => (part.startsWith(RECORD) && record instanceof Blob ? [[part.slice(RECORD.length), record] as const] : [])),
    );
    const shown = finished?.shown ?? null;
    const count = shown?.view.images.length ?? 0;
    const opened = kept.opened?.every((image) => image < count) === true ? kept.opened : null;
    return () => {
      passIds([...files, ...masks, ...(shown?.files ?? [])].map(({ id }) => id));
      this.engine.takeRecords(records);
      this.made = finished;
      this.store.dispatch({ type: 'restored', restored: { files, options: { ...kept.options, masks }, flight: kept.flight, truth, shown, opened } });
      const names = this.images();
      if (names.length === 0) return;
      const goesOn = records.size > 0 && shown === null ? ' The work that was done is kept: Run goes on from there.' : '';
      const text = `Restored from this browser: ${titleOf({ name: null, images: names })}.${goesOn}`;
      this.store.dispatch({ type: 'notice', notice: { kind: 'info', text, beside: true } });
    };
  }

  clear(): void {
    this.made = null;
    // What comes of an earlier run belongs to no project any more.
    if (this.store.state.running.kind === 'yes') this.engine.cancel();
    this.engine.takeRecords(new Map());
    this.store.dispatch({ type: 'cleared' });
  }

  /** Writes the finished block as a project file; its worker may be busy with another one, or be ended: then after the next change. */
  private async make(): Promise<void> {
    const { shown, running } = this.store.state;
    if (this.making || shown === null || shown.view.partial || running.kind === 'yes' || this.made?.shown === shown) return;
    this.making = true;
    try {
      const project = await this.engine.project();
      const { key, files, steps, seconds, view } = shown;
      if (this.store.state.shown === shown) this.made = { shown, kept: { project, key, files: files.map(keptFile), steps, seconds, score: view.score } };
    } catch {
      // See above.
    }
    this.making = false;
    this.changed();
    if (this.store.state.shown !== shown) void this.make();
  }

  private async finished(parts: ReadonlyMap<string, unknown>): Promise<{ shown: Shown; kept: KeptShown } | null> {
    if (!parts.has(SHOWN)) return null;
    const value = objectOf(parts.get(SHOWN), 'shown');
    const { project } = value;
    if (!(project instanceof Blob)) throw new Error('the finished block is damaged');
    const kept: KeptShown = {
      project,
      key: likeOf(value['key'], '', 'shown.key'),
      files: listOf(value['files'], 'shown.files', fileOf),
      steps: objectOf(value['steps'], 'shown.steps'),
      seconds: likeOf(value['seconds'], 0, 'shown.seconds'),
      score: orNull(value['score'], (score) => objectOf(score, 'shown.score') as unknown as KeptShown['score']),
    };
    const files = kept.files.map((file) => fileFrom(parts, file));
    const view = await this.engine.read(new Uint8Array(await project.arrayBuffer()));
    const { key, steps, seconds, score } = kept;
    return { shown: { key, files, steps, seconds, view: { ...view, score } }, kept: value as unknown as KeptShown };
  }
}

function keptFile({ id, name, file }: BlockFile): KeptFile {
  return { id, name, file: nameOf(file) };
}

/** All but files and the finished block; the same object while nothing of it has changed. */
const given = remember(
  (
    files: BlockState['files'],
    { masks, ...options }: BlockState['options'],
    flight: BlockState['flight'],
    truth: BlockState['truth'],
    opened: BlockState['opened'],
  ): KeptBlock => ({ files: files.map(keptFile), options, masks: masks.map(keptFile), flight, truth: orNull(truth, (known) => nameOf(known)), opened }),
);

function fileOf(value: unknown, name: string): KeptFile {
  const { id, name: called, file } = objectOf(value, name);
  return { id: likeOf(id, 0, `${name}.id`), name: likeOf(called, '', `${name}.name`), file: likeOf(file, '', `${name}.file`) };
}

/** @throws Error naming the field that is damaged */
function givenFrom(value: unknown, catalogue: BlockCatalogue): KeptBlock {
  const kept = objectOf(value, 'block');
  const options = objectOf(kept['options'], 'options');
  const text = (name: string) =>
    orNull(options[name], (given): TextFile => {
      const { name: called, text: content } = objectOf(given, `options.${name}`);
      return { name: likeOf(called, '', `options.${name}.name`), text: likeOf(content, '', `options.${name}.text`) };
    });
  const opened = orNull(kept['opened'], (pair) => listOf(pair, 'opened', (image, name) => likeOf(image, 0, name)));
  return {
    files: listOf(kept['files'], 'files', fileOf),
    masks: listOf(kept['masks'], 'masks', fileOf),
    options: {
      settings: orNull(options['settings'], (settings) => fitted(settings, catalogue.defaults, 'options.settings')),
      gps: options['gps'] === 'ignore' ? 'ignore' : 'use',
      cameras: text('cameras'),
      control: text('control'),
      marks: text('marks'),
    },
    flight: orNull(kept['flight'], (flight) => fitted(flight, catalogue.flight, 'flight')),
    truth: orNull(kept['truth'], (name) => likeOf(name, '', 'truth')),
    opened: opened?.length === 2 ? (opened as [number, number]) : null,
  };
}

/** @throws Error where the file is not there */
function fileFrom(parts: ReadonlyMap<string, unknown>, { id, name, file: at }: KeptFile): BlockFile {
  const file = parts.get(FILE + at);
  if (!(file instanceof Blob)) throw new Error(`the image ${name} is damaged`);
  nameOf(file, at);
  return { id, name, file };
}

function truthFrom(parts: ReadonlyMap<string, unknown>, name: string): BlockModel {
  const truth = objectOf(parts.get(FILE + name), 'truth');
  nameOf(truth, name);
  return truth as unknown as BlockModel;
}
