/** Photographs simulated blocks, and gives the photos as if they were files. */
import type { BlockFlight } from '../../../pkg/wasm/tiepoint.js';
import type { Here, TakeHere } from '../../shared/files/leaving';
import { say } from '../../shared/text/words';
import type { BlockEngine, BlockStore } from '../engine/engine';
import { areOfFile } from '../state/of-file';
import type { PlacingEngine } from '../engine/placing';
import type { BlockAside } from './aside';
import type { GroundFiles } from './ground';
import { newId } from './ids';
import type { BlockRuns } from './runs';
import type { Telling } from './told';

export class SimulatedFiles {
  constructor(
    private readonly store: BlockStore,
    private readonly engine: BlockEngine,
    private readonly placing: PlacingEngine,
    private readonly ground: GroundFiles,
    private readonly runs: BlockRuns,
    private readonly telling: Telling,
    private readonly aside: BlockAside,
    private readonly takeHere: TakeHere,
    /** Whether images that are given wait until Run is pressed. */
    private readonly waits: () => boolean,
  ) {}

  /** Photographs a block and runs it, whatever waits. */
  sample(flight: BlockFlight): Promise<void> {
    return this.takeHere([say('simulated-block')], async (here) => {
      if (await this.simulate(flight, here)) await this.runs.run(here);
    });
  }

  /** Photographs a block and the orthophoto of its scene, with pixels of so many m, and places the photos on it. */
  sampleOnOrthophoto(flight: BlockFlight, gsd: number): Promise<void> {
    return this.takeHere([say('simulated-block')], async (here) => {
      if (!(await this.simulate(flight, here))) return;
      this.telling.tell('busy', say('making-the-orthophoto-of-the'));
      try {
        const { picture, heights } = await this.placing.scene(flight, gsd);
        here();
        const rasters = {
          orthophotos: [{ file: new File([picture], 'orthophoto.tif'), world: null, projection: null }],
          heights: [{ file: new File([heights], 'heights.tif'), world: null, projection: null }],
          worlds: [],
          projections: [],
        };
        const taken = await this.ground.take(rasters, here);
        here();
        if (taken !== null) await this.runs.placeImages(here);
      } catch (error) {
        this.telling.failed(say('the-orthophoto-could-not-be'), error, here);
      }
    });
  }

  /** Photographs the simulated block that is set and runs it. */
  photograph(): Promise<void> {
    return this.takeHere([say('simulated-block')], async (here) => {
      const { flight } = this.store.state;
      if (flight === null || !(await this.simulate(flight, here))) return;
      if (this.waits()) this.telling.tell('info', say('photos-of-a-simulated-block', { files: this.store.state.files.length }));
      else await this.runs.run(here);
    });
  }

  /** Photographs a flight, in place of the images that are there; false where that failed. */
  private async simulate(flight: BlockFlight, here: Here): Promise<boolean> {
    this.telling.tell('busy', say('building-the-synthetic-scene'));
    try {
      const { files, truth } = await this.engine.photograph(flight, (count, of) => {
        here();
        this.telling.tell('busy', say('photographing-the-simulated-block-of', { count, of }));
      });
      here();
      const stays = await this.aside.leave(say('photograph-another-block'), here);
      if (stays === null) {
        this.store.dispatch({ type: 'notice', notice: null });
        return false;
      }
      // What stays in the list is not shown any more. A block with edits would lend them to the images of the next one, which have the same names; its
      // orthophoto shows other ground; a project file would lend its settings.
      const { state } = this.store;
      if (stays || state.history.edits.length + state.marks.edits.length > 0 || state.placing.orthophoto !== null || areOfFile(state))
        this.store.dispatch({ type: 'clear' });
      this.store.dispatch({ type: 'files', files: files.map((file) => ({ ...file, id: newId() })), truth });
      return true;
    } catch (error) {
      this.telling.failed(say('the-block-could-not-be'), error, here);
      return false;
    }
  }
}
