/** Images that the browser cannot decode, as the crate decodes them. */
import { Photo } from '../../../pkg/wasm/tiepoint.js';
import { bitmapOf } from '../../shared/engine/tiles';

export async function blockGrey({ file }: { file: Blob }): Promise<ImageBitmap> {
  const photo = Photo.decode(new Uint8Array(await file.arrayBuffer()));
  try {
    return await bitmapOf(photo.grey(), photo.width, photo.height);
  } finally {
    photo.free();
  }
}
