/** Masks that are painted on the page: files, as those that are given. */
import { Cancelled } from '../../shared/engine/client';
import { say } from '../../shared/text/words';
import type { Engine } from '../engine/engine';
import type { Area, GivenMask, MaskFile, Side, State } from '../state/state';
import { MASK_SIDE } from './beside';
import { freshId } from './ids';

/** The mask of a side: areas over the grey values of a mask, over a file, or over nothing; null where it was cancelled. */
export async function paintedMask(
  engine: Engine,
  state: State,
  side: Side,
  over: Uint8Array | MaskFile | null,
  areas: readonly Area[],
): Promise<GivenMask | null> {
  try {
    return over === null || over instanceof Uint8Array || areas.length > 0 ? await painted(engine, state, side, over, areas) : await read(engine, over);
  } catch (error) {
    if (error instanceof Cancelled) return null;
    throw error;
  }
}

/** Of its own: the pair's is busy while the pair is matched. */
const worker = (engine: Engine) => engine.client('preview');

async function painted(engine: Engine, { images }: State, side: Side, over: Uint8Array | MaskFile | null, areas: readonly Area[]): Promise<GivenMask> {
  const image = images[side];
  if (image === null) throw new Error(`there is no ${side} image`);
  const { info } = await engine.open(side, image);
  const { width, height } = info;
  const under = over === null || over instanceof Uint8Array ? over : fileOf(over);
  const { png, ...mask } = await worker(engine).call('paintMask', { over: under, width, height, areas, overlaySide: MASK_SIDE });
  const name = `${image.name.replace(/\.[^.]+$/u, '')}-mask-${side}.png`;
  return { ...mask, id: freshId(), name, source: { kind: 'file', file: new File([png], name, { type: 'image/png' }) } };
}

/** The mask of a file, as it was given. */
async function read(engine: Engine, file: MaskFile): Promise<GivenMask> {
  const { name, source } = file;
  const mask = await worker(engine).call('mask', { file: fileOf(file), overlaySide: MASK_SIDE });
  return { ...mask, id: freshId(), name, source };
}

function fileOf({ source }: MaskFile): Blob {
  if (source.kind !== 'file') throw new Error(say('an-image-is-damaged'));
  return source.file;
}
