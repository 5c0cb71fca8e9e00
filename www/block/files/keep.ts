/** Keeps the block in the browser's storage, and reads it from there. */
import type { BlockEdit, BlockModel } from '../../../pkg/wasm/tiepoint.js';
import type { Kept } from '../../shared/files/database';
import { Journal } from '../../shared/files/journal';
import { fitted, likeOf, listOf, nameOf, objectOf, orNull } from '../../shared/files/keepable';
import type { Keepable } from '../../shared/files/keepable';
import type { History } from '../../shared/state/history';
import { remember } from '../../shared/state/remember';
import { titleOf } from '../../shared/text/project';
import type { BlockEngine, BlockStore } from '../engine/engine';
import { isBlank } from '../state/kept';
import type { KeptBlock, KeptFile, KeptShown } from '../state/kept';
import { NONE_GIVEN } from '../state/given-points';
import type { BlockCatalogue, BlockFile, BlockState, Shown, TextFile } from '../state/state';
import type { EditStep } from '../state/edits';
import type { Former } from '../state/former';
import type { ImageVerdict, OnGround } from '../state/placing';
import { bytesOfStep, stepFrom } from './edit';
import { withPresentKeys } from './earlier-keys';
import { goesOn, RunUnderWay } from './going-on';
import { passIds } from './ids';
import { draftFrom, draftParts, linkParts, withLink } from './keep-draft';
import { formerFrom, formerParts, placesFrom } from './keep-former';
import { keptPlacing, placingFrom, rastersOf, sizeOfPlaced } from './keep-placing';
import { bytesOfKept, filesOfSteps, keptMarkSteps, keptStepFrom, markStepsFrom } from './keep-steps';
import { messageOf } from '../../shared/text/messages';
import { say } from '../../shared/text/words';

const GIVEN = 'block';
const SHOWN = 'block/shown';
const PLACED = 'block/placed/';
const FILE = 'block/file/';
const RECORD = 'block/record/';

/** Room of what is small and not counted, in bytes. */
const SMALL = 4096;

export class KeptBlocks implements Keepable {
  readonly mode = 'block';
  /** The finished block on the screen as it is kept; null until its file is written. */
  private made: { found: Shown['found']; kept: KeptShown } | null = null;
  private readonly journal = new Journal('block/edits', stepFrom, bytesOfStep);
  private readonly marks = new Journal('block/marks', keptStepFrom(fileOf), bytesOfKept);
  private readonly keptMarks = keptMarkSteps(keptFile);
  private readonly underWay: RunUnderWay;
  private making: Promise<void> | null = null;
  private changed: () => void = () => undefined;

  constructor(
    private readonly store: BlockStore,
    private readonly engine: BlockEngine,
    private readonly catalogue: BlockCatalogue,
    /** Ends what goes on with the block: what comes of it belongs to no project any more. */
    private readonly end: () => void,
    /** Runs the block. */
    private readonly run: () => void,
  ) {
    this.underWay = new RunUnderWay(store, engine);
  }

  watch(changed: () => void): void {
    this.changed = changed;
    this.engine.watchRecords(changed);
    this.store.watch(['files', 'options', 'flight', 'truth', 'shown', 'opened', 'running', 'history', 'former', 'marks', 'draft', 'panes', 'placing'], () => {
      changed();
      void this.settled();
    });
  }

  /** Writes the finished block as a project file, unless that is done. */
  async settled(): Promise<void> {
    const { shown, running } = this.store.state;
    if (shown === null || shown.view.partial || running.kind === 'yes' || this.made?.found === shown.found) return;
    const before = this.making;
    this.making ??= this.make(shown).finally(() => {
      this.making = null;
    });
    await this.making;
    // Another one has come meanwhile.
    if (before !== null || this.store.state.shown?.found !== shown.found) await this.settled();
  }

  images(): readonly string[] {
    const { files, shown, placing } = this.store.state;
    const names = (files.length > 0 ? files : (shown?.view.images ?? [])).map(({ name }) => name);
    return names.length === 0 && placing.orthophoto !== null ? [placing.orthophoto.raster.name] : names;
  }

  parts(): ReadonlyMap<string, Kept> {
    const { state } = this.store;
    const parts = new Map<string, Kept>();
    if (isBlank(state)) return parts;
    const { files, removed, options, flight, truth, opened, shown, placing } = state;
    parts.set(GIVEN, {
      value: given(files, removed, options, flight, truth, opened, placing.orthophoto, placing.heights, placing.film, placing.options, placing.purpose),
      bytes: SMALL,
    });
    for (const [id, placed] of placing.placed) parts.set(PLACED + String(id), { value: placed, bytes: sizeOfPlaced(placed) });
    if (truth !== null) parts.set(FILE + nameOf(truth), { value: truth, bytes: SMALL, alone: true });
    for (const { file } of [...files, ...removed, ...besidesOf(options), ...(shown?.files ?? []), ...rastersOf(placing), ...filesOfSteps(state.marks)])
      parts.set(FILE + nameOf(file), { value: file, bytes: file.size, alone: true });
    const { made } = this;
    for (const [name, part] of this.journal.parts(state.history)) parts.set(name, part);
    for (const [name, part] of this.marks.parts(this.keptMarks(state.marks))) parts.set(name, part);
    for (const [name, part] of formerParts(state.former, state.history)) parts.set(name, part);
    for (const [name, part] of [...draftParts(state.draft, state.panes.images), ...linkParts(placing), ...this.underWay.parts()]) parts.set(name, part);
    if (made !== null && made.found === shown?.found)
      parts.set(SHOWN, { value: made.kept, bytes: SMALL + made.kept.project.size + (made.kept.ground?.before.size ?? 0) });
    // Of images that were all removed nothing is left to go on with.
    if (files.length > 0) {
      for (const [key, record] of this.engine.records) parts.set(RECORD + key, { value: record, bytes: record.size, again: true });
    }
    return parts;
  }

  async read(parts: ReadonlyMap<string, unknown>, looks: boolean): Promise<() => void> {
    if (!parts.has(GIVEN)) return () => undefined;
    const kept = givenFrom(parts.get(GIVEN), this.catalogue);
    const files = kept.files.map((file) => fileFrom(parts, file));
    const removed = kept.removed.map((file) => fileFrom(parts, file));
    const masks = kept.masks.map((file) => fileFrom(parts, file));
    const geoid = orNull(kept.geoid, (file) => fileFrom(parts, file));
    const placed = new Map([...parts].flatMap(([part, value]) => (part.startsWith(PLACED) ? [[Number(part.slice(PLACED.length)), value] as const] : [])));
    const given = placingFrom(kept.placing, placed, this.catalogue, fileOf, (file) => fileFrom(parts, file));
    const placing = withLink(withPresentKeys(given, files, kept.options), parts);
    const history = this.journal.read(parts);
    const marks = markStepsFrom(this.marks.read(parts), (file) => fileFrom(parts, file));
    const { former, damage } = formerOrNone(parts, history);
    const finished = await this.finished(parts, history);
    const truth = orNull(kept.truth, (name) => truthFrom(parts, name));
    const records = new Map(
      [...parts].flatMap(([part, record]) => (part.startsWith(RECORD) && record instanceof Blob ? [[part.slice(RECORD.length), record] as const] : [])),
    );
    const shown = finished?.shown ?? null;
    const runs = !looks && shown === null && goesOn(parts, records.size);
    const count = shown?.view.images.length ?? 0;
    const draft = shown === null ? null : draftFrom(parts, count);
    const opened = kept.opened?.every((image) => image < count) === true ? kept.opened : null;
    return () => {
      passIds(
        [...files, ...removed, ...besidesOf({ masks, geoid }), ...(shown?.files ?? []), ...rastersOf(placing), ...filesOfSteps(marks)].map(({ id }) => id),
      );
      this.engine.takeRecords(records);
      this.made = finished === null ? null : { found: finished.shown.found, kept: finished.kept };
      finished?.hold();
      this.engine.keepSpare(finished?.kept.project ?? null);
      this.store.dispatch({
        type: 'restored',
        restored: {
          files,
          removed,
          options: { ...kept.options, masks, geoid },
          flight: kept.flight,
          truth,
          shown,
          opened,
          history,
          former,
          marks,
          draft,
          placing,
        },
      });
      const names = this.images();
      if (names.length === 0) return;
      const work = records.size > 0 && shown === null ? say('the-work-that-was-done') : '';
      const restored = say('restored-from-this-browser', { title_of: titleOf({ name: null, images: names }), goes_on: runs ? '' : work });
      const text = damage === '' ? restored : `${restored} ${damage}`;
      this.store.dispatch({ type: 'notice', notice: { kind: 'info', text, beside: true } });
      // All parts of the project are shown first.
      if (runs) queueMicrotask(this.run);
    };
  }

  clear(): void {
    this.made = null;
    this.engine.keepSpare(null);
    this.end();
    this.engine.takeRecords(new Map());
    this.store.dispatch({ type: 'cleared' });
  }

  /** Its worker may be busy with another one, or be ended: then it is made after the next change. */
  private async make(shown: Shown): Promise<void> {
    try {
      const project = await this.engine.project();
      const { key, tiePoints, files, steps, seconds, view, ground } = shown;
      if (this.store.state.shown?.found === shown.found)
        this.made = { found: shown.found, kept: { project, key, tiePoints, files: files.map(keptFile), steps, seconds, score: view.score, ground } };
    } catch {
      // See above.
    }
    this.changed();
    if (this.made?.found === this.store.state.shown?.found) this.engine.keepSpare(this.made?.kept.project ?? null);
  }

  private async finished(parts: ReadonlyMap<string, unknown>, history: History<EditStep>): Promise<{ shown: Shown; kept: KeptShown; hold: () => void } | null> {
    if (!parts.has(SHOWN)) return null;
    const value = objectOf(parts.get(SHOWN), 'shown');
    const { project } = value;
    if (!(project instanceof Blob)) throw new Error(say('the-finished-block-is-damaged'));
    const kept: KeptShown = {
      project,
      key: likeOf(value.key, '', 'shown.key'),
      // Earlier releases kept none.
      tiePoints: likeOf(value.tiePoints ?? '', '', 'shown.tiePoints'),
      files: listOf(value.files, 'shown.files', fileOf),
      steps: objectOf(value.steps, 'shown.steps'),
      seconds: likeOf(value.seconds, 0, 'shown.seconds'),
      score: orNull(value.score, (score) => objectOf(score, 'shown.score') as unknown as KeptShown['score']),
      ground: orNull(value.ground, groundFrom),
    };
    const files = kept.files.map((file) => fileFrom(parts, file));
    const opened = await this.engine.read(new Uint8Array(await project.arrayBuffer()));
    const { key, tiePoints, steps, seconds, score, ground } = kept;
    const view = { ...opened.view, score };
    return {
      shown: { key, files, steps, seconds, view, given: NONE_GIVEN, found: view, tiePoints, edits: theSame(opened.steps.flat(), history.edits.flat()), ground },
      kept: value as unknown as KeptShown,
      hold: opened.hold,
    };
  }
}

/** Edits of former blocks, of which only a way back is made: where they are damaged there is none. */
function formerOrNone(parts: ReadonlyMap<string, unknown>, history: History<EditStep>): { former: readonly Former[]; damage: string } {
  try {
    return { former: formerFrom(parts, history), damage: '' };
  } catch (error) {
    return { former: [], damage: say('edits-of-former-blocks-are-left-out', { error: messageOf(error) }) };
  }
}

/** The edits of a file by those of the history that are like them: what is the same needs no new adjustment. */
function theSame(edits: readonly BlockEdit[], history: readonly BlockEdit[]): readonly BlockEdit[] {
  return edits.map((edit, i) => {
    const known = history[i];
    return known !== undefined && JSON.stringify(known) === JSON.stringify(edit) ? known : edit;
  });
}

/** @throws Error naming the field that is damaged */
function groundFrom(value: unknown): OnGround {
  const { key, before, places, verdicts } = objectOf(value, 'shown.ground');
  if (!(before instanceof Blob)) throw new Error(say('the-finished-block-is-damaged'));
  return {
    key: likeOf(key, '', 'shown.ground.key'),
    before,
    // Earlier releases kept none.
    places: orNull(places ?? null, (own) => placesFrom(own, 'shown.ground.places')),
    verdicts: listOf(verdicts ?? [], 'shown.ground.verdicts', (one, name) => {
      const { name: image, verdict } = objectOf(one, name);
      // The crate says what it says.
      return { name: likeOf(image, '', `${name}.name`), verdict: objectOf(verdict, `${name}.verdict`) as unknown as ImageVerdict['verdict'] };
    }),
  };
}

/** The files that are given beside the images. */
function besidesOf({ masks, geoid }: Pick<BlockState['options'], 'masks' | 'geoid'>): readonly BlockFile[] {
  return geoid === null ? masks : [...masks, geoid];
}

function keptFile({ id, name, file }: BlockFile): KeptFile {
  return { id, name, file: nameOf(file) };
}

/** All but files and the finished block; the same object while nothing of it has changed. */
const given = remember(
  (
    files: BlockState['files'],
    removed: BlockState['removed'],
    { masks, geoid, ...options }: BlockState['options'],
    flight: BlockState['flight'],
    truth: BlockState['truth'],
    opened: BlockState['opened'],
    orthophoto: BlockState['placing']['orthophoto'],
    heights: BlockState['placing']['heights'],
    film: BlockState['placing']['film'],
    placing: BlockState['placing']['options'],
    purpose: BlockState['placing']['purpose'],
  ): KeptBlock => ({
    files: files.map(keptFile),
    removed: removed.map(keptFile),
    options,
    masks: masks.map(keptFile),
    geoid: orNull(geoid, keptFile),
    flight,
    truth: orNull(truth, (known) => nameOf(known)),
    opened,
    placing: keptPlacing(orthophoto, heights, film, placing, purpose),
  }),
);

function fileOf(value: unknown, name: string): KeptFile {
  const { id, name: called, file } = objectOf(value, name);
  return { id: likeOf(id, 0, `${name}.id`), name: likeOf(called, '', `${name}.name`), file: likeOf(file, '', `${name}.file`) };
}

/** @throws Error naming the field that is damaged */
function givenFrom(value: unknown, catalogue: BlockCatalogue): Omit<KeptBlock, 'placing'> & { placing: unknown } {
  const kept = objectOf(value, 'block');
  const options = objectOf(kept.options, 'options');
  const text = (name: string) =>
    orNull(options[name], (given): TextFile => {
      const { name: called, text: content } = objectOf(given, `options.${name}`);
      return { name: likeOf(called, '', `options.${name}.name`), text: likeOf(content, '', `options.${name}.text`) };
    });
  const opened = orNull(kept.opened, (pair) => listOf(pair, 'opened', (image, name) => likeOf(image, 0, name)));
  return {
    files: listOf(kept.files, 'files', fileOf),
    // Earlier releases kept none.
    removed: listOf(kept.removed ?? [], 'removed', fileOf),
    masks: listOf(kept.masks, 'masks', fileOf),
    // Earlier releases kept none.
    geoid: orNull(kept.geoid ?? null, (file) => fileOf(file, 'geoid')),
    options: {
      settings: orNull(options.settings, (settings) => fitted(settings, catalogue.defaults, 'options.settings')),
      gps: options.gps === 'ignore' ? 'ignore' : 'use',
      cameras: text('cameras'),
      control: text('control'),
      marks: text('marks'),
      // Earlier releases kept none.
      positions: options.positions === undefined ? null : text('positions'),
    },
    flight: orNull(kept.flight, (flight) => fitted(flight, catalogue.flight, 'flight')),
    truth: orNull(kept.truth, (name) => likeOf(name, '', 'truth')),
    opened: opened?.length === 2 ? (opened as [number, number]) : null,
    placing: kept.placing,
  };
}

/** @throws Error where the file is not there */
function fileFrom(parts: ReadonlyMap<string, unknown>, { id, name, file: at }: KeptFile): BlockFile {
  const file = parts.get(FILE + at);
  if (!(file instanceof Blob)) throw new Error(say('the-image-is-damaged', { name }));
  nameOf(file, at);
  return { id, name, file };
}

function truthFrom(parts: ReadonlyMap<string, unknown>, name: string): BlockModel {
  const truth = objectOf(parts.get(FILE + name), 'truth');
  nameOf(truth, name);
  return truth as unknown as BlockModel;
}
