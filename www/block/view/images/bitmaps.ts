/**
 * The pictures of the images that panes show: a small copy of each, and of the part that is looked at its pixels. An image is decoded when it is
 * needed, one at a time, and of whole decoded images only the latest are kept: nine images of 12 megapixels would take 430 MB.
 */
import { Cancelled } from '../../../shared/engine/client';
import { decodeColour } from '../../../shared/engine/colour';
import { wantedLevel } from '../../../shared/view/bitmap';
import type { BlockFile } from '../../state/state';

/** Longer side of a small copy, px. */
const COPY_SIDE = 1024;
/** What decoded images may take, in bytes. */
const MOST_DECODED = 100e6;
/** How much more than what is seen a part shows on each side, in shares of it and at least in px: room to move. */
const MARGIN = 0.25;
const LEAST_MARGIN = 96;

/** Left, top, right, bottom in px of the image. */
type Part = readonly [left: number, top: number, right: number, bottom: number];

/** A bitmap of a part of an image. */
export interface Piece {
  bitmap: ImageBitmap;
  /** The position of its corner, px of the image. */
  x: number;
  y: number;
  /** Px of the image of one of its own, across and down. */
  step: number;
}

interface Size {
  width: number;
  height: number;
}

/** What shows details of an image: its pane, and the loupe over it. */
export type Slot = 'pane' | 'loupe';

interface Held {
  copy: Piece | null;
  details: Map<Slot, Piece & { part: Part; level: number }>;
  /** It is neither decoded by the browser nor by the crate. */
  failed: boolean;
}

interface Wish {
  file: BlockFile;
  size: Size;
  slot: Slot;
  /** Null: the small copy. */
  part: Part | null;
  level: number;
}

export class Bitmaps {
  private readonly held = new Map<number, Held>();
  /** Decoded images by the number of their file, in order of last use. */
  private readonly decoded = new Map<number, ImageBitmap>();
  /** By file and slot; the latest counts. */
  private readonly wishes = new Map<string, Wish>();
  private working = false;

  constructor(
    /** Decodes what the browser cannot. */
    private readonly grey: (file: Blob) => Promise<ImageBitmap>,
    private readonly arrived: () => void,
  ) {}

  /** Whether the image of a file cannot be shown. */
  hasFailed(file: BlockFile): boolean {
    return this.held.get(file.id)?.failed === true;
  }

  /** What there is of an image, the coarser first, and asks for what is wanted. `part`: what is seen; `density`: device px of a px of the image. */
  pieces(file: BlockFile, size: Size, slot: Slot, part: Part, density: number): Piece[] {
    const held = this.held.get(file.id) ?? { copy: null, details: new Map(), failed: false };
    this.held.set(file.id, held);
    if (held.failed) return [];
    const level = wantedLevel(density, 1);
    const { copy } = held;
    const detail = held.details.get(slot);
    if (copy === null) this.wish({ file, size, slot, part: null, level: 0 });
    else if (2 ** level < copy.step && !(detail !== undefined && detail.level <= level && covers(detail.part, part)))
      this.wish({ file, size, slot, part: withMargin(part, size), level });
    return [copy, detail].filter((piece) => piece != null);
  }

  /** Frees what belongs to other files. */
  keep(files: ReadonlySet<number>): void {
    for (const [id, held] of this.held) {
      if (files.has(id)) continue;
      for (const piece of [held.copy, ...held.details.values()]) piece?.bitmap.close();
      this.held.delete(id);
    }
    for (const [name, { file }] of this.wishes) if (!files.has(file.id)) this.wishes.delete(name);
    for (const [id, bitmap] of this.decoded) {
      if (files.has(id)) continue;
      bitmap.close();
      this.decoded.delete(id);
    }
  }

  /** What all of it takes, in bytes. */
  get bytes(): number {
    const pieces = [...this.held.values()].flatMap(({ copy, details }) => [copy, ...details.values()].map((piece) => piece?.bitmap));
    return [...pieces, ...this.decoded.values()].reduce((sum, bitmap) => sum + (bitmap == null ? 0 : sizeOf(bitmap)), 0);
  }

  private wish(wish: Wish): void {
    this.wishes.set(nameOfWish(wish), wish);
    if (!this.working) void this.work();
  }

  private async work(): Promise<void> {
    this.working = true;
    for (let next = this.wishes.values().next().value; next !== undefined; next = this.wishes.values().next().value) {
      this.wishes.delete(nameOfWish(next));
      await this.fulfil(next);
      this.arrived();
    }
    this.working = false;
  }

  private async fulfil({ file, size, slot, part, level }: Wish): Promise<void> {
    // A cancelled run ends the worker that decodes: the next drawing asks again.
    const whole = await this.whole(file, size).catch((error: unknown) => (error instanceof Cancelled ? undefined : null));
    const held = this.held.get(file.id);
    if (held === undefined || whole === undefined) return;
    if (whole === null) {
      held.failed = true;
      return;
    }
    try {
      if (part === null) {
        const step = 2 ** Math.max(0, Math.ceil(Math.log2(Math.max(size.width, size.height) / COPY_SIDE)));
        held.copy = await pieceOf(whole, [0, 0, size.width, size.height], step);
      } else {
        const detail = await pieceOf(whole, part, 2 ** level);
        held.details.get(slot)?.bitmap.close();
        held.details.set(slot, { ...detail, part, level });
      }
    } catch {
      // It was freed meanwhile; the next drawing asks again for what it needs.
    }
    this.forgetOldest();
  }

  /** The decoded image; null where it cannot be decoded, or has another size than the block knows. */
  private async whole(file: BlockFile, size: Size): Promise<ImageBitmap | null> {
    const known = this.decoded.get(file.id);
    if (known !== undefined) {
      this.decoded.delete(file.id);
      this.decoded.set(file.id, known);
      return known;
    }
    const fits = (bitmap: ImageBitmap) => bitmap.width === size.width && bitmap.height === size.height;
    const colour = await decodeColour(new Uint8Array(await file.file.arrayBuffer()));
    if (colour !== null && !fits(colour)) colour.close();
    const made = colour !== null && fits(colour) ? colour : await this.grey(file.file);
    if (!fits(made)) return null;
    if (this.held.has(file.id)) this.decoded.set(file.id, made);
    return made;
  }

  private forgetOldest(): void {
    let sum = [...this.decoded.values()].reduce((all, bitmap) => all + sizeOf(bitmap), 0);
    for (const [id, bitmap] of this.decoded) {
      if (sum <= MOST_DECODED) return;
      sum -= sizeOf(bitmap);
      bitmap.close();
      this.decoded.delete(id);
    }
  }
}

function nameOfWish({ file, slot }: Wish): string {
  return `${String(file.id)} ${slot}`;
}

function sizeOf({ width, height }: ImageBitmap): number {
  return 4 * width * height;
}

function covers(outer: Part, inner: Part): boolean {
  return outer[0] <= inner[0] && outer[1] <= inner[1] && outer[2] >= inner[2] && outer[3] >= inner[3];
}

/** A part with room around it, in whole px. */
function withMargin([left, top, right, bottom]: Part, { width, height }: Size): Part {
  const [dx, dy] = [right - left, bottom - top].map((length) => Math.max(MARGIN * length, LEAST_MARGIN)) as [number, number];
  return [
    Math.max(0, Math.floor(left - dx)),
    Math.max(0, Math.floor(top - dy)),
    Math.min(width, Math.ceil(right + dx)),
    Math.min(height, Math.ceil(bottom + dy)),
  ];
}

/** A part of an image, reduced; where its sides are no multiples of the step the last px are a little narrower. */
async function pieceOf(whole: ImageBitmap, [left, top, right, bottom]: Part, step: number): Promise<Piece> {
  const [width, height] = [Math.max(1, Math.floor((right - left) / step)), Math.max(1, Math.floor((bottom - top) / step))];
  const bitmap = await createImageBitmap(whole, left, top, width * step, height * step, { resizeWidth: width, resizeHeight: height, resizeQuality: 'medium' });
  return { bitmap, x: left, y: top, step };
}
