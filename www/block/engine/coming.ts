/** What a run has found so far, as the page shows it: images as they are read, pairs as they are matched. */
import type { News } from '../../../pkg/block/index.js';
import type { Connection, ReadImage, TwoView } from '../../../pkg/wasm/tiepoint.js';
import { viewOfParts } from './outcome';
import type { BlockView, SkippedImage } from '../state/view';

/** Views follow one another no faster, in ms. */
const PAUSE_MS = 250;
/** Making views takes no more than this share of the time. */
const SHARE = 0.05;

export class Coming {
  private readonly images = new Map<number, ReadImage>();
  private readonly leftOut: SkippedImage[] = [];
  private readonly connections: Connection[] = [];
  private readonly geometries: (TwoView | null)[] = [];
  private nextAt = 0;
  /** What came too soon after a view is shown by the next one. */
  private timer: ReturnType<typeof setTimeout> | null = null;

  constructor(private readonly show: (view: BlockView) => void) {}

  take(news: News): void {
    if (news.kind === 'image') this.images.set(news.index, news);
    else if (news.kind === 'skipped') {
      this.leftOut.push({ name: news.name, reason: news.reason });
      // One that was read may turn out to be a copy of another.
      for (const [index, { name }] of this.images) if (name === news.name) this.images.delete(index);
    } else {
      this.connections.push(news.connection);
      this.geometries.push(news.geometry);
    }
    this.timer ??= setTimeout(
      () => {
        this.timer = null;
        const began = performance.now();
        this.tell();
        const ended = performance.now();
        this.nextAt = ended + Math.max(PAUSE_MS, (ended - began) / SHARE);
      },
      Math.max(0, this.nextAt - performance.now()),
    );
  }

  /** Shows all that was found. */
  tell(): void {
    if (this.images.size > 0) this.show(this.view());
  }

  /** Shows nothing more. */
  end(): void {
    if (this.timer !== null) clearTimeout(this.timer);
  }

  private view(): BlockView {
    const images = [...this.images].sort(([a], [b]) => a - b).map(([, image]) => image);
    return { ...viewOfParts(images, this.connections, this.geometries), leftOut: this.leftOut };
  }
}
