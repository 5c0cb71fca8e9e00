/** An image in its colours, as the browser decodes it. They are only looked at: nothing is computed from them. */

/** Larger files are shown in grey: their colours would take more memory than a tab has to spare. */
const MOST_BYTES = 2 ** 25;

/** The image as it is stored: the crate too leaves its EXIF orientation aside. Null where the browser cannot decode it. */
export async function decodeColour(bytes: Uint8Array<ArrayBuffer>): Promise<ImageBitmap | null> {
  if (bytes.length > MOST_BYTES) return null;
  try {
    return await createImageBitmap(new Blob([withoutExif(bytes)]));
  } catch {
    return null;
  }
}

/**
 * A JPEG file without its EXIF segments: browsers turn images by the orientation that stands there, whatever they are asked. Of others all stays.
 * In one piece: Firefox knows a format by the first piece of a blob, and before the EXIF segment of a photograph stand two bytes.
 */
function withoutExif(bytes: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> {
  const kept: Uint8Array<ArrayBuffer>[] = [];
  let [from, at] = [0, 2];
  const isJpeg = bytes[0] === 0xff && bytes[1] === 0xd8;
  // Up to the first scan.
  while (isJpeg && bytes[at] === 0xff && bytes[at + 1] !== 0xda && at + 4 < bytes.length) {
    const next = at + 2 + 256 * (bytes[at + 2] ?? 0) + (bytes[at + 3] ?? 0);
    if (bytes[at + 1] === 0xe1 && String.fromCharCode(...bytes.subarray(at + 4, at + 8)) === 'Exif') {
      kept.push(bytes.subarray(from, at));
      from = next;
    }
    at = next;
  }
  kept.push(bytes.subarray(from));
  const whole = new Uint8Array(kept.reduce((sum, { length }) => sum + length, 0));
  let end = 0;
  for (const piece of kept) {
    whole.set(piece, end);
    end += piece.length;
  }
  return whole;
}
