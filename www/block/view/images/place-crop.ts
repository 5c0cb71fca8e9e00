/** The orthophoto about a place that was measured on it by hand, beside the images in which it is to be measured. */
import { Layers } from '../../../shared/view/layers';
import { MEASURED } from '../../../shared/view/palette';
import type { BlockStore } from '../../engine/engine';
import type { PlacingEngine } from '../../engine/placing';
import { placeOnOrthophoto } from '../../state/place-on';
import { throughout } from '../../state/cells';
import { affineOf } from '../../state/under';
import { drawCross } from '../orthophoto/links';
import { OrthophotoTiles } from '../orthophoto/tiles';

/** A px of the orthophoto is shown so large, CSS px: the spot is told from its neighbours, and what is around it is seen. */
const PX = 3;

export class PlaceCrop {
  private readonly layers: Layers<'picture'>;
  private readonly tiles: OrthophotoTiles;

  /** `frame`: hidden while no such place is chosen; `host` is its picture. */
  constructor(
    private readonly frame: HTMLElement,
    host: HTMLElement,
    private readonly store: BlockStore,
    engine: PlacingEngine,
  ) {
    this.tiles = new OrthophotoTiles(
      (level, column, row) => engine.tile(level, column, row),
      () => this.layers.redraw(),
    );
    this.layers = new Layers(host, ['picture'], (_, context) => this.paint(context));
    store.watch(['placing', 'shown', 'selection'], () => {
      frame.hidden = placeOnOrthophoto(store.state) === null;
      this.layers.redraw();
    });
  }

  private paint(context: CanvasRenderingContext2D): void {
    const place = placeOnOrthophoto(this.store.state);
    const { orthophoto } = this.store.state.placing;
    if (place === null || orthophoto === null || this.frame.hidden) return;
    const { width, height, ratio } = this.layers;
    const scale = PX / orthophoto.info.gsd;
    const t = { scale, x: width / 2 - scale * place[0], y: height / 2 + scale * place[1] };
    this.tiles.paint(context, orthophoto, throughout(affineOf(orthophoto.info.georeference)), t, [width, height, ratio]);
    drawCross(context, [width / 2, height / 2], MEASURED.colour);
  }
}
