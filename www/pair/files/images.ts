/** Takes the images of a pair: each is decoded first, and replaces what is there only if it can be read. */
import { breakdownOf, Cancelled } from '../../shared/engine/client';
import type { Here, TakeHere } from '../../shared/files/leaving';
import { refusedText } from '../../shared/files/refused';
import type { Refused } from '../../shared/files/refused';
import { calibrationBehind } from '../../shared/state/calibrations';
import type { Choice } from '../../shared/state/notice';
import { messageOf } from '../../shared/text/messages';
import { readable } from '../../shared/text/names';
import { say } from '../../shared/text/words';
import type { Engine } from '../engine/engine';
import { hasData } from '../state/kept';
import { otherSide, SIDES } from '../state/state';
import type { GivenImage, Side, State } from '../state/state';
import type { Store } from '../state/store';
import type { PairAside } from './aside';
import { freshId } from './ids';
import { haveSameContent, sideOfFile } from './project';
import { info, problem, unchanged } from './told';
import type { Telling, Told } from './told';

/** Beyond this a file is refused before it is read, in bytes: a browser tab cannot hold it and its decoded copy. */
const MOST_BYTES = 2 ** 30;

/** What came of images; `isCancelled`: Cancel ended their reading. */
export interface Opened {
  told: readonly Told[];
  isCancelled: boolean;
}

const done = (told: readonly Told[]): Opened => ({ told, isCancelled: false });

export class ImageFiles {
  constructor(
    private readonly store: Store,
    private readonly engine: Engine,
    private readonly telling: Telling,
    private readonly aside: PairAside,
    /** Takes more images than a pair has. */
    private readonly toBlock: (files: readonly File[], masks: readonly File[]) => void,
    private readonly takeHere: TakeHere,
  ) {}

  /** Opens one or two images; each is decoded first, and replaces what is there only if it can be read. */
  async take(files: readonly File[], side: Side | null, asks: boolean, here: Here): Promise<Opened> {
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

  /**
   * Before a single photo takes the place of one of two: the three may be meant as a block, and the other one of the two would stand beside itself. Null where it
   * cannot be, or where the photo is the one that is there.
   */
  private async askOfThird(images: Partial<Record<Side, GivenImage>>): Promise<Told> {
    const { left, right } = this.store.state.images;
    const [[side, third], another] = Object.entries(images) as [[Side, GivenImage], unknown];
    const files = [left, right, third].flatMap((image) => (image === null ? [] : fileOf(image)));
    if (another !== undefined || files.length < 3 || (await this.isSame(this.store.state.images[side], third))) return null;
    const beside = otherSide(side);
    if (await this.isSame(this.store.state.images[beside], third)) return info(say('is-the-other-image-already', { name: third.name, side: beside }));
    const dismiss = () => this.store.dispatch({ type: 'notice', notice: null });
    const choices: Choice[] = [
      {
        text: say('open-three-as-a-block'),
        act: () => {
          dismiss();
          this.toBlock(files, []);
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
      this.telling.tell([...told, this.cameraStays(before)]);
    });
  }

  /** A camera that was given for the images before these is in use for them too; of one that a block calibrated is said elsewhere whether it is theirs. */
  cameraStays(before: State['images']): Told {
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
    const aside = replaces ? await this.aside.leave(marked.gone.length > 0, here) : [];
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
