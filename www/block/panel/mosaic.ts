/** The quick orthomosaic of a block: saved, or laid under its map. */
import { save } from '../../shared/files/save';
import type { Notice } from '../../shared/state/notice';
import { sentence } from '../../shared/text/format';
import type { BlockEngine, BlockStore } from '../engine/engine';
import type { MadeMosaic, MosaicKind } from '../engine/orthophoto';
import type { PlacingEngine } from '../engine/placing';
import { orthophotoText, rasterOf } from '../files/ground';
import { imagesOfBlock } from '../state/state';
import type { BlockFile } from '../state/state';
import { rectifiedName } from './placing-exports';
import { say } from '../../shared/text/words';
import { message, messageOf } from '../../shared/text/messages';

const NAME = 'orthomosaic.tif';

/**
 * `near`: the `data-testid` of the button that was pressed, beside which a refusal is said. `pixel`: the side of a pixel; undefined: that of the images; what is no
 * number is refused. `images`: the names of those that it is made of; null: all. One alone is that image on the ground.
 */
export async function saveMosaic(
  store: BlockStore,
  engine: BlockEngine,
  placing: PlacingEngine,
  near: string,
  pixel: number | undefined,
  images: readonly string[] | null,
): Promise<void> {
  const mosaic = await made(store, engine, placing, { inAdjustment: false, gsd: pixel ?? null, images }, near);
  if (mosaic === null) return;
  const [alone, ...others] = images ?? [];
  const name = alone === undefined || others.length > 0 ? NAME : rectifiedName(alone);
  save(mosaic.picture, name);
  const saved = say('was-saved-2', { name, store: missingText(store, images) });
  // What its file cannot say of where it lies.
  const noted = mosaic.remark === null ? [] : [say('noted', { remark: sentence(message('remark', mosaic.remark)) })];
  tell(store, 'info', [saved, ...noted].join(' '), { beside: true });
}

/** Takes it as the orthophoto of the project. */
export async function makeMosaic(store: BlockStore, engine: BlockEngine, placing: PlacingEngine, near: string): Promise<void> {
  const key = store.state.shown?.key ?? '';
  // The map is in the system of the adjustment.
  const mosaic = await made(store, engine, placing, { inAdjustment: true, gsd: null, images: null }, near);
  if (mosaic === null) return;
  tell(store, 'busy', say('laying-the-orthomosaic-under-the'));
  try {
    const file = new File([mosaic.picture], NAME, { type: mosaic.picture.type });
    const orthophoto = await placing.open(await rasterOf({ file, world: null, projection: null }), key);
    store.dispatch({ type: 'orthophoto', orthophoto });
    tell(store, 'info', say('the-orthomosaic-lies-under-the', { orthophoto: orthophotoText(orthophoto), store: missingText(store, null) }), { beside: true });
  } catch (error) {
    tell(store, 'problem', say('the-orthomosaic-cannot-be-shown', { sentence: sentence(messageOf(error)) }), { near });
  }
}

/** Null where it was cancelled or could not be made, which is said. */
async function made(store: BlockStore, engine: BlockEngine, placing: PlacingEngine, how: MosaicKind, near: string): Promise<MadeMosaic | null> {
  const files = there(store, how.images);
  if (files.length === 0) {
    tell(store, 'problem', say('an-orthomosaic-is-made-of'), { near });
    return null;
  }
  try {
    const mosaic = await placing.mosaic(await engine.project(), files, how);
    if (mosaic !== null) return mosaic;
    tell(store, 'info', say('cancelled-no-orthomosaic-was-made'), { beside: true });
  } catch (error) {
    tell(store, 'problem', say('no-orthomosaic-was-made', { sentence: sentence(messageOf(error)) }), { near });
  }
  return null;
}

/** The files of the images that it is made of, as far as they are there. */
function there({ state }: BlockStore, images: readonly string[] | null): readonly BlockFile[] {
  return imagesOfBlock(state).filter(({ name }) => images === null || images.includes(name));
}

/** What is not in it. */
function missingText(store: BlockStore, images: readonly string[] | null): string {
  const missing = (images ?? store.state.shown?.view.images ?? []).length - there(store, images).length;
  return missing > 0 ? say('missing-in-it-add-to', { missing }) : '';
}

function tell(store: BlockStore, kind: 'info' | 'busy' | 'problem', text: string, where: Pick<Notice, 'beside' | 'near'> = {}): void {
  store.dispatch({ type: 'notice', notice: { kind, text, ...where } });
}
