/** What a run has found so far, as the page shows it: images as they are read, pairs as they are matched. */
import { groupCameras } from '../../../pkg/block/index.js';
import type { LeftOut, News, PairHead, ReadImage } from '../../../pkg/block/index.js';
import type { Connection } from '../../../pkg/wasm/tiepoint.js';
import { viewOfParts } from './outcome';
import type { BlockView } from '../state/view';

/** Views follow one another no faster, in ms. */
const PAUSE_MS = 250;
/** Making views takes no more than this share of the time. */
const SHARE = 0.05;

export class Coming {
  private readonly images = new Map<number, ReadImage>();
  private readonly leftOut: LeftOut[] = [];
  private readonly connections: Connection[] = [];
  private readonly geometries: PairHead['geometry'][] = [];
  private nextAt = 0;
  /** What came too soon after a view is shown by the next one. */
  private timer: ReturnType<typeof setTimeout> | null = null;

  /** `cameras`: the text of a file of cameras. */
  constructor(private readonly cameras: string | undefined, private readonly show: (view: BlockView) => void) {}

  take(news: News): void {
    if (news.kind === 'image') this.images.set(news.index, news.image);
    else if (news.kind === 'left-out') this.leftOut.push(news.leftOut);
    else {
      this.connections.push(news.connection);
      this.geometries.push(news.geometry);
    }
    this.timer ??= setTimeout(() => {
      this.timer = null;
      const began = performance.now();
      this.tell();
      const ended = performance.now();
      this.nextAt = ended + Math.max(PAUSE_MS, (ended - began) / SHARE);
    }, Math.max(0, this.nextAt - performance.now()));
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
    const { cameras, of } = groupCameras(images, this.cameras);
    return { ...viewOfParts(images, cameras, of, this.connections, this.geometries), leftOut: this.leftOut };
  }
}
