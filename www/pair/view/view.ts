/** The canvases: images below, marks above them, selection and magnifier on top. Each is drawn again only when what it shows changed. */
import type { Engine } from '../engine/engine';
import { wantedKeys } from '../state/keys';
import { remember } from '../../shared/state/remember';
import { SIDES } from '../state/state';
import type { Side, State } from '../state/state';
import type { Store } from '../state/store';
import { toCanvas, toImage } from './geometry';
import { PointGrid } from './grid';
import { drawMarks } from './marks';
import { drawLens, drawSelection } from './overlay';
import { paintMask, paintPicture } from './picture';
import { isShown, paneAt, sceneOf } from './scene';
import type { Pane, Scene } from './scene';
import { TileCache } from './tilecache';

type LayerName = 'pictures' | 'marks' | 'overlay';
const LAYERS: readonly LayerName[] = ['pictures', 'marks', 'overlay'];

/** How near a click must be to a point, in CSS px. */
const CLICK_RADIUS = 14;

const gridOf: Record<Side, (points: Float64Array, width: number, height: number) => PointGrid> = {
  left: remember((points: Float64Array, width: number, height: number) => new PointGrid(points, width, height)),
  right: remember((points: Float64Array, width: number, height: number) => new PointGrid(points, width, height)),
};

const gridOfPlaces = remember((points: Float64Array, width: number, height: number) => new PointGrid(points, width, height));

export class View {
  private readonly layers: Record<LayerName, CanvasRenderingContext2D>;
  private readonly dirty = new Set<LayerName>(LAYERS);
  private readonly tiles: TileCache;
  private frame = 0;
  private ratio = 1;
  private pointer: [number, number] | null = null;
  width = 1;
  height = 1;

  constructor(readonly host: HTMLElement, private readonly store: Store, engine: Engine) {
    this.layers = { pictures: layer(host, 'pictures'), marks: layer(host, 'marks'), overlay: layer(host, 'overlay') };
    this.tiles = new TileCache(
      async (imageId, level, column, row) => {
        const side = SIDES.find((s) => store.state.images[s]?.id === imageId);
        if (side === undefined) throw new Error('the image is no longer shown');
        return (await engine.withImage(side, store.state)).call('tile', { level, column, row, side: 512 });
      },
      () => { this.redraw('pictures', 'overlay'); },
    );
    new ResizeObserver(() => { this.resize(); }).observe(host);
    store.watch((s) => [s.views, s.images, s.masks, s.results.openLeft, s.results.openRight] as const, () => { this.redraw(...LAYERS); });
    store.watch(
      (s) => [s.results.pointsLeft, s.results.pointsRight, s.results.match, s.results.orientation, s.display, s.catalogue] as const,
      () => { this.redraw('marks', 'overlay'); },
    );
    store.watch((s) => [s.selection, s.results.inspection, s.settings, s.results.offset] as const, () => { this.redraw('overlay'); });
  }

  /** The scene as it stands now. */
  scene(): Scene {
    return sceneOf(this.store.state, this.width, this.height);
  }

  /** The pointer's place over the canvas, for the magnifier; null when it left. */
  point(at: [number, number] | null): void {
    this.pointer = at;
    if (this.store.state.display.magnifier) this.redraw('overlay');
  }

  /** The shown point nearest to a canvas position. */
  hit(x: number, y: number): { side: Side; index: number } | null {
    const { state } = this.store;
    const scene = this.scene();
    const pane = paneAt(scene, x, y);
    if (pane?.picture == null || pane.points === null) return null;
    const { width, height } = pane.picture;
    const at = toImage(pane.transform, x, y);
    const radius = CLICK_RADIUS / pane.transform.scale;
    const found = gridOf[pane.side](pane.points, width, height).nearest(...at, radius, (i) => isShown(state.display, pane.codes[i] ?? 0));
    const index = found < 0 ? null : { side: pane.side, index: found };
    if (pane.side === 'left' || scene.match === null) return index;
    // A matched place that is no point stands for the left point it was found from.
    const { places } = scene;
    const place = gridOfPlaces(places.points, width, height).nearest(...at, radius, (i) => isShown(state.display, places.codes[i] ?? 0));
    return place < 0 ? index : { side: 'left', index: scene.match.indices[2 * (places.matches[place] ?? 0)] ?? 0 };
  }

  /** The picture as it is on the screen, all layers together. */
  snapshot(): HTMLCanvasElement {
    this.draw();
    const canvas = document.createElement('canvas');
    canvas.width = this.layers.pictures.canvas.width;
    canvas.height = this.layers.pictures.canvas.height;
    const context = contextOf(canvas);
    for (const name of LAYERS) context.drawImage(this.layers[name].canvas, 0, 0);
    return canvas;
  }

  private redraw(...layers: LayerName[]): void {
    for (const name of layers) this.dirty.add(name);
    if (this.frame === 0) this.frame = requestAnimationFrame(() => { this.draw(); });
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.host;
    this.ratio = window.devicePixelRatio || 1;
    this.width = Math.max(1, clientWidth);
    this.height = Math.max(1, clientHeight);
    for (const name of LAYERS) {
      const { canvas } = this.layers[name];
      canvas.width = Math.round(this.width * this.ratio);
      canvas.height = Math.round(this.height * this.ratio);
    }
    for (const name of LAYERS) this.dirty.add(name);
    // At once: a resized canvas is empty until it is drawn.
    this.draw();
  }

  private draw(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    const { state } = this.store;
    const scene = this.scene();
    const names = LAYERS.filter((name) => this.dirty.has(name));
    this.dirty.clear();
    for (const name of names) {
      const context = this.layers[name];
      context.setTransform(1, 0, 0, 1, 0, 0);
      context.clearRect(0, 0, context.canvas.width, context.canvas.height);
      context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
      context.lineCap = 'butt';
      this.drawLayer(name, context, state, scene);
    }
  }

  private drawLayer(name: LayerName, context: CanvasRenderingContext2D, state: State, scene: Scene): void {
    switch (name) {
      case 'pictures':
        for (const side of SIDES) this.drawPicture(context, scene.panes[side]);
        break;
      case 'marks':
        if (state.catalogue !== null) drawMarks(context, state, scene);
        break;
      case 'overlay':
        drawSelection(context, state, scene);
        this.drawMagnifier(context, state, scene);
    }
  }

  /** At the pointer; at the selected point while the pointer is elsewhere. */
  private drawMagnifier(context: CanvasRenderingContext2D, state: State, scene: Scene): void {
    const at = this.pointer ?? selectedPlace(state, scene);
    if (!state.display.magnifier || at === null || state.catalogue === null) return;
    const bounds = { left: 0, top: 0, width: this.width, height: this.height };
    drawLens(context, state, scene, at, this.ratio, this.tiles, bounds);
  }

  private drawPicture(context: CanvasRenderingContext2D, pane: Pane): void {
    if (pane.picture === null) return;
    // Tiles are for the picture of the image that is wanted now.
    const current = wantedKeys(this.store.state)[pane.side === 'left' ? 'openLeft' : 'openRight'] !== null;
    paintPicture(context, pane.picture, pane.transform, pane.rect, this.ratio, current ? this.tiles : null);
    const mask = this.store.state.masks[pane.side];
    if (mask !== null) paintMask(context, mask, pane.transform, pane.rect);
  }
}

function selectedPlace(state: State, scene: Scene): [number, number] | null {
  if (state.selection === null) return null;
  const { points, transform } = scene.panes[state.selection.side];
  const x = points?.[3 * state.selection.index];
  const y = points?.[3 * state.selection.index + 1];
  return x === undefined || y === undefined ? null : toCanvas(transform, x, y);
}

function contextOf(canvas: HTMLCanvasElement): CanvasRenderingContext2D {
  const context = canvas.getContext('2d');
  if (context === null) throw new Error('this browser offers no canvas to draw on');
  return context;
}

function layer(host: HTMLElement, name: LayerName): CanvasRenderingContext2D {
  const canvas = document.createElement('canvas');
  canvas.className = 'layer';
  canvas.dataset['testid'] = `layer-${name}`;
  canvas.setAttribute('aria-hidden', 'true');
  host.append(canvas);
  return contextOf(canvas);
}
