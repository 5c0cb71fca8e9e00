/** Detail tiles of large images: fetched when they are seen, the least recently seen ones dropped. */
export const TILE_SIDE = 512;
/** Tiles kept at most: 1 MB each. */
const MOST_TILES = 96;
/** Tiles asked for at the same time: a worker that also computes is not flooded with requests for places already left. */
const MOST_REQUESTS = 3;

type Fetch = (imageId: number, level: number, column: number, row: number) => Promise<ImageBitmap>;

export class TileCache {
  /** In order of last use. */
  private readonly tiles = new Map<string, ImageBitmap>();
  private readonly requested = new Set<string>();

  constructor(
    private readonly fetch: Fetch,
    private readonly arrived: () => void,
  ) {}

  /** The tile, or null while it is on its way. */
  get(imageId: number, level: number, column: number, row: number): ImageBitmap | null {
    const name = [imageId, level, column, row].join('/');
    const tile = this.tiles.get(name);
    if (tile !== undefined) {
      this.tiles.delete(name);
      this.tiles.set(name, tile);
      return tile;
    }
    if (!this.requested.has(name) && this.requested.size < MOST_REQUESTS) {
      this.requested.add(name);
      this.fetch(imageId, level, column, row).then(
        (bitmap) => this.keep(name, bitmap),
        // Without the tile the reduced image stays; the next drawing asks again.
        () => this.requested.delete(name),
      );
    }
    return null;
  }

  private keep(name: string, bitmap: ImageBitmap): void {
    this.requested.delete(name);
    this.tiles.set(name, bitmap);
    for (const [oldest, old] of this.tiles) {
      if (this.tiles.size <= MOST_TILES) break;
      old.close();
      this.tiles.delete(oldest);
    }
    this.arrived();
  }
}
