/** Takes orthophotos, heights and world files in, and says what they are. */
import type { Here } from '../../shared/files/leaving';
import { Cancelled } from '../../shared/engine/client';
import { fixed, sentence } from '../../shared/text/format';
import type { BlockStore } from '../engine/engine';
import type { PlacingEngine } from '../engine/placing';
import { stemOf } from '../state/film';
import { NEAR_PX } from '../state/cells';
import { levelByBlock } from '../state/level';
import { projectedOf } from './degrees';
import { isLookedAtAlone } from '../state/placing';
import type { GivenHeights, GivenOrthophoto, RasterFile } from '../state/placing';
import { unitOfOrthophoto } from '../state/orthophoto-unit';
import type { LengthUnit } from '../state/orthophoto-unit';
import { newId } from './ids';
import type { FoundRaster, Sorted } from './rasters';
import { say } from '../../shared/text/words';
import { messageOf } from '../../shared/text/messages';
import { unitText, withUnit } from '../../shared/text/units';

export class GroundFiles {
  constructor(
    private readonly store: BlockStore,
    private readonly engine: PlacingEngine,
  ) {}

  /** Gives what is said of them, nothing where nothing was given; null where one of them was refused, which is said. */
  async take({ orthophotos, heights, worlds, projections }: Omit<Sorted, 'others' | 'degrees'>, here: Here): Promise<string | null> {
    const said: string[] = [];
    const [orthophoto, ...more] = orthophotos;
    if (orthophoto !== undefined) {
      const taken = await this.takeOrthophoto(orthophoto, here);
      if (taken === null) return null;
      said.push(taken);
    }
    if (more.length > 0) said.push(say('skipped-a-project-has-one', { more: named(more) }));
    const [model, ...others] = heights;
    if (model !== undefined) {
      const taken = await this.takeHeights(model, here);
      if (taken === null) return null;
      said.push(taken);
    } else if (orthophoto !== undefined) {
      const taken = await this.takeLevelOfBlock(here);
      if (taken === null) return null;
      said.push(taken);
    }
    if (others.length > 0) said.push(say('skipped-an-orthophoto-has-one', { others: named(others) }));
    for (const world of worlds) {
      const taken = await this.takeWorld(world, projections.find(({ name }) => stemOf(name) === stemOf(world.name)) ?? null, here);
      if (taken === null) return null;
      said.push(taken);
    }
    return said.filter((text) => text !== '').join(' ');
  }

  /** Takes a picture of the ground in place of the one that is there. */
  private async takeOrthophoto(found: FoundRaster, here: Here): Promise<string | null> {
    const { file } = found;
    this.tell('busy', say('reading-the-orthophoto', { name: file.name }));
    try {
      const orthophoto = await this.opened(await rasterOf(found));
      here();
      this.store.dispatch({ type: 'orthophoto', orthophoto });
      this.store.dispatch({ type: 'stage', view: 'orthophoto' });
      this.quiet();
      return orthophotoText(orthophoto);
    } catch (error) {
      here();
      this.refused(say('cannot-be-used-as-an', { name: file.name }), error);
      return null;
    }
  }

  /** One in degrees can be looked at. */
  private async opened(raster: RasterFile): Promise<GivenOrthophoto> {
    try {
      return await this.engine.open(raster);
    } catch (error) {
      const projected = error instanceof Cancelled ? null : await projectedOf(raster);
      if (projected === null) throw error;
      return await this.engine.open(projected).catch((other: unknown) => {
        // What was wrong first is said.
        throw other instanceof Cancelled ? other : error;
      });
    }
  }

  /** Takes a height model in place of the heights that are there. */
  private takeHeights(found: FoundRaster, here: Here): Promise<string | null> {
    return this.setHeights(here, found.file.name, async () => ({ kind: 'model', model: await rasterOf(found) }));
  }

  /** Takes one height for all of the ground. */
  takeLevel(height: number, here: Here): Promise<string | null> {
    return this.setHeights(here, withUnit(fixed(height, 2), unitOfOrthophoto(this.store.state.placing.orthophoto)), () =>
      Promise.resolve({ kind: 'level', height, by: 'hand' }),
    );
  }

  /** The ground lies as high as the tie points of the block that is shown, where that lies on the earth and nothing else was given. Says nothing where it says no height. */
  async takeLevelOfBlock(here: Here): Promise<string | null> {
    const heights = this.otherLevel();
    if (heights === null) return '';
    const name = withUnit(fixed(heights.height, 1), unitOfOrthophoto(this.store.state.placing.orthophoto));
    const said = await this.setHeights(here, name, () => Promise.resolve(heights));
    return said === null ? null : say('level-of-block', { height: name });
  }

  /** Whether the block that is shown says another height of level ground than the one that is set. */
  hasOtherLevel(): boolean {
    return this.otherLevel() !== null;
  }

  private otherLevel(): Extract<GivenHeights, { kind: 'level' }> | null {
    const { placing, shown } = this.store.state;
    const heights = levelByBlock(placing, shown);
    if (heights?.kind !== 'level') return null;
    const { heights: set } = placing;
    return set.kind === 'level' && set.height === heights.height && set.by === 'block' ? null : heights;
  }

  private async setHeights(here: Here, name: string, made: () => Promise<GivenHeights>): Promise<string | null> {
    if (this.store.state.placing.orthophoto === null) {
      this.tell('problem', say('holds-heights-give-their-orthophoto', { name }));
      return null;
    }
    this.tell('busy', say('reading-the-heights', { name }));
    try {
      const heights = await made();
      here();
      await this.engine.setHeights(heights);
      here();
      this.quiet();
      const { orthophoto } = this.store.state.placing;
      const [from, to] = orthophoto?.info.heights ?? [];
      if (heights.kind === 'level') return say('the-ground-is-level-at', { name });
      return say('heights-from-to', { name, from, to, unit: unitText(unitOfOrthophoto(orthophoto)) });
    } catch (error) {
      here();
      this.refused(say('cannot-be-used-as-heights', { name }), error);
      return null;
    }
  }

  /** A world file by itself places the image of its name, which then is no photograph. */
  private async takeWorld(world: File, projection: File | null, here: Here): Promise<string | null> {
    const stem = stemOf(world.name);
    const { files, truth } = this.store.state;
    const image = files.find(({ name }) => stemOf(name) === stem);
    if (image === undefined) {
      this.tell('problem', say('says-where-a-picture-of', { name: world.name }));
      return null;
    }
    const taken = await this.takeOrthophoto({ file: new File([image.file], image.name, { type: image.file.type }), world, projection }, here);
    if (taken !== null) this.store.dispatch({ type: 'files', files: files.filter((file) => file !== image), truth });
    return taken;
  }

  private tell(kind: 'info' | 'busy' | 'problem', text: string): void {
    this.store.dispatch({ type: 'notice', notice: { kind, text } });
  }

  private refused(what: string, error: unknown): void {
    if (error instanceof Cancelled) this.tell('info', say('cancelled-nothing-was-changed'));
    else this.tell('problem', `${what}: ${sentence(messageOf(error))}`);
  }

  private quiet(): void {
    this.store.dispatch({ type: 'notice', notice: null });
  }
}

export async function rasterOf({ file, world, projection }: FoundRaster): Promise<RasterFile> {
  const textOf = async (beside: File | null) => (beside === null ? null : { name: beside.name, text: await beside.text() });
  return { id: newId(), name: file.name, file, world: await textOf(world), projection: await textOf(projection) };
}

/** What was recognised. */
export function orthophotoText(orthophoto: GivenOrthophoto): string {
  const { raster, info } = orthophoto;
  const { width, height, gsd, epsg } = info;
  const by = raster.world === null ? '' : say('placed-by', { name: raster.world.name });
  const system = raster.projection === null ? '' : say('in-the-system-of', { name: raster.projection.name });
  return say('orthophoto-px-of', {
    name: raster.name,
    width,
    height,
    gsd: gsdText(gsd, unitOfOrthophoto(orthophoto)),
    what: epsg === null || isLookedAtAlone(orthophoto) ? '' : say('epsg', { epsg }),
    by: by + system,
    degrees: degreesText(raster),
  });
}

function degreesText({ degrees = null }: RasterFile): string {
  if (degrees === null) return '';
  const { crs, shownIn, departs } = degrees;
  return say('an-orthophoto-in-degrees', { crs, shown: shownIn, departs: departs > NEAR_PX ? departs : null });
}

/** The side of a pixel with the digits that say something. */
export function gsdText(gsd: number, unit: LengthUnit): string {
  return say(unit === 'm' ? 'metres' : 'feet', { value: Number(gsd.toPrecision(3)) });
}

function named(rasters: readonly FoundRaster[]): string {
  return rasters.map(({ file }) => file.name).join(', ');
}
