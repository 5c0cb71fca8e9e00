/** Photographs in colour, and whether the page draws them so. */

import { part, upload } from './page.js';

/** @typedef {import('playwright-core').Page} Page */

/**
 * Pictures in orange, as JPEG files that begin with an EXIF segment, which asks to turn them.
 * @param {Page} page whose browser writes them @param {{ name: string, buffer: Buffer }[]} pictures PNG files
 */
export async function coloured(page, pictures) {
  const files = [];
  for (const { name, buffer } of pictures) {
    const bytes = await page.evaluate(
      async (given) => {
        const bitmap = await createImageBitmap(new Blob([new Uint8Array(given)]));
        const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
        const context = canvas.getContext('2d');
        if (context === null) throw new Error('no canvas');
        context.drawImage(bitmap, 0, 0);
        context.globalCompositeOperation = 'multiply';
        context.fillStyle = '#ffb060';
        context.fillRect(0, 0, bitmap.width, bitmap.height);
        return [...new Uint8Array(await (await canvas.convertToBlob({ type: 'image/jpeg', quality: 0.95 })).arrayBuffer())];
      },
      [...buffer],
    );
    // Orientation 6: a quarter turn. The crate takes pixels as they are stored, and so must the colours be.
    const tiff = [0x4d, 0x4d, 0, 42, 0, 0, 0, 8, 0, 1, 0x01, 0x12, 0, 3, 0, 0, 0, 1, 0, 6, 0, 0, 0, 0, 0, 0];
    const exif = [0x45, 0x78, 0x69, 0x66, 0, 0, ...tiff];
    const jpeg = Buffer.from([...bytes.slice(0, 2), 0xff, 0xe1, 0, exif.length + 2, ...exif, ...bytes.slice(2)]);
    files.push(upload(name.replace('png', 'jpg'), jpeg, 'image/jpeg'));
  }
  return files;
}

/** The share of what is drawn of the pictures, but for the darkest, that is orange; 0 where next to nothing is drawn.  @param {Page} page */
export async function shareOfOrange(page) {
  const { drawn, orange } = await part(page, 'layer-pictures').evaluate((element) => {
    const canvas = /** @type {HTMLCanvasElement} */ (element);
    const { data } = canvas.getContext('2d')?.getImageData(0, 0, canvas.width, canvas.height) ?? { data: [] };
    let drawn = 0;
    let orange = 0;
    for (let i = 0; i < data.length; i += 4) {
      if ((data[i + 3] ?? 0) < 250 || (data[i] ?? 0) < 60) continue;
      drawn += 1;
      if ((data[i] ?? 0) > 1.3 * (data[i + 1] ?? 0) && (data[i + 1] ?? 0) > 1.3 * (data[i + 2] ?? 0)) orange += 1;
    }
    return { drawn, orange };
  });
  return drawn > 10_000 ? orange / drawn : 0;
}
