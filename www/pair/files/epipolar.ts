/** Epipolar images of the pair on the screen: made in a worker of its own, and saved as one archive. */
import { Cancelled } from '../../shared/engine/client';
import { save } from '../../shared/files/save';
import { say } from '../../shared/text/words';
import type { Engine } from '../engine/engine';
import type { Store } from '../state/store';
import { baseName } from './export';
import { projectText } from './project';

/** Says itself what came of it, as how far the images fit. */
export async function exportEpipolar(store: Store, engine: Engine): Promise<null> {
  const { state } = store;
  const { left, right } = state.images;
  if (left === null || right === null) return null;
  const client = engine.client('report');
  const tell = (kind: 'busy' | 'info', text: string) => store.dispatch({ type: 'notice', notice: { kind, text } });
  try {
    tell('busy', say('epipolar-images-are-made'));
    const project = await projectText(state, engine);
    if (project === null) throw new Error(say('the-pair-is-not-matched'));
    const { archive, geometry } = await client.call('epipolar', { project, images: [left.source, right.source] });
    save(new Blob([archive], { type: 'application/zip' }), `${baseName(state)}-epipolar.zip`);
    const { points = 0, y_rms_px: left_over = 0 } = geometry.parallaxes ?? {};
    tell('info', say('epipolar-images-were-saved', { points, left_over }));
  } catch (error) {
    if (!(error instanceof Cancelled)) throw error;
    tell('info', say('cancelled-nothing-was-saved-the-epipolar'));
  } finally {
    // The images would stay in memory.
    client.cancel();
  }
  return null;
}
