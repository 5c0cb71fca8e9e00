/** Takes files of a block in: images, a folder of them, texts that say more of them, a block that was saved. */
import { IMAGE_FILE } from '../../../pkg/block/image-files.js';
import { keepChoice, keptChoice } from '../../shared/choices';
import type { FoundFile } from '../../shared/files/drop';
import { doHere, takeHere } from '../../shared/files/leaving';
import type { Here, TakeHere } from '../../shared/files/leaving';
import { kindsText, namesText, refusedKinds } from '../../shared/files/refused';
import type { Notice } from '../../shared/state/notice';
import { say } from '../../shared/text/words';
import type { BlockEngine, BlockStore } from '../engine/engine';
import type { PlacingEngine } from '../engine/placing';
import { awaitsFrames, stemOf } from '../state/film';
import { framesStep } from '../state/frames-step';
import { isReplaced, PROJECT_FILE } from '../state/of-file';
import { asksPurpose, purposeOf } from '../state/purpose';
import type { BlockFile, BlockState } from '../state/state';
import { BlockActions } from './actions';
import { BlockAside } from './aside';
import { BesideFiles, CAMERAS, TABLE } from './beside';
import { FilmFiles } from './film';
import { GroundFiles } from './ground';
import { newId } from './ids';
import { optionsOf } from './opened';
import { asGiven, sortRasters } from './rasters';
import type { BlockRuns } from './runs';
import { SimulatedFiles } from './simulated';
import { Telling } from './told';

const GEOID = /\.gtx$/iu;
const NEEDS_MORE = say('a-block-needs-two-images');

const WAITS = 'tiepoint-wait';

export class BlockFiles {
  /** What is given beside the images. */
  readonly beside: BesideFiles;
  readonly film: FilmFiles;
  readonly simulated: SimulatedFiles;
  /** What is done with the block. */
  readonly actions: BlockActions;
  private readonly ground: GroundFiles;
  private readonly telling: Telling;
  private readonly aside: BlockAside;
  /** Takes what has these names for the project that is shown. */
  private readonly takeHere: TakeHere;
  /** Images that are given wait until Run is pressed: large blocks have settings and files that come first. */
  private waiting = keptChoice(WAITS) === 'yes';

  constructor(
    private readonly store: BlockStore,
    private readonly engine: BlockEngine,
    placing: PlacingEngine,
    private readonly runs: BlockRuns,
    /** Opens a project of whatever kind where it belongs. */
    private readonly openProject: (file: File) => Promise<void>,
    /** Leaves the block that is shown in the list of projects; false where it cannot be. */
    putAside: () => Promise<boolean>,
    /** Waits for the project that is being left: files are of the next one. */
    private readonly left: () => Promise<Here>,
    /** Waits for it, too: what is done is done with the project that is shown now. */
    stays: () => Promise<Here>,
  ) {
    const telling = new Telling(store);
    const aside = new BlockAside(store, putAside);
    this.takeHere = (names, take) =>
      takeHere(left, take, () => telling.tell('info', say('were-not-taken-the-project', { files: names.length, names: namesText(names) })));
    this.telling = telling;
    this.aside = aside;
    this.ground = new GroundFiles(store, placing);
    this.film = new FilmFiles(store, this.takeHere);
    this.beside = new BesideFiles(store, telling, this.film, this.takeHere);
    this.simulated = new SimulatedFiles(store, engine, placing, this.ground, runs, telling, aside, this.takeHere, () => this.waiting);
    this.actions = new BlockActions(store, placing, runs, telling, aside, stays);
  }

  get waits(): boolean {
    return this.waiting;
  }

  set waits(waits: boolean) {
    this.waiting = waits;
    keepChoice(WAITS, waits ? 'yes' : 'no');
  }

  /** Adds images to the block; what a folder holds besides images is left aside. `why` is said first. */
  take(given: readonly FoundFile[], why = ''): Promise<void> {
    return this.takeHere(
      given.map(({ file }) => file.name),
      (here) => this.takeKinds(given, why, here),
    );
  }

  private async takeKinds(given: readonly FoundFile[], why: string, here: Here): Promise<void> {
    const before = this.store.state.notice;
    const kinds = await refusedKinds(given.map(({ file }) => file));
    const unread = kindsText(kinds);
    const { others: found, taken, degrees, ...rasters } = asGiven(await sortRasters(given.filter(({ file }) => !kinds.has(file))));
    here();
    const lone = rasters.projections.filter(({ name }) => !rasters.worlds.some((world) => stemOf(world.name) === stemOf(name)));
    const ground = await this.ground.take(rasters, here);
    here();
    const several = taken === 0 ? '' : say('that-say-where-they-lie', { taken: images(taken) });
    // Nothing else is taken with what is wrong: it can be given again.
    if (ground === null) {
      if (unread !== '') this.telling.tellBeside(this.store.state.notice, unread);
      return;
    }
    const alone = found.filter(({ path }) => path === '');
    const project = alone.find(({ file }) => PROJECT_FILE.test(file.name));
    const film = await this.beside.ofFilm(
      alone.map(({ file }) => file),
      here,
    );
    here();
    const said = [ground, several, film.said].filter((text) => text !== '').join(' ');
    const cameras = alone.find(({ file }) => CAMERAS.test(file.name) && !film.files.has(file));
    const geoid = alone.find(({ file }) => GEOID.test(file.name));
    const photos = found.filter(({ file }) => IMAGE_FILE.test(file.name) || file.type.startsWith('image/'));
    if (project !== undefined) await this.openProject(project.file);
    here();
    if (geoid !== undefined) this.beside.takeGeoid(geoid.file);
    const notCameras = cameras === undefined ? '' : await this.beside.cameras(cameras.file, photos, here);
    const tables = await this.beside.tables(
      alone.map(({ file }) => file).filter((file) => TABLE.test(file.name) && !film.files.has(file)),
      photos,
      here,
    );
    here();
    const known = new Set([...photos, project, cameras, geoid].map((one) => one?.file));
    const others = found.map(({ file }) => file).filter((file) => !known.has(file) && !film.files.has(file) && !tables.files.has(file));
    const aside = [...others, ...lone].map(({ name }) => name);
    if (photos.length > 0 || aside.length > 0) this.add(here, photos, aside, [why, said].filter((text) => text !== '').join(' '), before);
    else await this.said(here, [said, film.said === '' ? '' : framesStep(this.store.state)].filter((text) => text !== '').join(' '));
    // A geoid, or heights that would be refused: where the user gives it says which.
    const grids = degrees.map(({ file }) => say('is-a-grid-at-longitudes', { name: file.name })).join(' ');
    const putAside = [unread, grids, film.aside, this.beside.marksOfNone(film.marks), notCameras, tables.aside].filter((text) => text !== '').join(' ');
    if (putAside === '') return;
    const { notice } = this.store.state;
    if (given.length > 0 && kinds.size === given.length) this.telling.tellUnread(unread);
    else this.telling.tellBeside(notice === before ? null : notice, putAside);
  }

  /** Takes files that are given as an orthophoto with what belongs to it, or as its heights: what they hold decides where it can be told. */
  takeGround(given: readonly File[], asHeights = false): Promise<void> {
    return this.takeHere(
      given.map(({ name }) => name),
      (here) => this.takeRasters(given, asHeights, here),
    );
  }

  private async takeRasters(given: readonly File[], asHeights: boolean, here: Here): Promise<void> {
    const kinds = await refusedKinds(given);
    const { others, ...sorted } = await sortRasters(given.filter((file) => !kinds.has(file)).map((file) => ({ file, path: '' })));
    here();
    // A picture that does not say where it lies is refused with the crate's reason.
    const unknown = others.map(({ file }) => ({ file, world: null, projection: null }));
    const pictures = asHeights ? [] : [...sorted.orthophotos, ...(sorted.orthophotos.length > 0 ? [] : unknown)];
    const heights = [...sorted.heights, ...sorted.degrees, ...(asHeights ? [...sorted.orthophotos, ...unknown] : [])];
    const text = await this.ground.take({ orthophotos: pictures, heights, worlds: sorted.worlds, projections: sorted.projections }, here);
    here();
    await this.said(here, text, kindsText(kinds));
  }

  /** Takes one height for all of the ground. */
  takeLevel(height: number): Promise<void> {
    return doHere(this.left, async (here) => this.said(here, await this.ground.takeLevel(height, here)));
  }

  /** Says what was taken, null where that was refused, and what of it is not read; images that wait for nothing else are placed. */
  private async said(here: Here, text: string | null, unread = ''): Promise<void> {
    here();
    if (text !== null && text !== '') this.telling.tell('info', text);
    if (unread !== '' && text === '') this.telling.tellUnread(unread);
    else if (unread !== '') this.telling.tellBeside(this.store.state.notice, unread);
    if (text === null || text === '') return;
    // A finished block is placed when the user asks, one that is run when it is finished.
    const { shown, placing, files, running } = this.store.state;
    if (shown === null && running.kind !== 'yes' && !this.waits && files.length > 0 && placing.placed.size === 0) await this.start(here);
  }

  /** Places the images that are given, or runs them as a block. */
  private async start(here: Here): Promise<void> {
    const { state } = this.store;
    if (purposeOf(state) === 'images') await this.runs.placeImages(here);
    // A block is made of the frames of scans, not of these.
    else if (awaitsFrames(state.placing.film, state.files)) return;
    // What is done with the orthophoto comes first.
    else if (state.files.length >= 2 && !asksPurpose(state)) await this.runs.run(here);
  }

  /** Takes more images than a pair has, which were given there. */
  give(files: readonly File[], masks: readonly File[]): Promise<void> {
    return this.takeHere(
      [...files, ...masks].map(({ name }) => name),
      async (here) => {
        await this.takeKinds(
          files.map((file) => ({ file, path: '' })),
          say('more-than-two-images-are'),
          here,
        );
        if (masks.length > 0) this.beside.takeMasks(masks);
      },
    );
  }

  /** Opens a block that was saved. */
  open(file: File): Promise<void> {
    return this.takeHere([file.name], async (here) => {
      this.telling.tell('busy', say('reading', { name: file.name }));
      try {
        const { view, steps, made, hold } = await this.engine.read(new Uint8Array(await file.arrayBuffer()));
        here();
        // What is refused of the file is refused while the former block is held.
        const options = optionsOf(made, file.name);
        const stays = await this.aside.leave(say('open-the-other-project'), here, isReplaced(this.store.state, view));
        if (stays === null) {
          this.store.dispatch({ type: 'notice', notice: null });
          return;
        }
        hold();
        this.store.dispatch({ type: 'openedFile', view, steps, options });
        const former = stays ? say('the-former-block-stays-under') : '';
        this.telling.tell('info', say('was-opened-the-file-does', { name: file.name, former }));
      } catch (error) {
        this.telling.failed(say('cannot-be-opened', { name: file.name }), error, here);
      }
    });
  }

  /** `noticed`: what was said before the files were given. */
  private add(here: Here, found: readonly FoundFile[], aside: readonly string[], why: string, noticed: Notice | null): void {
    const files = new Map(this.store.state.files.map((file) => [file.name, file]));
    const before = files.size;
    for (const { file, path } of found) {
      // Images of one name in two folders are told apart by their paths.
      const name = [file.name, path].find((text) => text !== '' && !files.has(text));
      if (name !== undefined) files.set(name, { id: newId(), name, file });
    }
    const twice = found.length - (files.size - before);
    const sorted: BlockFile[] = [...files.values()].sort((a, b) => (a.name < b.name ? -1 : 1));
    const own = ofOpened(this.store.state, sorted);
    if (sorted.length > before) {
      this.store.dispatch({ type: 'files', files: sorted, truth: this.store.state.truth });
      // What is given is run; what was given before goes on.
      if (!this.waits && own === null) void this.start(here);
    }
    if (aside.length > 0) this.store.dispatch({ type: 'skipped', names: aside });
    const runs = this.telling.runsNow();
    const notImages = aside.length > 0 ? say('skipped-not-an-image-by', { aside: aside.length }) : '';
    const notes = [
      why,
      runs || own !== null ? '' : say('in-the-block', { sorted: images(sorted.length) }),
      own ?? '',
      twice > 0 ? say('skipped-their-names-are-in', { twice: images(twice) }) : '',
      notImages,
      runs || own !== null ? '' : this.nextStep(sorted.length),
    ].filter((note) => note !== '');
    // What is wrong with a file, or why the block cannot be run, was said just now.
    const { notice } = this.store.state;
    if (notes.length === 0 || (notice?.kind === 'problem' && notice !== noticed)) return;
    // What the details list afterwards is said while the run goes on: the answer then counts what could not be used.
    const passing = notes.every((note) => note === why || note === notImages);
    this.store.dispatch({ type: 'notice', notice: { kind: 'info', text: notes.join(' '), beside: runs, passing } });
  }

  /** What the user does next with so many images. */
  private nextStep(count: number): string {
    if (purposeOf(this.store.state) === 'images') return say('press-place');
    const frames = framesStep(this.store.state);
    if (frames !== '') return frames;
    return count >= 2 ? say('press-run') : NEEDS_MORE;
  }
}

/** What is said of files that are the images of a block that was opened without them: it needs no run. Null where they are not, or not all of them are. */
function ofOpened({ shown }: BlockState, files: readonly BlockFile[]): string | null {
  if (shown === null || shown.view.partial || shown.files.length > 0) return null;
  const names = new Set(shown.view.images.map(({ name }) => name));
  if (!files.every(({ name }) => names.has(name))) return null;
  return files.length === names.size ? say('all-images-of-the-block') : say('of-of-the-block-are', { files: files.length, size: images(names.size) });
}

function images(count: number): string {
  return say('so-many-images', { images: count });
}
