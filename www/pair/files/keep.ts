/** Keeps the pair in the browser's storage, and reads it from there. */
import { constant_offset, parse_camera } from '../../../pkg/wasm/tiepoint.js';
import { resolved } from '../../shared/crate';
import type { CameraMm, Catalogue } from '../../shared/crate';
import type { Kept } from '../../shared/files/database';
import { fitted, likeOf, listOf, nameOf, objectOf, orNull, positionFrom } from '../../shared/files/keepable';
import type { Keepable } from '../../shared/files/keepable';
import { remember } from '../../shared/state/remember';
import { titleOf } from '../../shared/text/project';
import type { Engine } from '../engine/engine';
import { areSame, besideOf, bothSides, isBlank, isWhole, resultsOf, typedOf, unedited } from '../state/kept';
import type { KeptFile, KeptMask, KeptPair, KeptResult, Typed } from '../state/kept';
import { INITIAL, SIDES } from '../state/state';
import type { FlightTruth, GivenImage, GivenMask, MaskFile, Side, State } from '../state/state';
import type { Store } from '../state/store';
import { Journal } from './journal';
import { MASK_SIDE } from './beside';
import { freshId } from './ids';
import { standingFor } from '../state/project';
import { knowDigest, projectText, readProject } from './project';
import { FILE, keptMask, keptSource, maskFrom, sourceFrom } from './sources';
import { keptMaskFrom, markFrom } from './steps';
import { say } from '../../shared/text/words';

const GIVEN = 'pair';
const RESULT = 'pair/result';

/** Room of what is small and not counted, in bytes. */
const SMALL = 4096;

/** Results are written once nothing has changed for so long, in ms: the next ones, which a slider brings, need the worker. */
const QUIET_MS = 300;

/** What changes what is kept. */
const WATCHED = [
  'settings',
  'camera',
  'photos',
  'fiducialModel',
  'offset',
  'images',
  'masks',
  'truth',
  'flight',
  'display',
  'results',
  'history',
  'maskSteps',
  'markSteps',
  'draft',
  'shelf',
  'running',
  'paused',
] as const satisfies readonly (keyof State)[];

/** Results that are kept, and what they were when they were written. */
interface Made {
  kept: KeptResult;
  results: readonly unknown[];
}

export class KeptPairs implements Keepable {
  readonly mode = 'pair';
  private made: Made | null = null;
  private making: Promise<void> | null = null;
  private readonly journal = new Journal();
  private timer: number | undefined;
  private changed: () => void = () => undefined;

  constructor(
    private readonly store: Store,
    private readonly engine: Engine,
    private readonly catalogue: Catalogue,
  ) {}

  watch(changed: () => void): void {
    this.changed = changed;
    this.store.watch(WATCHED, () => {
      changed();
      window.clearTimeout(this.timer);
      this.timer = window.setTimeout(() => void this.make(), QUIET_MS);
    });
  }

  images(): readonly string[] {
    const { images } = this.store.state;
    return SIDES.flatMap((side) => images[side]?.name ?? []);
  }

  parts(): ReadonlyMap<string, Kept> {
    const { state } = this.store;
    const parts = new Map<string, Kept>();
    const given = isBlank(state) ? null : givenOf(state);
    if (given === null) return parts;
    parts.set(GIVEN, { value: given, bytes: SMALL });
    for (const [part, kept] of this.journal.parts(state)) parts.set(part, kept);
    for (const given of sourcesOf(state)) {
      if (given !== null) parts.set(...keptSource(given.source));
    }
    const places = state.truth?.rightPosition;
    if (places !== undefined) parts.set(FILE + nameOf(places), { value: places, bytes: places.byteLength, alone: true });
    if (this.made !== null && this.made.kept.of === filesOf(state)) {
      const { kept } = this.made;
      const { descriptorsLeft: left, descriptorsRight: right } = kept.beside;
      const bytes = [left, right].reduce((sum, given) => sum + (given?.gradients.byteLength ?? 0) + (given?.moments.byteLength ?? 0), 0);
      parts.set(RESULT, { value: kept, bytes: SMALL + kept.project.length + bytes });
    }
    return parts;
  }

  async read(parts: ReadonlyMap<string, unknown>): Promise<() => void> {
    const value = parts.get(GIVEN);
    if (value === undefined) return () => undefined;
    const kept = givenFrom(value, this.catalogue);
    const { typed, display, flight, paused } = kept;
    const images = bothSides((side) => orNull(kept.images[side], ({ name, file }) => ({ id: freshId(), name, source: sourceFrom(parts, file) })));
    const byHand = this.journal.read(parts);
    const givenMasks = bothSides((side) => orNull(kept.givenMasks[side], (mask) => maskFrom(parts, mask)));
    const result = await this.result(parts, kept);
    SIDES.forEach((side, place) => {
      const image = images[side];
      if (image !== null) knowDigest(image.source, result?.project.images[place]?.content ?? null);
    });
    const masks = await this.masks(kept, parts, result?.masks ?? { left: null, right: null });
    const opened = { ...result?.standing };
    await Promise.all(
      SIDES.map(async (side) => {
        const image = images[side];
        if (image !== null && image.source.kind !== 'project') opened[side === 'left' ? 'openLeft' : 'openRight'] = await this.engine.open(side, image);
      }),
    );
    const truth = orNull(kept.truth, (known) => truthFrom(known, kept, parts, images));
    return () => {
      this.store.dispatch({ type: 'restored', restored: { typed, display, flight, paused, images, masks, givenMasks, truth, ...byHand, opened, result } });
      if (result !== null) this.made = { kept: result.kept, results: resultsOf(unedited(this.store.state)) };
      const names = this.images();
      if (names.length === 0) return;
      const text = say('restored-from-this-browser-2', { title_of: titleOf({ name: null, images: names }) });
      this.store.dispatch({ type: 'notice', notice: { kind: 'info', text } });
    };
  }

  clear(): void {
    this.made = null;
    // What comes of an earlier run belongs to no project any more.
    if (Object.keys(this.store.state.running).length > 0) this.engine.cancel();
    this.store.dispatch({ type: 'cleared' });
  }

  /** What came of a project file may be nowhere else: it is written before another pair takes its place. */
  async settled(): Promise<void> {
    window.clearTimeout(this.timer);
    await this.make();
  }

  private make(): Promise<void> {
    this.making ??= this.makeAll().finally(() => {
      this.making = null;
    });
    return this.making;
  }

  /** Writes the results as a project file once they are all there; what is cancelled meanwhile is written after the next change. */
  private async makeAll(): Promise<void> {
    for (;;) {
      const { state } = this.store;
      const typed = typedOf(state);
      if (typed === null || !isWhole(state)) return;
      const results = resultsOf(state);
      if (this.made !== null && areSame(this.made.results, results)) return;
      try {
        // Edits have a journal of their own.
        const project = await projectText(unedited(state), this.engine);
        if (project !== null) this.made = { results, kept: { project, typed, of: filesOf(state), ...besideOf(state) } };
      } catch {
        // The worker was ended. What is kept of the earlier results stays.
      }
      this.changed();
      if (this.store.state === state) return;
    }
  }

  /** `standing`: in place of masks whose files are not there. */
  private async masks({ masks }: KeptPair, parts: ReadonlyMap<string, unknown>, standing: State['masks']): Promise<State['masks']> {
    const read = async (side: Side) => {
      const kept = masks[side];
      if (kept === null) return null;
      const source = sourceFrom(parts, kept.file);
      if (source.kind !== 'file') return orNull(standing[side], (mask) => ({ ...mask, source }));
      const mask = await this.engine.client('pair').call('mask', { file: source.file, overlaySide: MASK_SIDE });
      return { ...mask, id: freshId(), name: kept.name, source };
    };
    const [left, right] = await Promise.all([read('left'), read('right')]);
    return { left, right };
  }

  /** The results, where they are of these very files. */
  private async result(parts: ReadonlyMap<string, unknown>, { images, masks }: KeptPair) {
    if (!parts.has(RESULT)) return null;
    const value = objectOf(parts.get(RESULT), 'result');
    const kept: KeptResult = {
      project: likeOf(value.project, '', 'result.project'),
      typed: typedFrom(value.typed, this.catalogue, 'result.typed'),
      of: likeOf(value.of, '', 'result.of'),
      beside: objectOf(value.beside, 'result.beside'),
      times: objectOf(value.times, 'result.times'),
    };
    const opened = await readProject(this.engine, new Blob([kept.project]), freshId);
    const files = [images.left, images.right, masks.left, masks.right].map((given) => given?.file ?? null);
    if (kept.of !== JSON.stringify(files)) return null;
    return {
      ...kept,
      kept: value as unknown as KeptResult,
      project: opened.project,
      masks: opened.masks,
      standing: standingFor(opened),
    };
  }
}

/** Images, masks, and the files that these were made of. */
function sourcesOf({ images, masks, givenMasks, maskSteps }: State): (MaskFile | null)[] {
  const given = maskSteps.edits.map((step) => ('given' in step ? step.given : null));
  return [...[images, masks, givenMasks].flatMap((of) => Object.values<MaskFile | null>(of)), ...given];
}

/** The names under which images and masks are kept, as one text. */
function filesOf({ images, masks }: State): string {
  const files = [images.left, images.right, masks.left, masks.right].map((given) => (given === null ? null : nameOf(given.source)));
  return JSON.stringify(files);
}

/** All but files and results; the same object while nothing of it has changed. */
function givenOf(state: State): KeptPair | null {
  const typed = typedOf(state);
  const { settings, camera, photos, fiducialModel, offset, display, flight, paused, images, masks, givenMasks, truth } = state;
  return typed === null ? null : given(settings, camera, photos, fiducialModel, offset, display, flight, paused, images, masks, givenMasks, truth);
}

const given = remember(
  (
    settings: State['settings'],
    camera: State['camera'],
    photos: State['photos'],
    fiducialModel: State['fiducialModel'],
    offset: State['offset'],
    display: State['display'],
    flight: State['flight'],
    paused: State['paused'],
    images: State['images'],
    masks: State['masks'],
    givenMasks: State['givenMasks'],
    truth: State['truth'],
  ): KeptPair | null => {
    if (settings === null) return null;
    const file = ({ id, name, source }: GivenImage | GivenMask): KeptFile => ({ id, name, file: nameOf(source) });
    return {
      typed: { settings, camera, photos, fiducialModel, offset },
      display,
      flight,
      paused,
      images: bothSides((side) => orNull(images[side], file)),
      masks: bothSides((side) => orNull(masks[side], file)),
      givenMasks: bothSides((side) => orNull(givenMasks[side], keptMask)),
      truth: orNull(truth, ({ rightPosition, ...known }) => ({ ...known, file: nameOf(rightPosition) })),
    };
  },
);

/** @throws Error naming the field that is damaged */
function givenFrom(value: unknown, catalogue: Catalogue): KeptPair {
  const kept = objectOf(value, 'pair');
  const file = (one: unknown, name: string): KeptFile => ({ id: likeOf(objectOf(one, name).id, 0, `${name}.id`), ...keptMaskFrom(one, name) });
  const files = <T>(name: 'images' | 'masks' | 'givenMasks', read: (one: unknown, name: string) => T) => {
    const sides = objectOf(kept[name], name);
    return bothSides((side) => orNull(sides[side], (one) => read(one, `${name}.${side}`)));
  };
  const masks = files('masks', file);
  return {
    typed: typedFrom(kept.typed, catalogue, 'typed'),
    display: fitted(kept.display, INITIAL.display, 'display'),
    flight: orNull(kept.flight, (flight) => fitted(flight, catalogue.flights[0]?.flight ?? {}, 'flight') as State['flight']) ?? null,
    paused: kept.paused === true,
    images: files('images', file),
    masks,
    // Earlier releases kept no steps: what a mask was then is what was given.
    givenMasks: kept.givenMasks === undefined ? masks : files<KeptMask>('givenMasks', keptMaskFrom),
    truth: orNull(kept.truth, (truth) => objectOf(truth, 'truth') as unknown as KeptPair['truth']) ?? null,
  };
}

/** What was typed, judged as it is where it is typed. @throws Error naming what is damaged */
function typedFrom(value: unknown, { defaults }: Catalogue, name: string): Typed {
  const kept = objectOf(value, name);
  const settings = fitted(kept.settings, defaults, `${name}.settings`);
  resolved(settings);
  const camera = orNull(kept.camera, (given) => objectOf(given, `${name}.camera`) as unknown as CameraMm);
  if (camera !== null) parse_camera(JSON.stringify(camera));
  const offset = orNull(kept.offset, (given) => positionFrom(given, `${name}.offset`));
  if (offset !== null) constant_offset(...offset);
  const photos = objectOf(kept.photos, `${name}.photos`);
  const photo = (side: Side) => {
    const at = `${name}.photos.${side}`;
    const { fiducials, origin } = objectOf(photos[side], at);
    return {
      fiducials: listOf(fiducials, `${at}.fiducials`, markFrom),
      origin: orNull(origin, (given) => positionFrom(given, `${at}.origin`)),
    };
  };
  const fiducialModel = likeOf(kept.fiducialModel, '', `${name}.fiducialModel`) as Typed['fiducialModel'];
  return { settings, camera, photos: bothSides(photo), fiducialModel, offset };
}

/** The truth of images that have other numbers now. */
function truthFrom(truth: NonNullable<KeptPair['truth']>, kept: KeptPair, parts: ReadonlyMap<string, unknown>, images: State['images']): FlightTruth {
  const { file, ...known } = truth;
  const rightPosition = parts.get(FILE + file);
  if (!(rightPosition instanceof Float32Array)) throw new Error(say('the-truth-of-the-simulated'));
  nameOf(rightPosition, file);
  const idOf = (id: number) => {
    const side = SIDES.find((one) => kept.images[one]?.id === id);
    return (side === undefined ? null : images[side]?.id) ?? NaN;
  };
  return { ...known, rightPosition, leftId: idOf(truth.leftId), rightId: idOf(truth.rightId) };
}
