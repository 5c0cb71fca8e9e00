/** The canvases: images below, masks and marks above them, selection and loupes on top. Each is drawn again only when what it shows changed. */
import { isCodeShown } from '../state/display';
import type { Engine } from '../engine/engine';
import { wantedKeys } from '../state/keys';
import { remember } from '../../shared/state/remember';
import { SIDES } from '../state/state';
import type { Side, State } from '../state/state';
import type { Store } from '../state/store';
import { Layers } from '../../shared/view/layers';
import { toCanvas, toPosition } from '../../shared/view/transform';
import type { Rect } from '../../shared/view/transform';
import { drawChosen, drawRectangle } from './chosen';
import { drawDraft } from './draft';
import { drawFiducials } from './fiducials';
import { PointGrid } from '../../shared/view/grid';
import { drawOverLenses, lensesOfMeasured, magnifierAt, paintLenses } from './lenses';
import type { Lens } from './lenses';
import { drawMarks } from './marks';
import { drawOutline } from './outline';
import { drawSelection } from './overlay';
import { paintMask, paintPicture } from './picture';
import { marksOf, paneAt, sceneOf } from './scene';
import type { Pane, Scene } from './scene';
import { TileCache } from './tilecache';

type LayerName = 'pictures' | 'masks' | 'marks' | 'overlay' | 'lenses' | 'glass';
const LAYERS: readonly LayerName[] = ['pictures', 'masks', 'marks', 'overlay', 'lenses', 'glass'];
/** What lies over the marks. */
const ABOVE: readonly LayerName[] = ['overlay', 'lenses', 'glass'];

/** How near a click must be to a point, in CSS px. */
const CLICK_RADIUS = 14;

const gridOf: Record<Side, (points: Float64Array, width: number, height: number) => PointGrid> = {
  left: remember((points: Float64Array, width: number, height: number) => new PointGrid(points, width, height)),
  right: remember((points: Float64Array, width: number, height: number) => new PointGrid(points, width, height)),
};

const gridOfPlaces = remember((points: Float64Array, width: number, height: number) => new PointGrid(points, width, height));

export class View {
  private readonly layers: Layers<LayerName>;
  private readonly tiles: TileCache;
  private pointer: [number, number] | null = null;
  private rectangle: Rect | null = null;

  constructor(
    readonly host: HTMLElement,
    private readonly store: Store,
    engine: Engine,
  ) {
    this.layers = new Layers(host, LAYERS, (name, context) => this.draw(name, context));
    this.tiles = new TileCache(
      async (imageId, level, column, row) => {
        const side = SIDES.find((s) => store.state.images[s]?.id === imageId);
        if (side === undefined) throw new Error('the image is no longer shown');
        return (await engine.withImage(side, store.state)).call('tile', { level, column, row, side: 512 });
      },
      () => this.layers.redraw('pictures', 'lenses'),
    );
    store.watch(
      (s) => [s.views, s.images, s.masks, s.results.openLeft, s.results.openRight] as const,
      () => this.layers.redraw(),
    );
    // A new orientation that rejects the same matches leaves them as they are.
    store.watch(
      (s) => {
        const { points, codes, match, matchCodes, places, vectors, shown } = marksOf(s);
        const { left, right } = vectors;
        return [points.left, points.right, codes.left, codes.right, match, matchCodes, places, left, right, shown, s.display, s.catalogue] as const;
      },
      () => this.layers.redraw('marks', ...ABOVE),
    );
    store.watch(
      (s) =>
        [
          s.selection,
          s.chosen,
          s.draft,
          s.outline,
          s.mark,
          s.photos,
          s.tool,
          s.activeSide,
          s.results.line,
          s.results.inspection,
          s.settings,
          s.results.offset,
        ] as const,
      () => this.layers.redraw(...ABOVE),
    );
  }

  /** The scene as it stands now. */
  scene(): Scene {
    return sceneOf(this.store.state, this.layers.width, this.layers.height);
  }

  /** The keyboard goes on in the pictures. */
  takeKeys(): void {
    this.host.focus({ preventScroll: true });
  }

  /** The pointer's place over the canvas, for the magnifier; null when it left. */
  point(at: [number, number] | null): void {
    this.pointer = at;
    if (this.store.state.display.magnifier) this.layers.redraw('lenses', 'glass');
  }

  /** Shows a rectangle that is being drawn; null: none. */
  enclose(rectangle: Rect | null): void {
    this.rectangle = rectangle;
    this.layers.redraw('overlay');
  }

  /** The shown point nearest to a canvas position. */
  hit(x: number, y: number): { side: Side; index: number } | null {
    const scene = this.scene();
    const pane = paneAt(scene, x, y);
    if (pane?.picture == null || pane.points === null) return null;
    const { width, height } = pane.picture;
    const at = toPosition(pane.transform, x, y);
    const radius = CLICK_RADIUS / pane.transform.scale;
    const found = gridOf[pane.side](pane.points, width, height).nearest(...at, radius, (i) => isCodeShown(scene.shown, pane.codes[i] ?? 0));
    const index = found < 0 ? null : { side: pane.side, index: found };
    if (pane.side === 'left' || scene.match === null) return index;
    // A matched place that is no point stands for the left point it was found from.
    const { places } = scene;
    const place = gridOfPlaces(places.points, width, height).nearest(...at, radius, (i) => isCodeShown(scene.shown, places.codes[i] ?? 0));
    return place < 0 ? index : { side: 'left', index: places.lefts[place] ?? 0 };
  }

  /** The picture as it is on the screen, all layers together. */
  snapshot(): HTMLCanvasElement {
    return this.layers.snapshot();
  }

  private draw(name: LayerName, context: CanvasRenderingContext2D): void {
    const { state } = this.store;
    const scene = this.scene();
    switch (name) {
      case 'pictures':
        for (const side of SIDES) this.drawPicture(context, scene.panes[side]);
        break;
      case 'masks':
        for (const { side, picture, transform, rect } of SIDES.map((one) => scene.panes[one])) {
          const mask = state.masks[side];
          if (picture !== null && mask !== null) paintMask(context, mask, transform, rect);
        }
        break;
      case 'marks':
        if (state.catalogue !== null) drawMarks(context, state, scene);
        break;
      case 'overlay':
        drawChosen(context, state, scene);
        drawSelection(context, state, scene);
        drawDraft(context, state, scene);
        drawOutline(context, state, scene);
        drawFiducials(context, state, scene);
        if (this.rectangle !== null) drawRectangle(context, this.rectangle);
        break;
      case 'lenses':
        paintLenses(context, this.lenses(state, scene), this.layers.ratio, this.tiles);
        break;
      case 'glass':
        if (state.catalogue !== null) drawOverLenses(context, state, scene, this.lenses(state, scene));
    }
  }

  /** Over what is measured; the magnifier at the pointer, or at the selected point while the pointer is elsewhere. */
  private lenses(state: State, scene: Scene): Lens[] {
    const { width, height } = this.layers;
    const at = this.pointer ?? selectedPlace(state, scene);
    const magnifies = state.display.magnifier && state.draft === null && at !== null && state.catalogue !== null;
    return [...lensesOfMeasured(state, scene), ...(magnifies ? magnifierAt(scene, at, { left: 0, top: 0, width, height }) : [])];
  }

  private drawPicture(context: CanvasRenderingContext2D, pane: Pane): void {
    if (pane.picture === null) return;
    // Tiles are for the picture of the image that is wanted now.
    const current = wantedKeys(this.store.state)[pane.side === 'left' ? 'openLeft' : 'openRight'] !== null;
    paintPicture(context, pane.picture, pane.transform, pane.rect, this.layers.ratio, current ? this.tiles : null);
  }
}

function selectedPlace(state: State, scene: Scene): [number, number] | null {
  if (state.selection === null) return null;
  const { points, transform } = scene.panes[state.selection.side];
  const x = points?.[3 * state.selection.index];
  const y = points?.[3 * state.selection.index + 1];
  return x === undefined || y === undefined ? null : toCanvas(transform, x, y);
}
