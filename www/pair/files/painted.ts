/** Masks that are painted on the page: files, as those that are given. */
import type { Engine } from '../engine/engine';
import type { GivenMask, Outline, Side, State } from '../state/state';
import { freshId, MASK_SIDE } from './open';

/** The mask of a side with an area masked or no longer. */
export async function paintedMask(engine: Engine, { images, masks }: State, side: Side, corners: Outline['corners'], masked: boolean): Promise<GivenMask> {
  const image = images[side];
  if (image === null) throw new Error(`there is no ${side} image`);
  const { info } = await engine.open(side, image);
  const { width, height } = info;
  const outline = Float64Array.from(corners.flat());
  const { png, ...mask } = await engine
    .client('pair')
    .call('paintMask', { grey: masks[side]?.grey ?? null, width, height, outline, masked, overlaySide: MASK_SIDE });
  const name = `${image.name.replace(/\.[^.]+$/u, '')}-mask.png`;
  return { ...mask, id: freshId(), name, source: { kind: 'file', file: new File([png], name, { type: 'image/png' }) } };
}
