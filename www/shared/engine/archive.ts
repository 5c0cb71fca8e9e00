/** Files as one archive. */
import { Zip, ZipDeflate, ZipPassThrough } from 'fflate';

/** The time in archives: that of their making would give the same files other bytes. */
export const ARCHIVE_TIME = '1980-01-01T00:00:00';

export class Archive {
  private readonly chunks: Uint8Array<ArrayBuffer>[] = [];
  private readonly zip = new Zip((error, chunk) => {
    if (error !== null) throw error;
    this.chunks.push(chunk as Uint8Array<ArrayBuffer>);
  });

  /** `compressed`: whether the content takes little room already. */
  add(name: string, content: Uint8Array, compressed: boolean): void {
    const entry = compressed ? new ZipPassThrough(name) : new ZipDeflate(name, { level: 6 });
    entry.mtime = ARCHIVE_TIME;
    this.zip.add(entry);
    entry.push(content, true);
  }

  /** All of it; nothing is added afterwards. */
  end(): Blob {
    this.zip.end();
    return new Blob(this.chunks, { type: 'application/zip' });
  }
}
