/** Takes files of a block in: images, a folder of them, texts that say more of them, a block that was saved. */
import type { FoundFile } from '../../shared/files/drop';
import { takeHere } from '../../shared/files/leaving';
import type { Here } from '../../shared/files/leaving';
import { kindsText, namesText, refusedKinds } from '../../shared/files/refused';
import { Cancelled } from '../../shared/engine/client';
import type { BlockFlight } from '../../../pkg/wasm/tiepoint.js';
import { keepChoice, keptChoice } from '../../shared/choices';
import { sentence } from '../../shared/text/format';
import { isOutdated, wantedKey } from '../state/state';
import { removesOthers } from '../state/removing';
import type { BlockFile, BlockState } from '../state/state';
import type { Notice } from '../../shared/state/notice';
import type { BlockEngine, BlockStore } from '../engine/engine';
import type { PlacingEngine } from '../engine/placing';
import { asksPurpose, lacksPlaceAlone, purposeOf } from '../state/purpose';
import { carriedOver } from '../state/carrying';
import { awaitsFrames, marksOfNone, stemOf } from '../state/film';
import { framesStep } from '../state/frames-step';
import { namesOf, withoutPlaces } from '../state/naming';
import type { Purpose } from '../state/placing';
import { IMAGE_FILE } from '../../../pkg/block/image-files.js';
import { PARTNER_MISSING, problemsOf } from '../state/given';
import { waitsForMarks } from '../state/marks';
import { controlText } from '../state/words';
import type { GivenText } from '../state/given';
import { FilmFiles } from './film';
import { GroundFiles } from './ground';
import { newId } from './ids';
import { fieldsOf, OWN_SETTINGS } from '../../shared/files/json';
import { textIn } from '../../shared/files/text';
import { asGiven, sortRasters } from './rasters';
import type { BlockRuns } from './runs';
import { hasFiducials, hasNumbers, kindOfTable } from './tables';
import { say } from '../../shared/text/words';
import { messageOf } from '../../shared/text/messages';

const PROJECT = /\.tiepoint$/iu;
const TABLE = /\.(?:csv|txt)$/iu;
const GEOID = /\.gtx$/iu;
const CSV = /\.csv$/iu;
const CAMERAS = /\.json$/iu;
/** The field that cameras of film have, and files of cameras and settings do not. */
const FOCAL_LENGTH = 'focal_mm';

const TEXTS: Readonly<Record<GivenText, string>> = {
  cameras: say('cameras'),
  control: say('ground-control-points'),
  marks: say('image-measurements'),
  positions: say('image-positions'),
};

const NEEDS_MORE = say('a-block-needs-two-images');

const NOTHING_LOST = { lost: 0, aside: [] };

const WAITS = 'tiepoint-wait';

export class BlockFiles {
  /** Orthophotos and heights. */
  readonly ground: GroundFiles;
  private readonly film: FilmFiles;
  /** Images that are given wait until Run is pressed: large blocks have settings and files that come first. */
  private waiting = keptChoice(WAITS) === 'yes';

  constructor(
    private readonly store: BlockStore,
    private readonly engine: BlockEngine,
    private readonly placing: PlacingEngine,
    private readonly runs: BlockRuns,
    /** Opens a project of whatever kind where it belongs. */
    private readonly openProject: (file: File) => Promise<void>,
    /** Leaves the block that is shown in the list of projects; false where it cannot be. */
    private readonly putAside: () => Promise<boolean>,
    /** Waits for the project that is being left: files are of the next one. */
    private readonly left: () => Promise<Here>,
  ) {
    this.ground = new GroundFiles(store, placing);
    this.film = new FilmFiles(store);
    let before = store.state;
    store.watch(['marks', 'shown'], ([marks, shown]) => {
      // What the browser kept, and another block, are shown as they are.
      const others = shown !== null && shown.found === before.shown?.found && removesOthers(before.marks, marks);
      before = store.state;
      if (others && isOutdated(before)) queueMicrotask(() => void this.run());
    });
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

  /** Takes what has these names for the project that is shown. */
  private takeHere(names: readonly string[], take: (here: Here) => Promise<void>): Promise<void> {
    const tell = () => this.tell('info', say('were-not-taken-the-project', { files: names.length, names: namesText(names) }));
    return takeHere(this.left, take, tell);
  }

  private async takeKinds(given: readonly FoundFile[], why: string, here: Here): Promise<void> {
    const before = this.store.state.notice;
    const kinds = await refusedKinds(given.map(({ file }) => file));
    const unread = kindsText(kinds);
    const { others: found, taken, degrees, ...rasters } = asGiven(await sortRasters(given.filter(({ file }) => !kinds.has(file))));
    here();
    const lone = rasters.projections.filter(({ name }) => !rasters.worlds.some((world) => stemOf(world.name) === stemOf(name)));
    const ground = await this.ground.take(rasters);
    here();
    const several = taken === 0 ? '' : say('that-say-where-they-lie', { taken: images(taken) });
    // Nothing else is taken with what is wrong: it can be given again.
    if (ground === null) {
      if (unread !== '') this.tellBeside(this.store.state.notice, unread);
      return;
    }
    const alone = found.filter(({ path }) => path === '');
    const project = alone.find(({ file }) => PROJECT.test(file.name));
    const film = await this.takeFilm(alone.map(({ file }) => file));
    here();
    const said = [ground, several, film.said].filter((text) => text !== '').join(' ');
    const cameras = alone.find(({ file }) => CAMERAS.test(file.name) && !film.files.has(file));
    const geoid = alone.find(({ file }) => GEOID.test(file.name));
    const photos = found.filter(({ file }) => IMAGE_FILE.test(file.name) || file.type.startsWith('image/'));
    if (project !== undefined) await this.openProject(project.file);
    here();
    if (geoid !== undefined) this.takeGeoid(geoid.file);
    const notCameras = cameras === undefined ? '' : await this.takeCameras(cameras.file, photos);
    const tables = await this.takeTables(
      alone.map(({ file }) => file).filter((file) => TABLE.test(file.name) && !film.files.has(file)),
      photos,
    );
    here();
    const aside =
      found.length - photos.length - film.files.size - tables.count - [project, cameras, geoid].filter((file) => file !== undefined).length + lone.length;
    if (photos.length > 0 || aside > 0) this.add(photos, aside, [why, said].filter((text) => text !== '').join(' '), before);
    else await this.said([said, film.said === '' ? '' : framesStep(this.store.state)].filter((text) => text !== '').join(' '));
    // A geoid, or heights that would be refused: where the user gives it says which.
    const grids = degrees.map(({ file }) => say('is-a-grid-at-longitudes', { name: file.name })).join(' ');
    const putAside = [unread, grids, film.aside, this.marksOfNone(film.marks), notCameras, tables.aside].filter((text) => text !== '').join(' ');
    if (putAside === '') return;
    const { notice } = this.store.state;
    if (given.length > 0 && kinds.size === given.length) this.tellUnread(unread);
    else this.tellBeside(notice === before ? null : notice, putAside);
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
    const text = await this.ground.take({ orthophotos: pictures, heights, worlds: sorted.worlds, projections: sorted.projections });
    here();
    await this.said(text, kindsText(kinds));
  }

  /** Takes one height for all of the ground. */
  async takeLevel(height: number): Promise<void> {
    await this.left();
    await this.said(await this.ground.takeLevel(height));
  }

  /** Says what was taken, null where that was refused, and what of it is not read; images that wait for nothing else are placed. */
  private async said(text: string | null, unread = ''): Promise<void> {
    if (text !== null && text !== '') this.tell('info', text);
    if (unread !== '' && text === '') this.tellUnread(unread);
    else if (unread !== '') this.tellBeside(this.store.state.notice, unread);
    if (text === null || text === '') return;
    // A finished block is placed when the user asks, one that is run when it is finished.
    const { shown, placing, files, running } = this.store.state;
    if (shown === null && running.kind !== 'yes' && !this.waits && files.length > 0 && placing.placed.size === 0) await this.start();
  }

  /** Places the images that are given, or runs them as a block. */
  private async start(): Promise<void> {
    const { state } = this.store;
    if (purposeOf(state) === 'images') await this.runs.placeImages();
    // A block is made of the frames of scans, not of these.
    else if (awaitsFrames(state.placing.film, state.files)) return;
    // What is done with the orthophoto comes first.
    else if (state.files.length >= 2 && !asksPurpose(state)) await this.runs.run();
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
        if (masks.length > 0) this.takeMasks(masks);
      },
    );
  }

  /** Photographs a block and runs it, whatever waits. */
  sample(flight: BlockFlight): Promise<void> {
    return this.takeHere([say('simulated-block')], async (here) => {
      if (await this.simulate(flight, here)) await this.runs.run();
    });
  }

  /** Photographs a block and the orthophoto of its scene, with pixels of so many m, and places the photos on it. */
  sampleOnOrthophoto(flight: BlockFlight, gsd: number): Promise<void> {
    return this.takeHere([say('simulated-block')], async (here) => {
      if (!(await this.simulate(flight, here))) return;
      this.tell('busy', say('making-the-orthophoto-of-the'));
      try {
        const { picture, heights } = await this.placing.scene(flight, gsd);
        here();
        const rasters = {
          orthophotos: [{ file: new File([picture], 'orthophoto.tif'), world: null, projection: null }],
          heights: [{ file: new File([heights], 'heights.tif'), world: null, projection: null }],
          worlds: [],
          projections: [],
        };
        const taken = await this.ground.take(rasters);
        here();
        if (taken !== null) await this.runs.placeImages();
      } catch (error) {
        this.failed(say('the-orthophoto-could-not-be'), error, here);
      }
    });
  }

  /** Photographs the simulated block that is set and runs it. */
  photograph(): Promise<void> {
    return this.takeHere([say('simulated-block')], async (here) => {
      const { flight } = this.store.state;
      if (flight === null || !(await this.simulate(flight, here))) return;
      if (this.waits) this.tell('info', say('photos-of-a-simulated-block', { files: this.store.state.files.length }));
      else await this.runs.run();
    });
  }

  /** Photographs a flight, in place of the images that are there; false where that failed. */
  private async simulate(flight: BlockFlight, here: Here): Promise<boolean> {
    this.tell('busy', say('building-the-synthetic-scene'));
    try {
      const { files, truth } = await this.engine.photograph(flight, (count, of) => {
        here();
        this.tell('busy', say('photographing-the-simulated-block-of', { count, of }));
      });
      here();
      const stays = await this.leave(say('photograph-another-block'), here);
      if (stays === null) {
        this.store.dispatch({ type: 'notice', notice: null });
        return false;
      }
      // What stays in the list is not shown any more. A block with edits would lend them to the images of the next one, which have the same names; its
      // orthophoto shows other ground.
      if (stays || this.store.state.history.edits.length + this.store.state.marks.edits.length > 0 || this.store.state.placing.orthophoto !== null)
        this.store.dispatch({ type: 'clear' });
      this.store.dispatch({ type: 'files', files: files.map((file) => ({ ...file, id: newId() })), truth });
      return true;
    } catch (error) {
      this.failed(say('the-block-could-not-be'), error, here);
      return false;
    }
  }

  /** Takes cameras that were given with these photos; a file that cannot be used is put aside, and changes nothing: what is said of it. */
  private async takeCameras(file: File, photos: readonly FoundFile[]): Promise<string> {
    const { state } = this.store;
    const text = await textIn(file);
    const files = [...state.files, ...photos.map((photo) => ({ id: 0, name: photo.file.name, file: photo.file }))];
    const { cameras: problem } = problemsOf({ ...state, files, options: { ...state.options, cameras: { name: file.name, text } } });
    if (problem === undefined) {
      await this.takeText('cameras', file);
      return '';
    }
    const fields = fieldsOf(text);
    if (OWN_SETTINGS in fields) return say('holds-settings', { name: file.name });
    return say('cameras' in fields ? 'cameras-are-put-aside' : 'holds-no-cameras', { problem: sentence(problem) });
  }

  /** Takes the camera and the fiducial marks of scanned film, told by what they hold. `marks`: their names; `aside`: what is wrong with them. */
  private async takeFilm(given: readonly File[]): Promise<{ files: Set<File>; marks: readonly string[]; said: string; aside: string }> {
    const cameras: File[] = [];
    const marks: File[] = [];
    for (const file of given) {
      if (CAMERAS.test(file.name) && FOCAL_LENGTH in fieldsOf(await textIn(file))) cameras.push(file);
      else if (TABLE.test(file.name) && hasFiducials(await textIn(file))) marks.push(file);
    }
    const [camera] = cameras;
    const said = [...(camera === undefined ? [] : [await this.film.camera(camera)]), ...(marks.length === 0 ? [] : [await this.film.marks(marks)])];
    const texts = (kind: 'info' | 'problem') => said.flatMap((one) => (one.kind === kind ? [one.text] : [])).join(' ');
    return {
      files: new Set([...(camera === undefined ? [] : [camera]), ...marks]),
      marks: marks.map(({ name }) => name),
      said: texts('info'),
      aside: texts('problem'),
    };
  }

  /** What is said of fiducial marks, of those with these names, that are of no image. */
  private marksOfNone(names: readonly string[]): string {
    const { placing, files } = this.store.state;
    const lone = marksOfNone(placing.film, files).filter((name) => names.includes(name));
    return lone.map((name) => say('marks-of-no-image', { name })).join(' ');
  }

  /** Takes tables of control points, of image measurements and of GNSS positions, given with these photos; what is none is left aside, and changes nothing. `count`: those that are said something of. */
  private async takeTables(files: readonly File[], photos: readonly FoundFile[]): Promise<{ count: number; aside: string }> {
    const names = new Set([...this.store.state.files, ...photos.map(({ file }) => file)].map(({ name }) => name));
    const aside: string[] = [];
    let count = 0;
    for (const file of files) {
      const text = await textIn(file);
      const found = kindOfTable(text, names);
      // Any other text, such as notes, is no table.
      if (found.kind === 'neither' && !CSV.test(file.name) && !hasNumbers(text)) continue;
      count += 1;
      if (found.kind === 'neither') aside.push(say('is-no-table-of', { name: file.name, why: sentence(found.why) }));
      else if (found.kind !== 'fiducials') await this.takeText(found.kind, file);
    }
    return { count, aside: aside.join(' ') };
  }

  /** Says more than what was said of the same files; where that is nothing, beside what is said of the block. */
  private tellBeside(said: Notice | null, text: string): void {
    const notice: Notice = said === null ? { kind: 'info', text, beside: true } : { ...said, text: `${said.text} ${text}` };
    this.store.dispatch({ type: 'notice', notice });
  }

  /** Takes a file of text and says what is wrong with it; it stays beside its field until another is given or it is removed. */
  async takeText(given: GivenText, file: File): Promise<void> {
    this.store.dispatch({ type: 'options', options: { [given]: { name: file.name, text: await textIn(file) } } });
    const problem = problemsOf(this.store.state)[given];
    const said = say('from', { texts: TEXTS[given], name: file.name });
    if (problem === undefined)
      this.tellTaken((given === 'control' || given === 'marks') && waitsForMarks(this.store.state) ? `${said} ${controlText(this.store.state)}` : said);
    else if (problem === PARTNER_MISSING[given]) this.tellTaken(say('from-2', { texts: TEXTS[given], name: file.name, problem }));
    else this.tell('problem', say('the-block-cannot-be-run', { problem: sentence(problem) }));
  }

  /** Takes masks in place of those that are there. */
  takeMasks(files: readonly File[]): void {
    this.store.dispatch({ type: 'options', options: { masks: files.map((file) => ({ id: newId(), name: file.name, file })) } });
    const problem = problemsOf(this.store.state).masks;
    if (problem !== undefined) this.tell('problem', say('the-block-cannot-be-run-with', { problem: sentence(problem) }));
  }

  /** Takes the geoid from which heights count, in place of the one that is there. */
  takeGeoid(file: File): void {
    this.store.dispatch({ type: 'options', options: { geoid: { id: newId(), name: file.name, file } } });
    const problem = problemsOf(this.store.state).geoid;
    if (problem === undefined) this.tellTaken(say('from', { texts: say('geoid'), name: file.name }));
    else this.tell('problem', say('the-block-cannot-be-run', { problem: sentence(problem) }));
  }

  /** Opens a block that was saved. */
  open(file: File): Promise<void> {
    return this.takeHere([file.name], async (here) => {
      this.tell('busy', say('reading', { name: file.name }));
      try {
        const { view, edits, hold } = await this.engine.read(new Uint8Array(await file.arrayBuffer()));
        here();
        const edited = await this.leave(say('open-the-other-project'), here);
        if (edited === null) {
          this.store.dispatch({ type: 'notice', notice: null });
          return;
        }
        const stays = edited || (this.store.state.shown !== null && (await this.putAside()));
        here();
        hold();
        this.store.dispatch({ type: 'openedFile', view, edits });
        const former = stays ? say('the-former-block-stays-under') : '';
        this.tell('info', say('was-opened-the-file-does', { name: file.name, former }));
      } catch (error) {
        this.failed(say('cannot-be-opened', { name: file.name }), error, here);
      }
    });
  }

  /** What the user decides to do with the orthophoto. */
  async decide(purpose: Purpose): Promise<void> {
    this.store.dispatch({ type: 'purpose', purpose });
    this.store.dispatch({ type: 'notice', notice: null });
    if (purpose === 'images') await this.runs.placeImages();
    else if (purpose === 'block') await this.run();
    else this.store.dispatch({ type: 'stage', view: 'map' });
  }

  /** Runs the block. One with edits that do not hold for the next one stays in the list of projects. */
  async run(): Promise<void> {
    const { shown, history } = this.store.state;
    const names = shown === null ? null : namesOf(shown.found);
    // The same files and settings give the same tie points.
    const isSame = shown !== null && shown.tiePoints !== '' && shown.key === wantedKey(this.store.state);
    const { lost, aside } = names === null ? NOTHING_LOST : carriedOver(history, names, withoutPlaces(names), isSame);
    if (lost + aside.length === 0 || lacksPlaceAlone(this.store.state)) return this.runs.run();
    this.tell('busy', say('keeping-the-edited-block'));
    const stays = await this.leave(say('run-it-again'));
    this.store.dispatch({ type: 'notice', notice: null });
    if (stays === null) return;
    await this.runs.run();
    const { notice, running } = this.store.state;
    if (!stays || running.kind !== 'no' || notice === null) return;
    this.store.dispatch({ type: 'notice', notice: { ...notice, text: say('the-former-block-stays-under-projects', { text: notice.text }) } });
  }

  /** Removes all images, and the block. */
  async clear(): Promise<void> {
    const { shown, history, marks } = this.store.state;
    const isEdited = history.edits.length + marks.edits.length > 0;
    const stays = await this.leave(say('remove-all-images'));
    if (stays === null) return;
    this.store.dispatch({ type: 'clear' });
    const what = shown === null ? say('project') : isEdited ? say('edited-block') : say('oriented-block');
    if (stays) this.tell('info', say('the-stays-under-projects', { what }));
  }

  /**
   * Before the block is gone: one of photos that were not simulated, one with edits, and what was placed on an orthophoto stay in the list of projects, which
   * is true then. Null where it cannot, and the user keeps it.
   */
  private async leave(step: string, here: Here = () => undefined): Promise<boolean | null> {
    const { shown, truth, history, marks, placing } = this.store.state;
    const length = history.edits.length + marks.edits.length;
    const isFound = shown !== null && !shown.view.partial && shown.view.oriented > 0 && truth === null;
    if (length === 0 && placing.placed.size === 0 && !isFound) return false;
    const stays = await this.putAside();
    here();
    if (stays) return true;
    const what = placing.placed.size > 0 ? say('what-was-placed-on-the') : say('the-block-of-these-photos');
    const edits = length === 0 ? what : length === 1 ? say('the-edit-by-hand-of') : say('the-edits-by-hand-of', { length });
    return window.confirm(say('cannot-be-kept-in-this', { edits, step, length: Math.max(1, length) })) ? false : null;
  }

  /** `noticed`: what was said before the files were given. */
  private add(found: readonly FoundFile[], aside: number, why: string, noticed: Notice | null): void {
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
      if (!this.waits && own === null) void this.start();
    }
    const runs = this.runsNow();
    const notes = [
      why,
      runs || own !== null ? '' : say('in-the-block', { sorted: images(sorted.length) }),
      own ?? '',
      twice > 0 ? say('skipped-their-names-are-in', { twice: images(twice) }) : '',
      aside > 0 ? say('skipped-not-an-image-by', { aside }) : '',
      runs || own !== null ? '' : this.nextStep(sorted.length),
    ].filter((note) => note !== '');
    // What is wrong with a file, or why the block cannot be run, was said just now.
    const { notice } = this.store.state;
    if (notes.length === 0 || (notice?.kind === 'problem' && notice !== noticed)) return;
    this.store.dispatch({ type: 'notice', notice: { kind: 'info', text: notes.join(' '), beside: runs, passing: notes.length === 1 && why !== '' } });
  }

  /** What the user does next with so many images. */
  private nextStep(count: number): string {
    if (purposeOf(this.store.state) === 'images') return say('press-place');
    const frames = framesStep(this.store.state);
    if (frames !== '') return frames;
    return count >= 2 ? say('press-run') : NEEDS_MORE;
  }

  private tell(kind: 'info' | 'busy' | 'problem', text: string): void {
    this.store.dispatch({ type: 'notice', notice: { kind, text } });
  }

  /** Says what was taken: of a block that was made without it beside what is to be done then. */
  private tellTaken(text: string): void {
    this.store.dispatch({ type: 'notice', notice: { kind: 'info', text, beside: isOutdated(this.store.state) } });
  }

  /** Says that nothing that was given is read; while something runs, beside that. */
  private tellUnread(text: string): void {
    this.store.dispatch({ type: 'notice', notice: { kind: 'problem', text, beside: this.runsNow() } });
  }

  private runsNow(): boolean {
    const { running, placing } = this.store.state;
    return running.kind === 'yes' || placing.running !== null;
  }

  private failed(what: string, error: unknown, here: Here): void {
    here();
    if (error instanceof Cancelled) this.tell('info', say('cancelled-nothing-was-changed'));
    else this.tell('problem', say('the-block-is-unchanged', { what, error: messageOf(error) }));
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
