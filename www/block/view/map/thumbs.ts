/** Small copies of the photos in their colours, as the browser decodes them and as their pixels are stored: made one after the other once the map shows them. */
import type { BlockFile } from '../../state/state';

/** Width of a copy, px. */
const SIDE = 240;
/** Photos of larger blocks stay dots: their copies would take minutes, and no room is for them. */
export const MOST_THUMBS = 150;

export class Thumbs {
  /** By the file's number; null where the browser cannot decode it. */
  private readonly made = new Map<number, ImageBitmap | null>();
  private readonly waiting: BlockFile[] = [];
  private making = false;

  constructor(private readonly arrived: () => void) {}

  /** The copy; null while there is none. */
  get(file: BlockFile): ImageBitmap | null {
    const found = this.made.get(file.id);
    if (found === undefined && !this.waiting.includes(file)) {
      this.waiting.push(file);
      void this.make();
    }
    return found ?? null;
  }

  private async make(): Promise<void> {
    if (this.making) return;
    this.making = true;
    for (let next = this.waiting[0]; next !== undefined; next = this.waiting[0]) {
      this.made.set(next.id, await copyOf(next.file));
      this.waiting.shift();
      this.arrived();
    }
    this.making = false;
  }
}

async function copyOf(file: Blob): Promise<ImageBitmap | null> {
  try {
    return await createImageBitmap(file, { resizeWidth: SIDE, resizeQuality: 'medium', imageOrientation: 'none' });
  } catch {
    return null;
  }
}
