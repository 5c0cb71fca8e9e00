/** An image that was placed, with its links and their residuals. */
import { remember } from '../../../shared/state/remember';
import { paintBitmap, smooth, visiblePart } from '../../../shared/view/bitmap';
import type { Colours } from '../../../shared/view/colours';
import type { Rect, Transform } from '../../../shared/view/transform';
import type { BlockStore } from '../../engine/engine';
import { Bitmaps } from '../images/bitmaps';
import type { LinkHands } from '../../engine/link-hands';
import { shownLinks } from '../../state/steps';
import { drawScaleBar } from '../images/observations';
import { drawLinkResiduals, drawLinks, drawRing, linksOnImage } from './links';
import type { DrawnLinks } from './links';
import { LinkPicture } from './picture';
import type { Box } from './picture';
import type { OrthophotoPlan } from './plan';

export class PlacedImageView extends LinkPicture {
  private readonly bitmaps: Bitmaps;
  private readonly drawn = remember(linksOnImage);
  private of = -1;
  private longer = 50;

  constructor(
    host: HTMLElement,
    store: BlockStore,
    hands: LinkHands,
    keys: (key: string, shift: boolean) => boolean,
    grey: (file: Blob) => Promise<ImageBitmap>,
  ) {
    super(host, store, hands, keys);
    this.bitmaps = new Bitmaps(grey, () => this.layers.redraw('picture'));
    store.watch(['placing', 'files'], () => {
      const { id } = this.chosen()?.file ?? { id: -1 };
      this.bitmaps.keep(new Set([id]));
      if (this.of !== id) this.fit();
      this.of = id;
      this.layers.redraw();
    });
  }

  /** How much longer than they are residuals are drawn; 0: not at all. */
  get factor(): number {
    return this.longer;
  }

  set factor(factor: number) {
    this.longer = factor;
    this.layers.redraw('marks');
  }

  /** Size of the chosen image; null where it could not be read. */
  private size(): { width: number; height: number } | null {
    const [width, height] = this.chosen()?.result?.size ?? [];
    return width === undefined || height === undefined ? null : { width, height };
  }

  protected override whole(): Box | null {
    const size = this.size();
    return size === null ? null : [0, 0, size.width, size.height];
  }

  protected override mostScale(fits: number): number {
    return Math.max(32, 4 * fits);
  }

  protected override links(): DrawnLinks | null {
    const chosen = this.chosen();
    const links = chosen === null ? null : shownLinks(chosen);
    return links === null ? null : this.drawn(links);
  }

  protected override other(): { image: number | null; link: null } {
    return { image: this.store.state.placing.chosen.image, link: null };
  }

  protected override end(): readonly [number, number] | null {
    return this.store.state.placing.draft?.at ?? null;
  }

  protected override measured(at: [number, number]): void {
    const size = this.size();
    if (size === null || at[0] < 0 || at[1] < 0 || at[0] > size.width || at[1] > size.height) return;
    void this.hands.place('at', at).then((place) => this.ground?.expectPlace(place));
  }

  /** The orthophoto beside it. */
  ground: OrthophotoPlan | null = null;

  private get clip(): Rect {
    return { left: 0, top: 0, width: this.layers.width, height: this.layers.height };
  }

  protected override paintPicture(context: CanvasRenderingContext2D, t: Transform): void {
    const [chosen, size] = [this.chosen(), this.size()];
    if (chosen === null || size === null) return;
    const { ratio } = this.layers;
    const part = visiblePart(size, t, this.clip);
    smooth(context, t.scale, ratio);
    for (const { bitmap, x, y, step } of this.bitmaps.pieces(chosen.file, size, 'pane', part, t.scale * ratio))
      paintBitmap(context, bitmap, x, y, step, part, t);
  }

  protected override paintMarks(context: CanvasRenderingContext2D, _colours: Colours, t: Transform): void {
    const links = this.links();
    if (links === null) {
      this.paintEnd(context, t);
      return;
    }
    const { clip } = this;
    const { chosen, pointed, uses } = this.store.state.placing;
    if (this.longer > 0) drawLinkResiduals(context, links, this.longer, t, clip, uses);
    drawLinks(context, links, t, clip, uses);
    if (pointed.image === chosen.image && pointed.link !== null) drawRing(context, links, pointed.link, t, false);
    if (chosen.link !== null) drawRing(context, links, chosen.link, t, true);
    this.paintEnd(context, t);
    if (this.longer > 0) drawScaleBar(context, this.longer, { transform: t, rect: clip });
  }
}
