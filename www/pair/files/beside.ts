/** Takes what is given beside the images of a pair: masks, the camera, fiducial marks. Each gives what is said of it. */
import { Cancelled } from '../../shared/engine/client';
import { fieldsOf, OWN_SETTINGS } from '../../shared/files/json';
import type { Here } from '../../shared/files/leaving';
import { sentence } from '../../shared/text/format';
import { say } from '../../shared/text/words';
import type { Engine } from '../engine/engine';
import type { Side } from '../state/state';
import type { Store } from '../state/store';
import { freshId } from './ids';
import { isOfBlock } from './of-block';
import { info, problem } from './told';
import type { Telling, Told } from './told';
import { textIn } from '../../shared/files/text';

/** Longest side of the copy of a mask that is shown, px. */
export const MASK_SIDE = 1024;

/** Masks named "right", or the second of two, belong right. */
export function sideOfMask(mask: File, index: number): Side {
  // As masks are named that were painted here, whatever their images are called.
  const [, painted] = /-mask-(left|right)\./u.exec(mask.name) ?? [];
  if (painted !== undefined) return painted as Side;
  if (/right/iu.test(mask.name)) return 'right';
  return /left/iu.test(mask.name) || index === 0 ? 'left' : 'right';
}

/** Whether a text is meant as a table: its first line has columns. What is wrong with the columns of another text helps nobody. */
function looksLikeTable(text: string): boolean {
  return /[,;\t]/u.test(text.trimStart().split('\n', 1)[0] ?? '');
}

export class BesideFiles {
  constructor(
    private readonly store: Store,
    private readonly engine: Engine,
    private readonly telling: Telling,
  ) {}

  /** An image whose zeros say where no points are wanted; it has to be as large as the image that is open. */
  async mask(file: File, side: Side, here: Here): Promise<Told> {
    const opened = this.store.state.images[side];
    if (opened === null) return problem(say('is-a-mask-of-the', { name: file.name, side }));
    try {
      const { info: photo } = await this.engine.open(side, opened);
      const mask = await this.engine.client('pair').call('mask', { file, overlaySide: MASK_SIDE });
      here();
      if (mask.width !== photo.width || mask.height !== photo.height) {
        return problem(
          say('has-px-the-image-px', { name: file.name, width: mask.width, height: mask.height, side, width_2: photo.width, height_2: photo.height }),
        );
      }
      this.store.dispatch({ type: 'mask', side, mask: { ...mask, id: freshId(), name: file.name, source: { kind: 'file', file } } });
      return info(say('masks-of-the-image', { name: file.name, left_out: 100 * mask.leftOut, side }));
    } catch (error) {
      return this.telling.failed(say('cannot-be-used-as-a', { name: file.name }), error, here);
    }
  }

  /** Fiducials named "right", or the second of two tables, belong right. */
  sideOfTable(table: File, index: number): Side {
    if (/right/iu.test(table.name)) return 'right';
    if (/left/iu.test(table.name)) return 'left';
    return index > 0 || this.store.state.photos.left.fiducials.length > 0 ? 'right' : 'left';
  }

  async fiducials(file: File, side: Side, here: Here): Promise<Told> {
    let text = '';
    try {
      text = await textIn(file);
    } catch (error) {
      return this.telling.failed(say('cannot-be-opened', { name: file.name }), error, here);
    }
    try {
      const fiducials = await this.engine.client('pair').call('parseFiducials', { text });
      here();
      const { fiducials: out } = this.store.state.photos[side];
      this.store.dispatch({ type: 'marked', step: { side, deed: 'given', at: 0, out, put: fiducials } });
      return info(say('fiducial-of-the-image-from', { fiducials: fiducials.length, side, name: file.name }));
    } catch (error) {
      here();
      if (isOfBlock(text)) return problem(say('is-a-table-of-a-block', { name: file.name }));
      const what = say('is-no-photograph-and-no-table', { name: file.name });
      if (!looksLikeTable(text) && !(error instanceof Cancelled)) return problem(sentence(what));
      return this.telling.failed(what, error, here);
    }
  }

  async camera(file: File, here: Here): Promise<Told> {
    try {
      const text = await textIn(file);
      here();
      const { [OWN_SETTINGS]: subject } = fieldsOf(text);
      if (subject === 'pair') return info(say('holds-settings', { name: file.name }));
      if (subject !== undefined) return problem(`${file.name}: ${sentence(say('the-file-holds-settings-of', { subject: String(subject), of: 'pair' }))}`);
      const camera = await this.engine.client('pair').call('parseCamera', { text });
      here();
      this.store.dispatch({ type: 'camera', camera });
      return info(say('camera-data-from', { name: file.name }));
    } catch (error) {
      return this.telling.failed(say('holds-no-camera-data', { name: file.name }), error, here);
    }
  }
}
