/** Small copies of the photos in their colours, as the browser decodes them and as their pixels are stored: made one after the other once the map shows them. */
import type { BlockFile } from '../../state/state';

/** Width of a copy, px. */
const SIDE = 240;
/** So many photos are shown at once: copies of more would take minutes, and no room is for them. */
export const MOST_THUMBS = 150;
/** So many copies are kept, for places that are looked at again. */
const MOST_KEPT = 3 * MOST_THUMBS;

export class Thumbs {
  /** By the file's number; null where the browser cannot decode it. */
  private readonly made = new Map<number, ImageBitmap | null>();
  private waiting: BlockFile[] = [];
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

  /** Which files are shown, by their numbers: the others wait no longer, and of their copies the oldest are given up. */
  shows(files: ReadonlySet<number>): void {
    this.waiting = this.waiting.filter(({ id }) => files.has(id));
    for (const [id, copy] of this.made) {
      if (this.made.size <= MOST_KEPT) break;
      if (files.has(id)) continue;
      copy?.close();
      this.made.delete(id);
    }
  }

  private async make(): Promise<void> {
    if (this.making) return;
    this.making = true;
    for (let next = this.waiting[0]; next !== undefined; next = this.waiting[0]) {
      const { id } = next;
      this.made.set(id, await copyOf(next.file));
      this.waiting = this.waiting.filter((file) => file.id !== id);
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
