/** The chosen image on the ground, over the orthophoto: roads that run on say that it is placed well. */
import { Cancelled } from '../../../shared/engine/client';
import type { Transform } from '../../../shared/view/transform';
import type { LaidPicture } from '../../engine/orthophoto';
import type { LinkedPlacement } from '../../state/links';
import type { PlacedFile } from '../../state/placed';
import { affineOf, after } from '../../state/under';

/** Longest side of its picture, px. */
const SIDE = 3000;

export class ImageOver {
  /** Of the placement for which it is made; the picture is null while it is on its way, and where it cannot be made. */
  private of: LinkedPlacement | null = null;
  private picture: LaidPicture | null = null;

  constructor(
    private readonly make: (placed: PlacedFile, placement: LinkedPlacement, side: number) => Promise<LaidPicture>,
    private readonly arrived: () => void,
  ) {}

  paint(context: CanvasRenderingContext2D, placed: PlacedFile | null, t: Transform): void {
    const placement = placed?.result?.placement ?? null;
    if (placed === null || placement === null) return;
    if (this.of !== placement) this.ask(placed, placement);
    if (this.picture === null) return;
    const { bitmap, step, georeference } = this.picture;
    const { a, b, c, d, e, f } = after({ a: t.scale, b: 0, c: 0, d: -t.scale, e: t.x, f: t.y }, affineOf(georeference));
    context.save();
    context.transform(a, b, c, d, e, f);
    context.drawImage(bitmap, 0, 0, bitmap.width * step, bitmap.height * step);
    context.restore();
  }

  private ask(placed: PlacedFile, placement: LinkedPlacement): void {
    this.of = placement;
    this.picture?.bitmap.close();
    this.picture = null;
    this.make(placed, placement, SIDE).then(
      (picture) => {
        if (this.of === placement) this.picture = picture;
        else picture.bitmap.close();
        this.arrived();
      },
      (error: unknown) => {
        // What was cancelled is asked for by the next drawing.
        if (this.of === placement && error instanceof Cancelled) this.of = null;
      },
    );
  }
}
