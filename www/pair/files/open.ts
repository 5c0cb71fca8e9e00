/** Takes files in: dropped, pasted, opened. A file that cannot be used changes nothing. */
import { breakdownOf, Cancelled } from '../../shared/engine/client';
import type { Engine } from '../engine/engine';
import type { Flight } from '../../shared/crate';
import { sentence } from '../../shared/text/format';
import { readable } from '../../shared/text/names';
import { bothSides, hasData, hasMarks, isWorthKeeping } from '../state/kept';
import { editsOfFile } from '../state/project';
import type { OpenedProject } from '../state/project';
import { calibrationBehind } from '../../shared/state/calibrations';
import { titleOf } from '../../shared/text/project';
import { SIDES } from '../state/state';
import type { GivenImage, Side, State } from '../state/state';
import type { Store } from '../state/store';
import type { FoundFile, Taker } from '../../shared/files/drop';
import { takeHere } from '../../shared/files/leaving';
import type { Here } from '../../shared/files/leaving';
import type { Choice, Notice } from '../../shared/state/notice';
import { kindsText, namesText, refusedKinds, refusedText } from '../../shared/files/refused';
import type { Refused } from '../../shared/files/refused';
import { contains } from '../../shared/view/transform';
import { panesOf } from '../view/geometry';
import type { View } from '../view/view';
import { haveSameContent, readProject, sideOfFile } from './project';
import { sortFiles } from './sort';
import { say } from '../../shared/text/words';
import { messageOf } from '../../shared/text/messages';
import { textIn } from '../../shared/files/text';

/** Longest side of the copy of a mask that is shown, px. */
export const MASK_SIDE = 1024;

/** Beyond this a file is refused before it is read, in bytes: a browser tab cannot hold it and its decoded copy. */
const MOST_BYTES = 2 ** 30;

let nextId = 1;

/** Differs for every image and mask ever given. */
export const freshId = (): number => nextId++;

/** Masks named "right", or the second of two, belong right. */
function sideOfMask(mask: File, index: number): Side {
  // As masks are named that were painted here, whatever their images are called.
  const [, painted] = /-mask-(left|right)\./u.exec(mask.name) ?? [];
  if (painted !== undefined) return painted as Side;
  if (/right/iu.test(mask.name)) return 'right';
  return /left/iu.test(mask.name) || index === 0 ? 'left' : 'right';
}

/** What came of a file; null where the page shows it. */
type Told = { kind: 'info' | 'problem'; text: string; choices?: readonly Choice[] } | null;

const problem = (text: string): Told => ({ kind: 'problem', text });
const info = (text: string): Told => ({ kind: 'info', text });
const unchanged = () => info(say('cancelled-nothing-was-changed'));

/** What came of images; `isCancelled`: Cancel ended their reading. */
interface Opened {
  told: readonly Told[];
  isCancelled: boolean;
}

const done = (told: readonly Told[]): Opened => ({ told, isCancelled: false });

/** A file of a former version holds the matches as the edits left them, and not the edits. */
function editsToldOf({ project }: OpenedProject): Told {
  const { rejected, manual } = editsOfFile(project);
  const of = (number: number, what: string) => (number === 0 ? [] : [say('matches-by-hand', { number, what })]);
  const said = [...of(rejected, 'rejected'), ...of(manual, 'measured')];
  return said.length === 0 ? null : info(say('it-holds-the-history-of', { join: said.join(say('and-between')) }));
}

export class Files {
  isReady = false;
  private started: () => void = () => undefined;
  /** Resolves with `begin`. */
  readonly ready = new Promise<void>((resolve) => {
    this.started = resolve;
  });

  constructor(
    private readonly store: Store,
    private readonly engine: Engine,
    /** Opens a project of whatever kind where it belongs. */
    private readonly openProject: (file: File) => Promise<void>,
    private readonly elsewhere: {
      /** Takes more images than a pair has. */
      toBlock: (files: readonly File[], masks: readonly File[]) => void;
      /** Takes photographs with the orthophoto or the heights that they are to be placed by; false where there are none among the files. */
      toGround: (found: FoundFile[]) => Promise<boolean>;
      /** Waits for the project that is being left: files are of the next one. */
      left: () => Promise<Here>;
    },
    /** Leaves the project in the list before another pair takes its place; false where it cannot. */
    private readonly putAside: () => Promise<boolean>,
  ) {}

  /** Takes files from now on: what was kept of the pair is shown. */
  begin(): void {
    this.isReady = true;
    this.started();
  }

  /** Takes files as they are chosen or dropped: photographs with an orthophoto are no pair. */
  async give(found: FoundFile[], side: Side | null, asks = side === null): Promise<void> {
    if (await this.elsewhere.toGround(found)) return;
    await this.take(
      found.map(({ file }) => file),
      side,
      asks,
    );
  }

  /** Takes files of any kind; `side` says where a single one belongs. `asks`: whether a third photo may replace one is asked before it does. */
  async take(files: readonly File[], side: Side | null, asks = side === null): Promise<void> {
    if (files.length === 0) return;
    await this.takeHere(
      files.map(({ name }) => name),
      (here) => this.takeKinds(files, side, asks, here),
    );
  }

  /** Takes what has these names for the project that is shown. */
  private takeHere(names: readonly string[], take: (here: Here) => Promise<void>): Promise<void> {
    const tell = () => this.tell([info(say('were-not-taken-the-project', { files: names.length, names: namesText(names) }))]);
    return takeHere(this.elsewhere.left, take, tell);
  }

  private async takeKinds(files: readonly File[], side: Side | null, asks: boolean, here: Here): Promise<void> {
    this.store.dispatch({ type: 'notice', notice: null });
    const refused = await refusedKinds(files);
    here();
    const { images, masks, tables, cameras, projects } = sortFiles(files.filter((file) => !refused.has(file)));
    const [project] = projects;
    if (project !== undefined) {
      await this.openProject(project);
      here();
      const others = files.filter((file) => !projects.includes(file));
      if (others.length > 0) await this.take(others, side, asks);
      return;
    }
    if (images.length > 2) {
      // The block says of those that it does not read why.
      this.elsewhere.toBlock(
        files.filter((file) => !masks.includes(file)),
        masks,
      );
      return;
    }
    const before = this.store.state.images;
    const told: Told[] = refused.size === 0 ? [] : [problem(kindsText(refused))];
    const camera = cameras[0];
    if (camera !== undefined) told.push(await this.takeCamera(camera, here));
    // Marks of the image before it go with that.
    const { told: ofImages, isCancelled } = images.length > 0 ? await this.takeImages(images, side, asks, here) : { told: [], isCancelled: false };
    // What belongs to images whose reading was cancelled would start the run that they wait for.
    if (isCancelled) {
      const names = [...tables, ...masks].map(({ name }) => name);
      this.tell(
        [...told, ...ofImages, names.length === 0 ? null : info(say('cancelled-before-they-were-read', { files: names.length, names: namesText(names) }))],
        before,
      );
      return;
    }
    for (const [i, table] of tables.entries()) told.push(await this.takeFiducials(table, side ?? this.sideOfTable(table, i), here));
    told.push(...ofImages);
    if (camera === undefined) told.push(this.cameraStays(before));
    for (const [i, mask] of masks.entries()) told.push(await this.readMask(mask, masks.length === 1 && side !== null ? side : sideOfMask(mask, i), here));
    this.tell(told, before);
  }

  /** Opens a pair that was saved. */
  takeProject(file: File): Promise<void> {
    return this.takeHere([file.name], async (here) => {
      this.store.dispatch({ type: 'notice', notice: { kind: 'busy', text: say('reading', { name: file.name }) } });
      try {
        const opened = await readProject(this.engine, file, freshId);
        const aside = await this.leave(hasMarks(this.store.state), here);
        if (aside === null) return this.tell([unchanged()]);
        this.store.dispatch({ type: 'opened', opened });
        this.tell([info(say('was-opened-the-file-does-not', { name: file.name })), editsToldOf(opened), ...aside]);
      } catch (error) {
        this.tell([this.failed(say('cannot-be-opened', { name: file.name }), error, here)]);
      }
    });
  }

  /** Takes an image whose zeros say where no points are wanted; it has to be as large as the image that is open. */
  takeMask(file: File, side: Side): Promise<void> {
    return this.takeHere([file.name], async (here) => {
      this.store.dispatch({ type: 'notice', notice: null });
      this.tell([await this.readMask(file, side, here)]);
    });
  }

  private async readMask(file: File, side: Side, here: Here): Promise<Told> {
    const opened = this.store.state.images[side];
    if (opened === null) return problem(say('is-a-mask-of-the', { name: file.name, side }));
    try {
      const { info: photo } = await this.engine.open(side, opened);
      const mask = await this.engine.client('pair').call('mask', { file, overlaySide: MASK_SIDE });
      here();
      if (mask.width !== photo.width || mask.height !== photo.height) {
        return problem(
          say('has-px-the-image-px', { name: file.name, width: mask.width, height: mask.height, side, width_2: photo.width, height_2: photo.height }),
        );
      }
      this.store.dispatch({ type: 'mask', side, mask: { ...mask, id: freshId(), name: file.name, source: { kind: 'file', file } } });
      return info(say('masks-of-the-image', { name: file.name, left_out: 100 * mask.leftOut, side }));
    } catch (error) {
      return this.failed(say('cannot-be-used-as-a', { name: file.name }), error, here);
    }
  }

  /** Renders the pair of a flight in a worker and opens it. */
  takeFlight(name: string, flight: Flight): Promise<void> {
    const names = bothSides((side) => `${name} ${side}`);
    return this.takeHere(Object.values(names), async (here) => {
      this.store.dispatch({ type: 'notice', notice: { kind: 'busy', text: say('rendering-the-pair-a-simulated') } });
      try {
        const pair = await this.engine.client('pair').call('simulate', flight);
        const given = (side: Side): GivenImage => ({ id: freshId(), name: names[side], source: { kind: 'grey', ...pair[side] } });
        const aside = await this.leave(hasMarks(this.store.state), here);
        if (aside === null) return this.tell([unchanged()]);
        this.store.dispatch({ type: 'simulated', left: given('left'), right: given('right'), pair });
        this.tell(aside);
      } catch (error) {
        this.tell([this.failed(say('the-pair-could-not-be'), error, here)]);
      }
    });
  }

  /** The built-in pair. */
  async takeSample(): Promise<void> {
    const sample = this.store.state.catalogue?.flights.find(({ name }) => name === 'sample');
    if (sample !== undefined) await this.takeFlight(sample.name, sample.flight);
  }

  /** Says together what came of files that were given together; `before`: the images that were open then. */
  private tell(told: readonly Told[], before = this.store.state.images): void {
    const said = [...this.saidMeanwhile(), ...told.filter((one) => one !== null)];
    const bad = said.some(({ kind }) => kind === 'problem');
    const { images } = this.store.state;
    // Where nothing was open there is nothing to be afraid for.
    const areKept = SIDES.every((side) => images[side] === before[side]) && SIDES.some((side) => before[side] !== null);
    const kept = bad && areKept ? say('the-open-images-are-kept') : '';
    const text = `${said.map((one) => one.text).join(' ')}${kept}`;
    const choices = said.flatMap((one) => one.choices ?? []);
    const notice: Notice = { kind: bad ? 'problem' : 'info', text, ...(choices.length > 0 && { choices }) };
    this.store.dispatch({ type: 'notice', notice: said.length === 0 ? null : notice });
  }

  /** What was said since the files were taken, as that the camera is not that of the new images. */
  private saidMeanwhile(): readonly { kind: 'info'; text: string; choices?: readonly Choice[] }[] {
    const { notice } = this.store.state;
    return notice?.kind !== 'info' || notice.choices !== undefined ? [] : [{ kind: 'info', text: notice.text }];
  }

  private failed(what: string, error: unknown, here: Here): Told {
    here();
    if (error instanceof Cancelled) return unchanged();
    return problem(`${what}: ${sentence(readable(this.store.state.catalogue, messageOf(error)))}`);
  }

  /** Fiducials named "right", or the second of two tables, belong right. */
  private sideOfTable(table: File, index: number): Side {
    if (/right/iu.test(table.name)) return 'right';
    if (/left/iu.test(table.name)) return 'left';
    return index > 0 || this.store.state.photos.left.fiducials.length > 0 ? 'right' : 'left';
  }

  private async takeFiducials(file: File, side: Side, here: Here): Promise<Told> {
    try {
      const fiducials = await this.engine.client('pair').call('parseFiducials', { text: await textIn(file) });
      here();
      this.store.dispatch({ type: 'photo', side, photo: { fiducials } });
      return info(say('fiducial-of-the-image-from', { fiducials: fiducials.length, side, name: file.name }));
    } catch (error) {
      return this.failed(say('holds-no-fiducial-marks', { name: file.name }), error, here);
    }
  }

  private async takeCamera(file: File, here: Here): Promise<Told> {
    try {
      const camera = await this.engine.client('pair').call('parseCamera', { text: await textIn(file) });
      here();
      this.store.dispatch({ type: 'camera', camera });
      return info(say('camera-data-from', { name: file.name }));
    } catch (error) {
      return this.failed(say('holds-no-camera-data', { name: file.name }), error, here);
    }
  }

  /** Opens one or two images; each is decoded first, and replaces what is there only if it can be read. */
  private async takeImages(files: readonly File[], side: Side | null, asks: boolean, here: Here): Promise<Opened> {
    const tooLarge = files.find((file) => file.size > MOST_BYTES);
    if (tooLarge !== undefined) return done([problem(say('has-mb-up-to-1', { name: tooLarge.name, size: Math.round(tooLarge.size / 2 ** 20) }))]);
    const known = await Promise.all(files.map((file) => sideOfFile(this.store.state, this.engine, file)));
    here();
    if (known.every((place) => place !== null)) return this.takeFound(files, known, here);
    const sides = files.length === 2 ? (['left', 'right'] as const) : [side ?? this.freeSide()];
    const images: Partial<Record<Side, GivenImage>> = {};
    for (const [i, file] of files.entries()) {
      const target = sides[i];
      if (target !== undefined) images[target] = { id: freshId(), name: file.name, source: { kind: 'file', file } };
    }
    this.store.dispatch({
      type: 'notice',
      notice: { kind: 'busy', text: say('reading-2', { join: files.map((file) => file.name).join(say('and-between')) }) },
    });
    return this.check(images, 'images', here, asks);
  }

  /** The files of images that a project names take their places: nothing of the project changes. */
  private async takeFound(files: readonly File[], sides: readonly Side[], here: Here): Promise<Opened> {
    const images: Partial<Record<Side, GivenImage>> = {};
    for (const [i, side] of sides.entries()) {
      const [image, file] = [this.store.state.images[side], files[i]];
      if (image !== null && file !== undefined) images[side] = { ...image, source: { kind: 'file', file } };
    }
    return this.check(images, 'found', here);
  }

  private async check(images: Partial<Record<Side, GivenImage>>, type: 'images' | 'found', here: Here, asks = false): Promise<Opened> {
    const entries = Object.entries(images) as [Side, GivenImage][];
    const outcomes = await Promise.allSettled(entries.map(([side, image]) => this.engine.open(side, image)));
    here();
    const isCancelled = outcomes.some((outcome) => outcome.status === 'rejected' && outcome.reason instanceof Cancelled);
    if (type === 'images' && isCancelled && entries.every(([side]) => this.store.state.images[side] === null))
      return { told: this.leaveToRun(entries, outcomes), isCancelled };
    const told = this.failedImages(
      outcomes.flatMap((outcome, i) =>
        outcome.status === 'rejected' ? [{ name: entries[i]?.[1].name ?? say('the-file'), error: outcome.reason as unknown }] : [],
      ),
    );
    if (told.length > 0) {
      // Where nothing was open, what can be read is shown: the other one alone is missing.
      const { left, right } = this.store.state.images;
      const opened = entries.filter((_, i) => outcomes[i]?.status === 'fulfilled');
      if (left === null && right === null && opened.length > 0) this.store.dispatch({ type, images: Object.fromEntries(opened) });
      return { told, isCancelled };
    }
    if (type === 'found') {
      this.store.dispatch({ type, images });
      return done([]);
    }
    const question = asks ? await this.askOfThird(images) : null;
    here();
    return question === null ? this.show(images, here) : done([question]);
  }

  /** Images that take no other's place stay where Cancel ended their reading: Run opens them. */
  private leaveToRun(entries: readonly [Side, GivenImage][], outcomes: readonly PromiseSettledResult<unknown>[]): Told[] {
    const refused = (i: number) => {
      const outcome = outcomes[i];
      return outcome?.status === 'rejected' && !(outcome.reason instanceof Cancelled)
        ? [{ name: entries[i]?.[1].name ?? '', error: outcome.reason as unknown }]
        : [];
    };
    const images = Object.fromEntries(entries.filter((_, i) => refused(i).length === 0));
    this.store.dispatch({ type: 'images', images, waits: true });
    return this.failedImages(entries.flatMap((_, i) => refused(i)));
  }

  /** Before a single photo takes the place of one of two: the three may be meant as a block. Null where it cannot be, or where the photo is the one that is there. */
  private async askOfThird(images: Partial<Record<Side, GivenImage>>): Promise<Told> {
    const { left, right } = this.store.state.images;
    const [[side, third], another] = Object.entries(images) as [[Side, GivenImage], unknown];
    const files = [left, right, third].flatMap((image) => (image === null ? [] : fileOf(image)));
    if (another !== undefined || files.length < 3 || (await this.isSame(this.store.state.images[side], third))) return null;
    const dismiss = () => this.store.dispatch({ type: 'notice', notice: null });
    const choices: Choice[] = [
      {
        text: say('open-three-as-a-block'),
        act: () => {
          dismiss();
          this.elsewhere.toBlock(files, []);
        },
      },
      { text: say('replace-the-image', { side }), act: () => void this.replace(images) },
      { text: say('keep-the-pair'), act: dismiss },
    ];
    return { kind: 'info', text: say('is-a-third-image', { name: third.name, side }), choices };
  }

  private replace(images: Partial<Record<Side, GivenImage>>): Promise<void> {
    const names = Object.values(images).map(({ name }) => name);
    return this.takeHere(names, async (here) => {
      const before = this.store.state.images;
      const { told } = await this.show(images, here);
      this.tell([...told, this.cameraStays(before)]);
    });
  }

  /** A camera that was given for the images before these is in use for them too; of one that a block calibrated is said elsewhere whether it is theirs. */
  private cameraStays(before: State['images']): Told {
    const { images, camera } = this.store.state;
    const areOthers = SIDES.some((side) => before[side] !== null && images[side]?.id !== before[side].id);
    return areOthers && camera !== null && calibrationBehind(camera) === null ? info(say('the-camera-that-was-given-stays')) : null;
  }

  /** Shows images that were decoded. */
  private async show(images: Partial<Record<Side, GivenImage>>, here: Here): Promise<Opened> {
    // A single one takes the mask of the one before it away, and the edits of their matches.
    const { photos, images: former } = this.store.state;
    const marked = await this.marked(images);
    // Beside an image that is alone nothing is lost.
    const replaces = SIDES.some((side) => images[side] !== undefined && former[side] !== null);
    here();
    const aside = replaces ? await this.leave(marked.gone.length > 0, here) : [];
    if (aside === null) return { told: [unchanged()], isCancelled: true };
    this.store.dispatch({ type: 'images', images, same: marked.same });
    return done([...aside, ...marked.gone.map((side) => info(say('marks-went-with-the-image', { side, marks: photos[side].fiducials.length })))]);
  }

  /** Of the sides whose image is replaced and has marks those whose new image is the same, and those whose marks go. */
  private async marked(images: Partial<Record<Side, GivenImage>>): Promise<{ same: Side[]; gone: Side[] }> {
    const { images: former, photos, truth } = this.store.state;
    const sides = SIDES.filter((side) => truth === null && images[side] !== undefined && former[side] !== null && hasData(photos[side]));
    const areSame = await Promise.all(sides.map((side) => this.isSame(former[side], images[side])));
    return { same: sides.filter((_, i) => areSame[i]), gone: sides.filter((_, i) => !areSame[i]) };
  }

  private isSame(a: GivenImage | null, b: GivenImage | undefined): Promise<boolean> {
    return a === null || b === undefined ? Promise.resolve(false) : haveSameContent(a.source, b.source, this.engine);
  }

  /**
   * Before another pair takes the place of one that is worth keeping: it stays in the list of projects, which is said; null where it cannot, and the user keeps
   * it. `marksGo`: so do images whose marks go with them.
   */
  private async leave(marksGo: boolean, here: Here): Promise<readonly Told[] | null> {
    here();
    if (!marksGo && !isWorthKeeping(this.store.state)) return [];
    const names = SIDES.flatMap((side) => this.store.state.images[side]?.name ?? []);
    const stays = await this.putAside();
    here();
    if (stays) return [info(say('stay-under-projects', { title_of: titleOf({ name: null, images: names }) }))];
    const question = say('cannot-be-kept-in-this', { edits: say('the-pair-with-its-marks'), step: say('open-the-other-pair'), length: 1 });
    return window.confirm(question) ? [] : null;
  }

  /** What is said of images that could not be opened: a reason that holds for several stands once. */
  private failedImages(failed: readonly { name: string; error: unknown }[]): Told[] {
    const refused: Refused[] = [];
    const told: Told[] = [];
    for (const { name, error } of failed) {
      const breakdown = breakdownOf(error);
      if (breakdown !== null) told.push(problem(say('could-not-be-opened-try', { name, breakdown })));
      else if (!(error instanceof Cancelled)) refused.push({ name, reason: readable(this.store.state.catalogue, messageOf(error)) });
    }
    if (failed.some(({ error }) => error instanceof Cancelled)) told.push(unchanged());
    return refused.length === 0 ? told : [...told, problem(refusedText(refused))];
  }

  /** Where a single image goes: an empty place, else the active one. */
  private freeSide(): Side {
    const { images, activeSide } = this.store.state;
    if (images.left === null) return 'left';
    return images.right === null ? 'right' : activeSide;
  }
}

/** The file of an image; none of one that was simulated, or that stands in a project without its file. */
function fileOf({ name, source }: GivenImage): File[] {
  if (source.kind !== 'file') return [];
  return [source.file instanceof File ? source.file : new File([source.file], name)];
}

/** Takes what is dropped on the page while no other part does; a single image goes to the pane that it is dropped on. */
export function takerOf(store: Store, view: View, files: Files): Taker {
  const sideAt = (event: DragEvent) => {
    const box = view.host.getBoundingClientRect();
    const panes = panesOf(store.state, box.width, box.height);
    return SIDES.find((side) => contains(panes[side], event.clientX - box.left, event.clientY - box.top));
  };
  return {
    isActive: () => true,
    markAt: (event) => sideAt(event) ?? 'page',
    take: (found, at) => void files.give(found, SIDES.find((side) => side === at) ?? null, true),
  };
}
