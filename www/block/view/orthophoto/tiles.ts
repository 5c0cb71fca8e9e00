/** The picture of an orthophoto on a canvas, in tiles that its worker makes when they are seen: coarse ones stand in for finer ones until these have come. */
import { Cancelled } from '../../../shared/engine/client';
import type { Transform } from '../../../shared/view/transform';
import type { GivenOrthophoto } from '../../state/placing';
import { affineOfPart } from '../../state/cells';
import type { Sheet } from '../../state/cells';
import { after, scaleOf, TILE_SIDE } from '../../state/under';
import { inverse, mapped } from '../../../shared/state/plane-map';
import type { Affine } from '../../../shared/state/plane-map';

/** So many tiles are kept: some 100 MB. */
const MOST_TILES = 400;
/** Tiles that are on their way at the same time. */
const AT_ONCE = 2;
/** So many device px tiles in cells reach beyond their edges: no more than is not seen, and two of them cover a pixel that they share. */
const OVER_PX = 0.5;

interface Tile {
  level: number;
  column: number;
  row: number;
}

export class OrthophotoTiles {
  private of: GivenOrthophoto['raster'] | null = null;
  /** In order of last use; null: it cannot be made. */
  private readonly made = new Map<string, ImageBitmap | null>();
  private wanted: Tile[] = [];
  private readonly asked = new Set<string>();

  constructor(
    private readonly make: (level: number, column: number, row: number) => Promise<ImageBitmap>,
    private readonly arrived: () => void,
  ) {}

  /** Paints what a canvas of `width` x `height` CSS px shows. `lies`: from the pixels of the orthophoto to the system of the map, whose Y goes up. */
  paint(
    context: CanvasRenderingContext2D,
    { raster, info }: GivenOrthophoto,
    lies: Pick<Sheet, 'whole' | 'cells'>,
    t: Transform,
    [width, height, ratio]: readonly [number, number, number],
  ): void {
    this.keepOnly(raster);
    const ofMap: Affine = { a: t.scale, b: 0, c: 0, d: -t.scale, e: t.x, f: t.y };
    const toCanvas = after(ofMap, lies.whole);
    const coarsest = Math.max(0, Math.ceil(Math.log2(Math.max(info.width, info.height) / (2 * TILE_SIDE))));
    const level = Math.min(coarsest, Math.max(0, Math.floor(Math.log2(1 / (scaleOf(toCanvas) * ratio)))));
    const seen = partSeen(toCanvas, info, [width, height], lies.cells?.margin ?? 0);
    context.save();
    context.imageSmoothingEnabled = scaleOf(toCanvas) * ratio < 2 || level > 0;
    const missing = tilesOf(coarsest, seen, info).filter((tile) => !this.made.has(nameOf(tile)));
    for (const tile of tilesOf(level, seen, info)) {
      if (level < coarsest && !this.made.has(nameOf(tile))) missing.push(tile);
      const { a, b, c, d, e, f } = lies.cells === null ? toCanvas : after(ofMap, affineOfPart(lies, info, partOf(tile, info)));
      context.save();
      context.transform(a, b, c, d, e, f);
      // Each cell lies a little otherwise: their smoothed edges would let the ground through.
      const over = lies.cells === null ? 0 : OVER_PX / (scaleOf({ a, b, c, d, e, f }) * ratio);
      this.paintTile(context, tile, coarsest, info, over);
      context.restore();
    }
    context.restore();
    this.ask(missing, seen);
  }

  /** A tile, or in its place the part of the finest coarser one that is there; stretched by `over` px of the picture beyond each edge. */
  private paintTile(context: CanvasRenderingContext2D, { level, column, row }: Tile, coarsest: number, { width, height }: Size, over: number): void {
    const side = TILE_SIDE * 2 ** level;
    const [x, y] = [column * side, row * side];
    for (let up = 0; level + up <= coarsest; up++) {
      const name = nameOf({ level: level + up, column: column >> up, row: row >> up });
      const bitmap = this.made.get(name);
      if (bitmap == null) continue;
      this.made.delete(name);
      this.made.set(name, bitmap);
      const step = 2 ** (level + up);
      const [left, top] = [(x / step) % TILE_SIDE, (y / step) % TILE_SIDE];
      const across = Math.min(TILE_SIDE / 2 ** up, bitmap.width - left, Math.ceil((width - x) / step));
      const down = Math.min(TILE_SIDE / 2 ** up, bitmap.height - top, Math.ceil((height - y) / step));
      context.drawImage(bitmap, left, top, across, down, x - over, y - over, across * step + 2 * over, down * step + 2 * over);
      return;
    }
  }

  /** The latest drawing says what is wanted; coarse tiles, and those in the middle, come first. */
  private ask(missing: Tile[], [left, top, right, bottom]: Part): void {
    const [x, y] = [(left + right) / 2, (top + bottom) / 2];
    const far = ({ level, column, row }: Tile) => {
      const side = TILE_SIDE * 2 ** level;
      return Math.hypot((column + 0.5) * side - x, (row + 0.5) * side - y);
    };
    this.wanted = missing.sort((a, b) => b.level - a.level || far(a) - far(b));
    this.next();
  }

  private next(): void {
    while (this.asked.size < AT_ONCE) {
      const tile = this.wanted.find((candidate) => !this.asked.has(nameOf(candidate)));
      if (tile === undefined) return;
      this.wanted = this.wanted.filter((other) => other !== tile);
      void this.fetch(tile, this.of);
    }
  }

  private async fetch(tile: Tile, of: GivenOrthophoto['raster'] | null): Promise<void> {
    const name = nameOf(tile);
    this.asked.add(name);
    try {
      const bitmap = await this.make(tile.level, tile.column, tile.row);
      if (this.of === of) this.made.set(name, bitmap);
      else bitmap.close();
    } catch (error) {
      if (this.of === of && !(error instanceof Cancelled)) this.made.set(name, null);
    }
    this.asked.delete(name);
    this.forgetOldest();
    this.next();
    this.arrived();
  }

  private forgetOldest(): void {
    for (const [name, bitmap] of this.made) {
      if (this.made.size <= MOST_TILES) return;
      bitmap?.close();
      this.made.delete(name);
    }
  }

  private keepOnly(raster: GivenOrthophoto['raster']): void {
    if (this.of === raster) return;
    this.of = raster;
    for (const bitmap of this.made.values()) bitmap?.close();
    this.made.clear();
    this.wanted = [];
  }
}

/** Left, top, right, bottom in px of the picture. */
type Part = readonly [number, number, number, number];

interface Size {
  width: number;
  height: number;
}

/** What of the picture a canvas shows, and so many px about it. */
function partSeen(toCanvas: Affine, { width, height }: Size, [across, down]: readonly [number, number], margin: number): Part {
  const back = inverse(toCanvas);
  const corners = [mapped(back, 0, 0), mapped(back, across, 0), mapped(back, 0, down), mapped(back, across, down)];
  const [xs, ys] = [corners.map(([x]) => x), corners.map(([, y]) => y)];
  const [left, top, right, bottom] = [Math.min(...xs) - margin, Math.min(...ys) - margin, Math.max(...xs) + margin, Math.max(...ys) + margin];
  return [Math.max(0, left), Math.max(0, top), Math.min(width, right), Math.min(height, bottom)];
}

function partOf({ level, column, row }: Tile, { width, height }: Size): Part {
  const side = TILE_SIDE * 2 ** level;
  return [column * side, row * side, Math.min(width, (column + 1) * side), Math.min(height, (row + 1) * side)];
}

function tilesOf(level: number, [left, top, right, bottom]: Part, { width, height }: Size): Tile[] {
  const side = TILE_SIDE * 2 ** level;
  const last = (length: number, end: number) => Math.min(Math.ceil(length / side), Math.ceil(end / side));
  const tiles: Tile[] = [];
  for (let row = Math.floor(top / side); row < last(height, bottom); row++)
    for (let column = Math.floor(left / side); column < last(width, right); column++) tiles.push({ level, column, row });
  return tiles;
}

function nameOf({ level, column, row }: Tile): string {
  return `${String(level)} ${String(column)} ${String(row)}`;
}
