/** Takes files in: dropped, pasted, opened. A file that cannot be used changes nothing. */
import type { Flight } from '../../shared/crate';
import type { FoundFile } from '../../shared/files/drop';
import { takeHere } from '../../shared/files/leaving';
import type { Here } from '../../shared/files/leaving';
import { kindsText, namesText, refusedKinds } from '../../shared/files/refused';
import { say } from '../../shared/text/words';
import type { Engine } from '../engine/engine';
import { bothSides, hasMarks } from '../state/kept';
import { editsOfFile } from '../state/project';
import type { OpenedProject } from '../state/project';
import type { GivenImage, Side } from '../state/state';
import type { Store } from '../state/store';
import { PairAside } from './aside';
import { BesideFiles, sideOfMask } from './beside';
import { freshId } from './ids';
import { ImageFiles } from './images';
import { readProject } from './project';
import { sortFiles } from './sort';
import { info, problem, Telling, unchanged } from './told';
import type { Told } from './told';

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

  private readonly telling: Telling;
  private readonly aside: PairAside;
  private readonly beside: BesideFiles;
  private readonly images: ImageFiles;

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
    putAside: () => Promise<boolean>,
  ) {
    this.telling = new Telling(store);
    this.aside = new PairAside(store, putAside);
    this.beside = new BesideFiles(store, engine, this.telling);
    this.images = new ImageFiles(store, engine, this.telling, this.aside, elsewhere.toBlock, (names, take) => this.takeHere(names, take));
  }

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
    const tell = () => this.telling.tell([info(say('were-not-taken-the-project', { files: names.length, names: namesText(names) }))]);
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
    if (camera !== undefined) told.push(await this.beside.camera(camera, here));
    // Marks of the image before it go with that.
    const { told: ofImages, isCancelled } = images.length > 0 ? await this.images.take(images, side, asks, here) : { told: [], isCancelled: false };
    // What belongs to images whose reading was cancelled would start the run that they wait for.
    if (isCancelled) {
      const names = [...tables, ...masks].map(({ name }) => name);
      this.telling.tell(
        [...told, ...ofImages, names.length === 0 ? null : info(say('cancelled-before-they-were-read', { files: names.length, names: namesText(names) }))],
        before,
      );
      return;
    }
    for (const [i, table] of tables.entries()) told.push(await this.beside.fiducials(table, side ?? this.beside.sideOfTable(table, i), here));
    told.push(...ofImages);
    if (camera === undefined) told.push(this.images.cameraStays(before));
    for (const [i, mask] of masks.entries()) told.push(await this.beside.mask(mask, masks.length === 1 && side !== null ? side : sideOfMask(mask, i), here));
    this.telling.tell(told, before);
  }

  /** Opens a pair that was saved. */
  takeProject(file: File): Promise<void> {
    return this.takeHere([file.name], async (here) => {
      this.store.dispatch({ type: 'notice', notice: { kind: 'busy', text: say('reading', { name: file.name }) } });
      try {
        const opened = await readProject(this.engine, file, freshId);
        const aside = await this.aside.leave(hasMarks(this.store.state), here);
        if (aside === null) return this.telling.tell([unchanged()]);
        this.store.dispatch({ type: 'opened', opened });
        this.telling.tell([info(say('was-opened-the-file-does-not', { name: file.name })), editsToldOf(opened), ...aside]);
      } catch (error) {
        this.telling.tell([this.telling.failed(say('cannot-be-opened', { name: file.name }), error, here)]);
      }
    });
  }

  /** Takes an image whose zeros say where no points are wanted; it has to be as large as the image that is open. */
  takeMask(file: File, side: Side): Promise<void> {
    return this.takeHere([file.name], async (here) => {
      this.store.dispatch({ type: 'notice', notice: null });
      this.telling.tell([await this.beside.mask(file, side, here)]);
    });
  }

  /** Renders the pair of a flight in a worker and opens it. */
  takeFlight(name: string, flight: Flight): Promise<void> {
    const names = bothSides((side) => `${name} ${side}`);
    return this.takeHere(Object.values(names), async (here) => {
      this.store.dispatch({ type: 'notice', notice: { kind: 'busy', text: say('rendering-the-pair-a-simulated') } });
      try {
        const pair = await this.engine.client('pair').call('simulate', flight);
        const given = (side: Side): GivenImage => ({ id: freshId(), name: names[side], source: { kind: 'grey', ...pair[side] } });
        const aside = await this.aside.leave(hasMarks(this.store.state), here);
        if (aside === null) return this.telling.tell([unchanged()]);
        this.store.dispatch({ type: 'simulated', left: given('left'), right: given('right'), pair });
        this.telling.tell(aside);
      } catch (error) {
        this.telling.tell([this.telling.failed(say('the-pair-could-not-be'), error, here)]);
      }
    });
  }

  /** The built-in pair. */
  async takeSample(): Promise<void> {
    const sample = this.store.state.catalogue?.flights.find(({ name }) => name === 'sample');
    if (sample !== undefined) await this.takeFlight(sample.name, sample.flight);
  }
}
