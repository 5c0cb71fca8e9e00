/** Places images on an orthophoto: one worker shows it, others place images, one image each at a time. */
import { breakdownOf, Cancelled, WorkerClient } from '../../shared/engine/client';
import { givenLinks, LEAST_LINKS } from '../state/steps';
import type { LinkStep } from '../state/steps';
import type { LinkedImage, LinkedPlacement } from '../state/links';
import { placingKey, placingKeyOf, unplacedFiles } from '../state/placed';
import { filmOf } from '../state/film';
import { givenPositions } from '../state/given-positions';
import { NO_PLACING } from '../state/placing';
import { countedFrom } from '../state/result-system';
import type { GivenHeights, GivenOrthophoto, RasterFile } from '../state/placing';
import type { BlockFile } from '../state/state';
import type { BlockView } from '../state/view';
import type { AddedControl } from '../state/added';
import type { CameraRule, Remark } from '../../../pkg/wasm/tiepoint.js';
import type { BlockCalls } from './calls';
import type { BlockStore } from './engine';
import { makeFrames } from './frames';
import { RecordedPositions } from './recorded';
import type { MadeFrame, Scan, Tell } from './frames';
import type { Ground, LaidPicture, MadeMosaic, MosaicKind } from './orthophoto';
import { say } from '../../shared/text/words';
import { message, messageOf } from '../../shared/text/messages';
import { sentence } from '../../shared/text/format';

/** Each worker holds an orthophoto that is not read in parts: of one beyond so many px there is one worker beside the one that shows it. */
const MOST_SHARED = 40e6;

export class PlacingEngine {
  private readonly shower = new WorkerClient<BlockCalls>('orthophoto');
  private readonly placers = [1, 2].map((number) => new WorkerClient<BlockCalls>(`placing ${String(number)}`));
  private readonly maker = new WorkerClient<BlockCalls>('mosaic');
  private readonly recorded = new RecordedPositions(new WorkerClient<BlockCalls>('positions'));
  /** Ends what the user cancelled, also between two images. */
  private stopped = false;
  private waits = 0;

  constructor(private readonly store: BlockStore) {}

  /** Opens an orthophoto; the former one stays where it is refused. */
  async open(raster: RasterFile, ofBlock: string | null = null): Promise<GivenOrthophoto> {
    const info = await this.asked(groundOf(raster, NO_PLACING.heights));
    return { raster, info, ofBlock };
  }

  /** Takes the heights of its ground; the former ones stay where these are refused. */
  async setHeights(heights: GivenHeights): Promise<void> {
    const { orthophoto } = this.store.state.placing;
    if (orthophoto === null) return;
    const info = await this.asked(groundOf(orthophoto.raster, heights));
    this.store.dispatch({ type: 'heights', heights, info });
  }

  private asked(ground: Ground): Promise<GivenOrthophoto['info']> {
    return this.waited(() => this.shower.call('orthoInfo', ground));
  }

  /** What the user waits for, of the worker that shows the orthophoto: Cancel ends it. */
  private async waited<T>(ask: () => Promise<T>): Promise<T> {
    this.waits += 1;
    try {
      return await ask();
    } catch (error) {
      throw named(error);
    } finally {
      this.waits -= 1;
    }
  }

  /** A tile of the picture, halved so many times. */
  tile(level: number, column: number, row: number): Promise<ImageBitmap> {
    const { ground } = this;
    if (ground === null) return Promise.reject(new Error('no orthophoto is given'));
    return this.shower.call('orthoTile', { ground, level, column, row });
  }

  /** Looks whether images record positions elsewhere than the orthophoto, before anything is matched. */
  async lookElsewhere(): Promise<void> {
    const { files, placing } = this.store.state;
    const { orthophoto, options } = placing;
    const { ground } = this;
    const given = givenPositions(this.store.state);
    let doubt: Remark | null = null;
    // One that was made of a block lies where that does, and of one in no known system nothing can be said.
    if (orthophoto?.ofBlock === null && orthophoto.info.on_earth && ground !== null && options !== null) {
      // What is given meanwhile is looked at by itself.
      const areWanted = () => {
        const now = this.store.state;
        return now.files === files && now.placing.orthophoto?.raster === orthophoto.raster && now.placing.options === options && givenPositions(now) === given;
      };
      const recorded = await this.recorded.of(
        files.filter(({ name }) => !given.has(name)),
        areWanted,
      );
      if (recorded === null) return;
      const positions = [...[...given.values()].map(({ position }) => position), ...recorded];
      if (positions.length > 0) doubt = await this.shower.call('orthoElsewhere', { ground, options, positions }).catch(() => null);
      if (!areWanted()) return;
    }
    this.store.dispatch({ type: 'elsewhere', text: doubt === null ? '' : sentence(message('remark', doubt)) });
  }

  /** Places images: those that are not placed yet, where none are named. Gives how many were tried; null where it was cancelled or refused as a whole. */
  async place(files: readonly BlockFile[] = unplacedFiles(this.store.state)): Promise<number | null> {
    const { state } = this.store;
    const { placing, options } = state;
    const { ground } = this;
    if (ground === null || placing.options === null || placing.orthophoto === null || placing.running !== null || files.length === 0) return 0;
    const { width, height, in_parts: isInParts } = placing.orthophoto.info;
    const isLight = isInParts || width * height <= MOST_SHARED;
    const key = placingKey(state);
    const workers = this.placers.slice(0, isLight && (navigator.hardwareConcurrency || 1) > 2 ? 2 : 1);
    const waiting = [...files];
    const { options: given, film } = placing;
    const cameras = options.cameras?.text ?? null;
    const positions = givenPositions(state);
    let done = 0;
    this.stopped = false;
    const tell = (text: string) => this.store.dispatch({ type: 'placing', running: { done, total: files.length, text } });
    tell(say('looking-for-points-of-the'));
    const work = async (worker: WorkerClient<BlockCalls>) => {
      // What is wrong with options and heights ends it all.
      await worker.call('orthoSearch', { ground, options: given });
      for (let file = waiting.shift(); file !== undefined; file = waiting.shift()) {
        tell(say('placing', { name: file.name }));
        const { id, name } = file;
        const [found, problem] = await this.tried(worker, {
          ground,
          options: given,
          name,
          file: file.file,
          cameras,
          film: filmOf(film, name),
          position: positions.get(name) ?? null,
        });
        done += 1;
        // Links that were measured by hand are of the image, whatever is found.
        const former = this.store.state.placing.placed.get(id);
        const steps = (former?.steps.slice(0, former.done) ?? []).filter(({ kind }) => kind === 'add');
        const result = steps.length === 0 ? found : await this.adjust(file, found, steps).catch(() => found);
        this.store.dispatch({
          type: 'placed',
          image: file,
          placed: { key: placingKeyOf(key, { film, positions }, name), result, problem, found, steps, done: steps.length },
        });
        tell(waiting[0] === undefined ? say('placing-2') : say('placing', { name: waiting[0].name }));
      }
    };
    try {
      await Promise.all(workers.slice(0, files.length).map(work));
      return done;
    } catch (error) {
      this.release();
      if (this.stopped || error instanceof Cancelled) return null;
      throw named(error);
    } finally {
      // The memory of a large orthophoto is given back.
      if (!isLight) this.release();
      this.store.dispatch({ type: 'placing', running: null });
    }
  }

  /** What came of an image, or why it cannot be read. */
  private async tried(worker: WorkerClient<BlockCalls>, input: BlockCalls['orthoPlace']['input']): Promise<[LinkedImage | null, string]> {
    try {
      return [await worker.call('orthoPlace', input), ''];
    } catch (error) {
      if (error instanceof Cancelled) throw error;
      return [null, breakdownOf(error) ?? messageOf(error)];
    }
  }

  /** Ends placing, the making of a mosaic, and what else the user waits for. What was placed stays. */
  cancel(): void {
    this.stopped = true;
    for (const worker of [...this.placers, this.maker]) worker.cancel();
    // It opens the orthophoto again when it is asked for a tile.
    if (this.waits > 0) this.shower.cancel();
  }

  /** An image by the links that were found, with these steps by hand. */
  async adjust(file: BlockFile, found: LinkedImage | null, steps: readonly LinkStep[]): Promise<LinkedImage | null> {
    const { placing, options } = this.store.state;
    const { ground } = this;
    const { options: settings } = placing;
    if (found === null || ground === null || settings === null || steps.length === 0) return found;
    const links = givenLinks(found, steps);
    // As long as they are too few, an image that was not placed has none.
    if (found.placement === null && links.filter(({ use }) => use === 'used').length < LEAST_LINKS) return found;
    const start = found.placement === null ? null : { ...found.placement, links: [] };
    const { name, file: bytes } = file;
    this.store.dispatch({ type: 'adjustsLinks', image: file.id });
    try {
      const cameras = options.cameras?.text ?? null;
      return await this.waited(() =>
        this.shower.call('orthoAdjust', {
          ground,
          options: settings,
          name,
          file: bytes,
          cameras,
          film: filmOf(placing.film, name),
          position: givenPositions(this.store.state).get(name) ?? null,
          links,
          start,
          size: found.size,
        }),
      );
    } finally {
      this.store.dispatch({ type: 'adjustsLinks', image: null });
    }
  }

  /** Where one end of a link of a placed image has the other one; null where it has none. */
  async predict(placement: LinkedPlacement, given: { at: [number, number] | null; place: [number, number] | null }): Promise<[number, number] | null> {
    const { ground } = this;
    return ground === null ? null : this.shower.call('orthoPredict', { ground, placement: { ...placement, links: [] }, ...given });
  }

  /** The edit that adds a place X, Y of the orthophoto to a block. `crs`: the coordinate reference system of that; null: that of the orthophoto. */
  controlByHand(place: readonly [number, number], number: number, view: Pick<BlockView, 'crs' | 'geoidM' | 'geoid'>): Promise<AddedControl> {
    const { ground } = this;
    const { options } = this.store.state.placing;
    if (ground === null || options === null) return Promise.reject(new Error('no orthophoto is given'));
    return this.waited(() => this.shower.call('orthoControl', { ground, options, place, number, crs: view.crs, heights: countedFrom(view) }));
  }

  /** A placed image resampled to the ground, as GeoTIFF. */
  async rectified(file: BlockFile): Promise<Uint8Array<ArrayBuffer>> {
    const { ground } = this;
    const placement = this.store.state.placing.placed.get(file.id)?.result?.placement ?? null;
    if (ground === null || placement === null) throw new Error(say('is-not-placed', { name: file.name }));
    return (await this.waited(() =>
      this.shower.call('orthoRectified', { ground, file: file.file, placement: { ...placement, links: [] } }),
    )) as Uint8Array<ArrayBuffer>;
  }

  /** A placed image on the ground, as a picture whose sides are no longer than so many px. */
  laid(file: BlockFile, placement: LinkedPlacement, side: number): Promise<LaidPicture> {
    const { ground } = this;
    if (ground === null) return Promise.reject(new Error('no orthophoto is given'));
    return this.shower.call('orthoLaid', { ground, file: file.file, placement: { ...placement, links: [] }, side });
  }

  /**
   * The orthomosaic of the block of a project file on the heights of its tie points; null where it was cancelled. In the coordinate reference system
   * of the block where it has one, or, `inAdjustment`, in the system of its adjustment.
   */
  mosaic(project: Blob, files: readonly BlockFile[], how: MosaicKind): Promise<MadeMosaic | null> {
    return this.made(async (tell) => {
      tell(0, files.length, say('laying-out-the-orthomosaic'));
      const byName = new Map(files.map(({ name, file }) => [name, file]));
      const { order, remark } = await this.maker.call('mosaicOpen', { project, heights: null, ...how, names: [...byName.keys()] });
      for (const [done, { name, index }] of order.entries()) {
        const file = byName.get(name);
        if (file === undefined) continue;
        tell(done, order.length, say('orthomosaic', { name }));
        await this.maker.call('mosaicAdd', { index, file });
      }
      tell(order.length, order.length, say('writing-the-orthomosaic'));
      return { picture: await this.maker.call('mosaicFinish', null), remark };
    });
  }

  /** The frames of scans of film; null where it was cancelled. `given`: the cameras of frames that were made before. */
  frames(scans: readonly Scan[], given: readonly CameraRule[]): Promise<MadeFrame[] | null> {
    return this.made((tell) => makeFrames(this.maker, scans, given, tell));
  }

  /** What is made of images one after the other; null where it was cancelled. */
  private async made<T>(make: (tell: Tell) => Promise<T>): Promise<T | null> {
    this.stopped = false;
    try {
      return await make((done, total, text) => this.store.dispatch({ type: 'placing', running: { done, total, text } }));
    } catch (error) {
      if (this.stopped || error instanceof Cancelled) return null;
      throw named(error);
    } finally {
      this.maker.cancel();
      this.store.dispatch({ type: 'placing', running: null });
    }
  }

  /** The orthophoto of a simulated flight with the heights of its ground, with pixels of so many m. */
  async scene(flight: BlockCalls['sceneOrthophoto']['input']['flight'], gsd: number): Promise<{ picture: Blob; heights: Blob }> {
    const { picture, heights } = await this.maker.call('sceneOrthophoto', { flight, gsd });
    this.maker.cancel();
    const type = 'image/tiff';
    return { picture: new Blob([picture], { type }), heights: new Blob([heights], { type }) };
  }

  /** Gives back what workers hold that place images; each opens the orthophoto again when it is asked. */
  release(): void {
    for (const worker of this.placers) worker.cancel();
  }

  /** The orthophoto with its heights; null where none is given. */
  get ground(): Ground | null {
    const { orthophoto, heights } = this.store.state.placing;
    return orthophoto === null ? null : groundOf(orthophoto.raster, heights);
  }
}

function groundOf(raster: RasterFile, heights: GivenHeights): Ground {
  const own = heights.kind === 'level' ? heights.height : sourceOf(heights.model);
  const name = heights.kind === 'level' ? `level ${String(heights.height)}` : `file ${String(heights.model.id)}`;
  return { picture: sourceOf(raster), heights: own, keys: { picture: String(raster.id), heights: name } };
}

function sourceOf({ file, world, projection, degrees = null }: RasterFile): Ground['picture'] {
  if (degrees !== null) return { file, sidecars: { world_file: degrees.world, projection: degrees.shownIn } };
  return { file, sidecars: { world_file: world?.text ?? null, projection: projection?.text ?? null } };
}

/** An error that says what broke off, where a worker did. */
export function named(error: unknown): Error {
  if (error instanceof Cancelled) return error;
  return new Error(breakdownOf(error) ?? messageOf(error));
}
