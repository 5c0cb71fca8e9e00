/** Masks that are painted on the page: files, as those that are given. */
import { Cancelled } from '../../shared/engine/client';
import type { Engine } from '../engine/engine';
import type { GivenMask, Outline, Side, State } from '../state/state';
import { MASK_SIDE } from './beside';
import { freshId } from './ids';

/** The mask of a side with an area masked or no longer; null where it was cancelled. */
export async function paintedMask(engine: Engine, state: State, side: Side, corners: Outline['corners'], masked: boolean): Promise<GivenMask | null> {
  try {
    return await painted(engine, state, side, corners, masked);
  } catch (error) {
    if (error instanceof Cancelled) return null;
    throw error;
  }
}

async function painted(engine: Engine, { images, masks }: State, side: Side, corners: Outline['corners'], masked: boolean): Promise<GivenMask> {
  const image = images[side];
  if (image === null) throw new Error(`there is no ${side} image`);
  const { info } = await engine.open(side, image);
  const { width, height } = info;
  const outline = Float64Array.from(corners.flat());
  const { png, ...mask } = await engine
    // Of its own: the pair's is busy while the pair is matched.
    .client('preview')
    .call('paintMask', { grey: masks[side]?.grey ?? null, width, height, outline, masked, overlaySide: MASK_SIDE });
  const name = `${image.name.replace(/\.[^.]+$/u, '')}-mask-${side}.png`;
  return { ...mask, id: freshId(), name, source: { kind: 'file', file: new File([png], name, { type: 'image/png' }) } };
}
